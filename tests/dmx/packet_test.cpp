// SPDX-License-Identifier: Apache-2.0
#include "dmx/build.h"
#include "dmx/packet.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

using Buffer = std::vector<std::uint8_t>;

// A data packet, byte by byte: universe 1, priority 100, source "Source_A", sync universe 7962, slots 1 2 3.
// The PDU lengths are those of a longer packet on purpose: the worked example of E1.31-2018 appendix B is
// wrong in the same way.
Buffer literal_sacn() {
    Buffer b = {0x00, 0x10, 0x00, 0x00, 0x41, 0x53, 0x43, 0x2d, 0x45, 0x31, 0x2e, 0x31, 0x37,
                0x00, 0x00, 0x00, 0x72, 0x7d, 0x00, 0x00, 0x00, 0x04, 0xef, 0x07, 0xc8, 0xdd,
                0x00, 0x64, 0x44, 0x01, 0xa3, 0xa2, 0x45, 0x9e, 0xf8, 0xe6, 0x14, 0x3e, 0x72,
                0x57, 0x00, 0x00, 0x00, 0x02, 'S',  'o',  'u',  'r',  'c',  'e',  '_',  'A'};
    b.resize(108); // the name is 64 bytes
    for (const int byte : {0x64, 0x1f, 0x1a, 0x9a, 0x00, 0x00, 0x01, 0x72, 0x0d, 0x02, 0xa1,
                           0x00, 0x00, 0x00, 0x01, 0x00, 0x04, 0x00, 0x01, 0x02, 0x03})
        b.push_back(static_cast<std::uint8_t>(byte));
    return b;
}

const Buffer kArtDmx = {'A',  'r',  't',  '-',  'N',  'e',  't', 0, 0x00, 0x50, 0x00, 0x0e,
                        0x11, 0x02, 0x23, 0x04, 0x00, 0x06, 1,   2, 3,    4,    5,    6};

Packet packet_of(const Parsed& parsed) {
    const Packet* packet = std::get_if<Packet>(&parsed);
    EXPECT_NE(packet, nullptr);
    return packet ? *packet : Packet{};
}

Drop drop_of(const Parsed& parsed) {
    const Drop* drop = std::get_if<Drop>(&parsed);
    EXPECT_NE(drop, nullptr);
    return drop ? *drop : Drop::kCount;
}

Notice notice_of(const Parsed& parsed) {
    const Notice* notice = std::get_if<Notice>(&parsed);
    EXPECT_NE(notice, nullptr);
    return notice ? *notice : Notice::kCount;
}

TEST(Sacn, reads_a_data_packet) {
    const Packet packet = packet_of(parse_sacn(literal_sacn(), 0x0A000002));
    EXPECT_EQ(packet.protocol, Protocol::sacn);
    EXPECT_EQ(packet.source.id[0], 0xEF);
    EXPECT_EQ(packet.source.id[15], 0x3E);
    EXPECT_EQ(packet.source_name, "Source_A");
    EXPECT_EQ(packet.from_ipv4, 0x0A000002u);
    EXPECT_EQ(packet.universe, 1);
    EXPECT_EQ(packet.priority, 100);
    EXPECT_EQ(packet.sequence, 0x9A);
    EXPECT_EQ(packet.sync_universe, 7962);
    EXPECT_EQ(packet.start_code, 0);
    EXPECT_FALSE(packet.preview);
    EXPECT_FALSE(packet.terminated);
    ASSERT_EQ(packet.slot_count, 3);
    EXPECT_EQ(packet.slots[0], 1);
    EXPECT_EQ(packet.slots[2], 3);
    EXPECT_EQ(packet.slots[3], 0);
}

TEST(Sacn, every_truncation_is_refused) {
    const Buffer full = build_sacn(1, Buffer(512, 200), 1, 100, {}, "Desk");
    for (const Buffer& whole : {literal_sacn(), full}) {
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const Buffer cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            EXPECT_EQ(drop_of(parse_sacn(cut)), Drop::too_short) << size << " of " << whole.size();
        }
        EXPECT_EQ(packet_of(parse_sacn(whole)).slot_count, whole.size() - 126);
    }
}

