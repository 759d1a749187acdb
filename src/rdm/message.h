#pragma once
// SPDX-License-Identifier: Apache-2.0
// RDM messages (ANSI E1.20-2010): what a controller says to a device and back, as bytes and as values. Pure;
// nothing that can be sent raises an error. Numbers in messages are big-endian.

#include "base/byte_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ghost::rdm {

// Unique ID of a device: 16 bits of its maker, 32 of itself (E1.20 5).
struct Uid {
    std::uint16_t maker = 0;
    std::uint32_t device = 0;

    auto operator<=>(const Uid&) const = default;
    std::uint64_t number() const { return std::uint64_t{maker} << 32 | device; }
    static Uid of(std::uint64_t number) {
        return {static_cast<std::uint16_t>(number >> 32), static_cast<std::uint32_t>(number)};
    }
    bool is_broadcast() const { return device == 0xFFFFFFFF; } // to all, or to all of a maker
    // Whether a message to this one is meant for that device.
    bool means(const Uid& one) const {
        return *this == one || (is_broadcast() && (maker == 0xFFFF || maker == one.maker));
    }
};
std::string uid_text(const Uid& uid); // "7ff0:00000001"

// A command; its response is one more (E1.20 6.2.10).
enum class Command : std::uint8_t { discovery = 0x10, get = 0x20, set = 0x30 };
// Of a response (E1.20 6.2.6).
enum class Answer : std::uint8_t { ack = 0, ack_timer = 1, nack = 2, ack_overflow = 3 };
// Why not (E1.20 table A-17).
enum class Nack : std::uint16_t {
    unknown_pid = 0,
    format_error = 1,
    write_protect = 4,
    unsupported_command = 5,
    data_out_of_range = 6,
    buffer_full = 7,
    sub_device_out_of_range = 9,
};

inline constexpr std::uint8_t kStartCode = 0xCC;
inline constexpr std::size_t kMaxDataBytes = 231; // of a message
inline constexpr std::size_t kMaxLabelBytes = 32; // of every text
inline constexpr std::uint16_t kAllSubDevices = 0xFFFF;

struct Message {
    Uid to, from;
    std::uint8_t transaction = 0;
    std::uint8_t port_or_answer = 1; // a port of the controller, 1-based; of a response an Answer
    std::uint8_t queued = 0;         // messages that wait, of a response
    std::uint16_t sub_device = 0;    // 0: the device itself
    Command command = Command::get;
    bool is_response = false;
    std::uint16_t pid = 0;
    std::vector<std::uint8_t> data; // at most kMaxDataBytes
};

// Why bytes are no message.
enum class Fault { too_short, not_rdm, wrong_length, wrong_checksum, unknown_command };

// Bytes begin with the start code; what follows the checksum is left out.
std::variant<Message, Fault> parse(Bytes bytes);
std::vector<std::uint8_t> build(const Message& message);

// The answer to "who is there between these?" (E1.20 7.5), which has no header and may collide on a line.
std::vector<std::uint8_t> build_discovery_answer(const Uid& uid);
// Nothing where it is none, or several at once.
std::optional<Uid> parse_discovery_answer(Bytes bytes);

} // namespace ghost::rdm
