// SPDX-License-Identifier: Apache-2.0
// Measured light as a beam: its lumens, its candela, its oval, and what check says of broken files.
#include "light/beam_shape.h"

#include "light/gobos.h"
#include "light/rig.h"
#include "photometry/photometry.h"
#include "shared/beam.h"
#include "support/plot_files.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace ghost::scene {
namespace {

using glm::vec3;

constexpr double kPi = std::numbers::pi;

// A lantern with a field of 2 x wide degrees across C0 and narrow across C90, cosine-shaped.
fixture::Photometric lantern(double wide_deg, double narrow_deg) {
    fixture::Photometric light;
    for (int k = 0; k <= 180; ++k) light.gamma_deg.push_back(0.5f * static_cast<float>(k));
    for (int c = 0; c < 360; c += 5) {
        light.c_deg.push_back(static_cast<float>(c));
        const double x = std::cos(c * kPi / 180.0) / wide_deg, y = std::sin(c * kPi / 180.0) / narrow_deg;
        const double end_deg = 1.0 / std::hypot(x, y);
        std::vector<float>& plane = light.candela.emplace_back();
        for (const float gamma : light.gamma_deg) {
            const double fraction = static_cast<double>(gamma) / end_deg;
            plane.push_back(
                fraction < 1.0 ? static_cast<float>(50000.0 * 0.5 * (1.0 + std::cos(kPi * fraction))) : 0.0f);
        }
    }
    return light;
}

Show lantern_show(const fixture::Photometric& light) {
    const fs::path folder = scratch("lantern");
    write_mvr(folder / "plot.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,5000}", "")));
    Report report;
    Show show = opened(folder / "plot.mvr", report);
    show.motion = fixture::Motion::as_commanded;
    show.fixtures[0].shape = std::make_shared<const BeamShape>(shape_of(light, "lantern.ies"));
    return show;
}

shared::Light lantern_light(const Show& show, const GoboStack& gobos) {
    Rig rig(show);
    dmx::Universes universes;
    rig.step(universes, 0);
    std::map<std::size_t, fixture::Programmer> full;
    full[0].intensity = 1.0f;
    rig.step(universes, 0, full);
    return rig.lights(gobos, DistanceMaps{}).front();
}

double lumens(const shared::Light& light, const GoboStack& gobos) {
    double sum = 0;
    constexpr int kGamma = 1600, kC = 180;
    for (int g = 0; g < kGamma; ++g)
        for (int c = 0; c < kC; ++c) {
            const double gamma = (g + 0.5) / kGamma * 0.5 * kPi, turn = 2.0 * kPi * (c + 0.5) / kC;
            const vec3 way(static_cast<float>(std::sin(gamma) * std::cos(turn)),
                           static_cast<float>(std::sin(gamma) * std::sin(turn)),
                           static_cast<float>(std::cos(gamma)));
            sum += static_cast<double>(shared::beam_candela(light, way, gobos.images).y) * std::sin(gamma);
        }
    return sum * 0.5 * kPi / kGamma * 2.0 * kPi / kC;
}

TEST(BeamShape, KeepsTheLumensOfTheFile) {
    for (const auto& [wide, narrow] : {std::pair{12.0, 12.0}, {30.0, 10.0}, {60.0, 45.0}}) {
        const fixture::Photometric file = lantern(wide, narrow);
        const Show show = lantern_show(file);
        Report report;
        const GoboStack gobos = build_gobos(show, report);
        ASSERT_EQ(gobos.shapes.size(), 1u);
        // The beam of the fixture is white of its lamp: luminance is that of the file.
        const shared::Light light = lantern_light(show, gobos);
        const double white = static_cast<double>(
            glm::dot(light.intensity_cd, vec3(0.2627f, 0.678f, 0.0593f)) / light.intensity_cd.y);
        EXPECT_NEAR(lumens(light, gobos) * white / file.flux_lm(), 1.0, 5e-3) << wide << " x " << narrow;
        EXPECT_NEAR(
            static_cast<double>(light.bounce_cd.y / (light.intensity_cd.y * measured_fraction(light))) * 4.0 *
                kPi * 50000.0 / file.flux_lm(),
            1.0, 0.01);
    }
}

