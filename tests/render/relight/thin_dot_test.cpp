// SPDX-License-Identifier: Apache-2.0
// The dot of a beam that is narrower than a pixel.
#include "shared/beam.h"
#include "support/test_view.h"

#include <cstdio>

namespace ghost::render {
namespace {

using glm::vec3;

using ThinDot = RelightTest;

constexpr int kWidth = 48, kHeight = 27;

// Lumens of its open gate.
void set_lumens(shared::Light& light) {
    constexpr int kSteps = 2000;
    double fraction = 0;
    const double tangent = static_cast<double>(light.tan_field);
    for (int k = 0; k < kSteps; ++k) {
        const double radius = (k + 0.5) / kSteps * static_cast<double>(light.cut_radius);
        const vec3 passed = shared::beam_gate(light, {static_cast<float>(radius), 0},
                                              shared::even_focus(light, light.edge), test_gobos());
        const double slant = 1 + radius * radius * tangent * tangent;
        fraction += static_cast<double>(passed.y) * radius / (slant * std::sqrt(slant));
    }
    fraction *= 2 * 3.14159265358979 * tangent * tangent * static_cast<double>(light.cut_radius) / kSteps;
    light.bounce_cd = light.intensity_cd * static_cast<float>(fraction / (4 * 3.14159265358979));
}

// Sum of what a wall aslant before the camera shows of it, in pixels of the coarse picture.
double seen(const vec3& to, int finer) {
    shared::Light light = aimed_light({-4, 0, 5}, to, 0.6f, 8000);
    light.lens_radius_m = 0;
    set_lumens(light);
    scene::Passes passes =
        wall_passes(camera_at({-6, -6, 3}, {1, 6, 3}, 26, kWidth * finer, kHeight * finer), 6.0f);
    light.pass = add_pass(passes, light.position_m, [&](const vec3& at) {
        const vec3 way = at - light.position_m;
        return vec3(0.1f * way.y / (glm::length(way) * glm::dot(way, way)));
    });
    Settings settings;
    settings.air = false;
    Relighter relighter(device(), passes, test_gobos(), 1, settings);
    relighter.draw(std::vector{light});
    const image::ImageF picture = relighter.frame();
    double sum = 0;
    for (std::size_t k = 1; k < picture.samples.size(); k += 3)
        sum += static_cast<double>(picture.samples[k]);
    return sum / (finer * finer);
}

TEST_F(ThinDot, HasItsLightWhereverItFalls) {
    double least = 1e9, most = 0;
    // Over two pixels and more, across and down.
    for (int k = 0; k < 8; ++k) {
        const float part = static_cast<float>(k) / 7;
        const vec3 to{1 + 0.7f * part, 6, 3 + 0.5f * part};
        const double fine = seen(to, 16);
        ASSERT_GT(fine, 0);
        const double fraction = seen(to, 1) / fine;
        least = std::min(least, fraction);
        most = std::max(most, fraction);
    }
    std::printf("a dot of a fifth of a pixel has %.3f to %.3f of its light\n", least, most);
    EXPECT_GT(least, 0.97);
    EXPECT_LT(most, 1.03);
}

} // namespace
} // namespace ghost::render
