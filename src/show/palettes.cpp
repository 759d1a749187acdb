// SPDX-License-Identifier: Apache-2.0
#include "show/palettes.h"

#include "base/suggest.h"
#include "base/text.h"
#include "json_xml_toml/toml_reader.h"
#include "show/show.h"

#include <algorithm>
#include <set>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostPalettes = 1000;
constexpr std::size_t kMostOwnValues = 65536; // fixtures of one palette
constexpr std::size_t kMostAttributes = 256;  // of a head
constexpr double kMostAxis_deg = 100000;      // as fixture::apply has it
constexpr double kWidestZoom_deg = 180;

void put_number(std::optional<float>& target, const std::optional<double>& value) {
    if (value) target = static_cast<float>(*value);
}

PaletteValues read_values(TableReader& reader, PaletteKind kind) {
    PaletteValues values;
    if (kind == PaletteKind::position) {
        put_number(values.pan_deg, reader.number("pan_deg", -kMostAxis_deg, kMostAxis_deg));
        put_number(values.tilt_deg, reader.number("tilt_deg", -kMostAxis_deg, kMostAxis_deg));
    } else if (kind == PaletteKind::colour) {
        values.colour = reader.light_colour("colour_rec2020");
    } else if (kind == PaletteKind::beam) {
        put_number(values.zoom_deg, reader.number("zoom_deg", 0, kWidestZoom_deg));
    } else {
        values.gobo = reader.integer("gobo", 0, 255);
    }
    values.attributes = reader.fractions("attributes", kMostAttributes);
    return values;
}

} // namespace

Result<PaletteKind> palette_kind_of(const std::string& word) {
    for (std::size_t i = 0; i < kPaletteKinds.size(); ++i)
        if (word == kPaletteKinds[i]) return static_cast<PaletteKind>(i);
    return Error{"'" + word.substr(0, 40) + "' is none of position, colour, beam and gobo", ""};
}

std::vector<Palette> read_palettes(TableReader& top, const std::string& file, Report& report) {
    std::vector<Palette> palettes;
    for (const toml::table* table : top.tables("palette", kMostPalettes)) {
        TableReader reader(*table, "[[palette]]", file, report);
        Palette palette;
        palette.where = file_line(file, reader.line());
        palette.name = reader.text("name").value_or("");
        if (palette.name.empty()) reader.missing("name", "what it is called by");
        const auto word = reader.text("kind");
        if (!reader.has("kind"))
            reader.missing("kind", "what it is about: position, colour, beam or gobo; it is left out");
        const Result<PaletteKind> kind = palette_kind_of(word.value_or(""));
        if (!kind.ok()) {
            if (word)
                reader.problem(Severity::error, "kind",
                               "is '" + word->substr(0, 40) +
                                   "', expected position, colour, beam or gobo; the palette is left out");
            continue;
        }
        palette.kind = *kind;
        palette.values = read_values(reader, *kind);
        for (const toml::table* own : reader.tables("fixture", kMostOwnValues)) {
            TableReader fixture(*own, "[[palette.fixture]]", file, report);
            const std::string name = fixture.text("name").value_or("");
            if (name.empty()) fixture.missing("name", "that of a fixture of the show");
            const PaletteValues values = read_values(fixture, *kind);
            fixture.finish();
            if (!name.empty() && !palette.fixtures.emplace(name, values).second)
                fixture.problem(Severity::error, "name", "is there twice in this palette");
        }
        reader.finish();
        if (palette.name.empty()) continue;
        if (std::ranges::find(palettes, palette.name, &Palette::name) != palettes.end())
            reader.problem(Severity::error, "name",
                           "is that of another palette; the first one is called by it");
        else
            palettes.push_back(std::move(palette));
    }
    return palettes;
}

void check_palettes(const Show& show, Report& report) {
    std::set<std::string> fixtures;
    for (const PatchedFixture& fixture : show.fixtures) fixtures.insert(fixture.name);
    for (const Palette& palette : show.palettes) {
        std::vector<std::string> missing;
        for (const auto& [name, values] : palette.fixtures)
            if (!fixtures.contains(name)) missing.push_back(name);
        if (!missing.empty())
            report.add(Severity::warning, palette.where,
                       "palette '" + palette.name +
                           "' has values for fixtures that the show does not have: " + name_list(missing));
    }
}

Result<std::size_t> find_palette(const std::vector<Palette>& palettes, const std::string& name) {
    std::vector<std::string> names;
    for (const Palette& palette : palettes) {
        if (palette.name == name) return names.size();
        names.push_back(palette.name);
    }
    return Error{"there is no palette '" + name + "'" + did_you_mean(name, names), ""};
}

} // namespace ghost::scene
