// SPDX-License-Identifier: Apache-2.0
// 2D symbols of the models: models/svg, svg_side, svg_front.
#include "fixture_files/common/svg_symbol.h"
#include "fixture_files/gdtf/private/gdtf_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace ghost::fixture {
namespace {

constexpr float kMillimetre = 1e-3f; // what the standard asks a unit to be
constexpr float kAlike = 0.25f;      // of two scales, as a share
constexpr std::size_t kMostPointsOfType = 32768;

struct SideOfFile {
    const char *folder, *offset_x, *offset_y;
    int x, y; // of Model::size_m
};
constexpr std::array<SideOfFile, kSymbolSides> kSides{
    {{"svg", "SVGOffsetX", "SVGOffsetY", 0, 1},
     {"svg_side", "SVGSideOffsetX", "SVGSideOffsetY", 1, 2},
     {"svg_front", "SVGFrontOffsetX", "SVGFrontOffsetY", 0, 2}}};

struct DrawnModel {
    std::size_t model = 0;
    SvgSymbol symbol;
    glm::vec2 origin{0};         // where it is put in, units of the drawing
    std::optional<float> unit_m; // nothing: the drawing is of another shape than the model
};

// Files are in millimetres, as the standard asks, or fill some square: then the model's box says the scale.
std::optional<float> unit_of(const SvgSymbol& symbol, const glm::vec2& size_m) {
    const glm::vec2 drawn = symbol.high - symbol.low;
    if (!(drawn.x > 0 && drawn.y > 0 && size_m.x > 0 && size_m.y > 0)) return std::nullopt;
    const auto is_like = [](float a, float b) { return std::abs(a / b - 1) < kAlike; };
    const glm::vec2 unit = size_m / drawn;
    if (is_like(unit.x, kMillimetre) && is_like(unit.y, kMillimetre)) return kMillimetre;
    if (is_like(unit.x, unit.y)) return std::sqrt(unit.x * unit.y);
    return std::nullopt;
}

std::optional<DrawnModel> read_drawing(GdtfReader& reader, pugi::xml_node node, std::size_t index,
                                       const SideOfFile& side) {
    const std::string file = reader.text(node, "File");
    const glm::vec2 offset(reader.number(node, side.offset_x, 0.0f, -1e6f, 1e6f),
                           reader.number(node, side.offset_y, 0.0f, -1e6f, 1e6f));
    if (file.empty()) return std::nullopt;
    const std::string entry = reader.archive.find(std::string("models/") + side.folder + "/" + file + ".svg");
    if (entry.empty()) return std::nullopt;
    const std::string where = reader.name + ": " + entry;
    const Result<std::vector<std::uint8_t>> bytes = reader.archive.read(entry);
    if (!bytes) {
        reader.say_at(Severity::error, bytes.error().where, bytes.error().what);
        return std::nullopt;
    }
    Result<SvgSymbol> symbol = read_svg_symbol(*bytes, where);
    if (!symbol) {
        reader.say_at(Severity::warning, where, symbol.error().what + "; it is not used on plans");
        return std::nullopt;
    }
    DrawnModel drawn;
    drawn.model = index;
    const Model& model = reader.type().models[index];
    drawn.unit_m = unit_of(*symbol, {model.size_m[side.x], model.size_m[side.y]});
    // Files leave the offset at 0 and draw around the middle.
    const bool says_origin = offset != glm::vec2(0.0f);
    drawn.origin = symbol->box_low + (says_origin ? offset : 0.5f * symbol->box_size);
    drawn.symbol = std::move(*symbol);
    return drawn;
}

// Heads are often drawn turned, so that their box says nothing: they have the unit of the other models.
void give_units(std::vector<DrawnModel>& drawings) {
    std::vector<float> known;
    for (const DrawnModel& drawn : drawings)
        if (drawn.unit_m) known.push_back(*drawn.unit_m);
    if (known.empty()) return;
    std::sort(known.begin(), known.end());
    for (DrawnModel& drawn : drawings)
        if (!drawn.unit_m) drawn.unit_m = known[known.size() / 2];
}

} // namespace

void read_symbols(GdtfReader& reader, pugi::xml_node fixture_type) {
    Type& type = reader.type();
    std::size_t points = 0;
    for (std::size_t side = 0; side < kSymbolSides; ++side) {
        std::vector<DrawnModel> drawings;
        std::size_t index = 0;
        for (const pugi::xml_node node : fixture_type.child("Models").children("Model")) {
            if (index == type.models.size()) break;
            if (auto drawn = read_drawing(reader, node, index, kSides[side]))
                drawings.push_back(std::move(*drawn));
            ++index;
        }
        give_units(drawings);
        if (drawings.empty()) continue;
        const std::string folder = reader.name + ": models/" + kSides[side].folder;
        for (const DrawnModel& drawn : drawings)
            for (const SvgSymbol::Line& line : drawn.symbol.lines) points += line.points.size();
        if (!drawings.front().unit_m || points > kMostPointsOfType) {
            reader.say_at(Severity::note, folder,
                          drawings.front().unit_m
                              ? "2D symbols of more than 32768 points in all; they are not used on plans"
                              : "the 2D symbols have other shapes than their models, so that their scale is "
                                "not known; they are not used on plans");
            continue;
        }
        for (const DrawnModel& drawn : drawings) {
            std::vector<SymbolLine>& lines = type.models[drawn.model].symbols[side];
            for (const SvgSymbol::Line& line : drawn.symbol.lines) {
                SymbolLine& made = lines.emplace_back();
                made.is_closed = line.is_closed;
                made.is_filled = line.is_filled;
                for (const glm::vec2& point : line.points) {
                    const glm::vec2 from = (point - drawn.origin) * *drawn.unit_m;
                    made.points_m.push_back({from.x, -from.y});
                }
            }
        }
    }
}

} // namespace ghost::fixture
