// SPDX-License-Identifier: Apache-2.0
// A camera before a stage sees it; behind its wall, or turned away, it is told, and by which body.
#include "live/lux/unseen_stage.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

// A wall across the stage at Y = 5, heads before it at Y = 0, a floor.
scene::Stage stage() {
    const auto sheet = [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
        scene::Mesh mesh;
        mesh.positions = {a, b, c, d};
        mesh.normals.assign(4, glm::normalize(glm::cross(b - a, d - a)));
        mesh.uvs.assign(4, {0, 0});
        mesh.indices = {0, 1, 2, 0, 2, 3};
        return mesh;
    };
    scene::Stage made;
    made.materials.emplace_back();
    made.meshes.push_back(sheet({-20, 5, -5}, {20, 5, -5}, {20, 5, 20}, {-20, 5, 20}));
    made.meshes.push_back(sheet({-20, -20, 0}, {20, -20, 0}, {20, 5, 0}, {-20, 5, 0}));
    for (int mesh = 0; mesh < 2; ++mesh) {
        scene::Instance instance;
        instance.name = mesh == 0 ? "wall_back" : "floor";
        instance.mesh = mesh;
        made.instances.push_back(instance);
    }
    return made;
}

const std::vector<glm::vec3> kHeads_m{{-2, 0, 5}, {0, 0, 5}, {2, 0, 5}};

scene::Camera camera(const glm::vec3& from_m, const glm::vec3& to_m) {
    scene::Camera made;
    made.position_m = from_m;
    made.target_m = to_m;
    made.fov_y_deg = 40;
    made.width = 160;
    made.height = 90;
    return made;
}

TEST(UnseenStage, a_wall_before_all_of_it_is_named) {
    const scene::Stage set = stage();
    const bake::Tracer tracer(set);
    const auto behind = camera({0, 15, 3}, {0, 0, 3});
    EXPECT_EQ(unseen_stage(behind, kHeads_m, tracer, true, false), "wall_back");
    EXPECT_EQ(unseen_stage(behind, kHeads_m, tracer, false, true), "wall_back")
        << "in the work light it is grey";
    EXPECT_FALSE(unseen_stage(behind, kHeads_m, tracer, false, false)) << "light is seen";
    EXPECT_EQ(unseen_stage(camera({0, -15, 3}, {0, -40, 30}), kHeads_m, tracer, true, false), "");
}

TEST(UnseenStage, a_dark_stage_is_no_unseen_one) {
    const scene::Stage set = stage();
    const bake::Tracer tracer(set);
    EXPECT_FALSE(unseen_stage(camera({0, -15, 3}, {0, 0, 3}), kHeads_m, tracer, true, true));
    // The wall alone, from where the heads are: it is looked at.
    EXPECT_FALSE(unseen_stage(camera({0, 0, 5}, {0, 5, 5}), kHeads_m, tracer, false, true));
}

TEST(UnseenStage, one_pixel_of_light_is_no_black_picture) {
    image::Image8 picture(50, 50, 4);
    picture.samples.assign(picture.samples.size(), 4);
    EXPECT_TRUE(is_black(picture));
    for (int y = 20; y < 26; ++y)
        for (int x = 20; x < 26; ++x) picture.samples[static_cast<std::size_t>(4 * (50 * y + x))] = 90;
    EXPECT_FALSE(is_black(picture));
}

} // namespace
} // namespace ghost::app