TEST(Sacn, a_cut_list_of_priorities_is_refused) {
    Buffer bytes = build_sacn(1, Buffer(512, 200), 1, 100, {}, "Desk", 0, 0xDD);
    EXPECT_EQ(packet_of(parse_sacn(bytes)).slot_count, 512);
    bytes.pop_back();
    EXPECT_EQ(drop_of(parse_sacn(bytes)), Drop::too_short);
}

TEST(Sacn, options_and_start_codes) {
    Buffer bytes = literal_sacn();
    bytes[112] = 0x80;
    EXPECT_TRUE(packet_of(parse_sacn(bytes)).preview);
    bytes[112] = 0x40;
    EXPECT_TRUE(packet_of(parse_sacn(bytes)).terminated);
    bytes[112] = 0x20; // force synchronisation: nothing to us
    EXPECT_FALSE(packet_of(parse_sacn(bytes)).terminated);
    bytes[125] = 0xDD;
    EXPECT_EQ(packet_of(parse_sacn(bytes)).start_code, 0xDD);
    bytes[125] = 0x17;
    EXPECT_EQ(drop_of(parse_sacn(bytes)), Drop::bad_start_code);
}

TEST(Sacn, no_slots_at_all_is_a_packet) {
    Buffer bytes = literal_sacn();
    bytes.resize(126);
    bytes[124] = 1; // only the start code
    bytes[112] = 0x40;
    const Packet packet = packet_of(parse_sacn(bytes));
    EXPECT_EQ(packet.slot_count, 0);
    EXPECT_TRUE(packet.terminated);
    bytes[124] = 0; // not even the start code
    EXPECT_EQ(drop_of(parse_sacn(bytes)), Drop::too_short);
}

TEST(Sacn, count_past_512_is_clipped) {
    Buffer bytes = literal_sacn();
    bytes.resize(126 + 600, 7);
    bytes[123] = 0xFF;
    bytes[124] = 0xFF;
    EXPECT_EQ(packet_of(parse_sacn(bytes)).slot_count, 512);
    bytes.resize(126 + 511); // a universe is not whole
    EXPECT_EQ(drop_of(parse_sacn(bytes)), Drop::too_short);
}

TEST(Sacn, bytes_behind_the_levels_are_left) {
    Buffer bytes = literal_sacn();
    bytes.resize(bytes.size() + 10, 7);
    const Packet packet = packet_of(parse_sacn(bytes));
    EXPECT_EQ(packet.slot_count, 3);
    EXPECT_EQ(packet.slots[3], 0);
}

TEST(Sacn, reasons_to_drop) {
    const Buffer good = literal_sacn();
    const auto with = [&](std::size_t at, std::uint8_t value) {
        Buffer bytes = good;
        bytes[at] = value;
        return parse_sacn(bytes);
    };
    EXPECT_EQ(drop_of(with(0, 1)), Drop::not_ours);
    EXPECT_EQ(drop_of(with(15, 1)), Drop::not_ours);
    EXPECT_EQ(drop_of(with(21, 3)), Drop::bad_vector); // root: the 2009 draft
    EXPECT_EQ(drop_of(with(43, 3)), Drop::bad_vector);
    EXPECT_EQ(drop_of(with(117, 1)), Drop::bad_vector);
    EXPECT_EQ(drop_of(with(118, 0xA2)), Drop::bad_vector);
    EXPECT_EQ(drop_of(with(120, 1)), Drop::bad_vector);
    EXPECT_EQ(drop_of(with(122, 2)), Drop::bad_vector);
    EXPECT_EQ(drop_of(with(108, 201)), Drop::bad_priority);
    EXPECT_EQ(packet_of(with(108, 200)).priority, 200);
    EXPECT_EQ(drop_of(with(114, 0)), Drop::bad_universe);
    Buffer top = good;
    top[113] = 0xF9;
    top[114] = 0xFF;
    EXPECT_EQ(packet_of(parse_sacn(top)).universe, 63999);
    top[113] = 0xFA;
    top[114] = 0x00;
    EXPECT_EQ(drop_of(parse_sacn(top)), Drop::bad_universe);
}

