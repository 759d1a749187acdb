#pragma once
// SPDX-License-Identifier: Apache-2.0
// Paper: what a crew prints of a show, as tables: instrument schedule, channel hookup, patch by universe with
// what is free, types with weight and power, gobos and colours. A cell that the show does not know is empty,
// and a sentence says how many. In the language and units that are asked for. Pure, any thread.

#include "print/print_style.h"

#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show; // show/show.h

struct PaperColumn {
    std::string title;
    bool is_number = false;
    bool is_whole = false; // its cells are codes, "61.106", "#ff8000": no line of a page breaks them
};

struct PaperRow {
    std::vector<std::string> cells; // one for each column
    bool is_free = false;           // nobody's channels
};

struct PaperTable {
    std::string file; // "instruments", without an extension
    std::string title;
    std::vector<PaperColumn> columns;
    std::vector<PaperRow> rows;
    std::vector<std::string> unknown; // sentences
};

struct Paper {
    std::string show;
    std::vector<PaperTable> tables;
    PrintStyle style;
};

// Where nobody says what circuits carry.
struct UsualCircuit {
    double breaker_a, voltage_v;

    constexpr double power_w() const { return breaker_a * voltage_v; }
};
constexpr UsualCircuit usual_circuit(Units units) {
    return units == Units::metric ? UsualCircuit{16, 230} : UsualCircuit{20, 120};
}

// circuit_w: of a circuit in the proposal of phases; nothing: a usual one.
Paper paper_of(const Show& show, const PrintStyle& style = {}, std::optional<double> circuit_w = {});

} // namespace ghost::scene
