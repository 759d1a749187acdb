// SPDX-License-Identifier: Apache-2.0
#include "light/led_wall_light.h"

#include "image/colour.h"
#include "photometry/photometry.h"
#include "shared/gobos.h"
#include "shared/led_wall.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;

constexpr float kCell_m = 3.0f;
constexpr int kDefaultCells = 4; // on a side, at most
constexpr int kSamples = 8;      // of a cell, on a side

// From -1..1 on the wall to -1..1 in the layer, and where the picture ends on the wall.
struct Mapping {
    vec2 scale{1.0f};
    vec2 shown{1.0f};
};

Mapping mapping_of(const LedWall& wall, const MediaNow& now) {
    Mapping result;
    const float ratio =
        now.extent.x / std::max(now.extent.y, 1e-6f) * wall.size_m.y / std::max(wall.size_m.x, 1e-6f);
    if (wall.fit == Fit::contain) result.shown = ratio > 1.0f ? vec2(1.0f, 1.0f / ratio) : vec2(ratio, 1.0f);
    result.scale = now.extent / result.shown;
    if (wall.fit == Fit::cover) result.scale *= ratio > 1.0f ? vec2(1.0f / ratio, 1.0f) : vec2(1.0f, ratio);
    return result;
}

} // namespace

glm::ivec2 cells_of(const LedWall& wall) {
    if (wall.cells.x > 0) return wall.cells;
    return glm::clamp(glm::ivec2(glm::round(wall.size_m / kCell_m)), glm::ivec2(1),
                      glm::ivec2(kDefaultCells));
}

shared::LedWall seen_wall(const LedWall& wall, const glm::mat4& to_world, const MediaNow& now,
                          const vec3& factor) {
    const Mapping mapping = mapping_of(wall, now);
    shared::LedWall seen{};
    seen.centre_m = vec3(to_world[3]);
    seen.right = glm::normalize(vec3(to_world[0])) * (2.0f / wall.size_m.x);
    seen.up = glm::normalize(vec3(to_world[2])) * (2.0f / wall.size_m.y);
    seen.normal = -glm::normalize(vec3(to_world[1]));
    seen.depth_m = wall.reach_m;
    seen.layer = static_cast<std::uint32_t>(wall.media) + 1;
    seen.moment = now.moment;
    seen.texel_m = wall.size_m.x / (static_cast<float>(now.side) * std::max(mapping.scale.x, 1e-6f));
    seen.radiance = factor * wall.nits;
    seen.pitch_m = wall.pitch_m;
    seen.scale = mapping.scale;
    seen.shown = mapping.shown;
    return seen;
}

vec3 cell_fraction(const LedWall& wall, int cell, const MediaNow& now, const shared::SlidePicture& picture) {
    if (!picture.levels) return vec3(0.0f);
    const glm::ivec2 cells = cells_of(wall);
    const Mapping mapping = mapping_of(wall, now);
    const vec2 size = 2.0f / vec2(cells); // of a cell, on -1..1
    const vec2 low(static_cast<float>(cell % cells.x) * size.x - 1.0f,
                   1.0f - static_cast<float>(cell / cells.x + 1) * size.y);
    // What of the cell the picture covers, and its mean there; samples as wide as they are apart.
    const vec2 from = glm::max(low, -mapping.shown), to = glm::min(low + size, mapping.shown);
    if (!(from.x < to.x && from.y < to.y)) return vec3(0.0f);
    const vec2 step = (to - from) / static_cast<float>(kSamples);
    const vec2 texels = step * mapping.scale * (0.5f * static_cast<float>(now.side));
    const float wanted = std::log2(std::max(std::min(texels.x, texels.y), 1.0f));
    const auto level =
        static_cast<std::size_t>(std::clamp(wanted, 0.0f, static_cast<float>(picture.levels->size() - 1)));
    vec3 sum(0.0f);
    for (int k = 0; k < kSamples * kSamples; ++k) {
        const vec2 at = from + step * (vec2(k % kSamples, k / kSamples) + 0.5f);
        sum += shared::slide_bilinear(picture, level, at * mapping.scale * vec2(0.5f, -0.5f) + 0.5f);
    }
    const vec2 covered = (to - from) / size;
    return image::rec709_to_rec2020(sum) * (covered.x * covered.y / static_cast<float>(kSamples * kSamples));
}

void light_cell(const LedWall& wall, const vec3& fraction, shared::Light& light) {
    const glm::ivec2 cells = cells_of(wall);
    const float area_m2 = wall.size_m.x * wall.size_m.y / static_cast<float>(cells.x * cells.y);
    const vec3 flux_lm = fraction * (shared::kPi * wall.nits * area_m2);
    light.intensity_cd = flux_lm / area_profile().open_sr;
    light.bounce_cd = flux_lm / (4.0f * shared::kPi);
}

} // namespace ghost::scene
