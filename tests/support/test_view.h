#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hand-made passes, gobos and lights for the tests of the relighter; one device, with validation, for all of
// them.

#include "image/pyramid.h"
#include "light/gobos.h"
#include "light/projector_beam.h"
#include "photometry/photometry.h"
#include "render/relight/relighter.h"
#include "show/show.h"
#include "support/must.h"
#include "support/one_device.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace ghost::render {

inline constexpr shared::Haze kHaze{0.022f, 0.022f, 0.77f, -0.6f, 0.035f};

// Every test ends with Vulkan used as the specification asks.
class RelightTest : public ::testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(device().validation_errors(), 0u); }
};

inline scene::Camera camera_at(const glm::vec3& eye_m, const glm::vec3& target_m, float fov_y_deg, int width,
                               int height) {
    scene::Camera camera;
    camera.position_m = eye_m;
    camera.target_m = target_m;
    camera.fov_y_deg = fov_y_deg;
    camera.width = width;
    camera.height = height;
    return camera;
}

// Unit ray through image point (x, y), as shared::View says.
inline glm::vec3 ray_through(const scene::Passes& passes, float x, float y) {
    const glm::mat4& m = passes.camera_to_world;
    const float tan_y = std::tan(glm::radians(passes.fov_y_deg) * 0.5f);
    const float tan_x = tan_y * static_cast<float>(passes.width) / static_cast<float>(passes.height);
    return glm::normalize(-glm::vec3(m[2]) +
                          glm::vec3(m[0]) * tan_x * (2.0f * x / static_cast<float>(passes.width) - 1.0f) +
                          glm::vec3(m[1]) * tan_y * (1.0f - 2.0f * y / static_cast<float>(passes.height)));
}

inline glm::vec3 eye_of(const scene::Passes& passes) {
    return glm::vec3(passes.camera_to_world[3]);
}

// The plane y = wall_y, one fragment a pixel, without a light.
inline scene::Passes wall_passes(const scene::Camera& camera, float wall_y) {
    scene::Passes passes;
    passes.width = camera.width;
    passes.height = camera.height;
    passes.camera_to_world = scene::camera_to_world(camera);
    passes.fov_y_deg = camera.fov_y_deg;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const glm::vec3 way =
                ray_through(passes, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const float t = (wall_y - camera.position_m.y) / way.y;
            passes.fragments.push_back(t > 0 ? glm::vec4(camera.position_m + t * way, 1.0f)
                                             : glm::vec4(0, 0, 0, -1));
        }
    passes.extra_first.assign(passes.pixel_count() + 1, 0);
    return passes;
}

// Adds a picture: radiance(position) in cd/m^2 per cd, times the coverage.
inline std::uint32_t add_pass(scene::Passes& passes, const glm::vec3& position_m,
                              const std::function<glm::vec3(const glm::vec3&)>& radiance) {
    scene::LightPass pass;
    pass.position_m = position_m;
    for (const glm::vec4& fragment : passes.fragments) {
        const glm::vec3 value = fragment.w < 0 ? glm::vec3(0) : radiance(glm::vec3(fragment)) * fragment.w;
        for (int c = 0; c < 3; ++c)
            pass.radiance.push_back(glm::packHalf1x16(value[c] * scene::kRadianceScale));
        pass.radiance.push_back(0);
    }
    passes.lights.push_back(std::move(pass));
    return static_cast<std::uint32_t>(passes.lights.size() - 1);
}

// A light as light_from makes it, with the peak given in candela.
inline shared::Light aimed_light(const glm::vec3& from, const glm::vec3& to, float field_deg, float peak_cd,
                                 bool hard_edge = true) {
    const scene::Profile profile =
        scene::make_profile(field_deg * (hard_edge ? 0.85f : 0.6f), field_deg, hard_edge);
    shared::Light light{};
    light.position_m = from;
    light.axis_w = glm::normalize(to - from);
    const glm::vec3 aside = std::abs(light.axis_w.z) > 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    light.axis_u = glm::normalize(glm::cross(light.axis_w, aside));
    light.axis_v = glm::cross(light.axis_u, light.axis_w);
    light.lens_m = 0.255f;
    light.tan_field = profile.tan_field;
    light.cut_radius = profile.cut_radius;
    light.profile_power = profile.power;
    light.profile_scale = profile.scale;
    light.intensity_cd = glm::vec3(peak_cd);
    light.colour_b = glm::vec3(1.0f);
    light.split = shared::kNoSplit;
    light.iris_radius = profile.aperture;
    light.edge = profile.edge;
    light.focus_per_m = 1.0f / 10.0f;
    light.lens_radius_m = hard_edge ? 0.07f : 0.0f;
    light.haze_samples = 4;
    return light;
}

