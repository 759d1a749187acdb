#pragma once
// SPDX-License-Identifier: Apache-2.0
// Stages that nobody would build, by number: rooms and fields, with holes, inside out, one in the other,
// white as nothing is, half a kilometre long; lamps in them, behind walls and inside of things; haze of any
// density. The same number gives the same stage.

#include "support/test_stage.h"

#include <string>

namespace ghost::bake {

class Chance {
public:
    explicit Chance(std::uint32_t seed) : state_(seed * 0x9e3779b97f4a7c15ull + 1) {}
    float in(float low, float high) { return low + (high - low) * unit(); }
    int below(int count) { return std::min(static_cast<int>(unit() * static_cast<float>(count)), count - 1); }
    bool one_in(int count) { return below(count) == 0; }
    glm::vec3 within(const glm::vec3& low, const glm::vec3& high) {
        const float x = unit(), y = unit(), z = unit();
        return low + (high - low) * glm::vec3(x, y, z);
    }

private:
    float unit() { // SplitMix64
        std::uint64_t mixed = state_ += 0x9e3779b97f4a7c15ull;
        mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ull;
        mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebull;
        return static_cast<float>((mixed ^ (mixed >> 31)) >> 40) * 0x1p-24f;
    }
    std::uint64_t state_;
};

struct RandomStage {
    std::string kind;
    scene::Stage stage;
    std::vector<shared::Light> lights;
    std::vector<shared::Haze> hazes; // one after the other
};

inline void turn_inside_out(scene::Mesh& mesh) {
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3)
        std::swap(mesh.indices[k], mesh.indices[k + 1]);
}

inline void tear_holes(scene::Mesh& mesh, Chance& chance) {
    std::vector<std::uint32_t> kept;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3)
        if (!chance.one_in(3)) kept.insert(kept.end(), &mesh.indices[k], &mesh.indices[k] + 3);
    mesh.indices = kept;
}

inline int random_material(scene::Stage& stage, Chance& chance) {
    const glm::vec3 colour = chance.one_in(3) ? glm::vec3(1) : chance.within(glm::vec3(0), glm::vec3(1));
    const int made = add_material(stage, colour, chance.one_in(2) ? 0.0f : 1.0f, chance.in(0.02f, 1));
    if (chance.one_in(4)) stage.materials.back().metalness = 1;
    if (chance.one_in(4)) stage.materials.back().emission = glm::vec3(chance.in(0, 500));
    stage.materials.back().double_sided = !chance.one_in(3);
    return made;
}

inline shared::Haze random_haze(Chance& chance) {
    switch (chance.below(5)) {
    case 0:
        return {};
    case 1:
        return {0.02f, 0.02f, 0.77f, -0.2f, 0.1f};
    case 2:
        return {3, 3, 0, 0, 0}; // absorbs nothing
    case 3:
        return {1, 0, 0, 0, 0}; // scatters nothing
    default:
        break;
    }
    const float extinction = std::pow(10.0f, chance.in(-4, 1));
    return {extinction, extinction * chance.in(0, 1), chance.in(-0.9f, 0.95f), chance.in(-0.9f, 0.9f),
            chance.in(0, 1)};
}

inline RandomStage random_stage(std::uint32_t seed) {
    Chance chance(seed);
    RandomStage made;
    static const char* const kKinds[] = {"room",           "field",           "room inside out",
                                         "rooms in rooms", "room with holes", "500 m",
                                         "nothing",        "loose triangles"};
    const std::uint32_t kind = seed % 8;
    made.kind = kKinds[kind];
    scene::Stage& stage = made.stage;
    glm::vec3 half_m = chance.within(glm::vec3(1, 1, 1), glm::vec3(12, 12, 6));
    if (kind == 5) half_m = {250, chance.in(5, 250), chance.in(3, 15)};
    const glm::vec3 middle_m(chance.in(-20, 20), chance.in(-20, 20), half_m.z);
    const glm::mat4 at = glm::translate(glm::mat4(1.0f), middle_m);
    if (kind == 1)
        place(stage, add_mesh(stage, quad_mesh({-500, -500, 0}, {1000, 0, 0}, {0, 1000, 0}),
                              random_material(stage, chance)));
    else if (kind != 6 && kind != 7)
        place(stage, add_mesh(stage, box_mesh(half_m), random_material(stage, chance)), at);
    if (kind == 2) turn_inside_out(stage.meshes[0]);
    if (kind == 4) tear_holes(stage.meshes[0], chance);
    if (kind == 3)
        for (float part = 0.8f; part > 0.1f; part *= chance.in(0.3f, 0.95f))
            place(stage, 0, glm::scale(at, glm::vec3(part)));
    const int things = kind == 6 ? 0 : chance.below(12);
    for (int k = 0; k < things; ++k) {
        const glm::vec3 size_m = chance.within(glm::vec3(0), half_m * 0.4f);
        scene::Mesh mesh = chance.one_in(3)
                               ? sphere_mesh(size_m.x, 8)
                               : box_mesh(chance.one_in(4) ? size_m * glm::vec3(1, 1, 0) : size_m);
        if (kind == 7)
            mesh = quad_mesh(-size_m, chance.within(-half_m, half_m), chance.within(-half_m, half_m));
        if (chance.one_in(4)) turn_inside_out(mesh);
        if (chance.one_in(4)) tear_holes(mesh, chance);
        const glm::vec3 place_m = middle_m + chance.within(-half_m, half_m);
        place(stage, add_mesh(stage, std::move(mesh), random_material(stage, chance)),
              glm::rotate(glm::translate(glm::mat4(1.0f), place_m), chance.in(0, 6),
                          glm::normalize(chance.within(glm::vec3(0.1f), glm::vec3(1)))));
    }
    const int lamps = 1 + chance.below(4);
    for (int k = 0; k < lamps; ++k) {
        const float reach = chance.one_in(4) ? 1.3f : 0.95f; // beyond a wall, too
        const glm::vec3 place_m = middle_m + chance.within(-half_m, half_m) * reach;
        shared::Light light = spot(place_m, middle_m + chance.within(-half_m, half_m), chance.in(1, 60),
                                   static_cast<std::uint32_t>(k));
        light.intensity_cd = chance.within(glm::vec3(0), glm::vec3(std::pow(10.0f, chance.in(0, 7))));
        if (chance.one_in(4)) light.intensity_cd.y = 0;
        made.lights.push_back(light);
    }
    for (int k = 0; k < 3; ++k) made.hazes.push_back(random_haze(chance));
    return made;
}

} // namespace ghost::bake
