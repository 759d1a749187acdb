// SPDX-License-Identifier: Apache-2.0
// Instances that move: after GBuffer::update every fragment is what a whole new drawing gives, and what no
// moving instance touches stays untouched.
#include "support/g_buffer_picture.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>

namespace ghost::render {
namespace {

using MovingTest = RelightTest;

constexpr std::size_t kRoom = 2; // instances of room()

// A box about the origin with slanted facets: plenty of edges.
scene::Mesh lump(float size_m, int material) {
    scene::Mesh mesh;
    mesh.material = material;
    for (int k = 0; k < 12; ++k) {
        const float a = static_cast<float>(k) * 0.7f, b = static_cast<float>(k) * 1.9f;
        const glm::vec3 along = glm::normalize(glm::vec3(std::cos(a), std::sin(a), std::sin(b)));
        const glm::vec3 up = glm::normalize(glm::cross(along, glm::vec3(std::sin(b), 0.3f, std::cos(a))));
        const scene::Mesh one =
            quad(-0.5f * size_m * (along + up) + 0.2f * size_m * glm::vec3(std::sin(a), 0, std::cos(b)),
                 along * size_m, up * size_m);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const std::uint32_t index : one.indices) mesh.indices.push_back(first + index);
        mesh.positions.insert(mesh.positions.end(), one.positions.begin(), one.positions.end());
        mesh.normals.insert(mesh.normals.end(), one.normals.begin(), one.normals.end());
        mesh.uvs.insert(mesh.uvs.end(), one.uvs.begin(), one.uvs.end());
    }
    return mesh;
}

// A room with something in the way and, from instance kRoom + 1 on, lumps: opaque, masked and blended.
scene::Stage room_with_lumps(std::size_t count) {
    scene::Stage stage = room();
    for (const scene::AlphaMode mode :
         {scene::AlphaMode::opaque, scene::AlphaMode::mask, scene::AlphaMode::blend}) {
        scene::Material material = plain({0.3f, 0.6f, 0.2f});
        material.alpha_mode = mode;
        material.alpha = mode == scene::AlphaMode::opaque ? 1.0f : 0.6f;
        material.emission = {1, 2, 3};
        stage.materials.push_back(material);
    }
    add(stage, quad({-3, -1, -1}, {0.7f, 0.1f, 0}, {0.2f, 0, 6}, 1));
    for (int k = 0; k < 3; ++k) stage.meshes.push_back(lump(1.2f, 2 + k));
    for (std::size_t k = 0; k < count; ++k) {
        const auto mesh = static_cast<int>(stage.meshes.size() - 3 + k % 3);
        stage.instances.push_back({"lump", mesh, glm::mat4(1.0f), scene::kNone});
    }
    return stage;
}

glm::mat4 at(const glm::vec3& place_m, float turn_rad = 0) {
    return glm::rotate(glm::translate(glm::mat4(1.0f), place_m), turn_rad, glm::vec3(0.3f, 0.2f, 0.9f));
}

struct Fragment {
    glm::vec4 place, diffuse, specular, normal;
    bool operator==(const Fragment&) const = default;
};

std::vector<std::vector<Fragment>> fragments_of(const Picture& picture) {
    std::vector<std::vector<Fragment>> all(picture.pixels());
    const auto one = [&](std::size_t k) {
        return Fragment{picture.places[k], picture.diffuse[k], picture.specular[k], picture.normals[k]};
    };
    for (std::size_t pixel = 0; pixel < all.size(); ++pixel) all[pixel].push_back(one(pixel));
    for (std::size_t e = 0; e < picture.fragments->edge_count; ++e)
        for (std::uint32_t k = 0; k < (picture.edges[e].y & 3u); ++k)
            all[picture.edges[e].x].push_back(one(picture.pixels() + (picture.edges[e].y >> 2) + k));
    return all;
}

// Both, fragment by fragment; bounds of the tiles too.
void expect_same(const Picture& ours, const Picture& whole) {
    const auto a = fragments_of(ours), b = fragments_of(whole);
    std::size_t different = 0;
    for (std::size_t pixel = 0; pixel < a.size(); ++pixel)
        different += a[pixel] == b[pixel] && ours.base[pixel] == whole.base[pixel] ? 0 : 1;
    EXPECT_EQ(different, 0u) << "pixels of " << a.size();
    const std::size_t tiles = std::size_t{whole.fragments->tiles_x} * whole.fragments->tiles_y;
    for (std::size_t k = 0; k < 2 * tiles; ++k) ASSERT_EQ(ours.bounds[k], whole.bounds[k]) << k;
}

bool covered(const std::vector<PixelRect>& rects, std::size_t pixel, std::size_t width) {
    const auto x = static_cast<int>(pixel % width), y = static_cast<int>(pixel / width);
    return std::any_of(rects.begin(), rects.end(), [&](const PixelRect& rect) {
        return x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
    });
}

class LumpScene {
public:
    explicit LumpScene(std::size_t lumps, const scene::Camera& camera, bool all_move = true)
        : stage_(room_with_lumps(lumps)), camera_(camera), model_(device(), stage_, report_),
          buffer_(device(), camera.width, camera.height) {
        surroundings_.ambient = {2, 3, 4};
        surroundings_.haze.extinction_per_m = 0.03f;
        for (std::size_t k = 0; k < lumps; ++k)
            if (all_move || k % 2 == 0) model_.mark_moving(first() + k);
    }
    static std::size_t first() { return kRoom + 1; }
    void move(std::size_t lump, const glm::mat4& world) {
        model_.move(first() + lump, world);
        stage_.instances[first() + lump].world = world;
    }
    void draw() { buffer_.draw(model_, pose_of(camera_), surroundings_); }
    bool update() { return buffer_.update(model_); }
    Picture picture() const { return read(buffer_); }
    // Another model of the same stage, in which nothing is marked, drawn at once.
    void expect_as_drawn_anew() const {
        Report report;
        const StageModel model(device(), stage_, report);
        GBuffer buffer(device(), camera_.width, camera_.height);
        buffer.draw(model, pose_of(camera_), surroundings_);
        const Picture ours = picture();
        expect_sound(ours, true);
        expect_same(ours, read(buffer));
    }
    StageModel& model() { return model_; }
    GBuffer& buffer() { return buffer_; }

private:
    scene::Stage stage_;
    scene::Camera camera_;
    Report report_;
    StageModel model_;
    GBuffer buffer_;
    Surroundings surroundings_;
};

scene::Camera front() {
    return camera_at({0, -10, 3}, {0, 10, 2.5f}, 40, 150, 100);
}

TEST_F(MovingTest, OnlyWhatAHeadTouchesChanges) {
    LumpScene scene(2, front());
    scene.move(0, at({-2, 2, 2}));
    scene.move(1, at({2, 0, 3}));
    scene.draw();
    // At once: a Picture refers to the numbers of the buffer as they are now.
    const auto a = fragments_of(scene.picture());
    scene.move(0, at({-2, 2, 2}, 0.8f));
    ASSERT_TRUE(scene.update());
    const auto b = fragments_of(scene.picture());
    std::size_t inside = 0, area = 0;
    for (std::size_t pixel = 0; pixel < a.size(); ++pixel) {
        const bool may = covered(scene.buffer().changed(), pixel, scene.buffer().fragments().width);
        area += may ? 1 : 0;
        if (a[pixel] == b[pixel]) continue;
        EXPECT_TRUE(may) << pixel;
        ++inside;
    }
    EXPECT_GT(inside, 100u);
    EXPECT_LT(area, a.size() / 4);
    scene.expect_as_drawn_anew();
}

TEST_F(MovingTest, WhatStandsStillIsNotDrawn) {
    LumpScene scene(3, front());
    for (std::size_t k = 0; k < 3; ++k) scene.move(k, at({static_cast<float>(k), 0, 3}));
    EXPECT_FALSE(scene.model().visible_moving({0, -10, 3}, {}, 1).empty());
    scene.draw();
    EXPECT_FALSE(scene.update());
    scene.move(1, at({1, 0, 3})); // where it is
    EXPECT_FALSE(scene.update());
    EXPECT_TRUE(scene.buffer().changed().empty());
    scene.move(1, at({1, 0, 3}, 0.1f));
    EXPECT_TRUE(scene.update());
    EXPECT_FALSE(scene.update());
    scene.expect_as_drawn_anew();
}

TEST_F(MovingTest, RandomMovesGiveWhatDrawingAnewGives) {
    constexpr std::size_t kLumps = 7;
    LumpScene scene(kLumps, front());
    std::mt19937 random(11);
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    scene.draw();
    for (int step = 0; step < 24; ++step) {
        for (std::size_t k = 0; k < kLumps; ++k)
            if (unit() < 0.5f) scene.move(k, at({8 * unit() - 4, 14 * unit() - 6, 6 * unit()}, 6 * unit()));
        if (step % 6 == 3) scene.model().show(LumpScene::first() + 2, false);
        scene.update();
        if (step % 6 == 3) { // hidden ones are hidden; then they come back
            expect_sound(scene.picture(), true);
            scene.model().show(LumpScene::first() + 2, true);
            scene.update();
        }
        SCOPED_TRACE(step);
        scene.expect_as_drawn_anew();
    }
}

TEST_F(MovingTest, AHeadLeavesTheViewAndComesBack) {
    LumpScene scene(2, front());
    scene.move(1, at({1, 3, 1}));
    scene.draw();
    const std::array<glm::vec3, 8> places{glm::vec3(0, 0, 3),   glm::vec3(6, 0, 3),   glm::vec3(60, 0, 3),
                                          glm::vec3(0, 0, 3),   glm::vec3(0, -9, 3), // before the lens
                                          glm::vec3(0, -10, 3), glm::vec3(0, -30, 3), glm::vec3(-1, 1, 2)};
    for (const glm::vec3& place_m : places) {
        SCOPED_TRACE(place_m.x + 100 * place_m.y);
        scene.move(0, at(place_m, place_m.x));
        scene.update();
        scene.expect_as_drawn_anew();
    }
    scene.move(0, at({80, 0, 3}));
    EXPECT_TRUE(scene.update());
    scene.move(0, at({90, 0, 3}));
    EXPECT_FALSE(scene.update()) << "both places are out of view";
    scene.move(0, glm::mat4(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(scene.update());
    scene.move(0, at({0, 0, 3}));
    EXPECT_TRUE(scene.update());
    scene.expect_as_drawn_anew();
}

TEST_F(MovingTest, AStillInstanceMovedOrAnotherCameraDrawsAll) {
    LumpScene scene(4, front(), false); // 1 and 3 are not marked
    for (std::size_t k = 0; k < 4; ++k) scene.move(k, at({1.5f * static_cast<float>(k) - 2, 0, 2}));
    scene.draw();
    scene.move(0, at({-2, 1, 2}, 1));
    EXPECT_TRUE(scene.update());
    scene.move(1, at({0, 3, 2}, 1));
    EXPECT_TRUE(scene.update());
    ASSERT_EQ(scene.buffer().changed().size(), 1u);
    EXPECT_EQ(scene.buffer().changed()[0], (PixelRect{0, 0, 150, 100}));
    scene.expect_as_drawn_anew();
    scene.move(2, at({0, 3, 4}, 1));
    EXPECT_TRUE(scene.update());
    scene.expect_as_drawn_anew();
    scene.draw(); // what was kept belongs to the drawing before
    scene.move(2, at({0, 3, 3}, 2));
    EXPECT_TRUE(scene.update());
    scene.expect_as_drawn_anew();
}

// Room for extra fragments runs out after many moves: everything is gathered anew, nothing is lost.
TEST_F(MovingTest, RoomForExtrasIsMadeAgain) {
    LumpScene scene(30, camera_at({0, -10, 3}, {0, 10, 2.5f}, 40, 64, 48));
    std::mt19937 random(5);
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    scene.draw();
    std::uint32_t most = 0, shrunk = 0, last = 0;
    for (int step = 0; step < 16; ++step) {
        for (std::size_t k = 0; k < 30; ++k)
            scene.move(k, at({8 * unit() - 4, 14 * unit() - 6, 6 * unit()}, 6 * unit()));
        scene.update();
        const std::uint32_t extras = scene.buffer().extra_count();
        shrunk += extras < last ? 1 : 0;
        last = extras;
        most = std::max(most, extras);
        if (scene.buffer().dropped_pixels() == 0) scene.expect_as_drawn_anew();
    }
    EXPECT_GT(shrunk, 0u) << "never full: the test tests nothing; most " << most;
    EXPECT_LE(most, 64u * 48u);
}

TEST(screen_area, TilesBecomeFewRectangles) {
    TileSet tiles(100, 50); // 7 x 7 tiles, the last ones cut off
    EXPECT_TRUE(tiles.empty());
    tiles.add({17, 9, 40, 20}); // tiles 1..2 x 1..2
    tiles.add({95, 45, 100, 50});
    tiles.add(PixelRect{});
    EXPECT_EQ(tiles.count(), 8u);
    EXPECT_EQ(tiles.rects(), (std::vector<PixelRect>{{16, 8, 48, 24}, {80, 40, 100, 50}}));
    EXPECT_EQ(tiles.list(), (std::vector<std::uint32_t>{8, 9, 15, 16, 40, 41, 47, 48}));
    EXPECT_TRUE(tiles.meets({47, 23, 48, 24}));
    EXPECT_FALSE(tiles.meets({48, 24, 80, 40}));
    TileSet other(100, 50);
    other.add({16, 8, 32, 16});
    tiles.remove(other);
    EXPECT_FALSE(tiles.meets({16, 8, 32, 16}));
    tiles.add(other);
    EXPECT_TRUE(tiles.meets({16, 8, 32, 16}));
}

} // namespace
} // namespace ghost::render
