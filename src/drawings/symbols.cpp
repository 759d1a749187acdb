// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/symbols.h"

#include "show/show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace ghost::scene {
namespace {

using fixture::Role;

constexpr float kNarrow_deg = 8; // widest field of a beam light
constexpr float kWarm_k = 3600;  // of a blinder's lamps
constexpr std::size_t kBarCells = 4;
constexpr float kBarShape = 3; // times as long as wide

struct Abilities {
    bool turns = false, dims = false, has_gobos = false, has_blades = false, strobes = false, mixes = false;
    float widest_deg = 0; // zoom; 0: it has none
};

Abilities abilities_of(const fixture::Mode& mode) {
    Abilities can;
    can.turns = !mode.axes.empty();
    for (const fixture::Channel& channel : mode.channels)
        for (const fixture::ChannelFunction& function : channel.functions) switch (function.meaning.role) {
            case Role::gobo_wheel:
            case Role::gobo_wheel_index:
            case Role::gobo_select_spin:
            case Role::gobo_select_shake:
                can.has_gobos = true;
                break;
            case Role::blade_a:
            case Role::blade_b:
                can.has_blades = true;
                break;
            case Role::pan:
            case Role::tilt:
                can.turns = true; // where a file has no axes, too
                break;
            case Role::dimmer:
                can.dims = true;
                break;
            case Role::strobe:
            case Role::strobe_frequency:
            case Role::strobe_random:
            case Role::strobe_effect:
                can.strobes = true;
                break;
            case Role::color_add:
            case Role::color_rgb:
            case Role::color_sub_c:
            case Role::color_wheel:
            case Role::hsb_hue:
            case Role::cie_x:
                can.mixes = true;
                break;
            case Role::zoom:
                can.widest_deg = std::max(
                    {can.widest_deg, std::abs(function.physical_from), std::abs(function.physical_to)});
                break;
            default:
                break;
            }
    return can;
}

// Cells in a row.
bool is_row(const fixture::Mode& mode) {
    if (mode.beams.size() < kBarCells) return false;
    glm::vec3 low(1e30f), high(-1e30f);
    for (int node : mode.beams) {
        glm::mat4 to_fixture(1.0f);
        for (; node >= 0; node = mode.nodes[static_cast<std::size_t>(node)].parent)
            to_fixture = mode.nodes[static_cast<std::size_t>(node)].local * to_fixture;
        low = glm::min(low, glm::vec3(to_fixture[3]));
        high = glm::max(high, glm::vec3(to_fixture[3]));
    }
    const glm::vec3 size = high - low;
    const float longest = std::max({size.x, size.y, size.z});
    const float second = size.x + size.y + size.z - longest - std::min({size.x, size.y, size.z});
    return longest > 0.2f && longest > kBarShape * second;
}

const fixture::Beam* first_beam(const fixture::Type& type, const fixture::Mode& mode) {
    if (mode.beams.empty()) return nullptr;
    const auto node = static_cast<std::size_t>(mode.beams.front());
    const fixture::Geometry& geometry = type.geometries[static_cast<std::size_t>(mode.nodes[node].geometry)];
    return geometry.beam && !geometry.beam->is_assumed ? &*geometry.beam : nullptr;
}

SymbolKind kind_of(const fixture::Type& type, const fixture::Mode& mode) {
    for (const int node : mode.beams) {
        const int geometry = mode.nodes[static_cast<std::size_t>(node)].geometry;
        if (type.geometries[static_cast<std::size_t>(geometry)].laser) return SymbolKind::laser;
    }
    const fixture::Beam* const beam = first_beam(type, mode);
    const Abilities can = abilities_of(mode);
    if (!beam && !can.dims) return mode.channels.empty() ? SymbolKind::not_known : SymbolKind::other;
    const bool is_spot =
        can.has_gobos || can.has_blades || (beam && beam->beam_type == fixture::BeamType::spot);
    const float widest_deg = can.widest_deg > 0 || !beam ? can.widest_deg : beam->field_angle_deg;
    if (can.turns) {
        if (widest_deg > 0 && widest_deg <= kNarrow_deg) return SymbolKind::moving_beam;
        return is_spot ? SymbolKind::moving_profile : SymbolKind::moving_wash;
    }
    if (is_row(mode)) return SymbolKind::bar;
    if (can.has_gobos || can.has_blades) return SymbolKind::profile;
    if (!beam) return SymbolKind::not_known; // which lens it has, its file does not say
    if (!can.mixes && mode.beams.size() > 1 && beam->color_temperature_k <= kWarm_k)
        return SymbolKind::blinder;
    if (!can.mixes && can.strobes) return SymbolKind::strobe;
    return is_spot ? SymbolKind::profile : SymbolKind::wash;
}

class SymbolPen {
public:
    SymbolPen(PdfWriter& pdf, const SymbolPlace& place)
        : pdf_(pdf), place_(place), round_(0.5 * std::min(place.size_pt.x, place.size_pt.y)) {
        ink_.width_pt = std::clamp(0.05 * round_ * 2, 0.25, 0.7);
        ink_.fill_grey = 1;
    }

