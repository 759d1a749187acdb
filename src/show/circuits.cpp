// SPDX-License-Identifier: Apache-2.0
#include "show/circuits.h"

#include "base/suggest.h"
#include "base/text.h"
#include "json_xml_toml/toml_reader.h"
#include "show/show.h"

#include <map>
#include <set>

namespace ghost::scene {
namespace {

constexpr double kLargestBreaker_a = 10'000;
constexpr double kLowestMains_v = 50, kHighestMains_v = 1000;

} // namespace

std::vector<Circuit> read_circuits(TableReader& top, const std::string& file, Report& report) {
    std::vector<Circuit> circuits;
    std::set<std::string> names;
    for (const toml::table* table : top.tables("circuit", kMostCircuits)) {
        TableReader reader(*table, "[[circuit]]", file, report);
        Circuit circuit;
        circuit.name = reader.text("name").value_or("");
        if (circuit.name.empty()) reader.missing("name", "by which fixtures name it; it is left out");
        if (const auto phase = reader.text("phase")) {
            if (*phase == "L1" || *phase == "L2" || *phase == "L3")
                circuit.phase = *phase;
            else
                reader.problem(Severity::error, "phase",
                               "is '" + phase->substr(0, 40) +
                                   "', expected \"L1\", \"L2\" or \"L3\"; it is not known");
        }
        circuit.breaker_a = reader.number("breaker_a", 0.1, kLargestBreaker_a).value_or(0);
        circuit.voltage_v = reader.number("voltage_v", kLowestMains_v, kHighestMains_v).value_or(0);
        const bool is_known = !names.insert(circuit.name).second;
        if (is_known && !circuit.name.empty())
            reader.problem(Severity::error, "name", "is that of another circuit; the first one counts");
        reader.finish();
        if (!circuit.name.empty() && !is_known) circuits.push_back(std::move(circuit));
    }
    return circuits;
}

void check_circuits(const Show& show, Report& report) {
    if (show.circuits.empty()) return;
    std::vector<std::string> names;
    for (const Circuit& circuit : show.circuits) names.push_back(circuit.name);
    std::map<std::string, std::vector<std::string>> unknown;
    const std::set<std::string> known(names.begin(), names.end());
    for (const PatchedFixture& fixture : show.fixtures)
        if (!fixture.circuit.empty() && !known.contains(fixture.circuit))
            unknown[fixture.circuit].push_back(fixture.name);
    Suggestions suggestions;
    for (const auto& [name, fixtures] : unknown)
        report.add(Severity::warning, show.file.string(),
                   "no [[circuit]] is called '" + name.substr(0, 60) + "', which feeds " +
                       name_list(fixtures) + suggestions.did_you_mean(name, names));
}

} // namespace ghost::scene
