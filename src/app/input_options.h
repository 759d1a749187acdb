#pragma once
// SPDX-License-Identifier: Apache-2.0
// The options of every command that listens to a lighting desk (monitor, record, render --live-input): which
// interface, which protocols, which universes. Main thread.

#include "base/result.h"
#include "dmx/receiver.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::app {

// Limits of --artnet-offset: no offset beyond them gives any Port-Address a universe.
inline constexpr int kLowestArtnetOffset = -32768;
inline constexpr int kHighestArtnetOffset = 63999;

struct InputOptions {
    std::string interface;
    std::string protocols = "both"; // sacn | artnet | both
    std::string universes;          // "1-4,7"; empty: whatever arrives
    int artnet_offset = 1;
    bool show_preview = false;
    bool no_poll_reply = false;
};

// Adds --interface, --protocols, --universes, --artnet-offset, --show-preview, --no-poll-reply. options must
// outlive command.
void add_input_options(CLI::App& command, InputOptions& options);

// "1-4,7" -> 1 2 3 4 7: sorted, each once, at most 4096 of 1..63999. Empty text: empty list.
Result<std::vector<std::uint16_t>> parse_universes(std::string_view text);

Result<dmx::ReceiverOptions> receiver_options(const InputOptions& options);

} // namespace ghost::app
