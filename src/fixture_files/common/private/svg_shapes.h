#pragma once
// SPDX-License-Identifier: Apache-2.0
// What SVG drawings are made of: shapes as lines, transforms, numbers. Whoever draws walks through the
// document. Units of the drawing. Any thread.

#include "fixture_files/common/svg_path.h"

#include <glm/mat3x3.hpp>
#include <pugixml.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::fixture {

std::string_view svg_name(const char* name); // "svg:path" is a path
// "12px"; units are not converted.
float svg_length(std::string_view text, float fallback);
std::vector<float> svg_numbers(std::string_view text); // as far as they are numbers
// "matrix(a b c d e f) translate(x, y) ...": the last one acts first.
glm::mat3 svg_transform(std::string_view text);
// x, y, width, height of the drawing.
std::array<float, 4> svg_box(pugi::xml_node root);
bool is_svg_group(std::string_view name);
bool is_svg_silent(std::string_view name); // definitions and remarks

struct SvgShape {
    std::vector<SvgLine> lines; // empty: nothing to draw
    bool is_known = true;       // the element is one of SVG's shapes
    bool is_whole = true;       // false: a faulty path, or one of too many points, as far as it goes
};
// Its transform is not in it.
SvgShape svg_shape(pugi::xml_node node, std::size_t most_points);

} // namespace ghost::fixture
