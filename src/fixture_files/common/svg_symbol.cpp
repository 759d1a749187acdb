// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/common/svg_symbol.h"

#include "base/text.h"
#include "fixture_files/common/private/svg_shapes.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace ghost::fixture {
namespace {

constexpr int kDeepestGroup = 32;
constexpr std::size_t kMostRules = 256;
constexpr std::size_t kMostElements = 16384;

struct Ink {
    bool fills = true; // as SVG begins
    bool strokes = false;
    bool fill_shows = true;
    bool stroke_shows = true;
    bool shows = true; // all of it

    bool is_filled() const { return shows && fills && fill_shows; }
    bool is_seen() const { return is_filled() || (shows && strokes && stroke_shows); }
};

using Rules = std::vector<std::pair<std::string, std::string>>; // key, value

Rules rules_in(std::string_view text) {
    Rules rules;
    for (const std::string_view part : split(text, ';')) {
        const std::size_t colon = part.find(':');
        if (colon == part.npos || rules.size() == kMostRules) continue;
        rules.emplace_back(trimmed(part.substr(0, colon)), trimmed(part.substr(colon + 1)));
    }
    return rules;
}

void set(Ink& ink, std::string_view key, std::string_view value) {
    const bool is_none = value == "none" || value == "transparent";
    const auto is_clear = [&] { return svg_length(value, 1.0f) <= 0.0f; };
    if (key == "fill") ink.fills = !is_none;
    if (key == "stroke") ink.strokes = !is_none;
    if (key == "fill-opacity") ink.fill_shows = !is_clear();
    if (key == "stroke-opacity") ink.stroke_shows = !is_clear();
    if (key == "opacity" && is_clear()) ink.shows = false;
    if (key == "display" && is_none) ink.shows = false;
    if (key == "visibility" && value == "hidden") ink.shows = false;
}

class SymbolReader {
public:
    explicit SymbolReader(pugi::xml_node root) : root_(root) {}

    Result<SvgSymbol> read(const std::string& name) {
        const auto [x, y, width, height] = svg_box(root_);
        symbol_.box_low = {x, y};
        symbol_.box_size = {width, height};
        read_classes(root_, 0);
        children(root_, inked({}, root_), svg_transform(root_.attribute("transform").value()), 0);
        if (!fault_.empty()) return Error{fault_, name};
        if (symbol_.lines.empty()) return Error{"an SVG in which nothing is seen", name};
        symbol_.low = symbol_.high = symbol_.lines.front().points.front();
        for (const SvgSymbol::Line& line : symbol_.lines)
            for (const glm::vec2& point : line.points) {
                symbol_.low = glm::min(symbol_.low, point);
                symbol_.high = glm::max(symbol_.high, point);
            }
        return std::move(symbol_);
    }

private:
    // ".st0, .st1 { fill: none }"; other selectors are no symbol's.
    void read_classes(pugi::xml_node parent, int depth) {
        for (const pugi::xml_node node : parent.children()) {
            const std::string_view name = svg_name(node.name());
            if (name == "defs" && depth < kDeepestGroup) read_classes(node, depth + 1);
            if (name != "style") continue;
            std::string_view text = node.child_value();
            for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{')) {
                const std::size_t close = std::min(text.find('}', open), text.size());
                const Rules rules = rules_in(text.substr(open + 1, close - open - 1));
                for (const std::string_view selector : split(text.substr(0, open), ',')) {
                    const std::string_view one = trimmed(selector);
                    if (!one.starts_with('.') || classes_.size() == kMostRules) continue;
                    Rules& known = classes_[std::string(one.substr(1))];
                    known.insert(known.end(), rules.begin(), rules.end());
                }
                text.remove_prefix(std::min(close + 1, text.size()));
            }
        }
    }

    Ink inked(Ink ink, pugi::xml_node node) const {
        for (const pugi::xml_attribute attribute : node.attributes())
            set(ink, svg_name(attribute.name()), trimmed(attribute.value()));
        for (const std::string_view name : split(node.attribute("class").value(), ' '))
            if (const auto found = classes_.find(std::string(name)); found != classes_.end())
                for (const auto& [key, value] : found->second) set(ink, key, value);
        for (const auto& [key, value] : rules_in(node.attribute("style").value())) set(ink, key, value);
        return ink;
    }

    void children(pugi::xml_node parent, const Ink& ink, const glm::mat3& transform, int depth) {
        for (const pugi::xml_node node : parent.children()) {
            if (!fault_.empty()) return;
            if (node.type() != pugi::node_element) continue;
            const std::string_view name = svg_name(node.name());
            if (is_svg_silent(name)) continue;
            if (++elements_ > kMostElements) return too_much(kMostElements, "elements");
            const glm::mat3 here = transform * svg_transform(node.attribute("transform").value());
            if (!is_svg_group(name)) {
                add(node, inked(ink, node), here);
            } else if (depth == kDeepestGroup) {
                return too_much(kDeepestGroup, "groups within each other");
            } else {
                children(node, inked(ink, node), here, depth + 1);
            }
        }
    }

    void add(pugi::xml_node node, const Ink& ink, const glm::mat3& transform) {
        if (!ink.is_seen()) return;
        for (const SvgLine& line : svg_shape(node, kMostSymbolPoints - points_ + 1).lines) {
            points_ += line.points.size();
            if (points_ > kMostSymbolPoints) return too_much(kMostSymbolPoints, "points");
            if (symbol_.lines.size() == kMostSymbolLines) return too_much(kMostSymbolLines, "lines");
            if (line.points.size() < 2) continue;
            SvgSymbol::Line drawn{{}, line.closed, ink.is_filled()};
            for (const glm::vec2& point : line.points) {
                const glm::vec2 place(transform * glm::vec3(point, 1.0f));
                if (!(std::abs(place.x) <= kMostUnits && std::abs(place.y) <= kMostUnits)) {
                    fault_ = "lines beyond all bounds in a 2D symbol";
                    return;
                }
                drawn.points.push_back(place);
            }
            symbol_.lines.push_back(std::move(drawn));
        }
    }

    void too_much(std::size_t most, const char* of_what) {
        fault_ = "a 2D symbol of more than " + std::to_string(most) + " " + of_what;
    }

    pugi::xml_node root_;
    std::map<std::string, Rules> classes_;
    SvgSymbol symbol_;
    std::string fault_;
    std::size_t points_ = 0, elements_ = 0;
};

} // namespace

Result<SvgSymbol> read_svg_symbol(Bytes svg, const std::string& name) {
    if (svg.size() > kMostSymbolBytes)
        return Error{"a 2D symbol of more than " + std::to_string(kMostSymbolBytes >> 20) + " MiB", name};
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(svg.data(), svg.size());
    if (!parsed) return Error{std::string("not well-formed SVG: ") + parsed.description(), name};
    const pugi::xml_node root = document.document_element();
    if (svg_name(root.name()) != "svg")
        return Error{"expected an SVG drawing, found another kind of XML", name};
    return SymbolReader(root).read(name);
}

} // namespace ghost::fixture
