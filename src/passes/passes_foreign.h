#pragma once
// SPDX-License-Identifier: Apache-2.0
// passes.toml (docs/reference/foreign-passes.md): what it says, without the pictures. load_foreign_passes
// (passes.h) reads those too. Metres, Z up, camera as columns right, up, backward, eye. Pure.

#include "base/report.h"
#include "base/result.h"
#include "image/colour.h"

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

struct ForeignLight {
    std::string name;
    int stop = 0;
    std::filesystem::path file; // as written
    glm::vec3 position_m{0};
    float intensity_cd = 1;
    int line = 0;
};

struct ForeignPasses {
    std::filesystem::path position; // as written
    bool y_up = false;              // of the position picture; the numbers here are turned already
    image::Chromaticities primaries = image::kRec709;
    glm::mat4 camera_to_world{1.0f};
    float fov_y_deg = 40;
    std::vector<ForeignLight> lights;
};

// y up (glTF) to z up.
glm::vec3 z_up(const glm::vec3& y_up);

// Error: not TOML, or without position picture or camera matrix. All else goes to the report with its line.
Result<ForeignPasses> parse_foreign_passes(std::string_view text, const std::string& file, Report& report);

} // namespace ghost::scene
