// SPDX-License-Identifier: Apache-2.0
#include "bench/bench.h"

#include "image/metrics.h"
#include "photometry/photometry.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace ghost::app {
namespace {

constexpr float kWall_m = 9.0f;  // behind the stage
constexpr float kEye_m = -15.5f; // front of house
constexpr float kEyeHigh_m = 4.0f;
constexpr float kFovY_deg = 23.4f;
constexpr int kGoboPixels = 256;

} // namespace

std::filesystem::path bench_file(const std::string& ending) {
    static const auto number = std::chrono::steady_clock::now().time_since_epoch().count() / 1'000'000;
    return std::filesystem::temp_directory_path() / ("ghostlight-bench-" + std::to_string(number) + ending);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double display_db(const image::ImageF& test, const image::ImageF& reference) {
    const auto pair = image::pair_up(test, reference, {});
    return pair.ok() ? image::psnr_db(*pair, image::p75_curve(*pair)) : 0;
}

double span_ms(const render::FrameStatistics& frame, const std::string& name) {
    double sum = 0;
    for (const gpu::Span& span : frame.spans)
        if (span.name == name) sum += span.ms;
    return sum;
}

double haze_ms(const render::FrameStatistics& frame) {
    return span_ms(frame, "haze") + span_ms(frame, "fan") + span_ms(frame, "gate");
}

scene::Passes bench_passes(int width, int height, int light_count) {
    scene::Passes passes;
    passes.width = width;
    passes.height = height;
    passes.fov_y_deg = kFovY_deg;
    passes.camera_to_world = glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(0, -1, 0, 0),
                                       glm::vec4(0, kEye_m, kEyeHigh_m, 1));
    passes.extra_first.assign(passes.pixel_count() + 1, 0);
    const float tan_y = std::tan(kFovY_deg * 0.5f * shared::kPi / 180.0f);
    const float tan_x = tan_y * static_cast<float>(width) / static_cast<float>(height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float rx = tan_x * (2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 1);
            const float rz = tan_y * (1 - 2 * (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
            float t = kWall_m - kEye_m;
            if (rz < 0) t = std::min(t, (kEyeHigh_m - 1.2f) / -rz);
            passes.fragments.emplace_back(rx * t, kEye_m + t, kEyeHigh_m + rz * t, 1.0f);
        }
    const std::uint16_t grey = glm::packHalf1x16(0.3f / shared::kPi / 60.0f * scene::kRadianceScale);
    for (int i = 0; i < light_count; ++i) {
        scene::LightPass pass;
        pass.radiance.assign(passes.fragment_count() * 4, grey);
        passes.lights.push_back(std::move(pass));
    }
    return passes;
}

shared::Light bench_light(int index, std::uint32_t wheels, double seconds) {
    const bool spot = wheels > 0;
    const scene::Profile profile =
        spot ? scene::make_profile(20, 24, true) : scene::make_profile(18, 30, false);
    const auto phase = static_cast<float>(seconds * 1.3 + index * 0.7);
    const float pan = 0.5f * std::sin(phase);
    const float tilt = (spot ? -0.5f : 0.5f) + 0.25f * std::cos(phase * 0.8f);
    shared::Light light{};
    light.position_m = glm::vec3(-5.0f + 1.11f * static_cast<float>(index % 10), spot ? 7.5f : 0.5f, 6.4f);
    light.lens_m = 0.3f;
    light.axis_w = glm::normalize(glm::vec3(std::sin(pan), std::sin(tilt), -std::cos(tilt)));
    light.axis_u = glm::normalize(glm::cross(light.axis_w, glm::vec3(0.0f, 1.0f, 0.1f)));
    light.axis_v = glm::cross(light.axis_u, light.axis_w);
    light.tan_field = profile.tan_field;
    light.cut_radius = profile.cut_radius;
    light.profile_power = profile.power;
    light.profile_scale = profile.scale;
    light.iris_radius = profile.aperture;
    light.edge = profile.edge;
    light.lens_radius_m = spot ? 0.07f : 0.0f;
    light.focus_per_m = 0.1f;
    light.intensity_cd = glm::vec3(1.0f, 0.6f, 0.3f) * scene::peak_candela(profile, 10000.0f);
    light.colour_b = glm::vec3(1.0f);
    light.split = shared::kNoSplit;
    light.wheel_count = wheels;
    for (std::uint32_t k = 0; k < wheels; ++k)
        light.wheel[k] = {k + 1,
                          k + 1,
                          0.0f,
                          std::cos(phase * static_cast<float>(k + 1)),
                          std::sin(phase * static_cast<float>(k + 1)),
                          0.0f};
    light.haze_samples = spot ? 10 : 4;
    return light;
}

shared::Gobos bench_gobos() {
    shared::Gobos gobos;
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(kGoboPixels) * kGoboPixels * 4, 255);
    for (int layer = 0; layer < 2; ++layer) {
        for (int y = 0; y < kGoboPixels; ++y)
            for (int x = 0; x < kGoboPixels; ++x) {
                const float fx = static_cast<float>(x) / kGoboPixels * 6.0f;
                const float fy = static_cast<float>(y) / kGoboPixels * 6.0f;
                const float wave = std::sin(fx * 2.1f + std::sin(fy * (layer == 0 ? 1.7f : 2.9f)) * 2.0f) +
                                   std::cos(fy * 2.7f);
                const auto value = static_cast<std::uint8_t>(wave > 0 ? 255 : 0);
                std::fill_n(rgba.begin() + (static_cast<std::ptrdiff_t>(y) * kGoboPixels + x) * 4, 3, value);
            }
        scene::append_gobo(gobos, rgba.data(), kGoboPixels, kGoboPixels);
    }
    return gobos;
}

render::Settings bench_settings() {
    render::Settings settings;
    settings.haze = {0.022f, 0.022f, 0.77f, -0.6f, 0.035f};
    return settings;
}

} // namespace ghost::app
