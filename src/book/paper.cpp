// SPDX-License-Identifier: Apache-2.0
#include "book/paper.h"

#include "book/fixture_values.h"
#include "book/private/paper_tables.h"
#include "book/quantities.h"
#include "mvr/mvr_load.h"
#include "show/show.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace ghost::scene {
namespace {

// What the plot says of a fixture beside what the show has.
struct Hanging {
    std::string position; // "Truss 1"
    std::string layer;
    std::string unit; // number on that position
    std::string function;
    std::string filter; // a colour in the beam
    std::string gobo;
};

Hanging hanging_of(const Plot& plot, const PlotObject& object) {
    Hanging hanging;
    const PlotDevice& device = object.device;
    if (device.position >= 0)
        hanging.position = plot.positions[static_cast<std::size_t>(device.position)].name;
    if (object.layer >= 0) hanging.layer = plot.layers[static_cast<std::size_t>(object.layer)].name;
    if (device.unit_number && *device.unit_number > 0) hanging.unit = std::to_string(*device.unit_number);
    hanging.function = device.function;
    if (device.color) hanging.filter = colour_text(*device.color);
    if (device.gobo) hanging.gobo = device.gobo->file;
    return hanging;
}

// One for each fixture; empty where there is no plot.
std::vector<Hanging> hangings_of(const Show& show) {
    std::vector<Hanging> all(show.fixtures.size());
    if (!show.plot) return all;
    const Plot& plot = show.plot->plot;
    std::map<std::string, std::size_t> objects;
    for (std::size_t i = 0; i < plot.objects.size(); ++i)
        objects.try_emplace(uuid_key(plot.objects[i].uuid), i);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (show.fixtures[i].uuid.empty()) continue;
        const auto found = objects.find(uuid_key(show.fixtures[i].uuid));
        if (found != objects.end()) all[i] = hanging_of(plot, plot.objects[found->second]);
    }
    return all;
}

std::string all_addresses(const PatchedFixture& fixture) {
    std::string text;
    for (const fixture::Address& address : addresses_of(fixture))
        text += (text.empty() ? "" : " + ") + address_text(address.universe, address.channel);
    return text;
}

std::string channels_text(const PatchedFixture& fixture) {
    std::string text;
    const std::size_t parts = fixture.type ? fixture.patch().mode_of().footprint.size() : 0;
    for (std::size_t part = 0; part < parts; ++part)
        text += (text.empty() ? "" : " + ") + std::to_string(footprint_of(fixture, part));
    return text;
}

std::string said(float value, int decimals) {
    return value > 0 ? number_text(value, decimals) : "";
}

std::vector<std::size_t> in_order_of(std::size_t count, const auto& is_before) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), is_before);
    return order;
}

} // namespace

std::string type_name(const PatchedFixture& fixture) {
    if (!fixture.type) return "";
    const std::string& maker = fixture.type->manufacturer;
    return maker + (maker.empty() ? "" : " ") + fixture.type->name;
}

std::string mode_name(const PatchedFixture& fixture) {
    return fixture.type && !fixture.type->modes.empty() ? fixture.patch().mode_of().name : "";
}

std::vector<fixture::Address> addresses_of(const PatchedFixture& fixture) {
    std::vector<fixture::Address> addresses{{fixture.universe, fixture.address}};
    addresses.insert(addresses.end(), fixture.more_addresses.begin(), fixture.more_addresses.end());
    return addresses;
}

