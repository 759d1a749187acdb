// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/file_symbols.h"

#include "drawings/private/rigging.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {
namespace {

using fixture::SymbolSide;

constexpr double kFinest_pt = 0.1;
constexpr float kFacing = 0.7f; // cosine: a part that is turned further is drawn as it is at rest

// The directions in which a side's x and y point, and where it is seen from.
struct SideAxes {
    int x, y, eye;
};
constexpr SideAxes axes_of(SymbolSide side) {
    switch (side) {
    case SymbolSide::right:
        return {1, 2, 0};
    case SymbolSide::front:
        return {0, 2, 1};
    case SymbolSide::top:
        break;
    }
    return {0, 1, 2};
}

// The one that looks most towards the eye, or away from it.
SymbolSide side_seen(const glm::mat4& to_world, const View& view) {
    SymbolSide best = SymbolSide::top;
    double most = -1;
    for (const SymbolSide side : {SymbolSide::top, SymbolSide::right, SymbolSide::front}) {
        const glm::dvec3 way(glm::normalize(glm::vec3(to_world[axes_of(side).eye])));
        const double facing = std::abs(glm::dot(way, view.to_eye()));
        if (facing > most + 1e-6) {
            most = facing;
            best = side;
        }
    }
    return best;
}

} // namespace

const std::vector<FileSymbols::Line>& FileSymbols::lines_of(const PatchedFixture& fixture, SymbolSide side) {
    const auto [found, is_new] = known_.try_emplace({fixture.type.get(), fixture.mode, side});
    std::vector<Line>& lines = found->second;
    if (!is_new) return lines;
    const auto index = static_cast<std::size_t>(side);
    const bool has_any =
        std::any_of(fixture.type->models.begin(), fixture.type->models.end(),
                    [&](const fixture::Model& model) { return !model.symbols[index].empty(); });
    if (!has_any) return lines;
    const SideAxes axes = axes_of(side);
    for (const fixture::PartState& part : straight_parts(fixture)) {
        const fixture::Model& model = fixture.type->models[static_cast<std::size_t>(part.model)];
        glm::mat4 place = part.to_fixture;
        if (std::abs(place[axes.eye][axes.eye]) < kFacing) {
            place = glm::mat4(1.0f);
            place[3] = part.to_fixture[3];
        }
        for (const fixture::SymbolLine& line : model.symbols[index]) {
            Line& made = lines.emplace_back();
            made.is_closed = line.is_closed;
            made.is_filled = line.is_filled;
            for (const glm::vec2& point : line.points_m) {
                glm::vec4 at(0, 0, 0, 1);
                at[axes.x] = point.x;
                at[axes.y] = point.y;
                made.points_m.emplace_back(place * at);
            }
        }
    }
    return lines;
}

std::vector<FlatLine> FileSymbols::seen(const PatchedFixture& fixture, const glm::mat4& to_world,
                                        const View& view) {
    std::vector<FlatLine> all;
    if (!fixture.type || fixture.type->modes.empty()) return all;
    const glm::dvec2 from = view.flat(glm::vec3(to_world[3]));
    for (const Line& line : lines_of(fixture, side_seen(to_world, view))) {
        FlatLine& flat = all.emplace_back();
        flat.is_closed = line.is_closed;
        flat.is_filled = line.is_filled;
        for (const glm::vec3& point : line.points_m)
            flat.points.push_back(view.flat(glm::vec3(to_world * glm::vec4(point, 1.0f))) - from);
    }
    return all;
}

std::vector<FlatLine> FileSymbols::from_above(const PatchedFixture& fixture) {
    return seen(fixture, glm::mat4(1.0f), scene::from_above());
}

void draw_lines(PdfWriter& pdf, const std::vector<FlatLine>& lines) {
    for (const FlatLine& line : lines) {
        std::vector<glm::dvec2> points;
        for (std::size_t k = 0; k < line.points.size(); ++k)
            if (points.empty() || k + 1 == line.points.size() ||
                glm::distance(points.back(), line.points[k]) > kFinest_pt)
                points.push_back(line.points[k]);
        pdf.shape(points, line.is_closed,
                  {.line_grey = 0, .width_pt = 0.3, .fill_grey = line.is_filled ? 1.0 : -1.0});
    }
}

} // namespace ghost::scene
