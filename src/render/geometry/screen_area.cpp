// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/screen_area.h"

#include "base/check.h"
#include "shared/push.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ghost::render {
namespace {

constexpr int kTileWidth = static_cast<int>(shared::kTileWidth);
constexpr int kTileHeight = static_cast<int>(shared::kTileHeight);
// The rasteriser rounds vertices to a fraction of a pixel.
constexpr float kRounding = 0.5f;

int ceil_div(int value, int by) {
    return (value + by - 1) / by;
}

int pixel(float at, int most) {
    return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(most)));
}

} // namespace

PixelRect pixels_of(const std::array<glm::vec3, 8>& corners_m, const glm::mat4& to_clip, int width,
                    int height) {
    glm::vec2 low(std::numeric_limits<float>::max());
    glm::vec2 high = -low;
    for (const glm::vec3& corner : corners_m) {
        const glm::vec4 at = to_clip * glm::vec4(corner, 1.0f);
        // Depth beyond 1: before the near plane. Not finite: neither comparison holds.
        if (!(at.w > 0.0f && at.z <= at.w)) return {0, 0, width, height};
        const glm::vec2 ndc = glm::vec2(at) / at.w;
        low = glm::min(low, ndc);
        high = glm::max(high, ndc);
    }
    const glm::vec2 size(static_cast<float>(width), static_cast<float>(height));
    low = (low * 0.5f + 0.5f) * size - kRounding;
    high = (high * 0.5f + 0.5f) * size + kRounding;
    return {pixel(std::floor(low.x), width), pixel(std::floor(low.y), height),
            pixel(std::ceil(high.x), width), pixel(std::ceil(high.y), height)};
}

TileSet::TileSet(int width, int height)
    : width_(width), height_(height), tiles_x_(ceil_div(width, kTileWidth)),
      tiles_y_(ceil_div(height, kTileHeight)),
      tiles_(static_cast<std::size_t>(tiles_x_) * static_cast<std::size_t>(tiles_y_), false) {}

void TileSet::set(std::size_t tile, bool value) {
    if (tiles_[tile] == value) return;
    tiles_[tile] = value;
    count_ += value ? 1u : ~std::size_t{0};
}

// In tiles.
PixelRect TileSet::tiles_under(const PixelRect& rect) const {
    if (rect.empty()) return {};
    return {std::max(rect.x0 / kTileWidth, 0), std::max(rect.y0 / kTileHeight, 0),
            std::min(ceil_div(rect.x1, kTileWidth), tiles_x_),
            std::min(ceil_div(rect.y1, kTileHeight), tiles_y_)};
}

void TileSet::add(const PixelRect& rect) {
    const PixelRect tiles = tiles_under(rect);
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x) set(static_cast<std::size_t>(y * tiles_x_ + x), true);
}

void TileSet::add(const TileSet& others) {
    CHECK_EQ(tiles_.size(), others.tiles_.size());
    for (std::size_t k = 0; k < tiles_.size(); ++k)
        if (others.tiles_[k]) set(k, true);
}

void TileSet::remove(const TileSet& others) {
    CHECK_EQ(tiles_.size(), others.tiles_.size());
    for (std::size_t k = 0; k < tiles_.size(); ++k)
        if (others.tiles_[k]) set(k, false);
}

bool TileSet::meets(const PixelRect& rect) const {
    const PixelRect tiles = tiles_under(rect);
    for (int y = tiles.y0; y < tiles.y1; ++y)
        for (int x = tiles.x0; x < tiles.x1; ++x)
            if (tiles_[static_cast<std::size_t>(y * tiles_x_ + x)]) return true;
    return false;
}

std::vector<std::uint32_t> TileSet::list() const {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(count_);
    for (std::size_t k = 0; k < tiles_.size(); ++k)
        if (tiles_[k]) numbers.push_back(static_cast<std::uint32_t>(k));
    return numbers;
}

std::vector<PixelRect> TileSet::rects() const {
    std::vector<PixelRect> done, open; // in tiles; open ones end at the row above
    for (int y = 0; y < tiles_y_; ++y) {
        std::vector<PixelRect> row;
        for (int x = 0; x < tiles_x_; ++x) {
            if (!tiles_[static_cast<std::size_t>(y * tiles_x_ + x)]) continue;
            if (!row.empty() && row.back().x1 == x)
                ++row.back().x1;
            else
                row.push_back({x, y, x + 1, y + 1});
        }
        for (const PixelRect& above : open) {
            const auto same = std::find_if(row.begin(), row.end(), [&](const PixelRect& run) {
                return run.x0 == above.x0 && run.x1 == above.x1;
            });
            if (same != row.end())
                same->y0 = above.y0;
            else
                done.push_back(above);
        }
        open = std::move(row);
    }
    done.insert(done.end(), open.begin(), open.end());
    for (PixelRect& rect : done)
        rect = {rect.x0 * kTileWidth, rect.y0 * kTileHeight, std::min(rect.x1 * kTileWidth, width_),
                std::min(rect.y1 * kTileHeight, height_)};
    return done;
}

} // namespace ghost::render
