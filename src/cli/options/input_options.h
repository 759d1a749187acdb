#pragma once
// SPDX-License-Identifier: Apache-2.0
// The options of every command that listens to a lighting desk (monitor, record, render --live-input): which
// interface, which protocols, which universes, which USB widgets. Main thread.

#include "base/result.h"
#include "dmx/receive/receiver.h"
#include "dmx/record/capture.h"

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
    std::string protocols = "both"; // sacn | artnet | both | none
    std::string universes;          // "1-4,7"; empty: those of the show, without one whatever arrives
    int artnet_offset = 1;
    std::string on_loss = "hold";     // hold | black | seconds until black
    std::string artnet_merge = "htp"; // htp | ltp
    std::uint16_t sacn_port = dmx::kSacnPort;
    std::uint16_t artnet_port = dmx::kArtnetPort;
    bool show_preview = false;
    std::string preview_universes; // "1-4,7"; empty: all
    bool no_poll_reply = false;
    std::vector<std::string> usb; // "/dev/ttyUSB0=3", "auto"
    std::string midi;             // add_midi_option
    std::string ltc;              // add_ltc_option; no receiver listens to it
};

// Adds --sacn-port and --artnet-port alone.
void add_port_options(CLI::App& command, std::uint16_t& sacn_port, std::uint16_t& artnet_port);
// Adds --midi. port must outlive command.
CLI::Option* add_midi_option(CLI::App& command, std::string& port);
// Adds --interface, --protocols, --universes, --artnet-offset, --artnet-merge, --sacn-port, --artnet-port,
// --on-loss, --show-preview,
// --preview-universes, --no-poll-reply, --usb. options must outlive command.
void add_input_options(CLI::App& command, InputOptions& options);

// "1-4,7" -> 1 2 3 4 7: sorted, each once, at most 4096 of 1..63999. Empty text: empty list.
Result<std::vector<std::uint16_t>> parse_universes(std::string_view text,
                                                   const std::string& option = "--universes");

// "hold", "black", or the seconds that the last look is held for.
Result<dmx::LossPolicy> parse_loss_policy(const std::string& text);

// "/dev/ttyUSB0=3", "auto" or "auto=5"; without a number one more than the one before, the first: 1.
Result<std::vector<dmx::UsbPortOptions>> parse_usb_ports(const std::vector<std::string>& texts);

Result<dmx::ReceiverOptions> receiver_options(const InputOptions& options);

// How captures are read; options must be valid (receiver_options).
dmx::CaptureOptions capture_options(const InputOptions& options);

// Returns when the receiver knows who sends (1.5 s after its start), or at Ctrl-C: from then on there are
// levels.
void wait_for_sources(const dmx::Receiver& receiver);

} // namespace ghost::app
