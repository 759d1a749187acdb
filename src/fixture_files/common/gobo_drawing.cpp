// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/gobo_drawing.h"

#include "base/text.h"
#include "fixture_files/common/private/svg_shapes.h"
#include "image/polygons.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ghost::fixture {
namespace {

using glm::vec2;
using glm::vec3;

constexpr std::size_t kMaxPoints = 200000; // the largest of QLC+'s 536 drawings has 80,000
constexpr float kInk = 0.2f;               // darker greys are black ink: metal lets nothing through
// Of the circle that fits into the drawing: discs of black that end short of it would leave a ring of light.
constexpr float kDisc = 0.98f;
constexpr int kMaxShapes = 2000;
constexpr int kMaxGroupDepth = 32;
constexpr int kMaxElements = 20000; // groups, shapes, and those of clips each time that they are used
// Of edges with the lines of samples: what filling takes its time for.
constexpr double kMaxCrossings = 2e7;

using Paint = std::optional<vec3>; // sRGB, 0..1; none: not painted

struct Style {
    Paint fill = vec3(0.0f);
    Paint stroke;
    float fill_opacity = 1.0f;
    float stroke_opacity = 1.0f;
    float opacity = 1.0f; // of all groups around it
    float stroke_width = 1.0f;
    image::FillRule rule = image::FillRule::nonzero;
    std::vector<float> clip; // coverage; empty: all
};

// "#rgb", "#rrggbb", "rgb(1,2,3)", a few names; other colours are black.
Paint paint_of(std::string_view text) {
    text = trimmed(text);
    if (text == "none" || text == "transparent") return std::nullopt;
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : 0;
    };
    vec3 color(0.0f);
    if (text.starts_with("#") && (text.size() == 4 || text.size() == 7)) {
        const std::size_t step = text.size() == 4 ? 1 : 2;
        for (std::size_t k = 0; k < 3; ++k)
            color[static_cast<int>(k)] =
                static_cast<float>(16 * digit(text[1 + k * step]) + digit(text[k * step + step])) / 255.0f;
    } else if (text.starts_with("rgb(") && text.ends_with(")")) {
        const std::vector<float> parts = svg_numbers(text.substr(4, text.size() - 5));
        for (std::size_t k = 0; k < 3 && parts.size() == 3; ++k)
            color[static_cast<int>(k)] = std::clamp(parts[k] / 255.0f, 0.0f, 1.0f);
    } else {
        constexpr std::pair<std::string_view, std::array<float, 3>> kNames[] = {
            {"white", {1, 1, 1}},    {"red", {1, 0, 0}},     {"lime", {0, 1, 0}},
            {"green", {0, 0.5f, 0}}, {"blue", {0, 0, 1}},    {"yellow", {1, 1, 0}},
            {"cyan", {0, 1, 1}},     {"magenta", {1, 0, 1}}, {"gray", {0.5f, 0.5f, 0.5f}}};
        for (const auto& [name, rgb] : kNames)
            if (text == name) color = {rgb[0], rgb[1], rgb[2]};
    }
    return std::max({color.x, color.y, color.z}) < kInk ? vec3(0.0f) : color;
}

void set_style(Style& style, std::string_view key, std::string_view value) {
    const auto share = [&] { return std::clamp(svg_length(value, 1.0f), 0.0f, 1.0f); };
    if (key == "fill") style.fill = paint_of(value);
    if (key == "stroke") style.stroke = paint_of(value);
    if (key == "fill-opacity") style.fill_opacity = share();
    if (key == "stroke-opacity") style.stroke_opacity = share();
    if (key == "opacity") style.opacity *= share();
    if (key == "stroke-width") style.stroke_width = std::max(svg_length(value, 1.0f), 0.0f);
    if (key == "fill-rule")
        style.rule = trimmed(value) == "evenodd" ? image::FillRule::even_odd : image::FillRule::nonzero;
}

class Drawer {
public:
    explicit Drawer(pugi::xml_node root) : root_(root) {
        const std::array<float, 4> box = svg_box(root);
        const float side = std::max({box[2], box[3], 1e-3f});
        const float scale = static_cast<float>(kGoboDrawing_px) / side;
        const vec2 corner =
            vec2(box[0], box[1]) - 0.5f * (vec2(side) - vec2(box[2], box[3])); // in the middle
        to_pixels_ = glm::mat3(scale, 0, 0, 0, scale, 0, -corner.x * scale, -corner.y * scale, 1);
        colors_.assign(kPixels, vec3(1.0f));
        struct Clips : pugi::xml_tree_walker {
            std::map<std::string, pugi::xml_node, std::less<>>& named;
            explicit Clips(std::map<std::string, pugi::xml_node, std::less<>>& all) : named(all) {}
            bool for_each(pugi::xml_node& node) override {
                if (svg_name(node.name()) == "clipPath") named.emplace(node.attribute("id").value(), node);
                return true;
            }
        } clips(clips_);
        root_.traverse(clips);
    }

