// SPDX-License-Identifier: Apache-2.0
#include "render/relight/dirty_tiles.h"

#include "base/check.h"
#include "render/relight/tile_lists.h"
#include "shared/beam.h"
#include "shared/g_buffer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::render {
namespace {

// A silhouette takes the haze of the pixel beside it: what changed there changes here.
constexpr int kBeside = 1;

PixelRect grown(const PixelRect& rect, int x, int y) {
    return {rect.x0 - x, rect.y0 - y, rect.x1 + x, rect.y1 + y};
}

} // namespace

bool DirtyTiles::touch(const std::vector<PixelRect>& rects) {
    bool fits = true;
    ++touches_;
    for (auto& [slot, kept] : kept_) {
        if (kept.stale.empty()) kept.since = touches_;
        for (const PixelRect& rect : rects) kept.stale.add(grown(rect, kBeside, kBeside));
        fits = fits && kept.stale.count() <= TileLists::kMostTiles;
    }
    return fits;
}

void DirtyTiles::made(const ImageSum& sum) {
    if (sum.target < 0) return;
    const Fragments& f = fragments_;
    Kept kept{sum.lights, sum.base, sum.at_unit,
              TileSet(static_cast<int>(f.width), static_cast<int>(f.height))};
    for (const Addend& addend : sum.addends) {
        const auto part = kept_.find(addend.slot);
        CHECK(part != kept_.end());
        if (!part->second.stale.empty())
            kept.since = kept.stale.empty() ? part->second.since : std::min(kept.since, part->second.since);
        kept.stale.add(part->second.stale);
        kept.lights.insert(kept.lights.end(), part->second.lights.begin(), part->second.lights.end());
        kept.base = kept.base || part->second.base;
    }
    kept_[sum.target] = std::move(kept);
}

bool DirtyTiles::is_stale(int slot) const {
    const auto kept = kept_.find(slot);
    return kept != kept_.end() && !kept->second.stale.empty();
}

bool DirtyTiles::is_stale_since(int slot, int touches) const {
    return is_stale(slot) && kept_.at(slot).since + static_cast<std::uint64_t>(touches) <= touches_;
}

ImageSum DirtyTiles::mend(int slot, const std::vector<shared::Light>& lights) const {
    const Kept& kept = kept_.at(slot);
    ImageSum sum;
    sum.target = slot;
    sum.base = kept.base;
    sum.at_unit = kept.at_unit;
    add_reaching(kept.lights, lights, kept.stale.rects(), sum.lights);
    return sum;
}

void DirtyTiles::add_reaching(const std::vector<int>& indices, const std::vector<shared::Light>& lights,
                              const std::vector<PixelRect>& rects, std::vector<int>& to) const {
    for (const int index : indices) {
        const shared::Light& light = lights[static_cast<std::size_t>(index)];
        if (std::any_of(rects.begin(), rects.end(), [&](const PixelRect& rect) {
                return may_reach(light, fragments_.camera, TileLists::around(rect));
            }))
            to.push_back(index);
    }
}

ImageSum DirtyTiles::patch(const ImageSum& sum, const std::vector<shared::Light>& lights, TileSet& tiles,
                           Lights which) const {
    tiles = TileSet(static_cast<int>(fragments_.width), static_cast<int>(fragments_.height));
    for (const Addend& addend : sum.addends)
        if (is_stale(addend.slot)) tiles.add(kept_.at(addend.slot).stale);
    const std::vector<PixelRect> rects = tiles.rects();
    ImageSum patch;
    patch.target = sum.target;
    patch.base = sum.base;
    if (which == Lights::all) add_reaching(sum.lights, lights, rects, patch.lights);
    for (const Addend& addend : sum.addends) {
        if (!is_stale(addend.slot)) {
            patch.addends.push_back(addend);
            continue;
        }
        const Kept& kept = kept_.at(addend.slot);
        patch.base = patch.base || kept.base;
        add_reaching(kept.lights, lights, rects, patch.lights);
    }
    return patch;
}

TileSet DirtyTiles::take_stale(int slot) {
    const TileSet fresh(static_cast<int>(fragments_.width), static_cast<int>(fragments_.height));
    return std::exchange(kept_.at(slot).stale, fresh);
}

bool may_reach(const shared::Light& light, const shared::View& view, const PixelRect& rect) {
    if (std::max({light.intensity_cd.x, light.intensity_cd.y, light.intensity_cd.z}) <= 0.0f) return false;
    const glm::vec2 size(static_cast<float>(view.width), static_cast<float>(view.height));
    const glm::vec2 low(static_cast<float>(rect.x0), static_cast<float>(rect.y0));
    const glm::vec2 high(static_cast<float>(rect.x1), static_cast<float>(rect.y1));
    const glm::vec2 middle = (low + high) / size - 1.0f; // -1..1
    const glm::vec2 half = (high - low) / size;
    const glm::vec3 ray = view.forward + view.right * middle.x - view.up * middle.y;
    const glm::vec3 way = glm::normalize(ray);
    const float spread = glm::length(view.right * half.x + view.up * half.y) / glm::length(ray);
    const float k = light.tan_field * light.cut_radius;
    const float back_per_m = std::sqrt(1.0f + k * k) / k;
    const glm::vec3 dq = shared::to_gate(light, way);
    // Piece by piece, each as wide as the bundle of rays is at its far end (see cull.comp).
    for (float near_m = 0.0f, far_m = 4.0f; near_m < shared::kFarthest_m; near_m = far_m, far_m *= 2.0f) {
        const float radius_m = far_m * spread * 1.05f + 1e-3f;
        glm::vec3 q = shared::to_gate(light, view.eye_m - light.position_m);
        q.z += radius_m * back_per_m;
        const glm::vec2 part = shared::clip_to_cone(q, dq, k, far_m + radius_m);
        if (part.y > part.x && part.y > near_m - radius_m) return true;
    }
    return false;
}

} // namespace ghost::render
