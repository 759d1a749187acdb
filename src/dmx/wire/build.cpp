// SPDX-License-Identifier: Apache-2.0
#include "dmx/wire/build.h"

#include "base/byte_writer.h"
#include "base/check.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

void put_u32(std::vector<std::uint8_t>& out, std::uint32_t value) {
    put_u16_be(out, value >> 16);
    put_u16_be(out, value & 0xFFFFu);
}

void put_text(std::vector<std::uint8_t>& out, const std::string& text, std::size_t size) {
    const std::size_t used = std::min(text.size(), size - 1);
    out.insert(out.end(), text.begin(), text.begin() + static_cast<std::ptrdiff_t>(used));
    out.insert(out.end(), size - used, 0);
}

// Flags and length of a layer that begins here and ends with the packet.
void put_layer(std::vector<std::uint8_t>& out, std::size_t size) {
    put_u16_be(out, 0x7000u | (size - out.size()));
}

std::vector<std::uint8_t> sacn_root(std::size_t size, std::uint32_t vector,
                                    const std::array<std::uint8_t, 16>& cid) {
    std::vector<std::uint8_t> out;
    out.reserve(size);
    put_u16_be(out, 0x0010);
    put_u16_be(out, 0);
    for (const char letter : {'A', 'S', 'C', '-', 'E', '1', '.', '1', '7', '\0', '\0', '\0'})
        out.push_back(static_cast<std::uint8_t>(letter));
    put_layer(out, size);
    put_u32(out, vector);
    out.insert(out.end(), cid.begin(), cid.end());
    return out;
}

} // namespace

std::vector<std::uint8_t> build_sacn(std::uint16_t universe, Bytes slots, std::uint8_t sequence,
                                     const SacnSource& source, const SacnExtras& extras) {
    CHECK(slots.size() <= kSlots);
    const std::size_t size = 126 + slots.size();
    std::vector<std::uint8_t> out = sacn_root(size, 4, source.cid);
    put_layer(out, size);
    put_u32(out, 2);
    put_text(out, source.name, 64);
    out.push_back(source.priority);
    put_u16_be(out, extras.sync_universe);
    out.push_back(sequence);
    out.push_back(extras.options);
    put_u16_be(out, universe);
    put_layer(out, size);
    out.push_back(2);
    out.push_back(0xA1);
    put_u16_be(out, 0);
    put_u16_be(out, 1);
    put_u16_be(out, slots.size() + 1);
    out.push_back(extras.start_code);
    out.insert(out.end(), slots.begin(), slots.end());
    CHECK_EQ(out.size(), size);
    return out;
}

std::vector<std::uint8_t> build_sacn_sync(std::uint16_t universe, std::uint8_t sequence,
                                          const std::array<std::uint8_t, 16>& cid) {
    constexpr std::size_t size = 49;
    std::vector<std::uint8_t> out = sacn_root(size, 8, cid);
    put_layer(out, size);
    put_u32(out, 1);
    out.push_back(sequence);
    put_u16_be(out, universe);
    put_u16_be(out, 0);
    CHECK_EQ(out.size(), size);
    return out;
}

std::vector<std::uint8_t> build_sacn_discovery(std::span<const std::uint16_t> universes, std::uint8_t page,
                                               std::uint8_t last_page,
                                               const std::array<std::uint8_t, 16>& cid,
                                               const std::string& source_name) {
    CHECK(universes.size() <= 512);
    const std::size_t size = 120 + 2 * universes.size();
    std::vector<std::uint8_t> out = sacn_root(size, 8, cid);
    put_layer(out, size);
    put_u32(out, 2);
    put_text(out, source_name, 64);
    put_u32(out, 0);
    put_layer(out, size);
    put_u32(out, 1);
    out.push_back(page);
    out.push_back(last_page);
    for (const std::uint16_t universe : universes) put_u16_be(out, universe);
    CHECK_EQ(out.size(), size);
    return out;
}

std::vector<std::uint8_t> build_artdmx(std::uint16_t port_address, Bytes slots, std::uint8_t sequence) {
    CHECK(slots.size() <= kSlots && port_address < 0x8000);
    const std::size_t length = slots.size() + slots.size() % 2;
    std::vector<std::uint8_t> out{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x50, 0, 14};
    out.reserve(18 + length);
    out.push_back(sequence);
    out.push_back(0); // Physical
    out.push_back(static_cast<std::uint8_t>(port_address));
    out.push_back(static_cast<std::uint8_t>(port_address >> 8));
    put_u16_be(out, length);
    out.insert(out.end(), slots.begin(), slots.end());
    out.resize(18 + length);
    return out;
}

std::array<std::uint8_t, 239> build_poll_reply(const PollReply& reply) {
    CHECK(!reply.ports.empty() && reply.ports.size() <= kMaxPortsPerReply);
    const std::uint16_t first = reply.ports.front().address;
    for (const PollReply::Port& port : reply.ports)
        CHECK(port.address < 0x8000 && port.address >> 4 == first >> 4);
    const auto put_ports = [&](std::vector<std::uint8_t>& to, auto&& value) {
        for (std::size_t i = 0; i < kMaxPortsPerReply; ++i)
            to.push_back(static_cast<std::uint8_t>(i < reply.ports.size() ? value(reply.ports[i]) : 0));
    };
    std::vector<std::uint8_t> out{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x21};
    put_u32(out, reply.ipv4);
    out.push_back(0x36); // port 6454, low byte first
    out.push_back(0x19);
    put_u16_be(out, 1);                                   // firmware version
    out.push_back(static_cast<std::uint8_t>(first >> 8)); // NetSwitch
    out.push_back((first >> 4) & 15);                     // SubSwitch
    put_u16_be(out, 0x00FF);                              // OEM code: unknown
    out.push_back(0);                                     // no UBEA
    out.push_back(reply.rdm ? 0xE2 : 0xE0); // Status1: indicators normal, set from the network; RDM
    put_u16_be(out, 0);                     // no ESTA manufacturer code
    put_text(out, reply.short_name, 18);
    put_text(out, reply.long_name, 64);
    put_text(out, reply.report, 64);
    put_u16_be(out, reply.ports.size());
    put_ports(out, [](const PollReply::Port&) { return 0x80; }); // PortTypes: DMX512 output
    out.insert(out.end(), 4, 0);                                 // GoodInput
    // GoodOutputA: bit 7 levels arrive, bit 3 two sources merge, bit 1 latest-takes-precedence
    put_ports(out, [&](const PollReply::Port& port) {
        return (port.receiving ? 0x80 : 0) | (port.merging ? 0x08 : 0) | (reply.ltp ? 0x02 : 0);
    });
    out.insert(out.end(), 4, 0);                                                   // SwIn
    put_ports(out, [](const PollReply::Port& port) { return port.address & 15; }); // SwOut
    out.insert(out.end(), 3 + 3, 0); // AcnPriority, SwMacro, SwRemote; spare
    out.push_back(0);                // Style: node, because some desks send to nothing else
    out.insert(out.end(), 6, 0);     // MAC address not told
    put_u32(out, reply.ipv4);        // BindIp
    out.push_back(reply.bind_index);
    out.push_back(0x08); // Status2: 15-bit Port-Address
    put_ports(out, [&](const PollReply::Port&) { return reply.rdm ? 0 : 0x80; }); // GoodOutputB: bit 7 no RDM
    CHECK_EQ(out.size(), 217u);
    std::array<std::uint8_t, 239> bytes{};
    std::copy(out.begin(), out.end(), bytes.begin());
    return bytes;
}

} // namespace ghost::dmx
