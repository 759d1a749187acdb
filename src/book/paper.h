#pragma once
// SPDX-License-Identifier: Apache-2.0
// Paper: what a crew prints of a show, as tables: instrument schedule, channel hookup, patch by universe with
// what is free, types with weight and power, gobos and colours. A cell that the show does not know is empty,
// and a sentence says how many. In the language and units that are asked for. Pure, any thread.

#include "print/print_style.h"

#include <string>
#include <vector>

namespace ghost::scene {

struct Show; // show/show.h

struct PaperColumn {
    std::string title;
    bool is_number = false;
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

inline constexpr double kCircuit_w = 3680; // 16 A at 230 V

// circuit_w: of a circuit in the proposal of phases.
Paper paper_of(const Show& show, const PrintStyle& style = {}, double circuit_w = kCircuit_w);

} // namespace ghost::scene
