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
    std::string number; // by which a desk calls it
    std::string name;
    std::string unit; // number on that position
    std::string function;
    std::string filter; // a colour in the beam
    std::string gobo;
    std::string focus;      // name of the point that it is aimed at
    std::string type, mode; // as the plot writes them
};

// One for each fixture; without a plot with number and name only.
std::vector<Hanging> hangings_of(const Show& show);
// Indices of the fixtures by hanging position and unit number, else by desk number and name; what hangs
// nowhere comes last, by layer.
std::vector<std::size_t> in_hanging_order(const std::vector<Hanging>& hangings);

} // namespace ghost::scene
