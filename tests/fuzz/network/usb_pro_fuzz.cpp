// SPDX-License-Identifier: Apache-2.0
// Any bytes from a serial port, whole and in pieces: the same packets, which hold what packets may.
#include "dmx/wire/usb_pro.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost;
    using namespace ghost::dmx;
    std::uint64_t sums[2] = {0, 0};
    for (const std::size_t piece : {std::max<std::size_t>(size, 1), std::size_t{7}}) {
        UsbProWidget widget(1, "/dev/ttyUSB0");
        std::uint64_t& sum = sums[piece == 7 ? 1 : 0];
        for (std::size_t at = 0; at < size; at += piece)
            widget.feed(Bytes(data + at, std::min(piece, size - at)), [&](const Packet& packet) {
                if (packet.slot_count > kSlots || packet.universe != 1) std::abort();
                for (std::size_t i = packet.slot_count; i < kSlots; ++i)
                    if (packet.slots[i] != 0) std::abort();
                for (const std::uint8_t level : packet.slots) sum = sum * 31 + level + 1;
            });
        if (widget.counters().skipped_bytes > size) std::abort();
    }
    if (size != 7 && sums[0] != sums[1]) std::abort();
    return 0;
}
