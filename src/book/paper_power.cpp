// SPDX-License-Identifier: Apache-2.0
// What hangs where weighs and takes, the cables of a plot, and a proposal for phases.
#include "book/private/paper_tables.h"

#include "mvr/mvr_load.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace ghost::scene {
namespace {

struct Load {
    std::size_t fixtures = 0, weightless = 0, powerless = 0;
    double weight_kg = 0, power_w = 0;
};

// What follows each other in the schedule, on one fuse.
struct ProposedCircuit {
    std::string position;
    std::vector<std::size_t> fixtures;
    double power_w = 0;
    std::size_t phase = 0;
};

// As they hang, as many as it takes.
std::vector<ProposedCircuit> propose_circuits(const Show& show, const std::vector<Hanging>& hangings,
                                              double most_w) {
    std::vector<ProposedCircuit> circuits;
    for (const std::size_t i : in_hanging_order(hangings)) {
        const double power_w = power_w_of(show.fixtures[i]);
        if (!(power_w > 0)) continue;
        const bool is_new = circuits.empty() || circuits.back().position != hangings[i].position ||
                            circuits.back().power_w + power_w > most_w;
        if (is_new) circuits.push_back({hangings[i].position, {}, 0, 0});
        circuits.back().fixtures.push_back(i);
        circuits.back().power_w += power_w;
    }
    return circuits;
}

// The heaviest first, each to the phase with the least.
std::array<double, 3> share_out(std::vector<ProposedCircuit>& circuits) {
    std::vector<std::size_t> order(circuits.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return circuits[a].power_w > circuits[b].power_w; });
    std::array<double, 3> phases_w{};
    for (const std::size_t i : order) {
        const auto least = std::min_element(phases_w.begin(), phases_w.end());
        circuits[i].phase = static_cast<std::size_t>(least - phases_w.begin());
        *least += circuits[i].power_w;
    }
    return phases_w;
}

} // namespace

double weight_kg_of(const PatchedFixture& fixture) {
    return fixture.type ? std::max(0.0, static_cast<double>(fixture.type->properties.weight_kg)) : 0.0;
}

PaperTable positions_of(const Show& show, const PrintStyle& style) {
    PaperTable table{"positions", style("Weight and power by hanging position"), {}, {}, {}};
    const std::string kg = style.weight_unit();
    table.columns = {{style("hangs on")}, {style("fixtures"), true},
                     {kg, true},          {style("%1 unknown", {kg}), true},
                     {"W", true},         {style("%1 unknown", {"W"}), true}};
    std::vector<std::pair<std::string, Load>> loads;
    const std::vector<Hanging> hangings = hangings_of(show);
    for (const std::size_t i : in_hanging_order(hangings)) {
        if (loads.empty() || loads.back().first != hangings[i].position)
            loads.emplace_back(hangings[i].position, Load{});
        Load& load = loads.back().second;
        const double weight_kg = weight_kg_of(show.fixtures[i]), power_w = power_w_of(show.fixtures[i]);
        ++load.fixtures;
        load.weight_kg += weight_kg;
        load.power_w += power_w;
        if (!(weight_kg > 0)) ++load.weightless;
        if (!(power_w > 0)) ++load.powerless;
    }
    const auto count = [](std::size_t number) { return number > 0 ? std::to_string(number) : ""; };
    for (const auto& [position, load] : loads)
        table.rows.push_back(
            {{position.empty() ? style("nobody says") : position, std::to_string(load.fixtures),
              load.weight_kg > 0 ? style.weight(load.weight_kg) : "", count(load.weightless),
              load.power_w > 0 ? style.number(load.power_w, 0) : "", count(load.powerless)}});
    drop_empty_columns(table);
    if (!table.rows.empty()) {
        table.unknown.push_back(
            style("Only fixtures are weighed: trusses, hoists, cables and clamps are not in it."));
        table.unknown.push_back(
            style("A sum leaves out the fixtures whose file does not say it; they are counted as unknown."));
    }
    return table;
}

PaperTable cables_of(const Show& show, const PrintStyle& style) {
    PaperTable table{"cables", style("Cables of the plot"), {}, {}, {}};
    table.columns = {{style("from")}, {style("plug")}, {style("to")}, {style("other plug")}};
    if (!show.plot) return table;
    const Plot& plot = show.plot->plot;
    for (const PlotObject& object : plot.objects)
        for (const PlotConnection& cable : object.device.connections) {
            const bool is_there = cable.to_object >= 0;
            table.rows.push_back(
                {{object.name, cable.own,
                  is_there ? plot.objects[static_cast<std::size_t>(cable.to_object)].name : cable.to_uuid,
                  cable.other}});
        }
    return table;
}

PaperTable phases_proposed(const Show& show, const PrintStyle& style, std::optional<double> asked_w) {
    const UsualCircuit usual = usual_circuit(style.units);
    const double circuit_w = asked_w.value_or(usual.power_w());
    PaperTable table{"phases_proposal", style("Phases: a proposal"), {}, {}, {}};
    table.columns = {{style("phase")}, {style("circuit"), true},  {style("hangs on")},
                     {style("name")},  {style("fixtures"), true}, {"W", true}};
    const std::vector<Hanging> hangings = hangings_of(show);
    std::vector<ProposedCircuit> circuits = propose_circuits(show, hangings, circuit_w);
    const std::array<double, 3> phases_w = share_out(circuits);
    table.unknown.push_back(
        style("A PROPOSAL, made by this program: neither the plot nor the show says phases or circuits."));
    table.unknown.push_back(
        style("Circuits of at most %1 W, of one hanging position each, in the order of the "
              "instrument schedule; the heaviest circuit goes to the "
              "phase with the least. Check it before anything is plugged.",
              {style.number(circuit_w, 0)}));
    if (!asked_w)
        table.unknown.push_back(
            style("%1 A at %2 V, for nobody names a circuit; --circuit names other watts.",
                  {style.number(usual.breaker_a, 0), style.number(usual.voltage_v, 0)}));
    for (std::size_t phase = 0; phase < phases_w.size(); ++phase) {
        const std::string name = "L" + std::to_string(phase + 1);
        table.unknown.push_back(style("Phase %1: %2 W.", {name, style.number(phases_w[phase], 0)}));
        std::size_t number = 0;
        for (const ProposedCircuit& circuit : circuits)
            if (circuit.phase == phase)
                table.rows.push_back(
                    {{name, std::to_string(++number), circuit.position, names_of(show, circuit.fixtures),
                      std::to_string(circuit.fixtures.size()), style.number(circuit.power_w, 0)}});
    }
    std::vector<std::size_t> unsaid, too_much;
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        if (!(power_w_of(show.fixtures[i]) > 0)) unsaid.push_back(i);
        if (power_w_of(show.fixtures[i]) > circuit_w) too_much.push_back(i);
    }
    if (!unsaid.empty())
        table.unknown.push_back(
            style("Not in it, for nobody says their power: %1.", {names_of(show, unsaid)}));
    if (!too_much.empty())
        table.unknown.push_back(
            style("Above %1 W by itself: %2.", {style.number(circuit_w, 0), names_of(show, too_much)}));
    drop_empty_columns(table);
    return table;
}

} // namespace ghost::scene
