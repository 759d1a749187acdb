// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/private/svg_shapes.h"

#include "base/text.h"
#include "fixture/values.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ghost::fixture {

std::string_view svg_name(const char* name) {
    const std::string_view text = name;
    const std::size_t colon = text.rfind(':');
    return colon == text.npos ? text : text.substr(colon + 1);
}

float svg_length(std::string_view text, float fallback) {
    text = trimmed(text);
    for (const std::string_view unit : {"px", "pt", "mm", "cm", "in", "%"})
        if (text.ends_with(unit)) text.remove_suffix(unit.size());
    const std::optional<float> value = parse_float(text);
    return value && std::abs(*value) <= kMostUnits ? *value : fallback;
}

std::vector<float> svg_numbers(std::string_view text) {
    std::vector<float> found;
    while (!text.empty() && found.size() < 16384) {
        const std::size_t start = text.find_first_not_of(" ,\t\r\n");
        if (start == text.npos) break;
        text.remove_prefix(start);
        const std::size_t end = std::min(text.find_first_of(" ,\t\r\n"), text.size());
        const std::optional<float> value = parse_float(text.substr(0, end));
        if (!value || std::abs(*value) > kMostUnits) break;
        found.push_back(*value);
        text.remove_prefix(end);
    }
    return found;
}

glm::mat3 svg_transform(std::string_view text) {
    glm::mat3 all(1.0f);
    for (std::size_t open = text.find('('); open != text.npos; open = text.find('(')) {
        const std::string_view name = trimmed(text.substr(0, open));
        const std::size_t close = std::min(text.find(')', open), text.size());
        const std::vector<float> v = svg_numbers(text.substr(open + 1, close - open - 1));
        glm::mat3 one(1.0f);
        if (name.ends_with("matrix") && v.size() == 6)
            one = glm::mat3(v[0], v[1], 0, v[2], v[3], 0, v[4], v[5], 1);
        else if (name.ends_with("translate") && !v.empty())
            one[2] = glm::vec3(v[0], v.size() > 1 ? v[1] : 0.0f, 1);
        else if (name.ends_with("scale") && !v.empty())
            one = glm::mat3(v[0], 0, 0, 0, v.size() > 1 ? v[1] : v[0], 0, 0, 0, 1);
        else if (name.ends_with("rotate") && !v.empty()) {
            const float angle = v[0] * 3.14159265f / 180.0f;
            const float c = std::cos(angle);
            const float s = std::sin(angle);
            const glm::vec2 about = v.size() > 2 ? glm::vec2(v[1], v[2]) : glm::vec2(0.0f);
            one = glm::mat3(c, s, 0, -s, c, 0, about.x - c * about.x + s * about.y,
                            about.y - s * about.x - c * about.y, 1);
        }
        all = all * one;
        text.remove_prefix(std::min(close + 1, text.size()));
    }
    return all;
}

std::array<float, 4> svg_box(pugi::xml_node root) {
    const std::vector<float> box = svg_numbers(root.attribute("viewBox").value());
    if (box.size() == 4) return {box[0], box[1], box[2], box[3]};
    return {0.0f, 0.0f, svg_length(root.attribute("width").value(), 100.0f),
            svg_length(root.attribute("height").value(), 100.0f)};
}

bool is_svg_group(std::string_view name) {
    return name == "g" || name == "svg" || name == "a";
}

bool is_svg_silent(std::string_view name) {
    return name == "defs" || name == "clipPath" || name == "metadata" || name == "title" || name == "desc" ||
           name == "namedview";
}

SvgShape svg_shape(pugi::xml_node node, std::size_t most_points) {
    const std::string_view name = svg_name(node.name());
    const auto number = [&](const char* key, float fallback = 0.0f) {
        return svg_length(node.attribute(key).value(), fallback);
    };
    SvgShape shape;
    std::vector<SvgLine>& lines = shape.lines;
    if (name == "path") {
        SvgPath path = read_svg_path(node.attribute("d").value(), most_points);
        shape.is_whole = path.whole;
        lines = std::move(path.lines);
    } else if (name == "circle" || name == "ellipse") {
        const float rx = number("rx", number("r"));
        lines.push_back(ellipse_line({number("cx"), number("cy")}, {rx, number("ry", rx)}));
    } else if (name == "rect") {
        const glm::vec2 a(number("x"), number("y"));
        const glm::vec2 b = a + glm::vec2(number("width"), number("height"));
        lines.push_back({{a, {b.x, a.y}, b, {a.x, b.y}}, true});
    } else if (name == "line") {
        lines.push_back({{{number("x1"), number("y1")}, {number("x2"), number("y2")}}, false});
    } else if (name == "polygon" || name == "polyline") {
        const std::vector<float> v = svg_numbers(node.attribute("points").value());
        SvgLine line{{}, name == "polygon"};
        for (std::size_t i = 0; i + 1 < v.size(); i += 2) line.points.push_back({v[i], v[i + 1]});
        lines.push_back(std::move(line));
    } else {
        shape.is_known = false;
    }
    return shape;
}

} // namespace ghost::fixture
