#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a show changes about objects of its stage without touching the model: surface, place, seen or not
// ([[object]] in docs/reference/show-file.md). Metres, Z up; colours linear Rec.2020. Pure functions; what
// matches nothing goes to the report.

#include "base/report.h"
#include "stage/stage.h"

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

struct ObjectSettings {
    std::string name;                    // pattern: * any letters, ? one letter
    std::string where;                   // file:line, for messages
    std::optional<glm::vec3> diffuse;    // instead of the base colour
    std::optional<float> diffuse_factor; // or times it
    std::optional<float> specular;
    std::optional<float> roughness;
    std::optional<float> metalness;
    std::optional<bool> shown;
    std::optional<glm::vec3> move_m;
};

// GGX roughness (perceptual, as in Material) whose highlight is as wide as that of a Blinn-Phong exponent:
// alpha = sqrt(2 / (shininess + 2)) (Walter et al. 2007), roughness = sqrt(alpha).
float roughness_from_shininess(float shininess);

// Each entry changes the objects of that name; where there is none, those with a mesh of that name; else
// those with a material of that name. Later entries win, key by key. Materials and meshes that other objects
// share are copied. Hidden objects stay in the list with shown = false.
void apply_objects(Stage& stage, const std::vector<ObjectSettings>& objects, Report& report);

// Without the hidden objects: what casts shadows and is drawn.
Stage visible(Stage stage);

} // namespace ghost::scene
