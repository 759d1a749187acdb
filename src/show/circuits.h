#pragma once
// SPDX-License-Identifier: Apache-2.0
// Circuits: [[circuit]] of show.toml: what feeds fixtures, for paperwork: a breaker, a phase, or the dimmer
// of a lamp. Fixtures name theirs. Nothing of it changes the picture. Values, and how they are read.

#include "base/report.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ghost::scene {

class TableReader; // json_xml_toml/toml_reader.h
struct Show;       // show/show.h

inline constexpr std::size_t kMostCircuits = 10'000;

struct Circuit {
    std::string name;
    std::string phase;    // "L1", "L2", "L3", or "": nobody says
    double breaker_a = 0; // 0: nobody says
    double voltage_v = 0; // 0: nobody says
};

std::vector<Circuit> read_circuits(TableReader& top, const std::string& file, Report& report);
// Names of circuits that the show does not describe, where it describes others.
void check_circuits(const Show& show, Report& report);

} // namespace ghost::scene
