// SPDX-License-Identifier: Apache-2.0
// Says what a UDP datagram of sACN or Art-Net holds: wire FILE
#include <cstdio>
#include <dmx/wire/packet.h>
#include <fstream>
#include <iterator>

int main(int count, char** words) {
    using namespace ghost::dmx;
    if (count != 2) return 2;
    std::ifstream file(words[1], std::ios::binary);
    const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(file)), {});
    Parsed parsed = parse_sacn(bytes);
    if (std::holds_alternative<Drop>(parsed)) parsed = parse_artnet(bytes);
    if (const auto* levels = std::get_if<Packet>(&parsed)) {
        std::printf("%s, universe %d:", protocol_name(levels->protocol), levels->universe);
        for (std::size_t slot = 0; slot < levels->slot_count; ++slot) std::printf(" %d", levels->slots[slot]);
        std::printf("\n");
        return 0;
    }
    const auto* drop = std::get_if<Drop>(&parsed);
    std::printf("no levels: %s\n", drop ? drop_name(*drop) : "another kind of packet");
    return 1;
}
