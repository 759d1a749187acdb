// SPDX-License-Identifier: Apache-2.0
#include "diagnose/learn.h"

#include "base/print.h"
#include "diagnose/diagnosis.h"
#include "diagnose/diagnosis_parts.h"

#include <cstdlib>

namespace ghost::scene {
namespace {

using namespace std::chrono_literals;

constexpr auto kRest = 1s;

std::string slots_text(const std::vector<const PatchedSlot*>& slots) {
    std::string text;
    for (const PatchedSlot* slot : slots)
        text += (text.empty() ? "'" : ", '") + one_line(slot->fixture_name) + "' " + slot->channel;
    return text;
}

std::string shift_hint(const Moved& moved, int by, int artnet_offset) {
    if (moved.protocol == dmx::Protocol::artnet)
        return "--artnet-offset " + std::to_string(artnet_offset + by);
    return "the desk's output or the patch moved by one";
}

} // namespace

std::vector<Moved> Learner::feed(const dmx::Statistics& statistics) {
    now_ = statistics.time;
    if (!begin_) begin_ = now_;
    std::vector<Moved> moved;
    too_many_ = 0;
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (!source.slots) continue;
        const dmx::Levels& levels = source.slots->levels;
        const auto [place, is_new] = sources_.try_emplace({source.universe, source.id});
        Seen& seen = place->second;
        if (is_new) {
            seen.rest = levels;
            seen.told.fill(-kRest);
            continue;
        }
        for (std::size_t slot = 0; slot < source.slot_count; ++slot) {
            if (std::abs(levels[slot] - seen.rest[slot]) < kLeastMove) continue;
            if (listens_first()) seen.restless.insert(slot);
            // One that goes on moving was told of already.
            const bool fresh = now_ - seen.told[slot] >= kRest && !seen.restless.contains(slot);
            if (fresh)
                moved.push_back(
                    {source.universe, static_cast<int>(slot) + 1, seen.rest[slot], levels[slot],
                     source.protocol,
                     diagnosed::source_text(source.name, dmx::place_text(source), source.protocol)});
            seen.told[slot] = now_;
            seen.rest[slot] = levels[slot];
        }
    }
    if (moved.size() > kMostMoved) {
        too_many_ = moved.size();
        moved.clear();
    }
    return moved;
}

std::string moved_text(const Moved& moved, const PatchMap& patch, int artnet_offset) {
    std::string text =
        "universe " + std::to_string(moved.universe) + " address " + std::to_string(moved.address);
    if (moved.protocol == dmx::Protocol::artnet)
        text += " (Port-Address " + port_address_text(moved.universe, artnet_offset) + ")";
    text += " from " + moved.source + ": " + std::to_string(moved.from) + " -> " + std::to_string(moved.to);
    if (patch.universes().empty()) return text;
    if (const auto here = patch.at(moved.universe, moved.address); !here.empty())
        return text + " is " + slots_text(here);
    text += ", nothing is patched there";
    for (const int by : {-1, 1})
        if (const auto beside = patch.at(moved.universe + by, moved.address); !beside.empty())
            text += "; off by one? on universe " + std::to_string(moved.universe + by) + " it would be " +
                    slots_text(beside) + " (" + shift_hint(moved, by, artnet_offset) + ")";
    return text;
}

} // namespace ghost::scene
