// SPDX-License-Identifier: Apache-2.0
#include "rdm/message.h"

#include "base/byte_writer.h"
#include "base/check.h"

#include <cstdio>
#include <numeric>

namespace ghost::rdm {

namespace {

constexpr std::uint8_t kSubStartCode = 0x01;
constexpr std::size_t kHeaderBytes = 24; // up to the data, with the start code
constexpr std::size_t kChecksumBytes = 2;
constexpr std::uint8_t kPreamble = 0xFE, kEndOfPreamble = 0xAA;
constexpr std::size_t kMaxPreamble = 7, kEncodedBytes = 16;

void put_uid(std::vector<std::uint8_t>& out, const Uid& uid) {
    put_u16_be(out, uid.maker);
    put_u16_be(out, uid.device >> 16);
    put_u16_be(out, uid.device & 0xFFFF);
}

Uid read_uid(ByteReader& reader) {
    Uid uid;
    uid.maker = reader.u16_be();
    uid.device = reader.u32_be();
    return uid;
}

std::size_t sum_of(Bytes bytes) {
    return std::accumulate(bytes.begin(), bytes.end(), std::size_t{0}) & 0xFFFF;
}

} // namespace

std::string uid_text(const Uid& uid) {
    char text[16];
    std::snprintf(text, sizeof text, "%04x:%08x", uid.maker, uid.device);
    return text;
}

std::variant<Message, Fault> parse(Bytes bytes) {
    if (bytes.size() < kHeaderBytes + kChecksumBytes) return Fault::too_short;
    ByteReader reader(bytes);
    if (reader.u8() != kStartCode || reader.u8() != kSubStartCode) return Fault::not_rdm;
    const std::size_t length = reader.u8();
    if (length < kHeaderBytes || length + kChecksumBytes > bytes.size()) return Fault::wrong_length;
    Message message;
    message.to = read_uid(reader);
    message.from = read_uid(reader);
    message.transaction = reader.u8();
    message.port_or_answer = reader.u8();
    message.queued = reader.u8();
    message.sub_device = reader.u16_be();
    const std::uint8_t command = reader.u8();
    message.pid = reader.u16_be();
    const std::size_t data = reader.u8();
    if (kHeaderBytes + data != length) return Fault::wrong_length;
    const Bytes content = reader.take(data);
    message.data.assign(content.begin(), content.end());
    if (reader.u16_be() != sum_of(bytes.first(length))) return Fault::wrong_checksum;
    const std::uint8_t kind = command & 0xFE;
    if (kind != 0x10 && kind != 0x20 && kind != 0x30) return Fault::unknown_command;
    message.command = static_cast<Command>(kind);
    message.is_response = (command & 1) != 0;
    return message;
}

std::vector<std::uint8_t> build(const Message& message) {
    CHECK(message.data.size() <= kMaxDataBytes);
    std::vector<std::uint8_t> out{kStartCode, kSubStartCode,
                                  static_cast<std::uint8_t>(kHeaderBytes + message.data.size())};
    put_uid(out, message.to);
    put_uid(out, message.from);
    out.push_back(message.transaction);
    out.push_back(message.port_or_answer);
    out.push_back(message.queued);
    put_u16_be(out, message.sub_device);
    out.push_back(
        static_cast<std::uint8_t>(static_cast<int>(message.command) | (message.is_response ? 1 : 0)));
    put_u16_be(out, message.pid);
    out.push_back(static_cast<std::uint8_t>(message.data.size()));
    out.insert(out.end(), message.data.begin(), message.data.end());
    put_u16_be(out, sum_of(out));
    return out;
}

std::vector<std::uint8_t> build_discovery_answer(const Uid& uid) {
    std::vector<std::uint8_t> plain, out(kMaxPreamble, kPreamble);
    out.push_back(kEndOfPreamble);
    const auto put = [&](std::uint8_t value) {
        out.push_back(value | 0xAA);
        out.push_back(value | 0x55);
    };
    put_uid(plain, uid);
    for (const std::uint8_t value : plain) put(value);
    const std::size_t sum = sum_of(Bytes(out).last(2 * plain.size()));
    put(static_cast<std::uint8_t>(sum >> 8));
    put(static_cast<std::uint8_t>(sum));
    return out;
}

std::optional<Uid> parse_discovery_answer(Bytes bytes) {
    std::size_t at = 0;
    while (at < bytes.size() && at < kMaxPreamble && bytes[at] == kPreamble) ++at;
    if (at >= bytes.size() || bytes[at] != kEndOfPreamble || bytes.size() - at - 1 < kEncodedBytes)
        return std::nullopt;
    const Bytes encoded = bytes.subspan(at + 1, kEncodedBytes);
    std::vector<std::uint8_t> plain;
    for (std::size_t i = 0; i < kEncodedBytes; i += 2) {
        if ((encoded[i] & 0xAA) != 0xAA || (encoded[i + 1] & 0x55) != 0x55) return std::nullopt;
        plain.push_back(encoded[i] & encoded[i + 1]);
    }
    ByteReader reader{Bytes(plain)};
    const Uid uid = read_uid(reader);
    if (reader.u16_be() != sum_of(encoded.first(12))) return std::nullopt;
    return uid;
}

} // namespace ghost::rdm
