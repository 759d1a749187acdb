// SPDX-License-Identifier: Apache-2.0
// Any bytes as sACN packets: levels, priorities, synchronisation, discovery.
#include "network_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    static Intake intake(all_rules(1));
    feed_all(intake, Protocol::sacn, {data, size}, 126, 1);
    return 0;
}
