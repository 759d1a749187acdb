// SPDX-License-Identifier: Apache-2.0
// Merges two sACN sources of one universe and prints its first slots.
#include <cstdio>
#include <dmx/merge/merge.h>
#include <dmx/wire/build.h>

int main() {
    using namespace ghost::dmx;
    Merge merge;
    const auto send = [&](std::uint8_t desk, std::vector<std::uint8_t> slots) {
        const auto bytes = build_sacn(7, slots, 0, {100, {desk}, "desk"});
        merge.feed(std::get<Packet>(parse_sacn(bytes)), std::chrono::seconds(1));
    };
    send(1, {255, 10, 0});
    send(2, {0, 200, 30});
    const Universes& merged = merge.universes();
    for (int address = 1; address <= 3; ++address) std::printf("%d ", merged.level(7, address));
    std::printf("\n");
    return 0;
}
