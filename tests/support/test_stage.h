#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hand-made stages, lights and measures for the tests of the baker.

#include "bake/frame.h"
#include "image/image.h"
#include "passes/passes.h"
#include "passes/passes_file.h"
#include "rays/tracer.h"
#include "shared/types.h"
#include "stage/stage.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

namespace ghost::bake {

inline int add_material(scene::Stage& stage, const glm::vec3& colour, float specular = 0.0f,
                        float roughness = 1.0f) {
    scene::Material material;
    material.base_colour = colour;
    material.specular = specular;
    material.roughness = roughness;
    stage.materials.push_back(material);
    return static_cast<int>(stage.materials.size()) - 1;
}

inline int add_mesh(scene::Stage& stage, scene::Mesh mesh, int material) {
    mesh.material = material;
    stage.meshes.push_back(std::move(mesh));
    return static_cast<int>(stage.meshes.size()) - 1;
}

inline void place(scene::Stage& stage, int mesh, const glm::mat4& world = glm::mat4(1.0f),
                  int fixture = scene::kNone) {
    stage.instances.push_back({"", mesh, world, fixture});
}

// Corner, then two edges; the normal is a x b. uv runs 0..1 along the edges, v down.
inline scene::Mesh quad_mesh(const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b) {
    scene::Mesh mesh;
    mesh.positions = {corner, corner + a, corner + a + b, corner + b};
    mesh.normals.assign(4, glm::normalize(glm::cross(a, b)));
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

inline scene::Mesh box_mesh(const glm::vec3& half) {
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 n(0), a(0), b(0);
            n[axis] = side;
            a[(axis + 1) % 3] = 1;
            b = glm::cross(n, a);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
                mesh.positions.push_back((n + a * static_cast<float>(s) + b * static_cast<float>(t)) * half);
                mesh.normals.push_back(n);
                mesh.uvs.emplace_back(0.5f + 0.5f * static_cast<float>(s),
                                      0.5f - 0.5f * static_cast<float>(t));
            }
            for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
        }
    return mesh;
}

inline scene::Mesh sphere_mesh(float radius, int rings) {
    scene::Mesh mesh;
    const int columns = 2 * rings;
    for (int r = 0; r <= rings; ++r)
        for (int c = 0; c <= columns; ++c) {
            const float theta = shared::kPi * static_cast<float>(r) / static_cast<float>(rings);
            const float phi = 2 * shared::kPi * static_cast<float>(c) / static_cast<float>(columns);
            const glm::vec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta));
            mesh.positions.push_back(n * radius);
            mesh.normals.push_back(n);
            mesh.uvs.emplace_back(static_cast<float>(c) / static_cast<float>(columns),
                                  static_cast<float>(r) / static_cast<float>(rings));
        }
    for (int r = 0; r < rings; ++r)
        for (int c = 0; c < columns; ++c) {
            const auto a = static_cast<std::uint32_t>(r * (columns + 1) + c);
            const auto b = a + static_cast<std::uint32_t>(columns) + 1;
            for (const std::uint32_t k : {a, b, b + 1, a, b + 1, a + 1}) mesh.indices.push_back(k);
        }
    return mesh;
}

// A small stage with what makes edges hard: thin bars before a far wall, spheres, boxes, a floor seen at a
// low angle.
inline scene::Stage edgy_stage() {
    scene::Stage stage;
    const int light = add_material(stage, {0.7f, 0.7f, 0.7f}, 1.0f, 0.8f);
    const int dark = add_material(stage, {0.25f, 0.1f, 0.08f}, 1.0f, 0.5f);
    const int shiny = add_material(stage, {0.5f, 0.5f, 0.55f}, 1.0f, 0.35f);
    place(stage, add_mesh(stage, quad_mesh({-9, -2, 0}, {18, 0, 0}, {0, 14, 0}), shiny));
    place(stage, add_mesh(stage, quad_mesh({-9, 12, 0}, {18, 0, 0}, {0, 0, 8}), light));
    const int ball = add_mesh(stage, sphere_mesh(0.5f, 24), light);
    const int bar = add_mesh(stage, box_mesh({0.03f, 0.03f, 3}), light);
    const int crate = add_mesh(stage, box_mesh({0.5f, 0.4f, 0.6f}), dark);
    const auto at = [](float x, float y, float z) {
        return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
    };
    for (int k = 0; k < 7; ++k) {
        const float x = -4.5f + 1.5f * static_cast<float>(k);
        place(stage, bar, at(x, 3, 3) * glm::rotate(glm::mat4(1.0f), 0.12f * x, glm::vec3(0, 1, 0)));
        place(stage, ball,
              at(x + 0.6f, 4 + 0.5f * static_cast<float>(k % 3), 0.9f + 0.5f * static_cast<float>(k % 2)));
        if (k % 2 == 0) place(stage, crate, at(x + 0.2f, 6, 0.6f));
    }
    return stage;
}

