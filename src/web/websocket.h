#pragma once
// SPDX-License-Identifier: Apache-2.0
// WebSocket (RFC 6455), a server's side: the answer to a handshake, frames read and written. Messages come in
// one frame each, without compression; fragments are refused. Pure; any bytes are taken.

#include "base/byte_reader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::web {

inline constexpr std::size_t kMostMessageBytes = 2u << 10; // of one to us

// Sec-WebSocket-Accept for a key; "" where the key is not 16 bytes as base64.
std::string accept_of(std::string_view key);

enum class Opcode : std::uint8_t { text = 1, binary = 2, close = 8, ping = 9, pong = 10 };

// Why a connection ends (RFC 6455, 7.4.1).
inline constexpr int kCloseGoingAway = 1001, kCloseProtocol = 1002, kCloseUnsupported = 1003,
                     kClosePolicy = 1008, kCloseTooBig = 1009, kCloseTryLater = 1013;

struct ParsedFrame {
    int close = 0;         // not 0: why the connection has to end
    std::size_t bytes = 0; // of the frame; 0: more are needed
    Opcode opcode = Opcode::text;
    std::vector<std::uint8_t> payload;
};
ParsedFrame parse_frame(Bytes bytes);

std::vector<std::uint8_t> build_frame(Opcode opcode, Bytes payload);
std::vector<std::uint8_t> build_text(std::string_view text);
// why: at most 123 bytes.
std::vector<std::uint8_t> build_close(int code, std::string_view why);

} // namespace ghost::web