    GoboDrawing draw() {
        children(root_, styled(Style{}, root_, to_pixels_), to_pixels_, 0);
        GoboDrawing drawing{image::Image8(kGoboDrawing_px, kGoboDrawing_px, 4), problem_};
        constexpr float radius = 0.5f * static_cast<float>(kGoboDrawing_px);
        static const std::vector<float> disc =
            image::coverage({ellipse_line(vec2(radius), vec2(kDisc * radius)).points},
                            image::FillRule::nonzero, kGoboDrawing_px, kGoboDrawing_px);
        for (std::size_t i = 0; i < kPixels; ++i) {
            for (int k = 0; k < 3; ++k)
                drawing.picture.samples[4 * i + static_cast<std::size_t>(k)] = byte(colors_[i][k]);
            drawing.picture.samples[4 * i + 3] = byte(disc[i]);
        }
        return drawing;
    }

private:
    static constexpr std::size_t kPixels = std::size_t{kGoboDrawing_px} * kGoboDrawing_px;

    static std::uint8_t byte(float share) {
        return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(share, 0.0f, 1.0f)));
    }

    void say(const std::string& what) {
        if (problem_.empty()) problem_ = what;
    }

    Style styled(Style style, pugi::xml_node node, const glm::mat3& transform) {
        for (const pugi::xml_attribute attribute : node.attributes())
            set_style(style, svg_name(attribute.name()), attribute.value());
        std::string_view list = node.attribute("style").value();
        while (!list.empty()) {
            const std::size_t end = std::min(list.find(';'), list.size());
            const std::string_view entry = list.substr(0, end);
            if (const std::size_t colon = entry.find(':'); colon != entry.npos)
                set_style(style, trimmed(entry.substr(0, colon)), entry.substr(colon + 1));
            list.remove_prefix(std::min(end + 1, list.size()));
        }
        if (const pugi::xml_attribute clip = node.attribute("clip-path"))
            apply_clip(style, clip.value(), transform);
        return style;
    }

    void apply_clip(Style& style, std::string_view link, const glm::mat3& transform) {
        const std::size_t open = link.find('#');
        const std::size_t close = link.find(')');
        if (open == link.npos || close == link.npos || close < open) return;
        const auto clip = clips_.find(trimmed(link.substr(open + 1, close - open - 1)));
        if (clip == clips_.end()) return;
        std::vector<image::Polygon> polygons;
        for (const pugi::xml_node shape : clip->second.children()) {
            if (!is_one_more()) return;
            append_polygons(lines_of(shape), transform * svg_transform(shape.attribute("transform").value()),
                            polygons);
        }
        if (++shapes_ > kMaxShapes) return;
        const std::vector<float> covered = coverage(polygons, image::FillRule::nonzero);
        if (covered.empty()) return;
        if (style.clip.empty()) style.clip.assign(kPixels, 1.0f);
        for (std::size_t i = 0; i < kPixels; ++i) style.clip[i] *= covered[i];
    }

    void children(pugi::xml_node parent, const Style& style, const glm::mat3& transform, int depth) {
        for (const pugi::xml_node node : parent.children()) {
            if (node.type() != pugi::node_element) continue;
            const std::string_view name = svg_name(node.name());
            const bool is_group = is_svg_group(name);
            if (is_group && depth >= kMaxGroupDepth) {
                say("groups more than 32 deep in a gobo drawing are not drawn");
                continue;
            }
            if (is_svg_silent(name)) continue;
            if (!is_one_more()) return;
            const glm::mat3 here = transform * svg_transform(node.attribute("transform").value());
            if (is_group) {
                children(node, styled(style, node, here), here, depth + 1);
                continue;
            }
            const std::vector<SvgLine> lines = lines_of(node);
            if (!lines.empty()) paint(lines, styled(style, node, here), here);
        }
    }

    bool is_one_more() {
        if (++elements_ <= kMaxElements) return true;
        say("a gobo drawing has more than " + std::to_string(kMaxElements) +
            " elements, the rest is not drawn");
        return false;
    }

    std::vector<SvgLine> lines_of(pugi::xml_node node) { // empty: nothing to draw
        SvgShape shape = svg_shape(node, kMaxPoints - points_);
        if (!shape.is_known)
            say("gobo drawings: '" + std::string(svg_name(node.name()).substr(0, 32)) + "' is not drawn");
        if (!shape.is_whole)
            say("a gobo drawing has a faulty or very long path, which is drawn as far as it goes");
        std::vector<SvgLine> lines = std::move(shape.lines);
        for (const SvgLine& line : lines) points_ += line.points.size();
        if (points_ > kMaxPoints) {
            points_ = kMaxPoints;
            say("a gobo drawing has more than " + std::to_string(kMaxPoints) +
                " points, the rest is not drawn");
            return {};
        }
        return lines;
    }

    static void append_polygons(const std::vector<SvgLine>& lines, const glm::mat3& transform,
                                std::vector<image::Polygon>& polygons) {
        for (const SvgLine& line : lines) {
            image::Polygon& polygon = polygons.emplace_back();
            for (const vec2& point : line.points) polygon.push_back(pixel(transform, point));
        }
    }

    static vec2 pixel(const glm::mat3& transform, vec2 point) {
        const vec2 place(transform * vec3(point, 1.0f));
        const auto tame = [](float v) {
            return v >= -kMostUnits && v <= kMostUnits ? v : (v > 0.0f ? kMostUnits : -kMostUnits);
        };
        return {tame(place.x), tame(place.y)};
    }

    // A rectangle per piece and a disc per joint, all turning the same way.
    static void append_stroke(const std::vector<SvgLine>& lines, const glm::mat3& transform, float half,
                              std::vector<image::Polygon>& polygons) {
        for (const SvgLine& line : lines) {
            const std::size_t count = line.points.size();
            for (std::size_t i = 0; i < count; ++i) {
                const vec2 a = pixel(transform, line.points[i]);
                const bool is_joint = line.closed || (i > 0 && i + 1 < count);
                if (is_joint && half > 0.6f) {
                    image::Polygon& disc = polygons.emplace_back();
                    for (int k = 0; k < 12; ++k) {
                        const float angle = static_cast<float>(k) * 0.5235988f;
                        disc.push_back(a + half * vec2(std::cos(angle), std::sin(angle)));
                    }
                }
                if (i + 1 == count && !line.closed) break;
                const vec2 b = pixel(transform, line.points[i + 1 < count ? i + 1 : 0]);
                const float length = glm::distance(a, b);
                if (!(length > 0.0f)) continue;
                const vec2 along = (b - a) / length;
                const vec2 aside = half * vec2(-along.y, along.x);
                polygons.push_back({a - aside, b - aside, b + aside, a + aside});
            }
        }
    }

    void paint(const std::vector<SvgLine>& lines, const Style& style, const glm::mat3& transform) {
        if (++shapes_ > kMaxShapes)
            return say("a gobo drawing has more than 2000 shapes, the rest is not drawn");
        if (style.fill) {
            std::vector<image::Polygon> polygons;
            append_polygons(lines, transform, polygons);
            mix(polygons, style.rule, *style.fill, style.fill_opacity * style.opacity, style.clip);
        }
        if (style.stroke && style.stroke_width > 0.0f) {
            const float scale = std::sqrt(std::abs(glm::determinant(glm::mat2(transform))));
            std::vector<image::Polygon> polygons;
            append_stroke(lines, transform, std::min(0.5f * style.stroke_width * scale, 1e4f), polygons);
            mix(polygons, image::FillRule::nonzero, *style.stroke, style.stroke_opacity * style.opacity,
                style.clip);
        }
    }

    // Empty: there was too much before.
    std::vector<float> coverage(const std::vector<image::Polygon>& polygons, image::FillRule rule) {
        constexpr float kSide = kGoboDrawing_px;
        for (const image::Polygon& polygon : polygons)
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const float a = std::clamp(polygon[i].y, 0.0f, kSide),
                            b = std::clamp(polygon[(i + 1) % polygon.size()].y, 0.0f, kSide);
                crossings_ += 8.0 + 4.0 * std::abs(b - a);
            }
        if (crossings_ > kMaxCrossings) {
            say("a gobo drawing has too many long strokes and edges, the rest is not drawn");
            return {};
        }
        return image::coverage(polygons, rule, kGoboDrawing_px, kGoboDrawing_px);
    }

    void mix(const std::vector<image::Polygon>& polygons, image::FillRule rule, const vec3& color,
             float opacity, const std::vector<float>& clip) {
        const std::vector<float> covered = coverage(polygons, rule);
        if (covered.empty()) return;
        for (std::size_t i = 0; i < kPixels; ++i)
            colors_[i] += (color - colors_[i]) * (covered[i] * opacity * (clip.empty() ? 1.0f : clip[i]));
    }

    pugi::xml_node root_;
    glm::mat3 to_pixels_{1.0f};
    std::vector<vec3> colors_; // sRGB
    std::string problem_;
    std::map<std::string, pugi::xml_node, std::less<>> clips_; // by their name; of several the first
    std::size_t points_ = 0;
    int shapes_ = 0, elements_ = 0;
    double crossings_ = 0.0;
};

} // namespace

Result<GoboDrawing> draw_gobo(Bytes svg, const std::string& name) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(svg.data(), svg.size());
    if (!parsed) return Error{std::string("not well-formed SVG: ") + parsed.description(), name};
    const pugi::xml_node root = document.document_element();
    if (svg_name(root.name()) != "svg")
        return Error{"expected an SVG drawing, found another kind of XML", name};
    return Drawer(root).draw();
}

} // namespace ghost::fixture
