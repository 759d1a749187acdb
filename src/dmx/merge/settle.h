#pragma once
// SPDX-License-Identifier: Apache-2.0
// What may leave a universe, and what its slots are: pure functions over the sources of one universe.

#include "dmx/merge/level_source.h"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace ghost::dmx {

// Whether the silent sources that take part may leave at this time: there are some, and every other one was
// heard since the last of them fell silent. Until then nobody knows whether the cable of all was pulled, and
// letting the first go would show the look of the next for a moment.
bool loss_is_settled(std::span<const LevelSource> sources, std::chrono::nanoseconds now);

// Of a universe whose places are all taken: which source a newcomer may replace. The one that is silent for
// longest, past its time-out, though it could not leave yet (of a protocol, if one is given); never a widget.
std::optional<std::size_t> longest_silent(std::span<const LevelSource> sources, std::chrono::nanoseconds now,
                                          std::optional<Protocol> of = std::nullopt);
// Else the sACN source that was heard only once, and longest ago. So packets from ever new forged sources
// find places among each other's, never that of a real one.
std::optional<std::size_t> heard_once(std::span<const LevelSource> sources, std::chrono::nanoseconds now);

// Of a packet with levels its priority, of one with priorities per address the highest of them.
std::uint8_t highest_priority(const Packet& packet);
// Else one of the lowest priority, where that is below the newcomer's; of several the one that came last.
// Never a widget.
std::optional<std::size_t> lowest_priority(std::span<const LevelSource> sources, std::uint8_t newcomer);

// Of each source the number of slots that it holds, alone or together with others: where nobody that takes
// part ranks higher.
std::vector<std::size_t> slots_held(std::span<const LevelSource> sources, bool show_preview);

// Of each source the number of slots that it holds and where something else shows, and how many of these it
// sends above 0, of those that stand still (LevelSource::stands). merged: of these sources.
std::vector<std::size_t> slots_overruled(std::span<const LevelSource> sources, bool show_preview,
                                         const Levels& merged);
std::vector<std::size_t> slots_contested(std::span<const LevelSource> sources, bool show_preview,
                                         const Levels& merged);

// The most slots that one of those that take part sends.
std::uint16_t slots_sent(std::span<const LevelSource> sources, bool show_preview);

// One level per slot of those sources that take part; where none does, of all that have levels. show_preview:
// where a source for preview is among them, only these.
Levels merge_levels(std::span<const LevelSource> sources, bool show_preview, bool artnet_ltp);

} // namespace ghost::dmx
