#pragma once
// SPDX-License-Identifier: Apache-2.0
// 2D symbols of fixtures as lines (SVG 1.1: paths, shapes, groups, transforms; presentation attributes,
// style, and classes of a style sheet). What is not seen (no fill and no stroke, or opacity 0, as GDTF marks
// what moves) is left out. Error: no SVG, or more than it may have. Any thread.

#include "base/byte_reader.h"
#include "base/result.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace ghost::fixture {

inline constexpr std::size_t kMostSymbolBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMostSymbolPoints = 8192;
inline constexpr std::size_t kMostSymbolLines = 1024;

// In units of the drawing, y down.
struct SvgSymbol {
    struct Line {
        std::vector<glm::vec2> points;
        bool is_closed = false;
        bool is_filled = false;
    };
    std::vector<Line> lines;
    glm::vec2 box_low{0}, box_size{0}; // viewBox
    glm::vec2 low{0}, high{0};         // of all lines
};

Result<SvgSymbol> read_svg_symbol(Bytes svg, const std::string& name);

} // namespace ghost::fixture
