// SPDX-License-Identifier: Apache-2.0
// Frost keeps the light of whatever is in the gate, and spreads it as a Gaussian does.
#include "base/text.h"
#include "photometry/photometry.h"
#include "support/optics_profile.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace ghost::scene {
namespace {

TEST(Frost, ConservesTheFlux) {
    for (const float zoom_deg : {8.0f, 20.0f, 44.0f})
        for (const float iris : {1.0f, 0.3f}) {
            fixture::BeamState beam = open_beam();
            beam.optics.zoom_deg = zoom_deg;
            beam.optics.iris = iris;
            // In focus: out of it the edge of any beam is blurred, and a little brighter.
            const auto lumens = [](shared::Light light) {
                light.lens_radius_m = 0;
                return flux_lm(light, 8.0, 600);
            };
            const double clear_lm = lumens(light_of(beam));
            for (const float full_deg : {1.0f, 3.0f, 8.0f})
                for (const float in : {0.1f, 0.5f, 1.0f}) {
                    beam.optics.frost = in;
                    beam.optics.frost_full_deg = full_deg;
                    const double lm = lumens(light_of(beam));
                    EXPECT_NEAR(lm / clear_lm, 1.0, 0.005)
                        << zoom_deg << " deg, iris " << iris << ", frost " << in * full_deg << " deg";
                }
        }
}

// Behind a gate with something in it, too, whatever hangs together with what, where it is focused.
TEST(Frost, ConservesTheFluxBehindAFullGate) {
    const auto gobo = [](int number, float slot) {
        return fixture::WheelState{.wheel = wheel_number(number == 1 ? "Static gobos" : "Rotating gobos"),
                                   .number = number,
                                   .position = slot};
    };
    const auto split = [](float place) {
        return fixture::WheelState{.wheel = wheel_number("Colours"), .number = 1, .position = place};
    };
    const std::vector<fixture::Blade> blades{{0.45f, 0.2f}, {0.3f, 0.3f}, {0.1f, 0.4f}, {}};
    const std::vector<std::pair<const char*, std::function<void(Optics&)>>> gates{
        {"gobo", [&](Optics& optics) { optics.gobo_wheels = {gobo(1, 1)}; }},
        {"gobo and iris",
         [&](Optics& optics) {
             optics.gobo_wheels = {gobo(1, 1)};
             optics.iris = 0.5f;
         }},
        {"two gobos",
         [&](Optics& optics) {
             optics.gobo_wheels = {gobo(1, 1), gobo(2, 1)};
         }},
        {"blades", [&](Optics& optics) { optics.blades = blades; }},
        {"colours split", [&](Optics& optics) { optics.color_wheels = {split(0.3f)}; }},
        {"red and blue", [&](Optics& optics) { optics.color_wheels = {split(1.5f)}; }},
        {"colours split at the rim", [&](Optics& optics) { optics.color_wheels = {split(0.7f)}; }},
        {"gobo and blades",
         [&](Optics& optics) {
             optics.gobo_wheels = {gobo(1, 2)};
             optics.blades = blades;
         }},
    };
    double worst = 0;
    for (const auto& [name, put] : gates)
        for (const float zoom_deg : {12.0f, 30.0f}) {
            fixture::BeamState beam = open_beam();
            beam.optics.zoom_deg = zoom_deg;
            beam.optics.focus_m = 8;
            put(beam.optics);
            const double clear_lm = flux_lm(light_of(beam), 8.0, 700);
            for (const float frost_deg : {0.3f, 1.0f, 3.0f, 8.0f}) {
                beam.optics.frost = 1;
                beam.optics.frost_full_deg = frost_deg;
                const double fraction = flux_lm(light_of(beam), 8.0, 700) / clear_lm;
                std::printf("%s, %.0f deg, frost %.1f deg: %.4f of the light\n", name,
                            static_cast<double>(zoom_deg), static_cast<double>(frost_deg), fraction);
                worst = std::max(worst, std::abs(fraction - 1));
                beam.optics.frost = 0;
            }
        }
    EXPECT_LT(worst, 0.005);
}

// Out of focus a beam has the light that it has in focus, with frost and without, at any iris.
TEST(Frost, ConservesTheFluxOutOfFocus) {
    double worst_open = 0, worst_iris = 0, worst = 0;
    for (const float zoom_deg : {12.0f, 30.0f})
        for (const float iris : {1.0f, 0.5f, 0.1f}) {
            fixture::BeamState beam = open_beam();
            beam.optics.zoom_deg = zoom_deg;
            beam.optics.iris = iris;
            beam.optics.focus_m = 8;
            beam.optics.frost_full_deg = 8;
            const double sharp_lm = flux_lm(light_of(beam), 8.0, 900);
            for (const float focus_m : {2.6f, 5.0f, 50.0f})
                for (const float frost : {0.0f, 0.1f, 0.4f, 1.0f}) {
                    beam.optics.focus_m = focus_m;
                    beam.optics.frost = frost;
                    const double fraction = flux_lm(light_of(beam), 8.0, 900) / sharp_lm;
                    std::printf("%.0f deg, iris %.1f, focus %.1f m, frost %.1f deg: %.4f of the light\n",
                                static_cast<double>(zoom_deg), static_cast<double>(iris),
                                static_cast<double>(focus_m), 8 * static_cast<double>(frost), fraction);
                    double& most = frost > 0 ? worst : (iris < 1 ? worst_iris : worst_open);
                    most = std::max(most, std::abs(fraction - 1));
                }
        }
    EXPECT_LT(worst_iris, 0.005);
    EXPECT_LT(worst, 0.005);
    // The field falls where its rim is: what of it is beyond is weakened twice.
    EXPECT_LT(worst_open, 0.025);
}

// Fraction of the light within a radius, against a disc that is scattered by a Gaussian: a million rays.
TEST(Frost, SpreadsAsAGaussianDoes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    double worst = 0;
    for (const float sigma : {0.05f, 0.2f, 0.5f, 1.0f}) {
        const Profile clear = make_profile(18, 20, true);
        const Profile soft = frosted(clear, clear.aperture, sigma);
        std::normal_distribution<double> gauss(0, static_cast<double>(sigma));
        constexpr int kBins = 60;
        const double bin = 0.1;
        std::vector<double> traced(kBins), drawn(kBins);
        double traced_all = 0, drawn_all = 0;
        for (int k = 0; k < 400000; ++k) {
            const double r = std::sqrt(unit(random)), a = 6.283185307 * unit(random);
            const float shape = shared::beam_profile(static_cast<float>(r * r), clear.power, clear.scale) *
                                shared::beam_aperture(static_cast<float>(r), clear.aperture, clear.edge);
            const double x = r * std::cos(a) + gauss(random), y = r * std::sin(a) + gauss(random);
            const auto at = static_cast<std::size_t>(std::hypot(x, y) / bin);
            if (at < traced.size()) traced[at] += static_cast<double>(shape);
            traced_all += static_cast<double>(shape);
        }
        for (int k = 0; k < 6000; ++k) {
            const double r = (k + 0.5) * kBins * bin / 6000;
            const auto rf = static_cast<float>(r);
            if (rf >= soft.cut_radius) break;
            const double shape = static_cast<double>(shared::beam_profile(rf * rf, soft.power, soft.scale) *
                                                     shared::beam_aperture(rf, soft.aperture, soft.edge)) *
                                 r;
            drawn[static_cast<std::size_t>(r / bin)] += shape;
            drawn_all += shape;
        }
        double a = 0, b = 0, most = 0;
        for (int k = 0; k < kBins; ++k) {
            a += traced[static_cast<std::size_t>(k)] / traced_all;
            b += drawn[static_cast<std::size_t>(k)] / drawn_all;
            most = std::max(most, std::abs(a - b));
        }
        std::printf("frost of %.2f gate radii: light within a radius is off by %.1f %% at most\n",
                    static_cast<double>(sigma), 100 * most);
        worst = std::max(worst, most);
    }
    EXPECT_LT(worst, 0.05);
}

} // namespace
} // namespace ghost::scene
