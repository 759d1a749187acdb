// SPDX-License-Identifier: Apache-2.0
#include "image/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::image {
namespace {

constexpr int kLines = 4; // of samples in a row of pixels; along the line coverage is exact

struct Crossing {
    float x = 0.0f;
    int turn = 0; // 1 where the edge goes down
};

// Lines are worked on in bands: few passes over the points, little memory however many edges cross a line.
constexpr int kBand = 32;
using Band = std::array<std::vector<Crossing>, kBand>;

float height_of(int line) {
    return (static_cast<float>(line) + 0.5f) / kLines;
}

void add_edge(const glm::vec2& a, const glm::vec2& b, int first_line, Band& band) {
    const float low = std::min(a.y, b.y);
    const float high = std::max(a.y, b.y);
    if (high <= height_of(first_line) || low > height_of(first_line + kBand - 1) || low == high) return;
    const int from = std::max(0, static_cast<int>(std::floor(low * kLines)) - 1 - first_line);
    for (int k = from; k < kBand; ++k) {
        const float y = height_of(first_line + k);
        if (y < low) continue;
        if (y >= high) break;
        band[static_cast<std::size_t>(k)].push_back(
            {a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), b.y > a.y ? 1 : -1});
    }
}

void fill_band(const std::vector<Polygon>& polygons, int first_line, Band& band) {
    for (std::vector<Crossing>& crossings : band) crossings.clear();
    for (const Polygon& polygon : polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i)
            add_edge(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0], first_line, band);
    for (std::vector<Crossing>& crossings : band)
        std::sort(crossings.begin(), crossings.end(),
                  [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
}

void cover(float* row, int width, float from, float to) {
    from = std::clamp(from, 0.0f, static_cast<float>(width));
    to = std::clamp(to, 0.0f, static_cast<float>(width));
    if (!(to > from)) return;
    const int first = static_cast<int>(from);
    const int last = std::min(static_cast<int>(to), width - 1);
    if (first == last) {
        row[first] += (to - from) / kLines;
        return;
    }
    row[first] += (static_cast<float>(first + 1) - from) / kLines;
    for (int x = first + 1; x < last; ++x) row[x] += 1.0f / kLines;
    row[last] += (to - static_cast<float>(last)) / kLines;
}

} // namespace

std::vector<float> coverage(const std::vector<Polygon>& polygons, FillRule rule, int width, int height) {
    std::vector<float> covered(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    Band band;
    for (int line = 0; line < height * kLines; ++line) {
        if (line % kBand == 0) fill_band(polygons, line, band);
        const std::vector<Crossing>& crossings = band[static_cast<std::size_t>(line % kBand)];
        float* row =
            covered.data() + static_cast<std::size_t>(line / kLines) * static_cast<std::size_t>(width);
        int winding = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            winding += crossings[i].turn;
            const bool is_inside = rule == FillRule::nonzero ? winding != 0 : (i % 2 == 0);
            if (is_inside) cover(row, width, crossings[i].x, crossings[i + 1].x);
        }
    }
    for (float& share : covered) share = std::min(share, 1.0f);
    return covered;
}

} // namespace ghost::image
