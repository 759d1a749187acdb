#pragma once
// SPDX-License-Identifier: Apache-2.0
// Open Sound Control 1.0, parsed: messages and bundles of messages, as remote controls send them by UDP.
// Pure; any bytes are taken. Time tags of bundles are not waited for, address patterns are not expanded, and
// arguments that are neither numbers, truth values nor text are passed over.

#include "base/byte_reader.h"

#include <string>
#include <variant>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kMostOscMessages = 64; // of a packet; the rest counts as malformed
inline constexpr std::size_t kMostOscArguments = 16;
inline constexpr std::size_t kMostOscText = 256; // letters of an address or argument
inline constexpr int kMostOscDepth = 4;          // bundles inside bundles

// Integers come as doubles; monostate: of a kind that we do not read.
using OscArgument = std::variant<std::monostate, double, bool, std::string>;

struct OscMessage {
    std::string address; // "/ghostlight/master"
    std::vector<OscArgument> arguments;
};

struct OscPacket {
    std::vector<OscMessage> messages;
    int malformed = 0; // parts that were left out
};

OscPacket parse_osc(Bytes bytes);

} // namespace ghost::dmx
