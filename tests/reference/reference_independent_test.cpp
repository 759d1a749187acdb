// SPDX-License-Identifier: Apache-2.0
// The reference picture against ../shared/reference: scenes of Blender by an independent integrator that
// reads only their JSON and the gobo.
#include "reference/reference.h"
#include "stage/model_reader.h"
#include "support/test_stage.h"

#include "files/files.h"
#include "image/exr.h"
#include "image/ldr.h"

#include <cstdio>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ghost::bake {
namespace {
namespace fs = std::filesystem;
using glm::dvec3;
using nlohmann::json;

double d(float value) {
    return static_cast<double>(value);
}

const fs::path kShared = "../shared/reference";

class IndependentReference : public testing::TestWithParam<const char*> {};

dvec3 vec3_of(const json& list) {
    return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

// The spot of the JSON: smoothstep in the cosine, times the gobo, both as its "expected" has them.
BeamOverride blender_spot(const json& light, const image::Image8& gobo) {
    const double outer = light["cos_outer"];
    const double inner = light["cos_inner"];
    const double tan_half = std::tan(glm::radians(light["cone_full_deg"].get<double>() / 2));
    const dvec3 candela = light["I0_W_per_sr"].get<double>() * vec3_of(light["rgb"]);
    return [=](const dvec3& gate_m) {
        const double cosine = gate_m.z / glm::length(gate_m);
        if (!(cosine > outer)) return dvec3(0);
        const double t = std::min((cosine - outer) / (inner - outer), 1.0);
        const dvec3 open = candela * (t * t * (3 - 2 * t));
        if (gobo.empty()) return open;
        const double u = (0.5 + 0.5 * gate_m.x / gate_m.z / tan_half) * gobo.width - 0.5;
        const double v = (0.5 - 0.5 * gate_m.y / gate_m.z / tan_half) * gobo.height - 0.5;
        dvec3 through(0);
        for (int k = 0; k < 4; ++k) {
            const int x = static_cast<int>(std::floor(u)) + k % 2;
            const int y = static_cast<int>(std::floor(v)) + k / 2;
            const double weight = (1 - std::abs(u - x)) * (1 - std::abs(v - y));
            if (x < 0 || y < 0 || x >= gobo.width || y >= gobo.height) continue;
            const std::uint8_t* texel = gobo.at(x, y);
            through += weight / 255 * dvec3(texel[0], texel[1], texel[2]);
        }
        return open * through;
    };
}

TEST_P(IndependentReference, Reproduced) {
    const std::string name = GetParam();
    if (!fs::exists(kShared / (name + ".json")))
        GTEST_SKIP() << "no ../shared beside the checkout: nothing to compare with";
    const auto text = read_text_file(kShared / (name + ".json"), 1 << 20);
    const auto check_text = read_text_file(kShared / "check.json", 1 << 20);
    ASSERT_TRUE(text.ok() && check_text.ok());
    const json scene = json::parse(*text);
    const json check = json::parse(*check_text)[name];
    const auto theirs = image::read_exr(kShared / (name + ".numpy.exr"));
    ASSERT_TRUE(theirs.ok()) << theirs.error().text();

    Report report;
    auto stage = scene::load_stage_file(kShared / scene["geometry_glb"].get<std::string>(), report);
    ASSERT_TRUE(stage.ok()) << stage.error().text();
    // All in the primaries of the reference: light and paint are multiplied channel by channel.
    stage->materials.clear();
    int painted = 0;
    for (scene::Instance& instance : stage->instances)
        for (const json& object : scene["objects"])
            if (object["name"] == instance.name) {
                stage->meshes[static_cast<std::size_t>(instance.mesh)].material =
                    add_material(*stage, glm::vec3(vec3_of(object["material"]["base_color"])));
                ++painted;
            }
    ASSERT_EQ(painted, static_cast<int>(scene["objects"].size()));

    scene::Camera camera;
    const auto column = [&](const json& matrix, std::size_t c) {
        return glm::vec3(matrix[0][c].get<float>(), matrix[1][c].get<float>(), matrix[2][c].get<float>());
    };
    const json& m = scene["camera"]["matrix_world"];
    camera.position_m = column(m, 3);
    camera.target_m = column(m, 3) - column(m, 2);
    camera.fov_y_deg = scene["camera"]["fov_y_deg"].get<float>();
    camera.width = scene["resolution"][0];
    camera.height = scene["resolution"][1];
    const json& lamp = scene["light"]["matrix_world"];
    shared::Light light{};
    light.position_m = column(lamp, 3);
    light.axis_u = column(lamp, 0);
    light.axis_v = column(lamp, 1);
    light.axis_w = -column(lamp, 2);
    const auto sigma_s = scene["medium"]["sigma_s"].get<float>();
    const shared::Haze haze{sigma_s + scene["medium"]["sigma_a"].get<float>(), sigma_s,
                            scene["medium"]["g"].get<float>(), 0, 0};

    image::Image8 gobo;
    if (!scene["light"]["gobo"].is_null()) {
        auto read = image::read_ldr(kShared / scene["light"]["gobo"].get<std::string>());
        ASSERT_TRUE(read.ok()) << read.error().text();
        gobo = std::move(*read);
    }
    ReferenceOptions options;
    options.beam = blender_spot(scene["light"], gobo);
    options.air_samples = 1024; // times 4 x 4 positions in the pixel
    options.pixel_samples = 4;  // as theirs: with 2 x 2 the silhouettes alone leave 42 dB
    options.every = 4;          // so that the test takes seconds
    options.far_m = 30;
    const Tracer tracer(*stage);
    const auto ours = reference_picture(&tracer, camera, {light}, {}, haze, 0, options);
    ASSERT_TRUE(ours.ok()) << ours.error().text();

    const auto scale = check["preview_scale"].get<float>();
    double error = 0, sum_ours = 0, sum_theirs = 0;
    int compared = 0;
    for (int y = 0; y < ours->height; ++y)
        for (int x = 0; x < ours->width; ++x) {
            const double away = std::hypot(x * options.every + 0.5 - check["light_pixel"][0].get<double>(),
                                           y * options.every + 0.5 - check["light_pixel"][1].get<double>());
            if (away < 20) continue;
            for (int c = 0; c < 3; ++c) {
                const float a = ours->at(x, y)[c];
                const float b = theirs->pixels.at(x * options.every, y * options.every)[c];
                sum_ours += d(a);
                sum_theirs += d(b);
                const auto shown = [&](float v) {
                    return d(image::linear_to_srgb(std::clamp(v * scale, 0.0f, 1.0f)));
                };
                error += std::pow(shown(a) - shown(b), 2);
                ++compared;
            }
        }
    const double psnr = 10 * std::log10(compared / std::max(error, 1e-12));
    std::printf(
        "%s: display PSNR %.1f dB, mean ratio %.4f (every 4th pixel, 20 px round the lamp left out)\n",
        name.c_str(), psnr, sum_ours / sum_theirs);
    EXPECT_GT(psnr, 70);
    EXPECT_NEAR(sum_ours / sum_theirs, 1, 0.001);
}

INSTANTIATE_TEST_SUITE_P(Scenes, IndependentReference,
                         testing::Values("A_side_plain", "A_side_gobo", "B_back_plain", "B_back_gobo"),
                         [](const auto& picture) { return std::string(picture.param); });

} // namespace
} // namespace ghost::bake