TEST(BeamShape, IsOvalWhereTheFileIs) {
    const fixture::Photometric file = lantern(30.0, 10.0);
    const Show show = lantern_show(file);
    Report report;
    const GoboStack gobos = build_gobos(show, report);
    const shared::Light light = lantern_light(show, gobos);
    // As a laboratory measures: 10 m before the lens.
    const auto candela = [&](const vec3& way) {
        const vec3 q = vec3(0, 0, light.lens_m) + 10.0f * way;
        return shared::beam_candela(light, q, gobos.images).y * 100.0f / glm::dot(q, q);
    };
    const float peak = candela({0, 0, 1});
    for (const float gamma : {2.0f, 5.0f, 8.0f, 15.0f, 25.0f})
        for (const float c : {0.0f, 30.0f, 90.0f, 200.0f}) {
            const float g = glm::radians(gamma), t = glm::radians(c);
            const vec3 way(std::sin(g) * std::cos(t), std::sin(g) * std::sin(t), std::cos(g));
            EXPECT_NEAR(candela(way) / peak, file.at(c, gamma) / 50000.0f, 0.012f) << gamma << " " << c;
        }
}

TEST(BeamShape, SaysWhatIsNotDrawn) {
    fixture::Photometric globe;
    globe.gamma_deg = {0, 90, 180};
    globe.c_deg = {0};
    globe.candela = {{100, 100, 100}};
    const BeamShape shape = shape_of(globe, "globe.ies");
    EXPECT_NEAR(shape.flux_lm, 2.0 * kPi * 100.0 * (1.0 - std::cos(80.0 * kPi / 180.0)), 0.1);
    EXPECT_NEAR(shape.flux_lm + shape.lost_lm, 4.0 * kPi * 100.0, 0.1);
    EXPECT_NEAR(static_cast<double>(shape.solid_angle(shape.tan_field)) * 100.0 / shape.flux_lm, 1.0, 5e-3);
}

TEST(BeamShape, CheckNamesWhatIsWrong) {
    const fs::path folder = scratch("photometry");
    write_mvr(folder / "plot.mvr", small_xml(fixture_xml(20, "Spot", kIdentity + "{0,0,5000}", "")));
    std::ofstream(folder / "good.ies")
        << "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 100\n0 10 20\n0\n1000 500 0\n";
    std::ofstream(folder / "bad.ies")
        << "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 100\n0 10 5\n0\n1 1 1\n";
    const auto open = [&](const std::string& entry, Report& report) {
        std::ofstream(folder / "show.toml") << "[show]\nplot = \"plot.mvr\"\n" << entry;
        return opened(folder / "show.toml", report);
    };
    Report report;
    EXPECT_TRUE(open("[[photometry]]\nfor = \"head.*\"\nfile = \"good.ies\"\n", report).fixtures[0].shape)
        << messages_of(report);
    EXPECT_FALSE(open("[[photometry]]\nfor = \"*\"\nfile = \"bad.ies\"\n", report).fixtures[0].shape);
    EXPECT_NE(messages_of(report).find("do not rise"), std::string::npos) << messages_of(report);
    EXPECT_FALSE(open("[[photometry]]\nfor = \"*\"\nfile = \"god.ies\"\n", report).fixtures[0].shape);
    EXPECT_NE(messages_of(report).find("did you mean"), std::string::npos) << messages_of(report);
    EXPECT_FALSE(open("[[photometry]]\nfor = \"Par*\"\nfile = \"good.ies\"\n", report).fixtures[0].shape);
    EXPECT_NE(messages_of(report).find("no fixture is of a file 'Par*'"), std::string::npos)
        << messages_of(report);
}

} // namespace
} // namespace ghost::scene
