#pragma once
// SPDX-License-Identifier: Apache-2.0
// Parts of the picture: which pixels a box covers, which tiles (shared/push.h) these pixels touch. For
// drawing again what changed and nothing else. Pixels count from the upper left. Pure values.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::render {

// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelRect {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    bool operator==(const PixelRect&) const = default;
};

// The whole picture where any corner is nearer than the near plane. to_clip: reversed depth, Y down.
PixelRect pixels_of(const std::array<glm::vec3, 8>& corners_m, const glm::mat4& to_clip, int width,
                    int height);

class TileSet {
public:
    TileSet() = default;
    TileSet(int width, int height); // of the picture, in pixels

    void add(const PixelRect& rect);
    void add(const TileSet& others);
    void remove(const TileSet& others);
    bool meets(const PixelRect& rect) const;
    bool empty() const { return count_ == 0; }
    std::size_t count() const { return count_; }
    std::vector<std::uint32_t> list() const; // numbers of the tiles, rows from above
    // The same as few rectangles without overlap, cut off at the picture's edge.
    std::vector<PixelRect> rects() const;

private:
    void set(std::size_t tile, bool value);
    PixelRect tiles_under(const PixelRect& rect) const;

    int width_ = 0;
    int height_ = 0;
    int tiles_x_ = 0;
    int tiles_y_ = 0;
    std::vector<bool> tiles_;
    std::size_t count_ = 0;
};

} // namespace ghost::render