inline void put_gobo(shared::Light& light, std::uint32_t layer, float turn_deg = 0, float shift = 0,
                     std::uint32_t next_layer = 0) {
    const float turn = glm::radians(turn_deg);
    if (shift != 0 && light.shaped != 2) { // as light/gate.cpp has it
        light.shaped = 2;
        for (shared::Blade& blade : light.blade) blade.offset = shared::kNoSplit;
    }
    light.wheel[light.wheel_count++] = {layer, next_layer, shift, std::cos(turn), std::sin(turn), 0};
    light.haze_samples = 10;
}

// A moving picture as it stands now: squares in colours, round ones among them.
inline const image::Pyramid& test_slide() {
    static const image::Pyramid made = [] {
        image::Image8 picture(256, 144, 4);
        for (int y = 0; y < 144; ++y)
            for (int x = 0; x < 256; ++x) {
                const bool round = std::hypot(x % 48 - 24, y % 48 - 24) < 17;
                const int square = x / 32 + 3 * (y / 36);
                std::uint8_t* t = picture.at(x, y);
                t[0] = round ? 255 : square % 3 == 0 ? 220 : 10;
                t[1] = round ? 230 : square % 3 == 1 ? 200 : 40;
                t[2] = square % 3 == 2 ? 240 : 30;
                t[3] = 255;
            }
        return image::make_pyramid(picture, 256);
    }();
    return made;
}

// What a video projector with that picture makes of a light.
// Swept along a curve, 60 degrees and more across: the laser itself is deviation_deg wide.
inline void put_figure(shared::Light& light, std::uint32_t kind, float deviation_deg) {
    light.tan_field = 0.7f;
    light.cut_radius = 1.0f;
    light.iris_radius = 2.0f;
    light.profile_scale = 0.0f;
    light.edge = 1e-4f;
    light.lens_radius_m = 0.0025f;
    light.focus_per_m = 0.0f;
    light.haze_samples = 10;
    const float deviation = std::tan(glm::radians(deviation_deg)) / light.tan_field;
    light.figure = {kind, {0.8f, 0.4f}, std::cos(0.4f), std::sin(0.4f), deviation, 0.7f, 2.0f};
}

inline void put_slide(shared::Light& light, const scene::Projector& settings = {}) {
    fixture::Optics optics;
    optics.zoom_deg = 2.0f * glm::degrees(std::atan(light.tan_field));
    const scene::MediaNow now{1, test_slide().extent, test_slide().mean, test_slide().side};
    scene::project(settings, optics, now, 0, light);
    light.haze_samples = 10;
}

// Layer 1: a chequered picture, layer 2: dots, layer 3: bars in colours; and the moving picture.
inline const shared::Gobos& test_gobos() {
    static const shared::Gobos gobos = [] {
        shared::Gobos made;
        std::vector<std::uint8_t> rgba(256 * 256 * 4);
        for (int kind = 0; kind < 3; ++kind) {
            for (int y = 0; y < 256; ++y)
                for (int x = 0; x < 256; ++x) {
                    const bool check = (x / 32 + y / 32) % 2 == 0;
                    const bool dot = std::hypot(x % 64 - 32, y % 64 - 32) < 20;
                    std::uint8_t* t =
                        rgba.data() + (static_cast<std::size_t>(y) * 256 + static_cast<std::size_t>(x)) * 4;
                    t[0] = kind == 0   ? (check ? 255 : 20)
                           : kind == 1 ? (dot ? 255 : 0)
                                       : (x / 20 % 3 == 0 ? 255 : 30);
                    t[1] = kind == 2 ? (x / 20 % 3 == 1 ? 255 : 60) : t[0];
                    t[2] = kind == 2 ? (x / 20 % 3 == 2 ? 255 : 0) : t[0];
                    t[3] = 255;
                }
            scene::append_gobo(made, rgba.data(), 256, 256);
        }
        made.slides.push_back({test_slide().side, test_slide().levels});
        return made;
    }();
    return gobos;
}

