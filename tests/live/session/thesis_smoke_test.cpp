// SPDX-License-Identifier: Apache-2.0
// Smoke as the thesis has it (9.2, step 4: drifting noise; figure 9.18: without smoke only the surfaces are
// lit) and past it: swirls in space that the wind carries, plumes of hazers, the thesis's attenuation. The
// free camera's picture against the reference that marches through the same air.
#include "live/session/session.h"
#include "support/thesis_scene.h"

#include "shared/air.h"

namespace ghost::app {
namespace {

using glm::vec3;

constexpr int kSmokeWidth = 64;
constexpr int kSmokeHeight = 36;

scene::Show smoky_show() {
    scene::Show show;
    show.haze.extinction_per_m = 0.022f;
    show.haze.unevenness = 0.8f;
    show.haze.patch_m = 2;
    show.haze.wind_m_s = {0.6f, 0, 0.1f};
    scene::Hazer hazer;
    hazer.position_m = {-3, 2.5f, 0.2f};
    hazer.direction = glm::normalize(vec3(0.8f, 0, 1));
    hazer.rate = 4;
    show.hazers.push_back(hazer);
    return show;
}

std::vector<shared::Light> two_beams() {
    return {aimed_light({-4, 3, 6}, {4, 3, 0}, 24, true), aimed_light({3, 4, 6.5f}, {-1, 1, 0}, 30, false)};
}

render::Settings with_air(render::Settings settings, const shared::Air& air) {
    settings.air_field = air;
    settings.beams.uneven = true;
    return settings;
}

TEST(thesis_smoke, SwirlsAndAPlumeAreTheReference) {
    const scene::Show show = smoky_show();
    for (const double time_s : {0.0, 12.5}) {
        const shared::Air air = atmosphere_of(show).field(time_s);
        LiveStage stage(small_stage(), two_beams(), kSmokeWidth, kSmokeHeight, with_air(haze_only(), air),
                        1024);
        stage.look(kHouse);
        const image::ImageF live = stage.draw();
        // The reference also weakens light on its way by the haze that is there; the live picture by even
        // haze.
        const Likeness found = likeness(live, stage.reference(384, [air](const glm::dvec3& place_m) {
            return static_cast<double>(shared::air_density(air, vec3(place_m)));
        }));
        const Likeness even = likeness(live, stage.reference(384));
        std::printf("swirls and a plume at %4.1f s: %.1f dB, bias %.2f %%; against even haze %.1f dB\n",
                    time_s, found.psnr_db, 100 * found.bias, even.psnr_db);
        EXPECT_GE(found.psnr_db, 42.0);
        EXPECT_LT(std::abs(found.bias), 0.025);
        EXPECT_GE(found.psnr_db, even.psnr_db + 6);
    }
}

TEST(thesis_smoke, TimeAloneSaysHowTheSmokeLies) {
    const scene::Show show = smoky_show();
    LiveStage stage(small_stage(), two_beams(), kSmokeWidth, kSmokeHeight,
                    with_air(haze_only(), atmosphere_of(show).field()));
    stage.look(kHouse);
    const auto at = [&](double time_s) {
        stage.relighter().set_air(atmosphere_of(show).field(time_s));
        return stage.draw();
    };
    const image::ImageF first = at(7);
    const image::ImageF other = at(9);
    EXPECT_NE(first.samples, other.samples);
    EXPECT_EQ(at(7).samples, first.samples);
    // It drifts and does not jump.
    EXPECT_GT(likeness(at(7.05), first).psnr_db, likeness(other, first).psnr_db + 10);
}

TEST(thesis_smoke, WithoutSmokeOnlySurfacesAreLit) {
    render::Settings clear = bench_settings();
    clear.haze.extinction_per_m = clear.haze.scattering_per_m = 0;
    LiveStage stage(small_stage(), two_beams(), kSmokeWidth, kSmokeHeight,
                    with_air(clear, atmosphere_of(smoky_show()).field(3)), 256);
    stage.look(kHouse);
    const image::ImageF picture = stage.draw();
    render::Settings no_air = stage.settings();
    no_air.air = false;
    stage.renew(no_air, bench_gobos());
    stage.look(kHouse);
    EXPECT_EQ(stage.draw().samples, picture.samples);
    EXPECT_GT(mean_of(picture), 0.1);
    render::Settings only_air = with_air(clear, atmosphere_of(smoky_show()).field(3));
    only_air.surfaces = false;
    stage.renew(only_air, bench_gobos());
    EXPECT_EQ(mean_of(stage.draw()), 0);
}

TEST(thesis_smoke, AttenuationOfHazeIsTheReferences) {
    for (const shared::Attenuation& attenuation : {shared::Attenuation{0, 0.1f, 0}, {1, 0.2f, 0.02f}}) {
        render::Settings settings = haze_only();
        settings.air_field.attenuation = attenuation;
        LiveStage stage(small_stage(), two_beams(), kSmokeWidth, kSmokeHeight, settings, 2048);
        stage.look(kHouse);
        const Likeness found = likeness(stage.draw(), stage.reference(384));
        std::printf("haze, 1 / (%g + %g d + %g d^2): %.1f dB, bias %.3f %%\n",
                    static_cast<double>(attenuation.constant), static_cast<double>(attenuation.linear),
                    static_cast<double>(attenuation.quadratic), found.psnr_db, 100 * found.bias);
        EXPECT_GE(found.psnr_db, 41.0);
        EXPECT_LT(std::abs(found.bias), 0.003);
    }
}

// A wall across the beam, without shadows: light on surfaces over that of physics is d^2 / (c + l d + q d^2).
TEST(thesis_smoke, AttenuationOfSurfacesIsTheClosedForm) {
    render::Settings settings = bench_settings();
    settings.air = false;
    scene::Stage wall = empty_stage();
    add_box(wall, {-40, 6, -40}, {40, 6.2f, 40});
    const shared::Light lamp = aimed_light({0, 1, 3}, {0, 6, 3}, 60, false);
    LiveStage stage(std::move(wall), {lamp}, kSmokeWidth, kSmokeHeight, settings);
    stage.look(kHouse);
    const image::ImageF physical = stage.draw();
    const shared::Attenuation attenuation{1, 0.2f, 0.02f};
    settings.air_field.attenuation = attenuation;
    stage.renew(settings, bench_gobos());
    const image::ImageF picture = stage.draw();
    const scene::Camera camera = stage.camera_at(kHouse);
    const double tan_y = std::tan(glm::radians(static_cast<double>(camera.fov_y_deg)) / 2);
    double worst = 0;
    int lit = 0;
    for (int y = 0; y < kSmokeHeight; ++y)
        for (int x = 0; x < kSmokeWidth; ++x) {
            // The camera looks along +Y, over 18 m to the wall.
            const double right = 18 * tan_y * kSmokeWidth / kSmokeHeight * ((2 * x + 1.0) / kSmokeWidth - 1);
            const double up = 18 * tan_y * (1 - (2 * y + 1.0) / kSmokeHeight);
            const double d_m = std::sqrt(right * right + up * up + 25);
            const double before = physical.at(x, y)[0], after = picture.at(x, y)[0];
            if (before < 0.5) continue;
            ++lit;
            const double expected = before * d_m * d_m / (1 + 0.2 * d_m + 0.02 * d_m * d_m);
            worst = std::max(worst, std::abs(after / expected - 1));
        }
    std::printf("surfaces, attenuation over physics: worst of %d pixels %.3f %%\n", lit, 100 * worst);
    EXPECT_GT(lit, 50);
    EXPECT_LT(worst, 0.004);
}

TEST(thesis_smoke, DISABLED_Picture) {
    ASSERT_TRUE(picture_folder()) << "GHOST_THESIS_PICTURES: the folder to write to";
    std::vector<image::Image8> views;
    const auto add = [&](const render::Settings& settings) {
        LiveStage stage(small_stage(), two_beams(), kPictureWidth / 2, kPictureHeight / 2, settings, 1024);
        stage.look(kHouse);
        stage.draw();
        views.push_back(stage.relighter().picture());
    };
    const render::Settings usual = picture_settings(4);
    render::Settings clear = usual;
    clear.haze.extinction_per_m = clear.haze.scattering_per_m = 0;
    render::Settings linear = usual;
    linear.air_field.attenuation = {0, 0.25f, 0};
    add(usual);
    add(with_air(usual, atmosphere_of(smoky_show()).field(12.5)));
    add(clear);
    add(linear);
    write_picture("smoke", panels(views, 2));
}

} // namespace
} // namespace ghost::app
