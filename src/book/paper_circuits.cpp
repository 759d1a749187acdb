// SPDX-License-Identifier: Apache-2.0
// What feeds the fixtures, as files and the show say it: plugs, circuits with their breakers, phases.
#include "base/natural_order.h"
#include "book/private/paper_tables.h"

#include "fixture/power.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace ghost::scene {
namespace {

struct CircuitLoad {
    std::vector<std::size_t> fixtures;
    std::size_t powerless = 0;  // fixtures whose power nobody says
    std::size_t factorless = 0; // those whose power factor nobody says
    double power_w = 0, apparent_va = 0;
};

void add_to(CircuitLoad& load, const Show& show, std::size_t index) {
    const PatchedFixture& fixture = show.fixtures[index];
    load.fixtures.push_back(index);
    const double power_w = power_w_of(fixture);
    if (!(power_w > 0)) {
        ++load.powerless;
        return;
    }
    load.power_w += power_w;
    double said_w = 0;
    for (const fixture::PowerInput& input :
         fixture::power_inputs_of(*fixture.type, fixture.patch().mode_of())) {
        if (!(input.power_factor > 0)) continue;
        said_w += static_cast<double>(input.power_w);
        load.apparent_va += static_cast<double>(input.power_w / input.power_factor);
    }
    if (said_w + 0.5 < power_w) ++load.factorless;
    load.apparent_va += std::max(0.0, power_w - said_w);
}

std::map<std::string, CircuitLoad> loads_of(const Show& show) {
    std::map<std::string, CircuitLoad> loads;
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) add_to(loads[show.fixtures[i].circuit], show, i);
    return loads;
}

// As the show describes them, then those that fixtures only name.
std::vector<Circuit> all_circuits(const Show& show, const std::map<std::string, CircuitLoad>& loads) {
    std::vector<Circuit> circuits = show.circuits, more;
    for (const auto& [name, load] : loads) {
        const bool is_described = std::ranges::find(circuits, name, &Circuit::name) != circuits.end();
        if (!name.empty() && !is_described) more.push_back({name, "", 0, 0});
    }
    std::stable_sort(more.begin(), more.end(),
                     [](const Circuit& a, const Circuit& b) { return natural_less(a.name, b.name); });
    circuits.insert(circuits.end(), more.begin(), more.end());
    return circuits;
}

std::string count_text(std::size_t number) {
    return number > 0 ? std::to_string(number) : "";
}

std::string said_number(const PrintStyle& style, double value, int decimals) {
    return value > 0 ? style.number(value, decimals) : "";
}

// Of a mode that nobody names only what all modes of the type say alike.
std::vector<fixture::PowerInput> inputs_said(const PatchedFixture& fixture) {
    const bool is_known = is_mode_said(fixture) || power_w_of(fixture) > 0;
    if (!is_known || fixture.type->modes.empty()) return {};
    const fixture::Type& type = *fixture.type;
    std::vector<fixture::PowerInput> said = fixture::power_inputs_of(type, fixture.patch().mode_of());
    if (fixture.is_mode_known) return said;
    for (const fixture::Mode& mode : type.modes) {
        const std::vector<fixture::PowerInput> others = fixture::power_inputs_of(type, mode);
        if (others.size() != said.size()) return {};
        for (std::size_t k = 0; k < said.size(); ++k) {
            if (others[k].connector != said[k].connector) said[k].connector.clear();
            if (others[k].plug != said[k].plug) said[k].plug.clear();
            if (others[k].voltage_low_v != said[k].voltage_low_v ||
                others[k].voltage_high_v != said[k].voltage_high_v)
                said[k].voltage_low_v = said[k].voltage_high_v = 0;
        }
    }
    return said;
}

void say_unknown(PaperTable& table, const Show& show, const PrintStyle& style, std::size_t powerless,
                 std::size_t factorless) {
    const auto loads = loads_of(show);
    if (powerless > 0)
        table.unknown.push_back(
            style("A sum leaves out the fixtures whose file does not say it; they are counted as unknown."));
    if (factorless > 0)
        table.unknown.push_back(style("Amperes are the least: the file of %1 says no power factor, and 1 is "
                                      "taken.",
                                      {std::to_string(factorless)}));
    if (const auto none = loads.find(""); none != loads.end())
        table.unknown.push_back(style("On no circuit: %1.", {names_of(show, none->second.fixtures)}));
}

} // namespace

double power_w_of(const PatchedFixture& fixture) {
    if (!fixture.type) return 0;
    const fixture::Type& type = *fixture.type;
    if (type.modes.empty()) return static_cast<double>(type.properties.power_w);
    const float power_w = fixture::power_w_of(type, fixture.patch().mode_of());
    const bool is_known =
        fixture.is_mode_known || std::all_of(type.modes.begin(), type.modes.end(), [&](const auto& mode) {
            return fixture::power_w_of(type, mode) == power_w;
        });
    return is_known ? static_cast<double>(power_w) : 0;
}

std::string names_of(const Show& show, const std::vector<std::size_t>& fixtures) {
    std::vector<std::string> names;
    for (const std::size_t i : fixtures) names.push_back(show.fixtures[i].name);
    return all_names_text(names);
}

bool names_circuits(const Show& show) {
    return std::any_of(show.fixtures.begin(), show.fixtures.end(),
                       [](const PatchedFixture& fixture) { return !fixture.circuit.empty(); });
}