    // From -1 to 1 across the body.
    void box(double left, double back, double right, double front) const {
        polygon({{left, back}, {right, back}, {right, front}, {left, front}});
    }
    void polygon(const std::vector<glm::dvec2>& points) const {
        std::vector<glm::dvec2> drawn;
        for (const glm::dvec2& point : points) drawn.push_back(at(point));
        pdf_.shape(drawn, true, ink_);
    }
    void line(const glm::dvec2& from, const glm::dvec2& to) const {
        const glm::dvec2 ends[] = {at(from), at(to)};
        pdf_.lines(ends, ink_);
    }
    void black(const glm::dvec2& middle, double radius) const {
        PdfInk dark = ink_;
        dark.fill_grey = 0;
        pdf_.circle(at(middle), radius * round_, dark);
    }
    void circle(const glm::dvec2& middle, double radius) const {
        pdf_.circle(at(middle), radius * round_, ink_);
    }

    // A head between two arms.
    void head() const {
        box(-1, -0.35, 1, 0.35);
        circle({0, 0}, 0.86);
    }

private:
    glm::dvec2 at(const glm::dvec2& point) const {
        return place_.at + point.x * 0.5 * place_.size_pt.x * place_.right +
               point.y * 0.5 * place_.size_pt.y * place_.front;
    }

    PdfWriter& pdf_;
    const SymbolPlace& place_;
    double round_;
    PdfInk ink_;
};

std::vector<glm::dvec2> star() {
    std::vector<glm::dvec2> points;
    for (int k = 0; k < 16; ++k) {
        const double angle = glm::pi<double>() * k / 8, radius = k % 2 == 0 ? 0.75 : 0.35;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return points;
}

} // namespace

SymbolKind symbol_of(const PatchedFixture& fixture) {
    if (fixture.projector) return SymbolKind::projector;
    if (fixture.laser) return SymbolKind::laser;
    if (fixture.wall) return SymbolKind::wall;
    if (!fixture.type) return SymbolKind::not_known;
    if (fixture.type->modes.empty()) return SymbolKind::not_known;
    return kind_of(*fixture.type, fixture.patch().mode_of());
}

Word word_of(SymbolKind kind) {
    constexpr std::array kNames{
        Word("moving profile"), Word("moving wash"), Word("moving beam"), Word("profile"), Word("wash"),
        Word("strobe"),         Word("LED bar"),     Word("blinder"),     Word("laser"),   Word("projector"),
        Word("LED wall"),       Word("other"),       Word("not known")};
    return kNames[static_cast<std::size_t>(kind)];
}

void draw_symbol(PdfWriter& pdf, SymbolKind kind, const SymbolPlace& place) {
    const SymbolPen pen(pdf, place);
    switch (kind) {
    case SymbolKind::moving_profile:
        pen.head();
        pen.line({0, -0.6}, {0, 0.6});
        pen.line({-0.6, 0}, {0.6, 0});
        break;
    case SymbolKind::moving_wash:
        pen.head();
        pen.circle({0, 0}, 0.5);
        break;
    case SymbolKind::moving_beam:
        pen.head();
        pen.black({0, 0}, 0.22);
        break;
    case SymbolKind::profile: // a long barrel
        pen.polygon(
            {{-0.9, -1}, {0.9, -1}, {0.9, -0.1}, {0.5, 0.1}, {0.5, 1}, {-0.5, 1}, {-0.5, 0.1}, {-0.9, -0.1}});
        break;
    case SymbolKind::wash: // round behind, a wide front
        pen.polygon({{-0.6, -1}, {0.6, -1}, {0.95, -0.5}, {0.95, 1}, {-0.95, 1}, {-0.95, -0.5}});
        pen.line({-0.95, 0.6}, {0.95, 0.6});
        break;
    case SymbolKind::strobe:
        pen.box(-1, -1, 1, 1);
        pen.polygon({{0.15, -0.8}, {-0.45, 0.1}, {0.0, 0.1}, {-0.15, 0.8}, {0.45, -0.1}, {0.0, -0.1}});
        break;
    case SymbolKind::bar:
        pen.box(-1, -1, 1, 1);
        for (const double x : {-0.6, -0.2, 0.2, 0.6}) pen.line({x, -1}, {x, 1});
        break;
    case SymbolKind::blinder:
        pen.box(-1, -1, 1, 1);
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5}) pen.circle({x, y}, 0.4);
        break;
    case SymbolKind::laser:
        pen.box(-1, -1, 1, 1);
        pen.polygon(star());
        break;
    case SymbolKind::projector:
        pen.box(-1, -1, 1, 0.6);
        pen.polygon({{-0.3, 0.6}, {0.3, 0.6}, {0.45, 1}, {-0.45, 1}});
        break;
    case SymbolKind::wall:
        pen.box(-1, -1, 1, 1);
        break;
    case SymbolKind::other:
        pen.box(-1, -1, 1, 1);
        pen.line({-1, -1}, {1, 1});
        pen.line({-1, 1}, {1, -1});
        break;
    case SymbolKind::not_known:
        pen.box(-1, -1, 1, 1);
        pen.line({-0.5, 0}, {0.5, 0});
        break;
    }
}

} // namespace ghost::scene
