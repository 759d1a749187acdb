// SPDX-License-Identifier: Apache-2.0
// Cells of a bar in the picture: each a glow of its own colour and candela, their light that of one lamp.
#include "support/test_glare.h"

namespace ghost::render {
namespace {

using glm::vec3;

using CellGlow = RelightTest;

scene::LensFace glowing(const vec3& place_m, const vec3& towards, const vec3& lumens, float radius_m) {
    scene::LensFace face{aimed_light(place_m, place_m + towards, 100, 1.0f, false), true};
    face.light.lens_m = 0;
    face.light.bounce_cd = lumens / (4.0f * shared::kPi);
    face.light.intensity_cd = face.light.bounce_cd;
    face.light.disc_radius_m = radius_m;
    return face;
}

// Whatever a file says of its angles: from all sides before it the glow is as bright.
TEST_F(CellGlow, GlowIsAsBrightFromEverySide) {
    DarkHall hall(200, 120, 20, 30);
    for (const float aside_deg : {0.0f, 45.0f, 75.0f}) {
        const float turn = glm::radians(aside_deg);
        const vec3 lumens(20.0f, 50.0f, 5.0f);
        hall.draw({glowing({0, 4, 0}, {std::sin(turn), -std::cos(turn), 0}, lumens, 0.4f)});
        const vec3 expected = lumens / (shared::kPi * shared::kPi * 0.4f * 0.4f);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(hall.frame().at(100, 60)[c] / expected[static_cast<int>(c)], 1.0f, 0.01f)
                << aside_deg;
        // Lambert: flux / pi cos / d^2.
        const double lux = hall.light() * hall.pixel_sr({100, 60});
        const double wanted = 50.0 / 3.14159265 * std::cos(double{turn}) / 16.0;
        EXPECT_NEAR(lux / wanted, 1.0, 0.02) << aside_deg;
    }
    hall.draw({glowing({0, 4, 0}, {0, 1, 0}, vec3(50), 0.1f)});
    EXPECT_EQ(hall.light(), 0.0) << "from behind it is the fixture's body";
}

TEST_F(CellGlow, ColoursStandInOrderAlongTheBar) {
    const vec3 colours[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0},
                            {0, 1, 1}, {1, 0, 1}, {1, 1, 1}, {0, 0, 0}};
    DarkHall hall(160, 24, 2, 30); // cells are 7 pixels apart
    std::vector<scene::LensFace> faces;
    for (int k = 0; k < 8; ++k)
        faces.push_back(
            glowing({0.1f * (static_cast<float>(k) - 3.5f), 10, 0}, {0, -1, 0}, 10.0f * colours[k], 0.01f));
    hall.draw(faces);
    EXPECT_EQ(hall.lenses().drawn(), 7) << "the dark one is not seen";
    const image::ImageF frame = hall.frame();
    double light[8];
    for (int k = 0; k < 8; ++k) {
        const glm::ivec2 at(hall.pixel_of(faces[static_cast<std::size_t>(k)].light.position_m));
        vec3 sum(0.0f);
        for (int y = at.y - 3; y <= at.y + 3; ++y)
            for (int x = at.x - 3; x <= at.x + 3; ++x)
                for (int c = 0; c < 3; ++c) sum[c] += frame.at(x, y)[static_cast<std::size_t>(c)];
        light[k] = double{std::max({sum.x, sum.y, sum.z})};
        for (int c = 0; c < 3; ++c) {
            if (colours[k][c] > 0)
                EXPECT_NEAR(double{sum[c]} / light[0], 1.0, 0.02) << "cell " << k << " colour " << c;
            else
                EXPECT_EQ(sum[c], 0.0f) << "cell " << k << " colour " << c;
        }
    }
    EXPECT_GT(light[0], 0.0);
}

// The group's light is drawn once and kept; cells that change places with one another cost no light.
TEST_F(CellGlow, FacesThatChangeAloneAreDrawnAndNoLightIs) {
    scene::Passes passes = wall_passes(camera_at({0, 0, 0}, {0, 1, 0}, 40, 96, 64), 8.0f);
    add_pass(passes, {0, 5, 1}, [](const vec3&) { return vec3(1.0f); });
    Settings settings = clear_air();
    settings.lens.on = true;
    scene::FrameLights lit;
    lit.lights = {aimed_light({0, 5, 1}, {0, 8, 0}, 60, 100)};
    lit.faces = {glowing({-0.3f, 5, 0}, {0, -1, 0}, {50, 0, 0}, 0.05f),
                 glowing({0.3f, 5, 0}, {0, -1, 0}, {0, 0, 50}, 0.05f)};
    Relighter relighter(device(), passes, test_gobos(), 1, settings);
    EXPECT_EQ(relighter.draw(lit).drawn, 1);
    const image::ImageF first = relighter.frame();
    EXPECT_EQ(relighter.draw(lit).faces, 0) << "nothing changed, nothing is drawn";
    std::swap(lit.faces[0].light.bounce_cd, lit.faces[1].light.bounce_cd);
    relighter.draw(lit); // the light gets an image of its own, to be kept
    std::swap(lit.faces[0].light.bounce_cd, lit.faces[1].light.bounce_cd);
    lit.faces[0].light.bounce_cd *= 0.5f;
    const FrameStatistics again = relighter.draw(lit);
    EXPECT_EQ(again.changed, 0);
    EXPECT_EQ(again.drawn, 0);
    EXPECT_EQ(again.faces, 2);
    const image::ImageF second = relighter.frame();
    double red = 0, blue = 0, before = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) {
            const auto glow = [&](const image::ImageF& frame, std::size_t c) {
                return double{frame.at(x, y)[c] - frame.at(x, y)[1]};
            };
            red += std::max(glow(second, 0), 0.0);
            before += std::max(glow(first, 0), 0.0);
            blue += std::max(glow(second, 2), 0.0);
        }
    EXPECT_NEAR(red / before, 0.5, 0.02);
    EXPECT_NEAR(blue / before, 1.0, 0.02);
}

// A show of cells that all only glow.
TEST_F(CellGlow, NoLightAtAll) {
    const scene::Passes passes = wall_passes(camera_at({0, 0, 0}, {0, 1, 0}, 40, 64, 48), 8.0f);
    Settings settings = clear_air();
    settings.lens.on = true;
    Relighter relighter(device(), passes, test_gobos(), 0, settings);
    const FrameStatistics drawn =
        relighter.draw(scene::FrameLights{{}, {glowing({0, 5, 0}, {0, -1, 0}, vec3(50), 0.05f)}, {}});
    EXPECT_EQ(drawn.faces, 1);
    EXPECT_GT(relighter.frame().at(32, 24)[1], 0.0f);
}

} // namespace
} // namespace ghost::render
