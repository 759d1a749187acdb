#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hangings: what a plot says of each fixture beside what the show has: where it hangs, its number there, what
// it is for. Pure, any thread.

#include <cstddef>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show; // show/show.h

struct Hanging {
    std::string position; // "Truss 1"
    std::string layer;
    std::string unit; // number on that position
    std::string function;
    std::string filter; // a colour in the beam
    std::string gobo;
    std::string focus; // name of the point that it is aimed at
};

// One for each fixture; empty where there is no plot.
std::vector<Hanging> hangings_of(const Show& show);
// Indices of the fixtures by hanging position and unit number; what hangs nowhere comes last, by layer.
std::vector<std::size_t> in_hanging_order(const std::vector<Hanging>& hangings);

} // namespace ghost::scene
