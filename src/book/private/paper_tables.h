#pragma once
// SPDX-License-Identifier: Apache-2.0
// The tables of Paper (book/paper.h), one by one, and what they share. Pure.

#include "book/hangings.h"
#include "book/paper.h"
#include "fixture/patch.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct PatchedFixture; // show/show.h

PaperTable instruments_of(const Show& show, const PrintStyle& style);
PaperTable hookup_of(const Show& show, const PrintStyle& style);
PaperTable types_of(const Show& show, const PrintStyle& style);
PaperTable patch_of(const Show& show, const PrintStyle& style);
PaperTable universes_of(const Show& show, const PrintStyle& style);
PaperTable wheels_of(const Show& show, const PrintStyle& style);
PaperTable positions_of(const Show& show, const PrintStyle& style);
PaperTable cables_of(const Show& show, const PrintStyle& style);
PaperTable plugs_of(const Show& show, const PrintStyle& style);
PaperTable circuits_of(const Show& show, const PrintStyle& style);
PaperTable phases_of(const Show& show, const PrintStyle& style);
PaperTable phases_proposed(const Show& show, const PrintStyle& style, std::optional<double> circuit_w);

std::string said_address(const PrintStyle& style, int universe, int channel);
// Names of those of which an address is written that cannot be read.
std::vector<std::string> addressless_of(const Show& show);

// "Vari-Lite VL2500 Spot"; "": its file could not be read.
std::string type_name(const PatchedFixture& fixture);
std::string mode_name(const PatchedFixture& fixture); // "": not known
// The same, but of a file that could not be read as the plot writes them, or the show, which keeps no mode.
std::string written_type(const PatchedFixture& fixture, const Hanging& hanging);
std::string written_mode(const PatchedFixture& fixture, const Hanging& hanging);
void say_unread(PaperTable& table, const Show& show, const PrintStyle& style);
// Its type was read, and it is in a mode of the type's that somebody names.
bool is_mode_said(const PatchedFixture& fixture);
// Addresses of all breaks, 0 where one is not patched.
std::vector<fixture::Address> addresses_of(const PatchedFixture& fixture);
// Of a break; 0: not known.
int footprint_of(const PatchedFixture& fixture, std::size_t part);
// 0: its file does not say it.
double weight_kg_of(const PatchedFixture& fixture);
// Of all that it takes; 0: nobody says it.
double power_w_of(const PatchedFixture& fixture);
// "Spot 1-8, Wash 3", all of them, by index.
std::string names_of(const Show& show, const std::vector<std::size_t>& fixtures);
bool names_circuits(const Show& show); // some fixture says what feeds it
// Columns in which no row has anything go.
void drop_empty_columns(PaperTable& table);

} // namespace ghost::scene