inline scene::Camera edgy_camera(int width, int height) {
    scene::Camera camera;
    camera.name = "front";
    camera.position_m = {0, -9, 1.9f};
    camera.target_m = {0, 5, 1.9f};
    camera.fov_y_deg = 32;
    camera.width = width;
    camera.height = height;
    return camera;
}

// A hard-edged spot.
inline shared::Light spot(const glm::vec3& from, const glm::vec3& to, float half_angle_deg,
                          std::uint32_t pass) {
    shared::Light light{};
    light.position_m = from;
    light.axis_w = glm::normalize(to - from);
    light.axis_u = glm::normalize(
        glm::cross(light.axis_w, std::abs(light.axis_w.z) > 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1)));
    light.axis_v = glm::cross(light.axis_u, light.axis_w);
    light.tan_field = std::tan(glm::radians(half_angle_deg));
    light.cut_radius = 1.1f;
    light.profile_power = 4.0f;
    light.profile_scale = 1.0f;
    light.intensity_cd = glm::vec3(1000.0f);
    light.colour_b = glm::vec3(1.0f);
    light.split = shared::kNoSplit;
    light.iris_radius = 1.0f;
    light.edge = 0.04f;
    light.focus_per_m = 0.1f;
    light.lens_radius_m = 0.05f;
    light.pass = pass;
    return light;
}

// What load_passes would give, without the disk.
inline scene::Passes passes_of(const Frame& frame, const scene::Camera& camera,
                               const std::vector<glm::vec3>& lights_m) {
    scene::Passes passes;
    passes.width = frame.width;
    passes.height = frame.height;
    passes.camera_to_world = scene::camera_to_world(camera);
    passes.fov_y_deg = camera.fov_y_deg;
    passes.extra_first = frame.extra_first;
    passes.fragments = frame.fragments;
    for (std::size_t k = 0; k < lights_m.size(); ++k) {
        scene::LightPass pass;
        pass.fixture = std::to_string(k);
        pass.position_m = lights_m[k];
        for (const glm::vec3& value : frame.lights[k]) {
            for (int c = 0; c < 3; ++c)
                pass.radiance.push_back(scene::to_half(value[c] * scene::kRadianceScale));
            pass.radiance.push_back(0);
        }
        passes.lights.push_back(std::move(pass));
    }
    return passes;
}

// The paper's own form of the same bake: whole pictures and the position of each pixel's centre.
inline scene::Passes plain_passes_of(const Frame& frame, const scene::Camera& camera,
                                     const std::vector<glm::vec3>& lights_m) {
    Frame plain = frame;
    const std::size_t pixels = frame.centre_position.size();
    plain.extra_first.assign(pixels + 1, 0);
    plain.fragments.resize(pixels);
    for (std::size_t p = 0; p < pixels; ++p)
        plain.fragments[p] =
            frame.centre_position[p].w > 0 ? frame.centre_position[p] : glm::vec4(0, 0, 0, -1);
    const scene::FragmentTable table{frame.width, frame.height, frame.extra_first, frame.fragments};
    for (std::size_t k = 0; k < frame.lights.size(); ++k)
        plain.lights[k] = scene::to_stored(table, frame.lights[k]).whole;
    return passes_of(plain, camera, lights_m);
}

} // namespace ghost::bake
