// SPDX-License-Identifier: Apache-2.0
// Shadows as soft as the lens is large: the penumbra that the straight edge of a plate throws on the floor,
// against the share of a disc that is seen past an edge.
#include "support/thesis_scene.h"

namespace ghost::app {
namespace {

constexpr float kLamp_m = 8, kPlate_m = 5; // above the floor
constexpr int kPixels = 512;
constexpr int kShadowMapSize = 1024;
constexpr double kTexel_m =
    2.0 / kShadowMapSize * static_cast<double>(kLamp_m); // on the floor, straight below

// Share of a disc of radius 1 on one side of a chord, -1 (none) to 1 (all) from its middle.
double disc_share(double chord) {
    const double x = std::clamp(chord, -1.0, 1.0);
    return 0.5 + (x * std::sqrt(1 - x * x) + std::asin(x)) / std::acos(-1.0);
}

struct Profile {
    std::vector<double> place_m;
    std::vector<double> lit; // share, from dark to bright
    double at(double share) const {
        for (std::size_t k = 1; k < lit.size(); ++k)
            if (lit[k - 1] < share && lit[k] >= share)
                return place_m[k - 1] +
                       (place_m[k] - place_m[k - 1]) * (share - lit[k - 1]) / (lit[k] - lit[k - 1]);
        ADD_FAILURE() << "the light never reaches " << share;
        return 0;
    }
};

Profile profile_of(float disc_radius_m) {
    scene::Stage stage = empty_stage();
    add_box(stage, {-30, -30, -0.2f}, {30, 30, 0});
    add_box(stage, {-10, -10, kPlate_m - 0.005f}, {0, 10, kPlate_m + 0.005f});
    shared::Light light = aimed_light({0, 0, kLamp_m}, {0, 0, 0}, 60, true);
    light.disc_radius_m = disc_radius_m;
    render::Settings settings = bench_settings();
    settings.air = false;
    const LiveStage::Eye eye{{0, -3, 3}, {0, 0, 0}, 0.5f};
    LiveStage with(stage, {light}, kPixels, 16, settings, kShadowMapSize);
    LiveStage without(stage, {light}, kPixels, 16, settings, kNoMaps);
    with.look(eye);
    without.look(eye);
    const image::ImageF shadowed = with.draw(), open = without.draw();
    Profile profile;
    const double half_m = std::tan(glm::radians(0.25)) * (kPixels / 16.0) * std::sqrt(18.0);
    for (int x = 0; x < kPixels; ++x) {
        profile.place_m.push_back(((x + 0.5) / kPixels * 2 - 1) * half_m);
        profile.lit.push_back(static_cast<double>(shadowed.at(x, 8)[1]) /
                              static_cast<double>(open.at(x, 8)[1]));
    }
    return profile;
}

// Penumbrae of few texels are off by a part of one; limits a little above what was measured.
TEST(SoftShadow, IsAsWideAsTheLensMakesIt) {
    struct Lens {
        float radius_m;
        double width_off; // share of the width, at most
        double share_off; // of the light
    };
    for (const auto& [radius_m, width_off, share_off] : {Lens{0.02f, 0.05, 0.04},
                                                         {0.04f, 0.04, 0.045},
                                                         {0.07f, 0.03, 0.015},
                                                         {0.1f, 0.02, 0.027},
                                                         {0.12f, 0.01, 0.018}}) {
        const Profile profile = profile_of(radius_m);
        // A point of the floor at x sees the lens past the plate's edge.
        const double half_m = static_cast<double>(radius_m * kPlate_m / (kLamp_m - kPlate_m));
        double worst = 0;
        for (std::size_t k = 0; k < profile.lit.size(); ++k)
            worst = std::max(worst, std::abs(profile.lit[k] - disc_share(profile.place_m[k] / half_m)));
        const double width_m = profile.at(0.9) - profile.at(0.1), wanted_m = 2 * 0.6870 * half_m;
        std::printf("lens of %.0f mm: penumbra of %.1f texels, 10 to 90 %% in %.1f mm (%.1f), middle off by "
                    "%.1f mm, worst share %.4f\n",
                    1e3 * static_cast<double>(radius_m), 2 * half_m / kTexel_m, 1e3 * width_m, 1e3 * wanted_m,
                    1e3 * profile.at(0.5), worst);
        EXPECT_NEAR(width_m / wanted_m, 1, width_off);
        EXPECT_NEAR(profile.at(0.5), 0, 0.05 * kTexel_m);
        EXPECT_LE(worst, share_off);
    }
}

TEST(SoftShadow, OfAPointIsOneTexelWide) {
    const Profile profile = profile_of(0);
    EXPECT_NEAR(profile.at(0.9) - profile.at(0.1), 0.7 * kTexel_m, 0.1 * kTexel_m);
    EXPECT_NEAR(profile.at(0.5), 0, 0.6 * kTexel_m);
}

struct Box {
    glm::vec3 low_m;
    glm::vec3 high_m;
};

// What stands between a lamp at (0, 0, 4) with a lens of 7 cm and a wall 9 m away, before brute force with
// a hundred points of the lens; limits a little above what was measured.
struct Obstacles {
    const char* name;
    std::vector<Box> boxes;
    double most_rms;   // of the light's share
    double most_wrong; // share of the pixels that are off by more than a tenth of the light
};

TEST(SoftShadow, OfThinThingsIsThatOfBruteForce) {
    const Box post{{-0.03f, 2.97f, 0}, {0.03f, 3.03f, 8}};
    const Box near_bar{{-2, 0.68f, 4.02f}, {2, 0.72f, 4.06f}};
    const Box far_bar{{-4, 4.97f, 4.6f}, {4, 5.03f, 4.66f}};
    const Box behind_post{{-0.1f, 5.97f, 0}, {-0.04f, 6.03f, 8}};
    const Obstacles all[] = {
        {"post of 6 cm at a third of the way", {post}, 0.016, 0.004},
        {"bar of 4 cm right before the lens", {near_bar}, 0.055, 0.01},
        // What the bar hides from the middle of the lens throws no shadow.
        {"both", {near_bar, post}, 0.075, 0.06},
        {"bars at two distances", {far_bar, behind_post, near_bar}, 0.08, 0.08},
        {"two posts behind each other", {post, behind_post}, 0.04, 0.05},
        {"plate's edge, a bar far aside",
         {{{-6, 1.98f, 0}, {-0.05f, 2.02f, 8}}, {{0.1f, 0.38f, 2}, {0.12f, 0.42f, 6}}},
         0.04,
         0.03},
        {"bar before a crate on the wall", {near_bar, {{-0.5f, 8.6f, 3}, {0.6f, 9, 4.2f}}}, 0.055, 0.01},
    };
    for (const Obstacles& obstacles : all) {
        SCOPED_TRACE(obstacles.name);
        scene::Stage wall = empty_stage();
        add_box(wall, {-30, 9, -30}, {30, 9.2f, 30});
        scene::Stage stage = wall;
        for (const Box& box : obstacles.boxes) add_box(stage, box.low_m, box.high_m);
        shared::Light light = aimed_light({0, 0, 4}, {0, 9, 4}, 26, true);
        light.disc_radius_m = 0.07f;
        render::Settings settings = bench_settings();
        settings.air = false;
        const LiveStage::Eye eye{{6, 1, 4.6f}, {0, 9, 4.1f}, 22};
        LiveStage with(stage, {light}, 160, 90, settings, kShadowMapSize);
        LiveStage without(stage, {light}, 160, 90, settings, kNoMaps);
        LiveStage bare(wall, {light}, 160, 90, settings, kNoMaps);
        for (LiveStage* each : {&with, &without, &bare}) each->look(eye);
        const image::ImageF shadowed = with.draw(), seen = without.draw(), open = bare.draw();
        const image::ImageF wanted = with.reference(1, {}, 100);
        // On the wall; the beam's own edge is another matter.
        const float least = 0.3f * *std::max_element(open.samples.begin(), open.samples.end());
        double squares = 0, worst = 0, lit = 0, wrong = 0, bias = 0, before = 0;
        int steps = 0; // from one pixel to the next, where there are none

        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 160; ++x) {
                const auto full = static_cast<double>(open.at(x, y)[1]);
                if (open.at(x, y)[1] < least ||
                    std::abs(static_cast<double>(seen.at(x, y)[1]) / full - 1) > 1e-3)
                    continue;
                const double off =
                    (static_cast<double>(shadowed.at(x, y)[1]) - static_cast<double>(wanted.at(x, y)[1])) /
                    full;
                lit += 1;
                steps += std::abs(off - before) > 0.3 ? 1 : 0;
                before = off;
                squares += off * off;
                bias += off;
                worst = std::max(worst, std::abs(off));
                wrong += std::abs(off) > 0.1 ? 1 : 0;
            }
        std::printf("%-36s rms %.4f, mean %+.4f, worst %.3f, off by a tenth %.3f, %d steps\n", obstacles.name,
                    std::sqrt(squares / lit), bias / lit, worst, wrong / lit, steps);
        EXPECT_LE(std::sqrt(squares / lit), obstacles.most_rms);
        EXPECT_LE(wrong / lit, obstacles.most_wrong);
        EXPECT_LE(steps, 20);
        ASSERT_GT(lit, 500) << "nothing to judge by";
    }
}

} // namespace
} // namespace ghost::app
