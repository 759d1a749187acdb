// SPDX-License-Identifier: Apache-2.0
#include "stage/overrides.h"

#include "base/name_index.h"
#include "base/suggest.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxSuggested = 2000; // names that are looked at for a near one

using Look = int; // index into a list of merged settings; 0: as in the model
constexpr Look kUnused = -1;
constexpr Look kMixed = -2;

std::vector<std::string> names_of(const Stage& stage) {
    std::set<std::string> unique;
    const auto add = [&](const std::string& name) {
        if (unique.size() < kMaxSuggested && !name.empty()) unique.insert(name);
    };
    for (const Material& material : stage.materials) add(material.name);
    for (const Instance& instance : stage.instances) add(instance.name);
    for (const Mesh& mesh : stage.meshes) add(mesh.name);
    return {unique.begin(), unique.end()};
}

// ", did you mean ...": the name that matches but for capitals, or the nearest.
std::string near_name(const std::vector<std::string>& names, const std::string& pattern,
                      Suggestions& suggestions, std::uint64_t& steps) {
    const std::string small = lower(pattern);
    for (const std::string& name : names)
        if (matches(small, lower(name), steps)) return ", did you mean '" + name + "'? (capitals count)";
    std::string letters;
    for (const char c : pattern)
        if (c != '*' && c != '?') letters += c;
    std::string near = suggestions.did_you_mean(letters, names);
    if (!near.empty() || letters.empty()) return near;
    for (const std::string& name : names)
        if (matches("*" + small + "*", lower(name), steps)) return ", did you mean '" + name + "'?";
    return "";
}

bool changes_surface(const ObjectSettings& settings) {
    return settings.diffuse || settings.diffuse_factor || settings.specular || settings.roughness ||
           settings.metalness;
}

template <class Value>
void take(std::optional<Value>& target, const std::optional<Value>& value) {
    if (value) target = value;
}

ObjectSettings merged(ObjectSettings under, const ObjectSettings& over) {
    if (over.diffuse || over.diffuse_factor) {
        under.diffuse = over.diffuse;
        under.diffuse_factor = over.diffuse_factor;
    }
    take(under.specular, over.specular);
    take(under.roughness, over.roughness);
    take(under.metalness, over.metalness);
    return under;
}

void change(Material& material, const ObjectSettings& settings) {
    if (settings.diffuse) material.base_colour = *settings.diffuse;
    // More than all of the light cannot come back.
    if (settings.diffuse_factor)
        material.base_colour = glm::min(material.base_colour * *settings.diffuse_factor, glm::vec3(1.0f));
    material.specular = settings.specular.value_or(material.specular);
    material.roughness = settings.roughness.value_or(material.roughness);
    material.metalness = settings.metalness.value_or(material.metalness);
}

class Overrides {
public:
    explicit Overrides(Stage& stage)
        : stage_(stage), looks_(1), look_of_(stage.instances.size(), 0), move_of_(stage.instances.size()) {
        for (std::size_t k = 0; k < stage.instances.size(); ++k) {
            if (!has_mesh(k)) continue;
            names_[0].add(stage.instances[k].name, k);
            names_[1].add(stage.meshes[mesh_index(k)].name, k);
            names_[2].add(stage.materials[material_index(k)].name, k);
        }
    }

    // False where nothing has this name.
    bool add(const ObjectSettings& settings, std::size_t number, std::uint64_t& steps) {
        for (const NameIndex& names : names_) {
            const std::vector<std::size_t> found = names.find(settings.name, steps);
            for (const std::size_t k : found) {
                if (settings.shown) stage_.instances[k].shown = *settings.shown;
                if (settings.move_m) move_of_[k] = *settings.move_m;
                if (changes_surface(settings)) look_of_[k] = next_look(look_of_[k], settings, number);
            }
            if (!found.empty()) return true;
        }
        return false;
    }

