// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/layout.h"

#include "base/check.h"
#include "shared/haze.h"

#include <algorithm>
#include <cmath>

namespace ghost::render {
namespace {

constexpr float kNoSurface_m = 60.0f; // length of a ray that leaves the hall

float distance_m(const glm::vec4& fragment, const glm::vec3& eye_m) {
    return fragment.w < 0 ? kNoSurface_m : glm::length(glm::vec3(fragment) - eye_m);
}

// The sphere round some fragments (radius below zero: no surface among them), and the farthest of them,
// beyond which no light can be seen.
void add_bounds(const scene::Passes& passes, const std::vector<std::uint32_t>& fragments,
                std::vector<glm::vec4>& bounds) {
    const glm::vec3 eye_m(passes.camera_to_world[3]);
    float far = 0;
    glm::vec3 low(1e30f), high(-1e30f);
    for (const std::uint32_t i : fragments) {
        far = std::max(far, distance_m(passes.fragments[i], eye_m));
        if (passes.fragments[i].w < 0) continue;
        low = glm::min(low, glm::vec3(passes.fragments[i]));
        high = glm::max(high, glm::vec3(passes.fragments[i]));
    }
    const bool any = low.x <= high.x;
    const glm::vec3 centre = any ? (low + high) * 0.5f : glm::vec3(0.0f);
    float radius = any ? 0.0f : -1.0f;
    for (const std::uint32_t i : fragments)
        if (passes.fragments[i].w >= 0)
            radius = std::max(radius, glm::length(glm::vec3(passes.fragments[i]) - centre));
    bounds.emplace_back(centre, radius);
    bounds.emplace_back(far, 0, 0, 0);
}

} // namespace

Layout make_layout(const scene::Passes& passes, std::uint32_t tiles_x, std::uint32_t tiles_y) {
    const auto width = static_cast<std::uint32_t>(passes.width);
    const auto height = static_cast<std::uint32_t>(passes.height);
    Layout layout;
    for (std::uint32_t pixel = 0; pixel < passes.pixel_count(); ++pixel) layout.order.push_back(pixel);
    std::vector<std::uint32_t> together;
    for (std::uint32_t tile = 0; tile < tiles_x * tiles_y; ++tile) {
        together.clear();
        const std::uint32_t x0 = tile % tiles_x * shared::kTileWidth;
        const std::uint32_t y0 = tile / tiles_x * shared::kTileHeight;
        for (std::uint32_t y = y0; y < std::min(y0 + shared::kTileHeight, height); ++y)
            for (std::uint32_t x = x0; x < std::min(x0 + shared::kTileWidth, width); ++x) {
                const std::uint32_t pixel = y * width + x;
                together.push_back(pixel);
                const std::uint32_t count = passes.extra_first[pixel + 1] - passes.extra_first[pixel];
                CHECK(count <= scene::kMostExtraFragments);
                if (count == 0) continue;
                const auto first = static_cast<std::uint32_t>(layout.order.size() - passes.pixel_count());
                layout.edges.emplace_back(pixel, first * 4 + count);
                for (std::uint32_t k = 0; k < count; ++k) {
                    const auto extra =
                        static_cast<std::uint32_t>(passes.pixel_count()) + passes.extra_first[pixel] + k;
                    layout.order.push_back(extra);
                    together.push_back(extra);
                }
            }
        add_bounds(passes, together, layout.bounds);
    }
    for (std::size_t begin = passes.pixel_count(); begin < layout.order.size();
         begin += shared::kTilePixels) {
        const std::size_t end = std::min(begin + shared::kTilePixels, layout.order.size());
        together.assign(layout.order.begin() + static_cast<std::ptrdiff_t>(begin),
                        layout.order.begin() + static_cast<std::ptrdiff_t>(end));
        add_bounds(passes, together, layout.bounds);
        ++layout.blocks;
    }
    return layout;
}

shared::View make_view(const glm::mat4& camera_to_world, float fov_y_deg, int width, int height,
                       const shared::Haze& haze) {
    const glm::mat4& m = camera_to_world;
    const float tan_y = std::tan(fov_y_deg * 0.5f * shared::kPi / 180.0f);
    const float tan_x = tan_y * static_cast<float>(width) / static_cast<float>(height);
    shared::View view{};
    view.eye_m = glm::vec3(m[3]);
    view.width = static_cast<std::uint32_t>(width);
    view.height = static_cast<std::uint32_t>(height);
    view.forward = -glm::vec3(m[2]);
    view.right = glm::vec3(m[0]) * tan_x;
    view.up = glm::vec3(m[1]) * tan_y;
    view.far_m = kNoSurface_m;
    view.haze = haze;
    return view;
}

shared::View make_view(const scene::Passes& passes, const shared::Haze& haze) {
    return make_view(passes.camera_to_world, passes.fov_y_deg, passes.width, passes.height, haze);
}

float pixels_per_rad(const shared::View& view) {
    return static_cast<float>(view.height) / (2.0f * glm::length(view.up));
}

std::vector<glm::vec4> base_image(const scene::Passes& passes, const glm::vec3& ambient,
                                  const shared::Haze& haze) {
    const glm::vec3 eye_m(passes.camera_to_world[3]);
    const auto light_of = [&](std::size_t fragment) {
        glm::vec3 sum(0.0f);
        if (fragment < passes.ambient.size()) sum += glm::vec3(passes.ambient[fragment]) * ambient;
        if (fragment < passes.emission.size()) sum += glm::vec3(passes.emission[fragment]);
        return sum * shared::haze_transmittance(haze, distance_m(passes.fragments[fragment], eye_m));
    };
    std::vector<glm::vec4> base(passes.pixel_count());
    for (std::size_t pixel = 0; pixel < base.size(); ++pixel) {
        glm::vec3 sum = light_of(pixel);
        for (std::uint32_t k = passes.extra_first[pixel]; k < passes.extra_first[pixel + 1]; ++k)
            sum += light_of(passes.pixel_count() + k);
        base[pixel] = glm::vec4(sum, 0.0f);
    }
    return base;
}

} // namespace ghost::render
