// SPDX-License-Identifier: Apache-2.0
// LED walls as the camera sees them: their luminance, where they are, through haze, behind what stands before
// them.
#include "light/led_wall_light.h"
#include "support/test_view.h"

#include <cmath>

namespace ghost::render {
namespace {

using glm::vec3;

using LedWallView = RelightTest;

constexpr float kNits = 1000.0f;

// Above left white, below right a half (of light), the rest black.
shared::Gobos gobos_with_picture(scene::MediaNow& now) {
    image::Image8 picture(64, 64, 4);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 4; ++c)
                picture.at(x, y)[c] = c == 3 || (x < 32 && y < 32) ? 255 : (x >= 32 && y >= 32 ? 188 : 0);
    const image::Pyramid pyramid = image::make_pyramid(picture, 64);
    shared::Gobos gobos = test_gobos();
    gobos.slides = {{pyramid.side, pyramid.levels}};
    now = {1, pyramid.extent, pyramid.mean, pyramid.side};
    return gobos;
}

// 4 x 2 m about (0, y, 0), towards the eye.
shared::LedWall wall_at(float y, const scene::MediaNow& now) {
    scene::LedWall wall;
    wall.size_m = {4, 2};
    wall.nits = kNits;
    wall.fit = scene::Fit::stretch;
    glm::mat4 to_world(1.0f);
    to_world[3].y = y;
    return scene::seen_wall(wall, to_world, now, vec3(1));
}

// 96 x 64 pixels, 40 degrees high: at 8 m a pixel is 0.091 m.
scene::Camera eye() {
    return camera_at({0, 0, 0}, {0, 1, 0}, 40, 96, 64);
}

TEST_F(LedWallView, ShowsItsPictureInCandelaPerSquareMetre) {
    scene::MediaNow now;
    const shared::Gobos gobos = gobos_with_picture(now);
    const scene::Passes passes = wall_passes(eye(), 8.0f);
    Relighter relighter(device(), passes, gobos, 0, clear_air());
    relighter.draw(scene::FrameLights{{}, {}, {wall_at(8.0f, now)}});
    const image::ImageF frame = relighter.frame();
    EXPECT_NEAR(frame.at(37, 27)[1], kNits, 0.01f * kNits);          // above left
    EXPECT_NEAR(frame.at(58, 36)[1], 0.503f * kNits, 0.01f * kNits); // below right: sRGB 188
    EXPECT_EQ(frame.at(58, 27)[1], 0.0f);
    EXPECT_EQ(frame.at(10, 32)[1], 0.0f);
    EXPECT_EQ(frame.at(37, 10)[1], 0.0f);
    // Its pixels together are as large as it is.
    double sum = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) sum += double{frame.at(x, y)[1]};
    const double pixel_m = 2.0 * 8.0 * std::tan(20.0 * 3.14159265 / 180.0) / 64.0;
    EXPECT_NEAR(sum * pixel_m * pixel_m / (double{kNits} * 2.0 * 1.503), 1.0, 0.03);
}

TEST_F(LedWallView, IsHiddenByWhatStandsBeforeIt) {
    scene::MediaNow now;
    const shared::Gobos gobos = gobos_with_picture(now);
    const scene::Passes passes = wall_passes(eye(), 5.0f);
    Relighter relighter(device(), passes, gobos, 0, clear_air());
    relighter.draw(scene::FrameLights{{}, {}, {wall_at(8.0f, now)}});
    EXPECT_EQ(relighter.frame().at(37, 27)[1], 0.0f);
}

TEST_F(LedWallView, HazeWeakensIt) {
    scene::MediaNow now;
    const shared::Gobos gobos = gobos_with_picture(now);
    const scene::Passes passes = wall_passes(eye(), 8.0f);
    Settings settings = clear_air();
    settings.haze.extinction_per_m = 0.1f;
    settings.haze.scattering_per_m = 0.1f;
    Relighter relighter(device(), passes, gobos, 0, settings);
    relighter.draw(scene::FrameLights{{}, {}, {wall_at(8.0f, now)}});
    EXPECT_NEAR(relighter.frame().at(40, 29)[1] / kNits, std::exp(-0.1f * 8.03f), 0.01f);
}

// A new picture or another dimmer draws the wall again, and no light.
TEST_F(LedWallView, CostsNoLightWhenItChanges) {
    scene::MediaNow now;
    const shared::Gobos gobos = gobos_with_picture(now);
    const scene::Passes passes = wall_passes(eye(), 8.0f);
    Relighter relighter(device(), passes, gobos, 0, clear_air());
    scene::FrameLights lit{{}, {}, {wall_at(8.0f, now)}};
    relighter.draw(lit);
    lit.walls[0].radiance *= 0.25f;
    EXPECT_EQ(relighter.draw(lit).drawn, 0);
    EXPECT_NEAR(relighter.frame().at(37, 27)[1], 0.25f * kNits, 0.01f * kNits);
}

} // namespace
} // namespace ghost::render
