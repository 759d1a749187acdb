#pragma once
// SPDX-License-Identifier: Apache-2.0
// A scene of tests/references or ../shared/reference as its JSON has it: stage, camera, spot, gobo, haze and
// the picture of the independent integrator. The spot's own profile (a smoothstep of the cosine) and its gobo
// become one picture in the gate, with a flat profile of ours; all stays in the primaries of the reference,
// in which light and paint are multiplied channel by channel.

#include "bounce/bounce_box.h"
#include "disk/files.h"
#include "image/exr.h"
#include "image/ldr.h"
#include "shared/gobos.h"
#include "show/show.h"
#include "stage/model_reader.h"
#include "support/likeness.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace ghost {

// Those of our own are always there.
struct ReferenceName {
    const char* folder;
    const char* name;

    std::string path(const std::string& ending) const { return std::string(folder) + "/" + name + ending; }
    bool is_missing() const {
        return std::string(folder).starts_with("..") && !std::filesystem::exists(path(".json"));
    }
};
inline constexpr const char* kOwnReferences = "tests/references"; // by tools/make_references.py
inline constexpr const char* kSharedReferences = "../shared/reference";
inline constexpr const char* kNoShared = "no ../shared beside the checkout: nothing to compare with";

// Transmission of the gate at a place -1..1: profile times gobo, both as tools/make_references.py has them.
class ReferenceGate {
public:
    ReferenceGate(const nlohmann::json& light, image::Image8 gobo)
        : outer_(light["cos_outer"]), inner_(light["cos_inner"]),
          tan_half_(std::tan(glm::radians(light["cone_full_deg"].get<double>() / 2))),
          gobo_(std::move(gobo)) {}

    double tan_half() const { return tan_half_; }
    glm::dvec3 at(const glm::dvec2& gate) const {
        const double cosine = 1 / std::sqrt(1 + glm::dot(gate, gate) * tan_half_ * tan_half_);
        if (!(cosine > outer_)) return glm::dvec3(0);
        const double t = std::min((cosine - outer_) / (inner_ - outer_), 1.0);
        const double open = t * t * (3 - 2 * t);
        if (gobo_.empty()) return glm::dvec3(open);
        const double u = (0.5 + 0.5 * gate.x) * gobo_.width - 0.5;
        const double v = (0.5 - 0.5 * gate.y) * gobo_.height - 0.5;
        glm::dvec3 through(0);
        for (int k = 0; k < 4; ++k) {
            const int x = static_cast<int>(std::floor(u)) + k % 2;
            const int y = static_cast<int>(std::floor(v)) + k / 2;
            const double weight = (1 - std::abs(u - x)) * (1 - std::abs(v - y));
            if (x < 0 || y < 0 || x >= gobo_.width || y >= gobo_.height) continue;
            const std::uint8_t* texel = gobo_.at(x, y);
            through += weight / 255 * glm::dvec3(texel[0], texel[1], texel[2]);
        }
        return open * through;
    }

private:
    double outer_;
    double inner_;
    double tan_half_;
    image::Image8 gobo_;
};

struct ReferenceScene {
    scene::Stage stage;
    scene::Camera camera;
    shared::Light light{};
    std::optional<ReferenceGate> gate;
    shared::Gobos gobos; // the gate's picture
    shared::Haze haze{};
    scene::BounceBox air; // where there is haze
    image::ImageF theirs; // light that was scattered once
    float preview_scale = 1;
    std::vector<image::Circle> left_out; // round the lamp, where 1/d^2 decides all
};

// Layer 1: the gate's picture, each texel the mean over its square.
inline shared::Gobos gate_picture(const ReferenceGate& gate) {
    constexpr int kPerTexel = 4;
    shared::Gobos gobos;
    gobos.layers = 2;
    std::vector<glm::dvec3> level;
    for (int y = 0; y < shared::kGoboSize; ++y)
        for (int x = 0; x < shared::kGoboSize; ++x) {
            glm::dvec3 sum(0);
            for (int k = 0; k < kPerTexel * kPerTexel; ++k) {
                const int row = k / kPerTexel;
                sum += gate.at({2 * (x + (k % kPerTexel + 0.5) / kPerTexel) / shared::kGoboSize - 1,
                                1 - 2 * (y + (row + 0.5) / kPerTexel) / shared::kGoboSize});
            }
            level.push_back(sum / static_cast<double>(kPerTexel * kPerTexel));
        }
    for (int k = 0, side = shared::kGoboSize; k < shared::kGoboLevels; ++k, side /= 2) {
        std::vector<std::uint32_t>& texels = gobos.texels[k];
        texels.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                      shared::gobo_code(glm::vec3(1.0f))); // open
        for (const glm::dvec3& value : level) texels.push_back(shared::gobo_code(glm::vec3(value)));
        std::vector<glm::dvec3> half;
        const auto at = [&](int x, int y) {
            return level[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                         static_cast<std::size_t>(x)];
        };
        for (int y = 0; y < side / 2; ++y)
            for (int x = 0; x < side / 2; ++x)
                half.push_back((at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) +
                                at(2 * x + 1, 2 * y + 1)) /
                               4.0);
        level = std::move(half);
    }
    return gobos;
}

