// SPDX-License-Identifier: Apache-2.0
#include "psn_osc/osc.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace ghost::dmx {

namespace {

constexpr std::uint8_t kBundle[8] = {'#', 'b', 'u', 'n', 'd', 'l', 'e', 0};
constexpr std::size_t kTimeTag = 8;

// Text ends with a zero and is filled up with zeros to a multiple of four.
std::optional<std::string> read_text(ByteReader& reader, Bytes all) {
    const Bytes left = all.subspan(reader.position());
    const auto end = std::find(left.begin(), left.end(), std::uint8_t{0});
    const auto length = static_cast<std::size_t>(end - left.begin());
    if (end == left.end() || length > kMostOscText) return std::nullopt;
    std::string text(left.begin(), end);
    reader.skip((length / 4 + 1) * 4);
    if (!reader.ok()) return std::nullopt;
    return text;
}

std::uint64_t u64_be(ByteReader& reader) {
    const std::uint64_t high = reader.u32_be();
    return (high << 32) | reader.u32_be();
}

// False: the argument's length is not known, and so neither is where the next one starts.
bool read_argument(char type, ByteReader& reader, Bytes all, OscArgument& argument) {
    switch (type) {
    case 'i':
        argument = static_cast<double>(static_cast<std::int32_t>(reader.u32_be()));
        return true;
    case 'f':
        argument = static_cast<double>(std::bit_cast<float>(reader.u32_be()));
        return true;
    case 'h':
        argument = static_cast<double>(static_cast<std::int64_t>(u64_be(reader)));
        return true;
    case 'd':
        argument = std::bit_cast<double>(u64_be(reader));
        return true;
    case 'T':
    case 'F':
        argument = type == 'T';
        return true;
    case 's':
    case 'S': {
        auto text = read_text(reader, all);
        if (!text) return false;
        argument = std::move(*text);
        return true;
    }
    case 'N':
    case 'I':
    case '[':
    case ']':
        return true;
    case 'c':
    case 'r':
    case 'm':
        reader.skip(4);
        return true;
    case 't':
        reader.skip(8);
        return true;
    case 'b': {
        const std::size_t size = reader.u32_be();
        if (size > reader.left()) return false;
        reader.skip((size + 3) / 4 * 4);
        return true;
    }
    default:
        return false;
    }
}

std::optional<OscMessage> read_message(Bytes bytes) {
    ByteReader reader(bytes);
    OscMessage message;
    auto address = read_text(reader, bytes);
    if (!address || !address->starts_with('/')) return std::nullopt;
    message.address = std::move(*address);
    if (reader.left() == 0) return message; // old senders leave the types out where there are no arguments
    const auto types = read_text(reader, bytes);
    if (!types || !types->starts_with(',') || types->size() > 1 + kMostOscArguments) return std::nullopt;
    for (const char type : types->substr(1)) {
        OscArgument argument;
        if (!read_argument(type, reader, bytes, argument) || !reader.ok()) return std::nullopt;
        if (type != '[' && type != ']') message.arguments.push_back(std::move(argument));
    }
    return message;
}

void read_part(Bytes bytes, int depth, OscPacket& packet) {
    if (bytes.size() < sizeof kBundle || !std::equal(std::begin(kBundle), std::end(kBundle), bytes.begin())) {
        auto message = packet.messages.size() < kMostOscMessages ? read_message(bytes) : std::nullopt;
        if (message)
            packet.messages.push_back(std::move(*message));
        else
            ++packet.malformed;
        return;
    }
    ByteReader reader(bytes);
    reader.skip(sizeof kBundle + kTimeTag);
    while (reader.ok() && reader.left() > 0 && depth < kMostOscDepth) {
        const std::size_t size = reader.u32_be();
        const Bytes part = reader.take(size);
        if (!reader.ok()) break;
        read_part(part, depth + 1, packet);
    }
    if (!reader.ok() || reader.left() > 0) ++packet.malformed;
}

} // namespace

OscPacket parse_osc(Bytes bytes) {
    OscPacket packet;
    read_part(bytes, 0, packet);
    return packet;
}

} // namespace ghost::dmx
