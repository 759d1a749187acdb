// SPDX-License-Identifier: Apache-2.0
#include "web/websocket.h"

#include "base/base64.h"
#include "base/check.h"
#include "web/private/sha1.h"

#include <algorithm>

namespace ghost::web {
namespace {

constexpr std::size_t kMostControlBytes = 125;

bool is_known(unsigned opcode) {
    return opcode == 1 || opcode == 2 || (opcode >= 8 && opcode <= 10);
}

} // namespace

std::string accept_of(std::string_view key) {
    const auto bytes = from_base64(key);
    if (key.size() != 24 || !bytes || bytes->size() != 16) return "";
    const std::string all = std::string(key) + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
    const auto digest = sha1(Bytes(reinterpret_cast<const std::uint8_t*>(all.data()), all.size()));
    return to_base64(digest);
}

ParsedFrame parse_frame(Bytes bytes) {
    ParsedFrame frame;
    const auto refused = [&](int code) {
        frame.close = code;
        return frame;
    };
    ByteReader reader(bytes);
    const std::uint8_t first = reader.u8(), second = reader.u8();
    if (!reader.ok()) return frame;
    const unsigned opcode = first & 0x0F;
    if ((first & 0x70) != 0 || (second & 0x80) == 0) return refused(kCloseProtocol);
    if (opcode == 0 || (first & 0x80) == 0) return refused(kCloseUnsupported);
    if (!is_known(opcode)) return refused(kCloseProtocol);
    std::size_t size = second & 0x7F;
    if (opcode >= 8 && size > kMostControlBytes) return refused(kCloseProtocol);
    if (size == 127) return refused(kCloseTooBig);
    if (size == 126) {
        size = reader.u16_be();
        if (reader.ok() && size < 126) return refused(kCloseProtocol);
    }
    if (size > kMostMessageBytes) return refused(kCloseTooBig);
    const Bytes mask = reader.take(4);
    const Bytes payload = reader.take(size);
    if (!reader.ok()) return frame;
    frame.bytes = reader.position();
    frame.opcode = static_cast<Opcode>(opcode);
    frame.payload.assign(payload.begin(), payload.end());
    for (std::size_t i = 0; i < size; ++i) frame.payload[i] ^= mask[i & 3];
    return frame;
}

std::vector<std::uint8_t> build_frame(Opcode opcode, Bytes payload) {
    std::vector<std::uint8_t> frame{static_cast<std::uint8_t>(0x80u | static_cast<unsigned>(opcode))};
    const std::uint64_t size = payload.size();
    const int size_bytes = size < 126 ? 0 : size <= 0xFFFF ? 2 : 8;
    frame.push_back(static_cast<std::uint8_t>(size_bytes == 0 ? size : size_bytes == 2 ? 126 : 127));
    for (int i = size_bytes - 1; i >= 0; --i) frame.push_back(static_cast<std::uint8_t>(size >> (8 * i)));
    frame.insert(frame.end(), payload.begin(), payload.end());
    return frame;
}

std::vector<std::uint8_t> build_text(std::string_view text) {
    return build_frame(Opcode::text, Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::vector<std::uint8_t> build_close(int code, std::string_view why) {
    CHECK(why.size() <= kMostControlBytes - 2);
    std::vector<std::uint8_t> payload{static_cast<std::uint8_t>(code >> 8), static_cast<std::uint8_t>(code)};
    payload.insert(payload.end(), why.begin(), why.end());
    return build_frame(Opcode::close, payload);
}

} // namespace ghost::web
