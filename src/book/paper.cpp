// SPDX-License-Identifier: Apache-2.0
#include "book/paper.h"

#include "base/natural_order.h"
#include "base/text.h"
#include "book/private/paper_tables.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <tuple>

namespace ghost::scene {
namespace {

std::string all_addresses(const PatchedFixture& fixture, const PrintStyle& style) {
    std::string text;
    const std::vector<fixture::Address> addresses = addresses_of(fixture);
    for (std::size_t part = 0; part < addresses.size(); ++part) {
        if (!fixture.is_address_known && addresses[part].channel < 1) continue;
        // Plots name breaks that the mode does not have.
        const bool is_used = part == 0 || addresses[part].channel > 0 || footprint_of(fixture, part) > 0;
        if (is_used)
            text += (text.empty() ? "" : " + ") +
                    said_address(style, addresses[part].universe, addresses[part].channel);
    }
    return text;
}

std::string channels_text(const PatchedFixture& fixture) {
    std::string text;
    if (!is_mode_said(fixture)) return text;
    const std::size_t parts = fixture.patch().mode_of().footprint.size();
    for (std::size_t part = 0; part < parts; ++part)
        text += (text.empty() ? "" : " + ") + std::to_string(footprint_of(fixture, part));
    return text;
}

std::string said_weight(const PrintStyle& style, double kilograms) {
    return kilograms > 0 ? style.weight(kilograms) : "";
}

std::string said_power(const PrintStyle& style, double watts) {
    return watts > 0 ? style.number(watts, 0) : "";
}

void say_addressless(PaperTable& table, const Show& show, const PrintStyle& style) {
    if (const std::vector<std::string> names = addressless_of(show); !names.empty())
        table.unknown.push_back(style("The address of %1 cannot be read.", {names_text(names, style)}));
}

std::vector<std::size_t> in_order_of(std::size_t count, const auto& is_before) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), is_before);
    return order;
}

} // namespace

std::string said_address(const PrintStyle& style, int universe, int channel) {
    return channel < 1 ? style("not patched") : address_text(universe, channel);
}

std::vector<std::string> addressless_of(const Show& show) {
    std::vector<std::string> names;
    for (const PatchedFixture& fixture : show.fixtures)
        if (!fixture.is_address_known) names.push_back(fixture.name);
    return names;
}

std::string type_name(const PatchedFixture& fixture) {
    if (!fixture.type) return "";
    const std::string& maker = fixture.type->manufacturer;
    return maker + (maker.empty() ? "" : " ") + fixture.type->name;
}

std::string mode_name(const PatchedFixture& fixture) {
    return is_mode_said(fixture) ? fixture.patch().mode_of().name : "";
}

std::string written_type(const PatchedFixture& fixture, const Hanging& hanging) {
    constexpr std::string_view kEnd = ".gdtf";
    if (fixture.type) return type_name(fixture);
    std::string written = hanging.type.empty() ? fixture.gdtf.filename().string() : hanging.type;
    if (lower(written).ends_with(kEnd)) written.resize(written.size() - kEnd.size());
    return written;
}

std::string written_mode(const PatchedFixture& fixture, const Hanging& hanging) {
    return fixture.type ? mode_name(fixture) : hanging.mode;
}

void say_unread(PaperTable& table, const Show& show, const PrintStyle& style) {
    const auto unread = std::count_if(show.fixtures.begin(), show.fixtures.end(),
                                      [](const PatchedFixture& fixture) { return !fixture.type; });
    if (unread > 0)
        table.unknown.push_back(
            style("The file of the type could not be read of %1: type and mode are as the "
                  "plot or the show writes them, channels, weight and power are not known.",
                  {std::to_string(unread)}));
}

bool is_mode_said(const PatchedFixture& fixture) {
    return fixture.type && !fixture.type->modes.empty() && fixture.is_mode_known;
}

std::vector<fixture::Address> addresses_of(const PatchedFixture& fixture) {
    std::vector<fixture::Address> addresses{{fixture.universe, fixture.address}};
    addresses.insert(addresses.end(), fixture.more_addresses.begin(), fixture.more_addresses.end());
    return addresses;
}

int footprint_of(const PatchedFixture& fixture, std::size_t part) {
    if (!is_mode_said(fixture)) return 0;
    const std::vector<int>& footprint = fixture.patch().mode_of().footprint;
    return part < footprint.size() ? footprint[part] : 0;
}

