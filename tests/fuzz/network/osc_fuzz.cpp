// SPDX-License-Identifier: Apache-2.0
// Any bytes as an OSC packet.
#include "psn_osc/osc.h"

#include <cstddef>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    const OscPacket packet = parse_osc({data, size});
    if (packet.messages.size() > kMostOscMessages || packet.malformed < 0) std::abort();
    for (const OscMessage& message : packet.messages) {
        if (message.address.empty() || message.address[0] != '/' || message.address.size() > kMostOscText)
            std::abort();
        if (message.arguments.size() > kMostOscArguments) std::abort();
    }
    return 0;
}
