// SPDX-License-Identifier: Apache-2.0
#include "render/haze/fan_nodes.h"

#include "base/check.h"
#include "shared/optics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ghost::render {
namespace {

constexpr float kBladeIsOut = 4.0f; // gate radii
constexpr float kLastNode = 1e-3f;  // of the way, see nodes_of
constexpr float kNodeRatio = 2.0f;
constexpr float kCoarser = 1.2f;
constexpr float kFineRows = 2.0f, kPlainRows = 1.5f; // for the radius of a blur

// Depths of the planes that a shaped beam goes through.
std::vector<float> depths_of(const shared::Light& light) {
    std::vector<float> depths{light.iris_depth};
    if (light.slide.layer != 0) depths.push_back(0.0f);
    for (std::uint32_t k = 0; k < light.wheel_count; ++k) depths.push_back(light.wheel[k].depth);
    if (light.disc.layer != 0) depths.push_back(light.disc.depth);
    for (const shared::Blade& blade : light.blade)
        if (blade.offset < kBladeIsOut) depths.push_back(blade.depth);
    std::sort(depths.begin(), depths.end());
    depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
    return depths;
}

std::uint32_t whole_rows(float rows, std::uint32_t least, std::uint32_t most) {
    const auto steps = static_cast<std::uint32_t>(std::ceil(rows / static_cast<float>(shared::kNodeStep)));
    return std::clamp(steps * shared::kNodeStep, least, most);
}

// Rows (and columns) of a level.
struct Sizes {
    const shared::Light& light;
    const BeamExtent& extent;
    FanDetail detail;
    std::uint32_t most;

    // So many as the picture shows at this place of the way.
    std::uint32_t seen(float node) const {
        if (detail == FanDetail::fine || extent.surrounds) return most;
        const double along_m = double{light.lens_radius_m} / (std::max(double{node}, 1e-9) * light.tan_field);
        return whole_rows(rows_per_pixel(detail) * extent.pixels_at(along_m), shared::kLeastSharp, most);
    }
    // A blur that is as wide as one of so many rows.
    float finest(std::uint32_t rows) const { return 2.0f * light.cut_radius / static_cast<float>(rows); }
    // And no more than its planes' blur leaves to be seen.
    std::uint32_t needed(float node, const std::vector<float>& depths) const {
        const bool fine = detail == FanDetail::fine;
        const shared::Focus focus = shared::focus_at(light, node, 0);
        float sharpest = 2.0f * light.cut_radius;
        for (const float depth : depths) sharpest = std::min(sharpest, shared::blur_of(light, focus, depth));
        const float rows =
            (fine ? kFineRows : kPlainRows) * 2.0f * light.cut_radius / std::max(sharpest, 1e-6f);
        return std::min(seen(node), whole_rows(rows, fine ? shared::kLeastSharp : shared::kLeastFan, most));
    }
};

// Falling from 1 (the lens) to the last one, so close that no plane's blur grows or falls by more than
// `ratio` from one to the next, or by more than the finest detail times `coarser` where it is nearly sharp.
std::vector<float> nodes_of(const Sizes& sizes, const std::vector<float>& depths, float last, float coarser) {
    const shared::Light& light = sizes.light;
    const float ratio = kNodeRatio * coarser;
    const float far_blur = light.lens_radius_m * light.focus_per_m / light.tan_field;
    std::vector<float> nodes{1.0f};
    while (nodes.back() > last && nodes.size() <= shared::kFanNodes) {
        const float finest = sizes.finest(sizes.seen(nodes.back())) * coarser;
        float step = nodes.back();
        for (const float depth : depths) {
            const float slope = 1.0f + far_blur - depth; // of its blur, which is linear in t
            const float blur = nodes.back() * slope - (far_blur - depth);
            const float grows = (ratio - 1.0f) * std::abs(blur), falls = grows / ratio;
            step = std::min(step, std::max(finest, blur * slope > 0 ? falls : grows) / std::abs(slope));
        }
        const float next = nodes.back() - step;
        nodes.push_back(next > last + kLastNode ? next : last);
    }
    return nodes;
}

// In lines across the layer.
void place_nodes(shared::Fan& fan, const Sizes& sizes, const std::vector<float>& depths) {
    std::uint32_t x = 0, y = 0, line = 0;
    for (std::uint32_t k = 0; k < fan.levels; ++k) {
        const std::uint32_t side = sizes.needed(fan.node[k].x, depths);
        if (x + side > shared::kFanWidth) {
            y += line;
            x = line = 0;
        }
        CHECK(y + side <= shared::kFinestFan);
        fan.place[k] = shared::fan_placed(x, y, side);
        x += side;
        line = std::max(line, side);
    }
}

} // namespace

float BeamExtent::pixels_at(double along_m) const {
    const double far_m = std::min(along_m, reach_m);
    // Where it is nearest to the eye it is largest.
    const double nearest_m = cosine < 0 ? -eye_m / cosine : INFINITY;
    const double z = std::min(far_m, nearest_m);
    const double from_eye_m = std::sqrt(std::max(z * z + 2 * z * eye_m * cosine + eye_m * eye_m, 0.0));
    return pixels * static_cast<float>(z < from_eye_m ? z / from_eye_m : 1.0);
}

BeamExtent extent_of(const shared::Planes& beam, double tangent, float pixels_per_rad, float reach_m,
                     bool surrounds) {
    BeamExtent extent;
    extent.eye_m = double{beam.eye_m};
    // pole points at the eye. The rim is nearer to it than the axis.
    const double away = std::acos(std::clamp(-double{beam.cos_axis}, -1.0, 1.0)) + std::atan(tangent);
    extent.cosine = std::cos(std::min(away, double{shared::kPi}));
    extent.reach_m = double{reach_m};
    extent.pixels = 2.0f * static_cast<float>(tangent) * pixels_per_rad;
    extent.surrounds = surrounds;
    return extent;
}

void set_nodes(shared::Fan& fan, const shared::Light& light, const BeamExtent& extent, FanDetail detail) {
    const std::vector<float> depths = depths_of(light);
    const Sizes sizes{light, extent, detail, fan.size};
    std::vector<float> nodes{0.0f};
    if (light.lens_radius_m > 0) {
        // Beyond its reach the way needs no nodes.
        const float last = light.lens_radius_m / (static_cast<float>(extent.reach_m) * light.tan_field);
        float coarser = 1;
        do {
            nodes = nodes_of(sizes, depths, last > kLastNode ? std::min(last, 0.9f) : 0.0f, coarser);
            coarser *= kCoarser;
        } while (nodes.size() > shared::kFanNodes);
    }
    fan.plain = detail == FanDetail::plain ? 1 : 0;
    fan.levels = static_cast<std::uint32_t>(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const float next = k + 1 < nodes.size() ? nodes[k + 1] : nodes[k];
        fan.node[k] = {nodes[k], 1.0f / std::max(nodes[k] - next, 1e-6f)};
    }
    place_nodes(fan, sizes, depths);
}

} // namespace ghost::render