void drop_empty_columns(PaperTable& table) {
    if (table.rows.empty()) return;
    for (std::size_t column = table.columns.size(); column-- > 0;) {
        const bool is_empty = std::all_of(table.rows.begin(), table.rows.end(),
                                          [&](const PaperRow& row) { return row.cells[column].empty(); });
        if (!is_empty) continue;
        const auto at = static_cast<std::ptrdiff_t>(column);
        table.columns.erase(table.columns.begin() + at);
        for (PaperRow& row : table.rows) row.cells.erase(row.cells.begin() + at);
    }
}

PaperTable instruments_of(const Show& show, const PrintStyle& style) {
    PaperTable table{"instruments", style("Instrument schedule"), {}, {}, {}};
    const std::string m = " " + style.length_unit();
    table.columns = {{style("hangs on")},
                     {style("unit"), true},
                     {style("number"), false, true},
                     {style("name")},
                     {style("type")},
                     {style("mode")},
                     {style("address"), false, true},
                     {style("channels"), false, true},
                     {"x" + m, true},
                     {"y" + m, true},
                     {"z" + m, true},
                     {style("function")},
                     {style("filter"), false, true},
                     {style("gobo")},
                     {style("focus point")},
                     {style("circuit")},
                     {style("layer")},
                     {style.weight_unit(), true},
                     {"W", true}};
    const std::vector<Hanging> hangings = hangings_of(show);
    std::size_t nowhere = 0;
    std::vector<std::string> placeless, modeless;
    const auto place = [&](const PatchedFixture& fixture, int axis) {
        return fixture.is_place_known ? style.length(static_cast<double>(fixture.position_m[axis])) : "";
    };
    for (const std::size_t i : in_hanging_order(hangings)) {
        const PatchedFixture& fixture = show.fixtures[i];
        const Hanging& hanging = hangings[i];
        table.rows.push_back(
            {{hanging.position, hanging.unit, fixture.fixture_id, fixture.name,
              written_type(fixture, hanging), written_mode(fixture, hanging), all_addresses(fixture, style),
              channels_text(fixture), place(fixture, 0), place(fixture, 1), place(fixture, 2),
              hanging.function, hanging.filter, hanging.gobo, hanging.focus, fixture.circuit, hanging.layer,
              said_weight(style, weight_kg_of(fixture)), said_power(style, power_w_of(fixture))}});
        if (hanging.position.empty()) ++nowhere;
        if (!fixture.is_place_known) placeless.push_back(fixture.name);
        if (fixture.type && !is_mode_said(fixture)) modeless.push_back(fixture.name);
    }
    drop_empty_columns(table);
    say_addressless(table, show, style);
    if (!placeless.empty())
        table.unknown.push_back(
            style("Nobody says a place that can be used of %1.", {names_text(placeless, style)}));
    if (!modeless.empty())
        table.unknown.push_back(
            style("Nobody names a mode that the type has of %1: channels, and power where "
                  "modes differ in it, are not known.",
                  {names_text(modeless, style)}));
    if (nowhere == 1) table.unknown.push_back(style("What they hang on: 1 fixture does not say it."));
    if (nowhere > 1)
        table.unknown.push_back(
            style("What they hang on: %1 fixtures do not say it.", {std::to_string(nowhere)}));
    say_unread(table, show, style);
    return table;
}

PaperTable hookup_of(const Show& show, const PrintStyle& style) {
    PaperTable table{"hookup", style("Channel hookup"), {}, {}, {}};
    table.columns = {{style("number"), false, true},
                     {style("name")},
                     {style("address"), false, true},
                     {style("channels"), false, true},
                     {style("type")},
                     {style("mode")},
                     {style("hangs on")},
                     {style("unit"), true},
                     {style("function")}};
    const std::vector<Hanging> hangings = hangings_of(show);
    const auto order = in_order_of(show.fixtures.size(), [&](std::size_t a, std::size_t b) {
        const PatchedFixture &one = show.fixtures[a], &other = show.fixtures[b];
        if (one.fixture_id.empty() != other.fixture_id.empty()) return other.fixture_id.empty();
        if (one.fixture_id != other.fixture_id) return natural_less(one.fixture_id, other.fixture_id);
        return natural_less(one.name, other.name);
    });
    std::size_t numberless = 0;
    for (const std::size_t i : order) {
        const PatchedFixture& fixture = show.fixtures[i];
        if (fixture.fixture_id.empty()) ++numberless;
        table.rows.push_back(
            {{fixture.fixture_id, fixture.name, all_addresses(fixture, style), channels_text(fixture),
              written_type(fixture, hangings[i]), written_mode(fixture, hangings[i]), hangings[i].position,
              hangings[i].unit, hangings[i].function}});
    }
    drop_empty_columns(table);
    say_addressless(table, show, style);
    say_unread(table, show, style);
    if (numberless == 1)
        table.unknown.push_back(style(
            "The number by which a desk calls them: 1 fixture does not say it, and is sorted by name."));
    if (numberless > 1)
        table.unknown.push_back(style("The number by which a desk calls them: %1 fixtures do not say it, and "
                                      "are sorted by name.",
                                      {std::to_string(numberless)}));
    return table;
}