TEST(Sacn, extended_packets_are_notices) {
    Buffer bytes = literal_sacn();
    bytes[21] = 8;
    bytes[43] = 1;
    bytes.resize(49);
    EXPECT_EQ(notice_of(parse_sacn(bytes)), Notice::sync);
    bytes[43] = 2;
    EXPECT_EQ(notice_of(parse_sacn(bytes)), Notice::discovery);
    bytes[21] = 4;
    bytes[43] = 4; // the draft discovery that OLA sends
    EXPECT_EQ(notice_of(parse_sacn(bytes)), Notice::discovery);
}

TEST(Sacn, a_name_of_64_bytes_without_end_is_cut) {
    Buffer bytes = literal_sacn();
    for (std::size_t i = 44; i < 108; ++i) bytes[i] = 'x';
    EXPECT_EQ(packet_of(parse_sacn(bytes)).source_name, std::string(63, 'x'));
}

TEST(Artnet, reads_dmx) {
    const Packet packet = packet_of(parse_artnet(kArtDmx, 0xC0A80105));
    EXPECT_EQ(packet.protocol, Protocol::artnet);
    EXPECT_EQ(packet.universe, 0x0423 + 1); // net 4, sub-net 2, universe 3
    EXPECT_EQ(packet.sequence, 0x11);
    EXPECT_EQ(packet.priority, 100);
    EXPECT_EQ(packet.source.id[0], 192);
    EXPECT_EQ(packet.source.id[3], 5);
    EXPECT_EQ(packet.source.id[4], 2); // Physical
    ASSERT_EQ(packet.slot_count, 6);
    EXPECT_EQ(packet.slots[0], 1);
    EXPECT_EQ(packet.slots[5], 6);
    EXPECT_EQ(packet.slots[6], 0);
}

TEST(Artnet, every_truncation_is_refused) {
    const Buffer full = build_artdmx(0, Buffer(512, 200), 1);
    for (const Buffer& whole : {kArtDmx, full}) {
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const Buffer cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            EXPECT_EQ(drop_of(parse_artnet(cut)), Drop::too_short) << size << " of " << whole.size();
        }
        EXPECT_EQ(packet_of(parse_artnet(whole)).slot_count, whole.size() - 18);
    }
}

// Home Assistant to an ArtGateOne, as somebody captured it.
TEST(Artnet, twelve_slots_of_a_real_sender) {
    Buffer bytes = {'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x50, 0x00, 0x0e, 1, 0, 0, 0, 0, 12};
    bytes.resize(18 + 12, 0xFF);
    const Packet packet = packet_of(parse_artnet(bytes));
    EXPECT_EQ(packet.slot_count, 12);
    EXPECT_EQ(packet.slots[11], 255);
}

TEST(Artnet, universe_offset) {
    Buffer bytes = kArtDmx;
    bytes[14] = bytes[15] = 0;
    EXPECT_EQ(packet_of(parse_artnet(bytes)).universe, 1);
    EXPECT_EQ(packet_of(parse_artnet(bytes, 0, 33)).universe, 33);
    EXPECT_EQ(drop_of(parse_artnet(bytes, 0, 0)), Drop::bad_universe);
    bytes[14] = 0xFF;
    bytes[15] = 0x7F;
    EXPECT_EQ(packet_of(parse_artnet(bytes)).universe, 32768);
    bytes[15] = 0x80; // the Port-Address has 15 bits
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::bad_universe);
}