// Any light that a desk can set, within the cone of `to`.
inline shared::Light random_light(std::mt19937& random, const glm::vec3& from, const glm::vec3& to) {
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    shared::Light light =
        aimed_light(from, to, 3.0f + 50.0f * unit(), 500.0f + 3000.0f * unit(), random() % 2 == 0);
    light.intensity_cd *= glm::vec3(unit(), unit(), unit());
    if (random() % 2 == 0) {
        light.split = 2.4f * (unit() - 0.5f);
        light.colour_b = glm::vec3(unit(), 2.0f * unit(), unit());
    }
    light.focus_per_m = 1.0f / (2.0f + 48.0f * unit());
    if (random() % 4 == 0) light.iris_radius *= 0.1f + 0.9f * unit();
    for (auto wheels = random() % 3; wheels > 0; --wheels)
        put_gobo(light, 1 + static_cast<std::uint32_t>(random() % 3), 360.0f * unit(),
                 random() % 3 == 0 ? unit() : 0.0f, static_cast<std::uint32_t>(random() % 4));
    return light;
}

inline scene::Passes white_wall(int width, int height) {
    return wall_passes(camera_at({0.5f, -8, 2}, {0, 4, 2.5f}, 30, width, height), 4.0f);
}

// A wall in disorder: every pixel with 0 to 3 extra fragments at other places and coverage of their own.
inline scene::Passes edgy_passes(std::mt19937& random, int width, int height) {
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    scene::Passes passes = white_wall(width, height);
    std::vector<glm::vec4> extra;
    for (std::size_t p = 0; p < passes.pixel_count(); ++p) {
        passes.extra_first[p] = static_cast<std::uint32_t>(extra.size());
        const unsigned kind = random() % 8;
        if (kind == 0) {
            passes.fragments[p] = glm::vec4(0, 0, 0, -1);
            continue;
        }
        if (kind > 3) continue;
        passes.fragments[p].w = 0.4f;
        for (unsigned k = 0; k < kind; ++k) {
            const glm::vec3 eye = eye_of(passes);
            const glm::vec3 nearer = eye + (glm::vec3(passes.fragments[p]) - eye) * (0.3f + 0.6f * unit());
            extra.emplace_back(nearer, 0.2f);
        }
    }
    passes.extra_first.back() = static_cast<std::uint32_t>(extra.size());
    passes.fragments.insert(passes.fragments.end(), extra.begin(), extra.end());
    return passes;
}

inline std::vector<shared::Light> random_rig(std::mt19937& random, scene::Passes& passes, int count) {
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    std::vector<shared::Light> lights;
    for (int k = 0; k < count; ++k) {
        const glm::vec3 from(-5.0f + 10.0f * unit(), -6.0f + 8.0f * unit(), 4.0f + 3.0f * unit());
        lights.push_back(random_light(random, from, {-3.0f + 6.0f * unit(), 4, 4.0f * unit()}));
        // Of two pixels and more: narrower beams are dots (shaders/common/thin_dot.glsl).
        lights.back().tan_field = std::max(lights.back().tan_field, 0.25f);
        if (passes.lights.size() < 12) {
            const glm::vec3 colour(unit(), unit(), unit());
            add_pass(passes, from, [&](const glm::vec3& x) { return colour / glm::dot(x - from, x - from); });
        }
        lights.back().pass = static_cast<std::uint32_t>(k % 13); // one of them beyond the passes: dark
        if (k % 13 == 12) lights.back().pass = static_cast<std::uint32_t>(passes.lights.size());
    }
    for (shared::Light& light : lights)
        light.pass = std::min(light.pass, static_cast<std::uint32_t>(passes.lights.size()));
    return lights;
}

struct Difference {
    double mean_bias = 0; // of the sums: picture / reference - 1
    double worst = 0;     // of one sample, as a share of the reference's largest
    double rms = 0;       // as a share of the reference's mean
};

inline Difference compare(const image::ImageF& picture, const image::ImageF& reference) {
    EXPECT_EQ(picture.samples.size(), reference.samples.size());
    double sum = 0, sum_reference = 0, most = 1e-30, worst = 0, squares = 0;
    for (std::size_t k = 0; k < reference.samples.size(); ++k) {
        const double value = picture.samples.at(k);
        const double expected = reference.samples[k];
        sum += value;
        sum_reference += expected;
        most = std::max(most, expected);
        worst = std::max(worst, std::abs(value - expected));
        squares += (value - expected) * (value - expected);
        EXPECT_TRUE(std::isfinite(value));
    }
    const double count = static_cast<double>(reference.samples.size());
    const double mean = std::max(sum_reference / count, 1e-30);
    return {sum / std::max(sum_reference, 1e-30) - 1.0, worst / most, std::sqrt(squares / count) / mean};
}

inline Settings clear_air() {
    Settings settings;
    settings.air = false;
    return settings;
}

} // namespace ghost::render
