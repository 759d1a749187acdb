// SPDX-License-Identifier: Apache-2.0
// Cameras moved by hand: what must stay where it is in the picture stays there, and no way leads over the
// head.
#include "show/camera_moves.h"

#include <cmath>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

Camera camera() {
    Camera one;
    one.position_m = {2, -10, 3};
    one.target_m = {1, 4, 2};
    one.fov_y_deg = 40;
    one.width = 1600;
    one.height = 900;
    return one;
}

void expect_close(const glm::vec3& a, const glm::vec3& b) {
    EXPECT_LT(glm::distance(a, b), 1e-4f)
        << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

TEST(CameraMoves, project_knows_centre_edges_and_what_is_behind) {
    Camera one = camera();
    one.position_m = {0, -10, 2};
    one.target_m = {0, 0, 2};
    const float up_m = 10 * std::tan(glm::radians(20.0f)); // the edge, 10 m away
    const auto centre = project(one, {0, 0, 2});
    ASSERT_TRUE(centre);
    EXPECT_NEAR(centre->at.x, 0.5f, 1e-5f);
    EXPECT_NEAR(centre->at.y, 0.5f, 1e-5f);
    EXPECT_NEAR(centre->depth_m, 10, 1e-4f);
    EXPECT_NEAR(project(one, {0, 0, 2 + up_m})->at.y, 0, 1e-4f);
    EXPECT_NEAR(project(one, {up_m * 16 / 9, 0, 2})->at.x, 1, 1e-4f);
    EXPECT_FALSE(project(one, {0, -11, 2}));
}

TEST(CameraMoves, the_floor_is_met_where_one_looks_and_not_in_the_next_town) {
    Camera one;
    one.position_m = {1, -10, 3};
    one.target_m = {1, 0, 0.5f};
    const auto ahead = [&] { return glm::normalize(one.target_m - one.position_m); };
    expect_close(floor_along(one, ahead()), {1, 2, 0});
    one.target_m = {1, 0, 2.5f}; // nearly level: the floor would be at 50
    EXPECT_NEAR(floor_along(one, ahead()).y, 0, 0.01f);
    one.target_m = {1, 0, 8}; // up
    expect_close(floor_along(one, ahead()), {1, 0, 0});
    one.target_m = {1, 0, 3}; // level
    expect_close(floor_along(one, ahead()), {1, 0, 0});
}

TEST(CameraMoves, between_begins_and_ends_at_the_cameras) {
    Camera to = camera();
    to.position_m = {-8, 1, 6};
    to.target_m = {2, 2, 1};
    to.fov_y_deg = 60;
    to.ev100 = 9;
    expect_close(camera_between(camera(), to, 0).target_m, camera().target_m);
    expect_close(camera_between(camera(), to, 1).position_m, to.position_m);
    expect_close(camera_between(camera(), to, 1).target_m, to.target_m);
    const Camera half = camera_between(camera(), to, 0.5f);
    EXPECT_NEAR(half.fov_y_deg, 50, 1e-4f);
    EXPECT_NEAR(half.ev100, 7.5f, 1e-4f);
}

TEST(CameraMoves, orbit_keeps_the_target_and_the_distance) {
    const Camera moved = orbited(camera(), 0.7f, 0.2f);
    expect_close(moved.target_m, camera().target_m);
    EXPECT_NEAR(glm::distance(moved.position_m, moved.target_m),
                glm::distance(camera().position_m, camera().target_m), 1e-3f);
    EXPECT_GT(moved.position_m.z, camera().position_m.z); // the stage goes down: the eye goes up
    expect_close(orbited(orbited(camera(), 0.7f, 0.2f), -0.7f, -0.2f).position_m, camera().position_m);
    // A point before the target moves to the right.
    const glm::vec3 near_m = camera().target_m + glm::vec3(0, -1, 0);
    EXPECT_GT(project(moved, near_m)->at.x, project(camera(), near_m)->at.x);
}

TEST(CameraMoves, orbit_stops_at_the_floor) {
    Camera one = camera();
    for (int i = 0; i < 20; ++i) one = orbited(one, 0.1f, -0.1f);
    EXPECT_NEAR(one.position_m.z, 0.05f, 1e-3f);
    EXPECT_NEAR(glm::distance(one.position_m, one.target_m),
                glm::distance(camera().position_m, camera().target_m), 1e-2f);
    Camera below = camera();
    below.position_m.z = below.target_m.z = -3;
    EXPECT_LT(orbited(below, 0, -0.1f).position_m.z, -3.0f) << "who is there has flown there";
}

TEST(CameraMoves, no_way_leads_over_the_head) {
    Camera one = camera();
    for (int i = 0; i < 100; ++i) one = orbited(one, 0, 0.3f);
    const glm::vec3 way = glm::normalize(one.target_m - one.position_m);
    EXPECT_GT(way.z, -0.999f);
    EXPECT_LT(way.z, -0.9f);
    EXPECT_GT(project(one, one.target_m + glm::vec3(0, 0.5f, 0))->depth_m, 0); // still upright and finite
}

TEST(CameraMoves, turning_stays_where_it_stands) {
    const Camera moved = turned(camera(), 0.3f, 0.1f);
    expect_close(moved.position_m, camera().position_m);
    const auto seen = project(moved, camera().target_m);
    EXPECT_GT(seen->at.x, 0.5f); // it looks to the left, so what was in the middle is on the right
    EXPECT_GT(seen->at.y, 0.5f);
}

TEST(CameraMoves, pan_moves_the_target_by_the_share_of_the_picture) {
    const Camera moved = panned(camera(), 0.25f, -0.5f);
    const auto seen = project(moved, camera().target_m);
    EXPECT_NEAR(seen->at.x, 0.5f - 0.25f * 9 / 16, 1e-4f);
    EXPECT_NEAR(seen->at.y, 0.5f - 0.5f, 1e-4f);
}

TEST(CameraMoves, dolly_stops_before_the_target) {
    const float distance_m = glm::distance(camera().position_m, camera().target_m);
    EXPECT_NEAR(glm::distance(dollied(camera(), 0.5f).position_m, camera().target_m), distance_m / 2, 1e-3f);
    Camera one = camera();
    for (int i = 0; i < 100; ++i) one = dollied(one, 0.5f);
    EXPECT_NEAR(glm::distance(one.position_m, one.target_m), kNearest_m, 1e-4f);
}

TEST(CameraMoves, flying_forward_stays_level) {
    const Camera moved = flown(camera(), {0, 3, 0});
    EXPECT_NEAR(moved.position_m.z, camera().position_m.z, 1e-5f);
    EXPECT_NEAR(glm::distance(moved.position_m, camera().position_m), 3, 1e-4f);
    EXPECT_GT(moved.position_m.y, camera().position_m.y);
    EXPECT_GT(flown(camera(), {1, 0, 0}).position_m.x, camera().position_m.x);
    expect_close(moved.target_m - moved.position_m, camera().target_m - camera().position_m);
    EXPECT_LE(flown(camera(), {0, 0, 1e9f}).position_m.z, 10000);
}

TEST(CameraMoves, focus_shows_the_whole_ball_and_not_much_more) {
    const glm::vec3 centre_m{3, 2, 5};
    for (const int width : {1600, 300}) {
        Camera one = camera();
        one.width = width;
        const Camera moved = focused(one, centre_m, 1.5f);
        const auto middle = project(moved, centre_m);
        EXPECT_NEAR(middle->at.x, 0.5f, 1e-4f);
        EXPECT_NEAR(middle->at.y, 0.5f, 1e-4f);
        const glm::mat4 axes = camera_to_world(moved);
        // The outline of a ball is nearer than its middle; the axis through the middle comes close.
        const auto side = project(moved, centre_m + 1.5f * glm::vec3(axes[width < 900 ? 0 : 1]));
        const float reach = width < 900 ? side->at.x : 1 - side->at.y;
        EXPECT_GT(reach, 0.9f);
        EXPECT_LE(reach, 1.0f);
    }
}

// What is at the edge of the frame's sides is at the edge of a narrower picture, and a wider one has the
// camera's own height.
TEST(CameraMoves, a_frame_fits_into_a_picture_of_any_shape) {
    Camera one = camera();
    one.width = 400;
    one.height = 600;
    const glm::ivec2 frame(1024, 300);
    const Camera wide = with_frame(one, frame);
    EXPECT_GT(wide.fov_y_deg, one.fov_y_deg);
    Camera stored = one;
    stored.width = frame.x;
    stored.height = frame.y;
    const glm::vec3 beside = one.target_m + 3.0f * glm::vec3(camera_to_world(one)[0]);
    EXPECT_NEAR(project(wide, beside)->at.x, project(stored, beside)->at.x, 1e-5f);
    EXPECT_NEAR(share_of_frame(one, frame), 400 / (1024.0f / 300 * 600), 1e-6f);
    one.width = 4000;
    EXPECT_EQ(with_frame(one, frame).fov_y_deg, one.fov_y_deg);
    EXPECT_EQ(share_of_frame(one, frame), 1);
    EXPECT_EQ(with_frame(one, {0, 0}).fov_y_deg, one.fov_y_deg);
    one.width = 1;
    EXPECT_LT(with_frame(one, {8192, 16}).fov_y_deg, 175);
}

} // namespace
} // namespace ghost::scene