inline void read_reference(const ReferenceName& wanted, ReferenceScene& made) {
    using nlohmann::json;
    const std::filesystem::path folder = wanted.folder;
    const json scene = json::parse(must(read_text_file(wanted.path(".json"), 1 << 20)));
    const json check = json::parse(must(read_text_file(folder / "check.json", 1 << 20)))[wanted.name];
    made.theirs = must(image::read_exr(wanted.path(".numpy.exr"))).pixels;
    made.preview_scale = check["preview_scale"];
    const float scale = static_cast<float>(made.theirs.width) / 512;
    made.left_out = {{check["light_pixel"][0], check["light_pixel"][1], 20 * scale}};

    Report report;
    made.stage = must(scene::load_stage_file(folder / scene["geometry_glb"].get<std::string>(), report));
    made.stage.materials.clear();
    const auto vec3_of = [](const json& list) {
        return glm::vec3(list[0].get<float>(), list[1].get<float>(), list[2].get<float>());
    };
    std::size_t painted = 0;
    for (scene::Instance& instance : made.stage.instances)
        for (const json& object : scene["objects"])
            if (object["name"] == instance.name) {
                scene::Material material;
                material.base_colour = vec3_of(object["material"]["base_color"]);
                material.specular = 0;
                made.stage.meshes[static_cast<std::size_t>(instance.mesh)].material =
                    static_cast<int>(made.stage.materials.size());
                made.stage.materials.push_back(material);
                ++painted;
            }
    ASSERT_EQ(painted, scene["objects"].size());

    const auto column = [&](const json& matrix, std::size_t c) {
        return glm::vec3(matrix[0][c].get<float>(), matrix[1][c].get<float>(), matrix[2][c].get<float>());
    };
    const json& m = scene["camera"]["matrix_world"];
    made.camera.position_m = column(m, 3);
    made.camera.target_m = column(m, 3) - column(m, 2);
    made.camera.fov_y_deg = scene["camera"]["fov_y_deg"];
    made.camera.width = scene["resolution"][0];
    made.camera.height = scene["resolution"][1];

    const json& lamp = scene["light"]["matrix_world"];
    shared::Light& light = made.light;
    light.position_m = column(lamp, 3);
    light.axis_u = column(lamp, 0);
    light.axis_v = column(lamp, 1);
    light.axis_w = -column(lamp, 2);
    light.tan_field = std::tan(glm::radians(scene["light"]["cone_full_deg"].get<float>() / 2));
    light.cut_radius = 1;
    light.profile_power = 1;
    light.profile_scale = 0;
    light.intensity_cd = scene["light"]["I0_W_per_sr"].get<float>() * vec3_of(scene["light"]["rgb"]);
    light.colour_b = glm::vec3(1);
    light.split = shared::kNoSplit;
    light.iris_radius = 2;
    light.edge = 1e-4f;
    light.focus_per_m = 0.1f;
    light.wheel[0] = {1, 1, 0, 1, 0, 0};
    light.wheel_count = 1;
    light.haze_samples = 10;

    const auto sigma_s = scene["medium"]["sigma_s"].get<float>();
    made.haze = {sigma_s + scene["medium"]["sigma_a"].get<float>(), sigma_s,
                 scene["medium"]["g"].get<float>(), 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        made.air.low_m[axis] = scene["medium"]["domain_min"][static_cast<std::size_t>(axis)];
        made.air.high_m[axis] = scene["medium"]["domain_max"][static_cast<std::size_t>(axis)];
    }
    image::Image8 gobo;
    if (!scene["light"]["gobo"].is_null())
        gobo = must(image::read_ldr(folder / scene["light"]["gobo"].get<std::string>()));
    made.gate.emplace(scene["light"], std::move(gobo));
    made.gobos = gate_picture(*made.gate);
}

struct DisplayFigures {
    double psnr_db = 0;
    double mean_ratio = 0;
};

// As a display shows it.
inline DisplayFigures compare_displayed(const ReferenceScene& scene, const image::ImageF& ours) {
    const image::PicturePair pair = pair_of(ours, scene.theirs, scene.left_out);
    return {image::psnr_db(pair, srgb_curve(scene.preview_scale)), 1 + image::relative_errors(pair).bias};
}

} // namespace ghost
