// SPDX-License-Identifier: Apache-2.0
// Any bytes as a capture, pcap or pcapng; what comes out are frames by time.
#include "dmx/record/capture.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    ByteSource source(std::vector<std::uint8_t>(data, data + size));
    auto before = std::chrono::microseconds(0);
    const auto end = read_capture(
        source, "fuzz", {}, {}, [](std::chrono::microseconds) {},
        [&](const RecordedFrame& frame) -> ghost::Result<void> {
            if (frame.time < before || !frame.levels || frame.universe < 1) std::abort();
            before = frame.time;
            return {};
        });
    if (end.ok() && end->duration < before) std::abort();
    return 0;
}