TEST(Artnet, odd_and_too_long_lengths) {
    Buffer bytes = kArtDmx;
    bytes[17] = 5;
    EXPECT_EQ(packet_of(parse_artnet(bytes)).slot_count, 5);
    bytes[16] = 0xFF;
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::too_short);
    bytes.resize(18 + 700, 9);
    EXPECT_EQ(packet_of(parse_artnet(bytes)).slot_count, 512);
    bytes.resize(18 + 511); // a universe is not whole
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::too_short);
}

TEST(Artnet, other_packets_and_reasons) {
    Buffer bytes = {'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x20, 0x00, 0x0e, 0x02, 0x00};
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::poll);
    bytes[9] = 0x52;
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::sync);
    bytes[9] = 0x97;
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::timecode);
    bytes[9] = 0x21;
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::poll_reply);
    bytes[9] = 0x60;
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::other);
    bytes[11] = 13;
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::bad_version);
    bytes[0] = 'a';
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::not_ours);
}

TEST(Build, sacn_bytes) {
    std::array<std::uint8_t, 16> cid{};
    cid[0] = 0xAB;
    const Buffer slots = {10, 20};
    const Buffer bytes = build_sacn(258, slots, 7, 150, cid, "Desk");
    ASSERT_EQ(bytes.size(), 128u);
    EXPECT_EQ(bytes[16], 0x70); // root: 112 bytes from here
    EXPECT_EQ(bytes[17], 0x70);
    EXPECT_EQ(bytes[39], 0x5A);  // framing: 90
    EXPECT_EQ(bytes[116], 0x0D); // DMP: 13
    const Packet packet = packet_of(parse_sacn(bytes));
    EXPECT_EQ(packet.universe, 258);
    EXPECT_EQ(packet.priority, 150);
    EXPECT_EQ(packet.sequence, 7);
    EXPECT_EQ(packet.source_name, "Desk");
    EXPECT_EQ(packet.source.id, cid);
    EXPECT_EQ(packet.slot_count, 2);
    EXPECT_EQ(packet.slots[1], 20);
    EXPECT_EQ(sacn_group(258), 0xEFFF0102u);
}

TEST(Build, artdmx_bytes) {
    const Buffer slots = {1, 2, 3};
    const Buffer expected = {'A',  'r',  't', '-',  'N',  'e',  't',  0, 0x00, 0x50, 0x00,
                             0x0e, 0x05, 0,   0x23, 0x04, 0x00, 0x04, 1, 2,    3,    0};
    EXPECT_EQ(build_artdmx(0x0423, slots, 5), expected);
}

TEST(Build, poll_reply_fields) {
    PollReply reply;
    reply.ipv4 = 0x7F010002;
    reply.port_address = 0x0423;
    reply.bind_index = 3;
    reply.receiving = true;
    reply.short_name = "a name that is longer than 17";
    reply.long_name = "long";
    const auto bytes = build_poll_reply(reply);
    EXPECT_EQ(bytes[8], 0x00);
    EXPECT_EQ(bytes[9], 0x21);
    EXPECT_EQ(bytes[10], 127);
    EXPECT_EQ(bytes[13], 2);
    EXPECT_EQ(bytes[14], 0x36);
    EXPECT_EQ(bytes[15], 0x19);
    EXPECT_EQ(bytes[18], 4); // net
    EXPECT_EQ(bytes[19], 2); // sub-net
    EXPECT_EQ(bytes[26], 'a');
    EXPECT_EQ(bytes[42], 'o'); // 17 letters, then the end
    EXPECT_EQ(bytes[43], 0);
    EXPECT_EQ(bytes[44], 'l');
    EXPECT_EQ(bytes[173], 1);    // one port
    EXPECT_EQ(bytes[174], 0x80); // that puts out DMX
    EXPECT_EQ(bytes[182], 0x80);
    EXPECT_EQ(bytes[190], 3); // universe
    EXPECT_EQ(bytes[200], 0);
    EXPECT_EQ(bytes[207], 127);
    EXPECT_EQ(bytes[211], 3);
    EXPECT_EQ(bytes[212], 0x08);
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::poll_reply);
}

} // namespace
} // namespace ghost::dmx