int footprint_of(const PatchedFixture& fixture, std::size_t part) {
    if (!fixture.type || fixture.type->modes.empty()) return 0;
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

std::string fixtures_do(std::size_t count) {
    return count == 1 ? "1 fixture does" : std::to_string(count) + " fixtures do";
}

PaperTable instruments_of(const Show& show) {
    PaperTable table{"instruments", "Instrument schedule", {}, {}, {}};
    table.columns = {{"hangs on"}, {"unit", true}, {"number"},    {"name"},      {"type"},      {"mode"},
                     {"address"},  {"channels"},   {"x m", true}, {"y m", true}, {"z m", true}, {"function"},
                     {"filter"},   {"gobo"},       {"layer"},     {"kg", true},  {"W", true}};
    const std::vector<Hanging> hangings = hangings_of(show);
    const auto order = in_order_of(show.fixtures.size(), [&](std::size_t a, std::size_t b) {
        const Hanging &one = hangings[a], &other = hangings[b];
        // What hangs nowhere comes last.
        if (one.position.empty() != other.position.empty()) return other.position.empty();
        if (one.position != other.position) return natural_less(one.position, other.position);
        if (one.position.empty() && one.layer != other.layer) return natural_less(one.layer, other.layer);
        return natural_less(one.unit, other.unit);
    });
    std::size_t nowhere = 0, unread = 0;
    for (const std::size_t i : order) {
        const PatchedFixture& fixture = show.fixtures[i];
        const Hanging& hanging = hangings[i];
        const fixture::Properties properties =
            fixture.type ? fixture.type->properties : fixture::Properties{};
        table.rows.push_back(
            {{hanging.position, hanging.unit, fixture.fixture_id, fixture.name, type_name(fixture),
              mode_name(fixture), all_addresses(fixture), channels_text(fixture),
              number_text(fixture.position_m.x, 2), number_text(fixture.position_m.y, 2),
              number_text(fixture.position_m.z, 2), hanging.function, hanging.filter, hanging.gobo,
              hanging.layer, said(properties.weight_kg, 1), said(properties.power_w, 0)}});
        if (hanging.position.empty()) ++nowhere;
        if (!fixture.type) ++unread;
    }
    drop_empty_columns(table);
    if (nowhere > 0) table.unknown.push_back("What they hang on: " + fixtures_do(nowhere) + " not say it.");
    if (unread > 0)
        table.unknown.push_back("The file of the type could not be read of " + std::to_string(unread) +
                                ": type, mode, channels, weight and power are not known.");
    return table;
}

PaperTable hookup_of(const Show& show) {
    PaperTable table{"hookup", "Channel hookup", {}, {}, {}};
    table.columns = {{"number"}, {"name"},     {"address"},    {"channels"}, {"type"},
                     {"mode"},   {"hangs on"}, {"unit", true}, {"function"}};
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
        table.rows.push_back({{fixture.fixture_id, fixture.name, all_addresses(fixture),
                               channels_text(fixture), type_name(fixture), mode_name(fixture),
                               hangings[i].position, hangings[i].unit, hangings[i].function}});
    }
    drop_empty_columns(table);
    if (numberless > 0)
        table.unknown.push_back("The number by which a desk calls them: " + fixtures_do(numberless) +
                                " not say it, and are sorted by name.");
    return table;
}

PaperTable types_of(const Show& show) {
    struct Kind {
        const PatchedFixture* first = nullptr;
        std::size_t count = 0;
    };
    std::map<std::pair<std::string, std::string>, Kind> kinds;
    for (const PatchedFixture& fixture : show.fixtures) {
        Kind& kind = kinds[{type_name(fixture), mode_name(fixture)}];
        if (!kind.first) kind.first = &fixture;
        ++kind.count;
    }
    PaperTable table{"types", "Types, weight and power", {}, {}, {}};
    table.columns = {{"type"},          {"mode"},         {"fixtures", true}, {"channels"},
                     {"kg each", true}, {"kg all", true}, {"W each", true},   {"W all", true}};
    double weight_kg = 0, power_w = 0;
    std::size_t weightless = 0, powerless = 0;
    for (const auto& [names, kind] : kinds) {
        const auto count = static_cast<float>(kind.count);
        const fixture::Properties properties =
            kind.first->type ? kind.first->type->properties : fixture::Properties{};
        table.rows.push_back({{names.first.empty() ? "file not read" : names.first, names.second,
                               std::to_string(kind.count), channels_text(*kind.first),
                               said(properties.weight_kg, 1), said(count * properties.weight_kg, 1),
                               said(properties.power_w, 0), said(count * properties.power_w, 0)}});
        weight_kg += static_cast<double>(count * properties.weight_kg);
        power_w += static_cast<double>(count * properties.power_w);
        if (!(properties.weight_kg > 0)) weightless += kind.count;
        if (!(properties.power_w > 0)) powerless += kind.count;
    }
    const auto total = [&](const std::string& what, double sum, const std::string& unit, std::size_t unsaid) {
        if (unsaid == show.fixtures.size())
            table.unknown.push_back(what + ": no fixture file says it.");
        else
            table.unknown.push_back(
                what + " of the fixtures: " + number_text(static_cast<float>(sum), 1) + " " + unit +
                (unsaid > 0 ? ", without those that do not say it: " + std::to_string(unsaid) + "." : "."));
    };
    if (!show.fixtures.empty()) {
        total("Weight", weight_kg, "kg", weightless);
        total("Power", power_w, "W", powerless);
        table.unknown.push_back("Phases, circuits and cables are not known.");
    }
    return table;
}

Paper paper_of(const Show& show) {
    Paper paper;
    paper.show = show.name.empty() ? show.folder.filename().string() : show.name;
    paper.tables = {instruments_of(show), hookup_of(show), patch_of(show),
                    universes_of(show),   wheels_of(show), types_of(show)};
    return paper;
}

} // namespace ghost::scene