    void finish() {
        for (std::size_t k = 0; k < move_of_.size(); ++k)
            stage_.instances[k].world[3] += glm::vec4(move_of_[k], 0.0f);
        // A mesh or material that all its users want alike changes in place.
        std::vector<Look> mesh_look(stage_.meshes.size(), kUnused);
        std::vector<Look> material_look(stage_.materials.size(), kUnused);
        std::vector<int> material_of;
        for (const Mesh& mesh : stage_.meshes) material_of.push_back(mesh.material);
        const auto note = [](Look& known, Look look) {
            known = known == kUnused || known == look ? look : kMixed;
        };
        for (std::size_t k = 0; k < look_of_.size(); ++k) {
            if (!has_mesh(k)) continue;
            note(mesh_look[mesh_index(k)], look_of_[k]);
            note(material_look[material_index(k)], look_of_[k]);
        }
        std::map<std::pair<int, Look>, int> materials;
        std::map<std::pair<int, Look>, int> meshes;
        for (std::size_t k = 0; k < look_of_.size(); ++k) {
            const Look look = look_of_[k];
            if (look == 0) continue;
            const int mesh = stage_.instances[k].mesh;
            const auto [known, is_new] = meshes.try_emplace({mesh, look}, mesh);
            if (is_new) {
                const int old = material_of[static_cast<std::size_t>(mesh)];
                const int material = changed_material(
                    old, look, material_look[static_cast<std::size_t>(old)] == look, materials);
                if (mesh_look[static_cast<std::size_t>(mesh)] != look) {
                    known->second = static_cast<int>(stage_.meshes.size());
                    stage_.meshes.push_back(Mesh(stage_.meshes[static_cast<std::size_t>(mesh)]));
                }
                stage_.meshes[static_cast<std::size_t>(known->second)].material = material;
            }
            stage_.instances[k].mesh = known->second;
        }
    }

private:
    std::size_t mesh_index(std::size_t k) const { return static_cast<std::size_t>(stage_.instances[k].mesh); }
    std::size_t material_index(std::size_t k) const {
        return static_cast<std::size_t>(stage_.meshes[mesh_index(k)].material);
    }
    bool has_mesh(std::size_t k) const {
        return mesh_index(k) < stage_.meshes.size() && material_index(k) < stage_.materials.size();
    }

    Look next_look(Look look, const ObjectSettings& settings, std::size_t number) {
        const auto [known, is_new] = next_.try_emplace({look, number}, static_cast<Look>(looks_.size()));
        if (is_new) looks_.push_back(merged(looks_[static_cast<std::size_t>(look)], settings));
        return known->second;
    }

    int changed_material(int old, Look look, bool in_place, std::map<std::pair<int, Look>, int>& done) {
        const auto [known, is_new] = done.try_emplace({old, look}, old);
        if (!is_new) return known->second;
        if (!in_place) {
            known->second = static_cast<int>(stage_.materials.size());
            stage_.materials.push_back(Material(stage_.materials[static_cast<std::size_t>(old)]));
        }
        change(stage_.materials[static_cast<std::size_t>(known->second)],
               looks_[static_cast<std::size_t>(look)]);
        return known->second;
    }

    Stage& stage_;
    std::array<NameIndex, 3> names_; // of objects, meshes, materials: views of stage_, until finish()
    std::vector<ObjectSettings> looks_;
    std::map<std::pair<Look, std::size_t>, Look> next_; // a look and the entry on top of it
    std::vector<Look> look_of_;                         // per instance
    std::vector<glm::vec3> move_of_;
};

} // namespace

float roughness_from_shininess(float shininess) {
    return std::pow(2.0f / (shininess + 2.0f), 0.25f);
}

void apply_objects(Stage& stage, const std::vector<ObjectSettings>& objects, Report& report) {
    if (objects.empty()) return;
    Overrides overrides(stage);
    const std::vector<std::string> names = names_of(stage);
    Suggestions suggestions;
    std::uint64_t steps = kMostMatchSteps, to_suggest = kMostMatchSteps / 10;
    for (std::size_t k = 0; k < objects.size(); ++k) {
        const ObjectSettings& settings = objects[k];
        const bool is_there = overrides.add(settings, k, steps);
        if (steps == 0) {
            report.add(Severity::error, settings.where, std::string("[[object]] ") + kMatchStepsSpent);
            break;
        }
        if (!is_there)
            report.add(Severity::warning, settings.where,
                       "[[object]] name '" + settings.name.substr(0, 80) +
                           "' is that of no object, mesh or material of the stage" +
                           near_name(names, settings.name, suggestions, to_suggest));
    }
    overrides.finish();
}

Stage visible(Stage stage) {
    std::erase_if(stage.instances, [](const Instance& instance) { return !instance.shown; });
    return stage;
}

} // namespace ghost::scene