PaperTable plugs_of(const Show& show, const PrintStyle& style) {
    struct Plugs {
        std::size_t count = 0;
        double power_w = 0;
    };
    std::map<std::tuple<std::string, std::string, std::string>, Plugs> kinds;
    std::vector<std::size_t> unsaid;
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        const std::vector<fixture::PowerInput> inputs = inputs_said(show.fixtures[i]);
        if (inputs.empty()) unsaid.push_back(i);
        for (const fixture::PowerInput& input : inputs) {
            const std::string low = said_number(style, static_cast<double>(input.voltage_low_v), 0),
                              high = said_number(style, static_cast<double>(input.voltage_high_v), 0);
            const std::string volts =
                low.empty() || high.empty() || low == high ? (high.empty() ? low : high) : low + "-" + high;
            Plugs& plugs = kinds[{input.connector, input.plug, volts}];
            ++plugs.count;
            plugs.power_w += static_cast<double>(input.power_w);
        }
    }
    PaperTable table{"plugs", style("Power by connector"), {}, {}, {}};
    table.columns = {{style("connector")}, {style("plug")}, {"V"}, {style("plugs"), true}, {"W", true}};
    for (const auto& [key, plugs] : kinds) {
        const auto& [connector, plug, volts] = key;
        table.rows.push_back({{connector.empty() ? style("nobody says") : connector, plug, volts,
                               std::to_string(plugs.count), style.number(plugs.power_w, 0)}});
    }
    drop_empty_columns(table);
    if (!unsaid.empty())
        table.unknown.push_back(
            style("Not in it, for nobody says their plugs: %1.", {names_of(show, unsaid)}));
    return table;
}

PaperTable circuits_of(const Show& show, const PrintStyle& style) {
    const std::map<std::string, CircuitLoad> loads = loads_of(show);
    PaperTable table{"circuits", style("Circuits"), {}, {}, {}};
    table.columns = {{style("circuit")}, {style("phase")}, {style("fixtures"), true},
                     {style("name")},    {"W", true},      {style("%1 unknown", {"W"}), true},
                     {"V", true},        {"A", true},      {style("breaker, A"), true}};
    std::size_t powerless = 0, factorless = 0;
    std::vector<std::string> voltless, too_much;
    for (const Circuit& circuit : all_circuits(show, loads)) {
        const auto found = loads.find(circuit.name);
        const CircuitLoad load = found == loads.end() ? CircuitLoad{} : found->second;
        const double current_a = circuit.voltage_v > 0 ? load.apparent_va / circuit.voltage_v : 0;
        powerless += load.powerless;
        factorless += load.factorless;
        if (!(circuit.voltage_v > 0) && load.power_w > 0) voltless.push_back(circuit.name);
        if (circuit.breaker_a > 0 && current_a > circuit.breaker_a)
            too_much.push_back(style("%1 (%2 A of %3 A)", {circuit.name, style.number(current_a, 1),
                                                           style.number(circuit.breaker_a, 1)}));
        table.rows.push_back({{circuit.name, circuit.phase, std::to_string(load.fixtures.size()),
                               names_of(show, load.fixtures), said_number(style, load.power_w, 0),
                               count_text(load.powerless), said_number(style, circuit.voltage_v, 0),
                               said_number(style, current_a, 1), said_number(style, circuit.breaker_a, 1)}});
    }
    drop_empty_columns(table);
    for (const std::string& circuit : too_much)
        table.unknown.push_back(style("ABOVE ITS BREAKER: circuit %1.", {circuit}));
    if (!voltless.empty())
        table.unknown.push_back(
            style("Amperes are not known of circuits without a voltage: %1.", {names_text(voltless, style)}));
    say_unknown(table, show, style, powerless, factorless);
    return table;
}

PaperTable phases_of(const Show& show, const PrintStyle& style) {
    struct Phase {
        std::size_t circuits = 0, fixtures = 0, powerless = 0, factorless = 0;
        double power_w = 0, current_a = 0;
        bool is_current_known = true;
    };
    const std::map<std::string, CircuitLoad> loads = loads_of(show);
    std::map<std::string, Phase> phases;
    bool is_said = false;
    std::size_t powerless = 0, factorless = 0;
    for (const Circuit& circuit : all_circuits(show, loads)) {
        const auto found = loads.find(circuit.name);
        const CircuitLoad load = found == loads.end() ? CircuitLoad{} : found->second;
        Phase& phase = phases[circuit.phase.empty() ? "~" : circuit.phase]; // nobody's comes last
        is_said = is_said || !circuit.phase.empty();
        ++phase.circuits;
        phase.fixtures += load.fixtures.size();
        phase.powerless += load.powerless;
        phase.power_w += load.power_w;
        if (circuit.voltage_v > 0)
            phase.current_a += load.apparent_va / circuit.voltage_v;
        else if (load.power_w > 0)
            phase.is_current_known = false;
        powerless += load.powerless;
        factorless += load.factorless;
    }
    PaperTable table{"phases", style("Power by phase"), {}, {}, {}};
    if (!is_said) return table;
    table.columns = {{style("phase")}, {style("circuits"), true},          {style("fixtures"), true},
                     {"W", true},      {style("%1 unknown", {"W"}), true}, {"A", true}};
    for (const auto& [name, phase] : phases)
        table.rows.push_back({{name == "~" ? style("nobody says") : name, std::to_string(phase.circuits),
                               std::to_string(phase.fixtures), said_number(style, phase.power_w, 0),
                               count_text(phase.powerless),
                               phase.is_current_known ? said_number(style, phase.current_a, 1) : ""}});
    drop_empty_columns(table);
    say_unknown(table, show, style, powerless, factorless);
    return table;
}

} // namespace ghost::scene
