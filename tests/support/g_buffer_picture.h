#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a G-buffer made, read back, and what holds for every one of them. Small stages to draw.

#include "render/geometry/g_buffer.h"
#include "shared/g_buffer.h"
#include "shared/push.h"
#include "support/test_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

namespace ghost::render {

// Everything that a G-buffer made, in C++.
struct Picture {
    Fragments const* fragments = nullptr;
    std::uint32_t extras = 0;
    std::uint32_t dropped = 0;
    std::vector<glm::vec4> places, base, diffuse, specular, normals, bounds;
    glm::vec3 normal(std::size_t fragment) const {
        return shared::unpack_normal(glm::vec2(normals[fragment]));
    }
    glm::vec3 facet(std::size_t fragment) const {
        return shared::unpack_normal({normals[fragment].z, normals[fragment].w});
    }
    std::vector<glm::uvec2> edges;

    std::size_t pixels() const { return std::size_t{fragments->width} * fragments->height; }
    // Indices of the fragments of a pixel, the main one first.
    std::vector<std::size_t> of(std::size_t pixel) const {
        std::vector<std::size_t> all{pixel};
        for (std::size_t e = 0; e < fragments->edge_count; ++e)
            if (edges[e].x == pixel)
                for (std::uint32_t k = 0; k < (edges[e].y & 3u); ++k)
                    all.push_back(pixels() + (edges[e].y >> 2) + k);
        return all;
    }
    float coverage(std::size_t pixel) const {
        float sum = 0;
        for (const std::size_t k : of(pixel)) sum += std::max(places[k].w, 0.0f);
        return sum;
    }
};

inline std::vector<std::uint8_t> read(const gpu::Texture& texture, std::size_t texel_bytes) {
    const std::size_t bytes = texel_bytes * texture.shape().width * texture.shape().height;
    const gpu::Buffer buffer(device(), bytes, gpu::Access::readback);
    gpu::Commands commands(device());
    commands.begin();
    commands.copy(texture, buffer);
    commands.submit_and_wait();
    const auto* from = static_cast<const std::uint8_t*>(buffer.mapped());
    return {from, from + bytes};
}

template <class T>
std::vector<T> read_as(const gpu::Texture& texture) {
    const std::vector<std::uint8_t> bytes = read(texture, sizeof(T));
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

inline std::vector<glm::vec4> read_halves(const gpu::Texture& texture) {
    std::vector<glm::vec4> values;
    for (const std::uint64_t texel : read_as<std::uint64_t>(texture))
        values.push_back(glm::unpackHalf4x16(texel));
    return values;
}

inline Picture read(const GBuffer& buffer) {
    Picture picture;
    picture.fragments = &buffer.fragments();
    picture.extras = buffer.extra_count();
    picture.dropped = buffer.dropped_pixels();
    picture.places = read_as<glm::vec4>(buffer.fragments().places);
    picture.base = read_halves(buffer.fragments().base);
    picture.edges = read_as<glm::uvec2>(buffer.fragments().edges);
    picture.diffuse = read_halves(buffer.diffuse());
    picture.specular = read_halves(buffer.specular());
    picture.normals = read_halves(buffer.normals());
    const gpu::Buffer& bounds = buffer.fragments().tile_bounds;
    const gpu::Buffer copy(device(), bounds.bytes(), gpu::Access::readback);
    gpu::Commands commands(device());
    commands.begin();
    commands.copy(bounds, copy, bounds.bytes());
    commands.submit_and_wait();
    picture.bounds.resize(bounds.bytes() / sizeof(glm::vec4));
    std::memcpy(picture.bounds.data(), copy.mapped(), bounds.bytes());
    return picture;
}

inline Pose pose_of(const scene::Camera& camera) {
    return {scene::camera_to_world(camera), camera.fov_y_deg, camera.width, camera.height};
}

// A rectangle from corner along two edges; its normal is their cross product.
inline scene::Mesh quad(const glm::vec3& corner, const glm::vec3& along, const glm::vec3& up,
                        int material = 0) {
    scene::Mesh mesh;
    mesh.name = "quad";
    mesh.positions = {corner, corner + along, corner + along + up, corner + up};
    mesh.normals.assign(4, glm::normalize(glm::cross(along, up)));
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = material;
    return mesh;
}

inline void add(scene::Stage& stage, scene::Mesh mesh, const glm::mat4& world = glm::mat4(1.0f)) {
    stage.meshes.push_back(std::move(mesh));
    stage.instances.push_back({"instance " + std::to_string(stage.instances.size()),
                               static_cast<int>(stage.meshes.size()) - 1, world, scene::kNone});
}

inline scene::Material plain(const glm::vec3& colour) {
    scene::Material material;
    material.base_colour = colour;
    return material;
}

// A floor z = 0 and a wall y = 10, both 60 m wide.
inline scene::Stage room() {
    scene::Stage stage;
    stage.materials = {plain({0.5f, 0.25f, 0.125f}), plain({0.1f, 0.2f, 0.7f})};
    add(stage, quad({-30, -30, 0}, {60, 0, 0}, {0, 40, 0}, 0));
    add(stage, quad({-30, 10, 0}, {60, 0, 0}, {0, 0, 40}, 1)); // its normal is -y
    return stage;
}

inline Picture drawn(const scene::Stage& stage, const scene::Camera& camera,
                     const Surroundings& surroundings = {}) {
    Report report;
    const StageModel model(device(), stage, report);
    GBuffer buffer(device(), camera.width, camera.height);
    buffer.draw(model, pose_of(camera), surroundings);
    Picture picture = read(buffer);
    static Fragments kept; // the numbers outlive the buffer
    kept = Fragments{};
    kept.width = buffer.fragments().width;
    kept.height = buffer.fragments().height;
    kept.tiles_x = buffer.fragments().tiles_x;
    kept.tiles_y = buffer.fragments().tiles_y;
    kept.blocks = buffer.fragments().blocks;
    kept.edge_count = buffer.fragments().edge_count;
    picture.fragments = &kept;
    return picture;
}

// What holds for every picture of every stage.
// spare_room: after an update there may be places and edges that nothing fills.
inline void expect_sound(const Picture& picture, bool spare_room = false) {
    const std::size_t pixels = picture.pixels();
    std::vector<float> coverage(pixels);
    std::vector<std::vector<std::size_t>> all(pixels);
    for (std::size_t k = 0; k < pixels; ++k) all[k].push_back(k);
    std::set<std::uint32_t> seen;
    for (std::size_t e = 0; e < picture.fragments->edge_count; ++e) {
        const glm::uvec2 edge = picture.edges[e];
        if (spare_room && (edge.y & 3u) == 0u) continue;
        ASSERT_LT(edge.x, pixels);
        ASSERT_TRUE(seen.insert(edge.x).second) << "a pixel is listed twice";
        ASSERT_GE(edge.y & 3u, 1u);
        for (std::uint32_t k = 0; k < (edge.y & 3u); ++k) {
            ASSERT_LT((edge.y >> 2) + k, picture.extras);
            all[edge.x].push_back(pixels + (edge.y >> 2) + k);
            ASSERT_GT(picture.places[all[edge.x].back()].w, 0.0f);
        }
    }
    const std::uint32_t tiles_x = picture.fragments->tiles_x;
    const std::uint32_t tiles = tiles_x * picture.fragments->tiles_y;
    std::size_t extras = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        float sum = 0;
        const std::size_t tile = pixel / picture.fragments->width / shared::kTileHeight * tiles_x +
                                 pixel % picture.fragments->width / shared::kTileWidth;
        for (const std::size_t k : all[pixel]) {
            const glm::vec4 place = picture.places[k];
            for (int c = 0; c < 4; ++c) {
                ASSERT_TRUE(std::isfinite(place[c]) && std::isfinite(picture.diffuse[k][c]) &&
                            std::isfinite(picture.specular[k][c]) && std::isfinite(picture.normals[k][c]));
            }
            if (place.w < 0) continue;
            sum += place.w;
            ASSERT_NEAR(glm::length(picture.normal(k)), 1.0f, 2e-3f);
            std::vector<std::size_t> spheres{tile};
            if (k >= pixels) spheres.push_back(tiles + (k - pixels) / shared::kTilePixels);
            for (const std::size_t sphere : spheres) {
                const glm::vec4 bound = picture.bounds[sphere * 2];
                ASSERT_LE(glm::length(glm::vec3(place) - glm::vec3(bound)), bound.w + 1e-4f)
                    << "outside its tile";
            }
            extras += k >= pixels ? 1 : 0;
        }
        ASSERT_LE(sum, 1.0f + 1e-6f);
        for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(picture.base[pixel][c]));
    }
    if (spare_room)
        EXPECT_LE(extras, picture.extras);
    else
        EXPECT_EQ(extras, picture.extras);
    EXPECT_EQ(picture.fragments->blocks, (picture.extras + shared::kTilePixels - 1) / shared::kTilePixels);
    const std::size_t last = pixels + std::size_t{picture.fragments->blocks} * shared::kTilePixels;
    for (std::size_t k = pixels + picture.extras; k < last; ++k)
        ASSERT_LT(picture.places[k].w, 0.0f) << "the last block ends in no surface";
}

// Boards that stand at several depths before the wall.
inline scene::Stage room_with_boards() {
    scene::Stage stage = room();
    stage.meshes.push_back(quad({-0.5f, 0, -1}, {1, 0.3f, 0}, {0, 0, 2}));
    for (int k = 0; k < 4; ++k)
        stage.instances.push_back({"board", static_cast<int>(stage.meshes.size()) - 1,
                                   glm::translate(glm::mat4(1.0f), {2.0f * static_cast<float>(k) - 3,
                                                                    1 + 0.5f * static_cast<float>(k), 2}),
                                   scene::kNone});
    return stage;
}

} // namespace ghost::render
