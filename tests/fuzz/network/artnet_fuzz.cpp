// SPDX-License-Identifier: Apache-2.0
// Any bytes as Art-Net packets: levels, sync, polls, time code, triggers.
#include "network_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    constexpr int kOffset = -3; // so that some Port-Addresses have no universe
    static Intake intake(all_rules(kOffset));
    feed_all(intake, Protocol::artnet, {data, size}, 18, kOffset);
    return 0;
}
