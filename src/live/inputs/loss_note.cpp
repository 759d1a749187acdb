// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/loss_note.h"

#include "base/log.h"

#include <algorithm>
#include <iterator>

namespace ghost::app {

namespace {

constexpr std::size_t kMostNamed = 4;

std::string named(const std::set<std::uint16_t>& universes) {
    std::string text = universes.size() == 1 ? "universe " : "universes ";
    std::size_t count = 0;
    for (const std::uint16_t universe : universes) {
        if (count == kMostNamed)
            return text + " and " + std::to_string(universes.size() - kMostNamed) + " more";
        text += (count++ == 0 ? "" : ", ") + std::to_string(universe);
    }
    return text;
}

} // namespace

void LossNote::look(const dmx::Universes& universes, std::chrono::nanoseconds now) {
    std::set<std::uint16_t> lost;
    std::chrono::nanoseconds silent{0};
    bool black = true;
    for (const dmx::Universe& universe : universes.list) {
        if (!universe.lost) continue;
        lost.insert(universe.number);
        silent = std::max(silent, now - universe.arrival);
        black = black && universe.black;
    }
    text_.clear();
    if (!lost.empty())
        text_ = "no DMX on " + named(lost) + " for " +
                std::to_string(std::chrono::duration_cast<std::chrono::seconds>(silent).count()) +
                " s: " + (black ? "black" : "last look held");
    std::set<std::uint16_t> gone, back;
    std::set_difference(lost.begin(), lost.end(), lost_.begin(), lost_.end(),
                        std::inserter(gone, gone.end()));
    std::set_difference(lost_.begin(), lost_.end(), lost.begin(), lost.end(),
                        std::inserter(back, back.end()));
    if (!gone.empty()) log_warning("no source sends " + named(gone) + " any more");
    if (!back.empty()) log_info(named(back) + ": DMX is back");
    lost_ = std::move(lost);
}

std::string joined(const std::string& first, const std::string& second) {
    return first.empty() || second.empty() ? first + second : first + ", " + second;
}

} // namespace ghost::app
