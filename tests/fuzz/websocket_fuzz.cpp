// SPDX-License-Identifier: Apache-2.0
// Any bytes as the frames of a viewer, and their messages.
#include "web/protocol.h"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::web;
    for (ghost::Bytes left(data, size);;) {
        const ParsedFrame frame = parse_frame(left);
        if (frame.close != 0 || frame.bytes == 0) return 0;
        if (frame.payload.size() > kMostMessageBytes || frame.bytes > left.size()) std::abort();
        left = left.subspan(frame.bytes);
        if (frame.opcode != Opcode::text && frame.opcode != Opcode::binary) continue;
        const auto message = read_message(frame.opcode, frame.payload);
        if (!message.ok()) continue;
        if (const auto* watch = std::get_if<Watch>(&*message);
            watch && (watch->width < 1 || watch->width > kMostWidth))
            std::abort();
        if (const auto* ping = std::get_if<Ping>(&*message); ping && !std::isfinite(ping->t)) std::abort();
    }
}