PaperTable types_of(const Show& show, const PrintStyle& style) {
    // By names, and by what is said: two files of one name may differ.
    std::map<std::tuple<std::string, std::string, double, double, std::string>, std::size_t> kinds;
    const std::vector<Hanging> hangings = hangings_of(show);
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        const PatchedFixture& fixture = show.fixtures[i];
        ++kinds[{written_type(fixture, hangings[i]), written_mode(fixture, hangings[i]),
                 weight_kg_of(fixture), power_w_of(fixture), channels_text(fixture)}];
    }
    PaperTable table{"types", style("Types, weight and power"), {}, {}, {}};
    const std::string kg = style.weight_unit();
    table.columns = {{style("type")},
                     {style("mode")},
                     {style("fixtures"), true},
                     {style("channels"), false, true},
                     {style("%1 each", {kg}), true},
                     {style("%1 all", {kg}), true},
                     {style("%1 each", {"W"}), true},
                     {style("%1 all", {"W"}), true}};
    double weight_kg = 0, power_w = 0;
    std::size_t weightless = 0, powerless = 0;
    std::set<std::pair<std::string, std::string>> names;
    for (const auto& [key, fixtures] : kinds) {
        const auto& [name, mode, each_kg, each_w, channels] = key;
        const auto count = static_cast<double>(fixtures);
        names.emplace(name, mode);
        table.rows.push_back({{name.empty() ? style("file not read") : name, mode, std::to_string(fixtures),
                               channels, said_weight(style, each_kg), said_weight(style, count * each_kg),
                               said_power(style, each_w), said_power(style, count * each_w)}});
        weight_kg += count * each_kg;
        power_w += count * each_w;
        if (!(each_kg > 0)) weightless += fixtures;
        if (!(each_w > 0)) powerless += fixtures;
    }
    const auto total = [&](const std::string& what, const std::string& sum, std::size_t unsaid) {
        if (unsaid == show.fixtures.size())
            table.unknown.push_back(style("%1: no fixture file says it.", {what}));
        else if (unsaid > 0)
            table.unknown.push_back(style("%1 of the fixtures: %2, without those that do not say it: %3.",
                                          {what, sum, std::to_string(unsaid)}));
        else
            table.unknown.push_back(style("%1 of the fixtures: %2.", {what, sum}));
    };
    if (names.size() < kinds.size())
        table.unknown.push_back(style("Rows of one name are of fixture files that say different things."));
    if (!show.fixtures.empty()) {
        total(style("Weight"), style.weight(weight_kg) + " " + kg, weightless);
        total(style("Power"), style.number(power_w, 1) + " W", powerless);
    }
    say_unread(table, show, style);
    return table;
}

Paper paper_of(const Show& show, const PrintStyle& style, std::optional<double> circuit_w) {
    Paper paper;
    paper.show = show.name.empty() ? show.folder.filename().string() : show.name;
    paper.style = style;
    paper.tables = {instruments_of(show, style), hookup_of(show, style), patch_of(show, style),
                    universes_of(show, style),   wheels_of(show, style), types_of(show, style),
                    positions_of(show, style)};
    if (show.fixtures.empty())
        for (PaperTable& table : paper.tables)
            table.unknown.insert(table.unknown.begin(), style("The show has no fixtures."));
    // Not there where nobody says anything about cables or power; what is said stands in the place of a
    // proposal.
    std::vector<PaperTable> more{cables_of(show, style), plugs_of(show, style)};
    if (names_circuits(show)) {
        more.push_back(circuits_of(show, style));
        more.push_back(phases_of(show, style));
    } else {
        more.push_back(phases_proposed(show, style, circuit_w));
    }
    for (PaperTable& table : more)
        if (!table.rows.empty()) paper.tables.push_back(std::move(table));
    return paper;
}

} // namespace ghost::scene
