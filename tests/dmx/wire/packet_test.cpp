// SPDX-License-Identifier: Apache-2.0
#include "dmx/wire/build.h"
#include "dmx/wire/packet.h"

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

TEST(Sacn, reads_a_data_packet) {
    const Packet packet = packet_of(parse_sacn(literal_sacn(), 0x0A000002));
    EXPECT_EQ(packet.protocol, Protocol::sacn);
    EXPECT_EQ(packet.source.id[0], 0xEF);
    EXPECT_EQ(packet.source.id[15], 0x3E);
    EXPECT_EQ(packet.source_name, "Source_A");
    EXPECT_EQ(packet.from, IpAddress(0x0A000002u));
    EXPECT_EQ(packet.universe, 1);
    EXPECT_EQ(packet.priority, 100);
    EXPECT_EQ(packet.sequence, 0x9A);
    EXPECT_EQ(packet.sync_universe, 7962);
    EXPECT_EQ(packet.start_code, 0);
    EXPECT_FALSE(packet.source.preview);
    EXPECT_FALSE(packet.terminated);
    ASSERT_EQ(packet.slot_count, 3);
    EXPECT_EQ(packet.slots[0], 1);
    EXPECT_EQ(packet.slots[2], 3);
    EXPECT_EQ(packet.slots[3], 0);
}

// Of a packet that was cut: what came, and that more was declared. Without a single level it is none.
void expect_clipped(const Parsed& parsed, std::size_t came, std::size_t of) {
    if (came == 0) {
        EXPECT_EQ(drop_of(parsed), Drop::too_short) << "none of " << of;
        return;
    }
    const Packet packet = packet_of(parsed);
    EXPECT_EQ(packet.slot_count, came) << of;
    EXPECT_EQ(packet.wrong_length, came < of) << came << " of " << of;
    for (std::size_t i = 0; i < kSlots; ++i) EXPECT_EQ(packet.slots[i] > 0, i < came) << i << " of " << came;
}

TEST(Sacn, of_every_truncation_the_levels_that_came_are_used) {
    const Buffer full = build_sacn(1, Buffer(512, 200), 1, {100, {}, "Desk"});
    const Buffer priorities = build_sacn(1, Buffer(512, 200), 1, {100, {}, "Desk"}, {0, 0xDD});
    for (const Buffer& whole : {literal_sacn(), full, priorities})
        for (std::size_t size = 0; size <= whole.size(); ++size) {
            const Buffer cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            if (size < 126)
                EXPECT_EQ(drop_of(parse_sacn(cut)), Drop::too_short) << size << " of " << whole.size();
            else
                expect_clipped(parse_sacn(cut), size - 126, whole.size() - 126);
        }
}

TEST(Sacn, options_and_start_codes) {
    Buffer bytes = literal_sacn();
    bytes[112] = 0x80;
    EXPECT_TRUE(packet_of(parse_sacn(bytes)).source.preview);
    bytes[112] = 0x40;
    EXPECT_TRUE(packet_of(parse_sacn(bytes)).terminated);
    bytes[112] = 0x20;
    EXPECT_TRUE(packet_of(parse_sacn(bytes)).force_sync);
    EXPECT_FALSE(packet_of(parse_sacn(bytes)).terminated);
    bytes[125] = 0xDD;
    EXPECT_EQ(packet_of(parse_sacn(bytes)).start_code, 0xDD);
    bytes[125] = 0x17;
    const Parsed parsed = parse_sacn(bytes);
    ASSERT_TRUE(std::holds_alternative<Passing>(parsed));
    EXPECT_EQ(std::get<Passing>(parsed).universe, 1);
    EXPECT_EQ(std::get<Passing>(parsed).sequence, bytes[111]);
    EXPECT_EQ(notice_of(parsed), Notice::other_start_code) << "a packet that is fine, E1.11 knows many";
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
    expect_clipped(parse_sacn(bytes), 512, 0xFFFE);
    bytes.resize(126 + 511);
    expect_clipped(parse_sacn(bytes), 511, 0xFFFE);
}

TEST(Sacn, bytes_behind_the_levels_are_left) {
    Buffer bytes = literal_sacn();
    bytes.resize(bytes.size() + 10, 7);
    const Packet packet = packet_of(parse_sacn(bytes));
    EXPECT_EQ(packet.slot_count, 3);
    EXPECT_FALSE(packet.wrong_length);
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

TEST(Sacn, sync_packet) {
    std::array<std::uint8_t, 16> cid{};
    cid[0] = 0xAB;
    Buffer bytes = build_sacn_sync(7962, 0x1F, cid);
    ASSERT_EQ(bytes.size(), 49u);
    EXPECT_EQ(bytes[17], 0x21);
    EXPECT_EQ(bytes[39], 0x0B);
    const Parsed parsed = parse_sacn(bytes);
    EXPECT_EQ(notice_of(parsed), Notice::sync);
    const auto* sync = std::get_if<SyncPacket>(&parsed);
    ASSERT_NE(sync, nullptr);
    EXPECT_EQ(sync->universe, 7962);
    EXPECT_EQ(sync->sequence, 0x1F);
    EXPECT_EQ(sync->source.id, cid);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_EQ(drop_of(parse_sacn(Bytes(bytes).first(size))), Drop::too_short) << size;
    bytes[45] = bytes[46] = 0;
    EXPECT_EQ(drop_of(parse_sacn(bytes)), Drop::bad_universe);
}

TEST(Sacn, discovery_packet) {
    const std::vector<std::uint16_t> universes = {1, 2, 40000};
    Buffer bytes = build_sacn_discovery(universes, 1, 2, {}, "Desk");
    EXPECT_EQ(bytes.size(), 126u);
    const Parsed parsed = parse_sacn(bytes, 0x0A000001);
    EXPECT_EQ(notice_of(parsed), Notice::discovery);
    const auto* list = std::get_if<DiscoveryPacket>(&parsed);
    ASSERT_NE(list, nullptr);
    EXPECT_EQ(list->universes, universes);
    EXPECT_EQ(list->page, 1);
    EXPECT_EQ(list->last_page, 2);
    EXPECT_EQ(list->source_name, "Desk");
    EXPECT_EQ(list->from, IpAddress(0x0A000001));
    for (const std::size_t size : {0u, 44u, 108u, 119u, 121u, 125u})
        EXPECT_EQ(drop_of(parse_sacn(Bytes(bytes).first(size))), Drop::too_short) << size;
    bytes[118] = 3; // behind the last page
    EXPECT_EQ(drop_of(parse_sacn(bytes)), Drop::bad_value);
    bytes[117] = 9;
    EXPECT_EQ(drop_of(parse_sacn(bytes)), Drop::bad_vector);
}

// As OLA 0.10.9 sends it: the framing layer of data, then page, last page and list.
TEST(Sacn, discovery_of_the_draft) {
    Buffer bytes = literal_sacn();
    bytes[43] = 4;
    bytes.resize(115);
    for (const int byte : {0, 0, 0, 1, 0, 5}) bytes.push_back(static_cast<std::uint8_t>(byte));
    const Parsed parsed = parse_sacn(bytes);
    const auto* list = std::get_if<DiscoveryPacket>(&parsed);
    ASSERT_NE(list, nullptr);
    EXPECT_EQ(list->universes, (std::vector<std::uint16_t>{1, 5}));
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

TEST(Artnet, of_every_truncation_the_levels_that_came_are_used) {
    const Buffer full = build_artdmx(0, Buffer(512, 200), 1);
    for (const Buffer& whole : {kArtDmx, full})
        for (std::size_t size = 0; size <= whole.size(); ++size) {
            const Buffer cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            if (size < 18)
                EXPECT_EQ(drop_of(parse_artnet(cut)), Drop::too_short) << size << " of " << whole.size();
            else
                expect_clipped(parse_artnet(cut), size - 18, whole.size() - 18);
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
    EXPECT_FALSE(packet_of(parse_artnet(bytes)).wrong_length) << "more came than is declared";
    bytes[16] = 0xFF;
    expect_clipped(parse_artnet(bytes), 6, 0xFF05);
    bytes.resize(18 + 700, 9);
    expect_clipped(parse_artnet(bytes), 512, 0xFF05);
    bytes.resize(18 + 511);
    expect_clipped(parse_artnet(bytes), 511, 0xFF05);
}

TEST(Artnet, other_packets_and_reasons) {
    Buffer bytes = {'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x20, 0x00, 0x0e, 0x02, 0x00};
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::poll);
    bytes[9] = 0x52;
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::sync);
    bytes[9] = 0x21;
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::poll_reply);
    bytes[9] = 0x60;
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::other);
    bytes[9] = 0x97; // cut
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::too_short);
    bytes[11] = 13;
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::bad_version);
    bytes[0] = 'a';
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::not_ours);
}

// As OLA 0.10.9 sent it: four ports that go both ways, of which the input of the first is on, SwIn 1.
TEST(Artnet, a_poll_reply_says_who_brings_in_what) {
    Buffer reply = {'A', 'r',  't',  '-', 'N', 'e', 't', 0,    0x00, 0x21, 10,   93,   0,
                    1,   0x36, 0x19, 0,   0,   0,   0,   0x04, 0x31, 0,    0xD2, 0x70, 0x7A};
    const auto text = [&](const char* words, std::size_t size) {
        const std::size_t end = reply.size() + size;
        for (; *words != 0; ++words) reply.push_back(static_cast<std::uint8_t>(*words));
        reply.resize(end);
    };
    text("short", 18);
    text("test", 64);
    text("#0001 [1] OLA", 64);
    for (const int byte : {0, 4, 0xC0, 0xC0, 0xC0, 0xC0, 0, 8, 8, 8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0})
        reply.push_back(static_cast<std::uint8_t>(byte));
    const std::size_t told = reply.size() - 4; // SwIn is there
    reply.resize(239);
    const IpAddress from(0x0A5D0001);
    const auto universes = [&](const Buffer& bytes) {
        const Parsed parsed = parse_artnet(bytes, from);
        EXPECT_EQ(notice_of(parsed), Notice::poll_reply);
        const auto* packet = std::get_if<DiscoveryPacket>(&parsed);
        return packet ? packet->universes : std::vector<std::uint16_t>{};
    };
    const DiscoveryPacket ola = std::get<DiscoveryPacket>(parse_artnet(reply, from));
    EXPECT_EQ(ola.source_name, "test");
    EXPECT_EQ(ola.from, from);
    EXPECT_EQ(ola.source.protocol, Protocol::artnet);
    EXPECT_EQ(universes(reply), std::vector<std::uint16_t>{2});
    for (std::size_t size = 10; size < reply.size(); ++size)
        EXPECT_EQ(universes(Buffer(reply.begin(), reply.begin() + static_cast<long>(size))).size(),
                  size < told ? 0u : 1u)
            << size;
    reply[18] = 3;    // NetSwitch
    reply[19] = 2;    // SubSwitch
    reply[179] = 0;   // the second input is on, too
    reply[187] = 0xF; // SwIn
    EXPECT_EQ(universes(reply), (std::vector<std::uint16_t>{0x321 + 1, 0x32F + 1}));
    reply[173] = 1; // ports
    EXPECT_EQ(universes(reply), std::vector<std::uint16_t>{0x321 + 1});
    reply[174] = 0x80; // gives out alone
    EXPECT_EQ(universes(reply), std::vector<std::uint16_t>{});
    const auto ours = build_poll_reply({.ports = {{1}}});
    EXPECT_EQ(universes(Buffer(ours.begin(), ours.end())), std::vector<std::uint16_t>{});
}

TEST(Artnet, a_poll_may_name_the_ports_it_means) {
    Buffer bytes = {'A',  'r',  't',  '-',  'N',  'e',  't',  0,    0x00,
                    0x20, 0x00, 0x0e, 0x20, 0x00, 0x01, 0x10, 0x01, 0x00};
    Parsed parsed = parse_artnet(bytes);
    const auto* poll = std::get_if<PollPacket>(&parsed);
    ASSERT_NE(poll, nullptr);
    EXPECT_EQ(poll->first, 0x0100);
    EXPECT_EQ(poll->last, 0x0110);
    bytes[12] = 0; // not targeted
    parsed = parse_artnet(bytes);
    EXPECT_EQ(std::get<PollPacket>(parsed).first, 0);
    EXPECT_EQ(std::get<PollPacket>(parsed).last, 0x7FFF);
    bytes[12] = 0x20;
    bytes.resize(16);
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::too_short);
    bytes.resize(12);
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::poll);
}

TEST(Artnet, timecode) {
    // OLA: ola_timecode -f EBU 01:02:03:04
    Buffer bytes = {'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x97, 0x00, 0x0e, 0, 0, 4, 3, 2, 1, 1};
    const Parsed parsed = parse_artnet(bytes);
    const auto* time = std::get_if<TimeCode>(&parsed);
    ASSERT_NE(time, nullptr);
    EXPECT_EQ(timecode_text(*time), "01:02:03:04 EBU 25");
    bytes[14] = 25;
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::bad_value);
    bytes[18] = 3;
    EXPECT_EQ(timecode_text(std::get<TimeCode>(parse_artnet(bytes))), "01:02:03:25 SMPTE 30");
    bytes[18] = 4;
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::bad_value);
    bytes.pop_back();
    EXPECT_EQ(drop_of(parse_artnet(bytes)), Drop::too_short);
}

TEST(Artnet, trigger) {
    const Buffer bytes = {'A',  'r',  't',  '-', 'N', 'e',  't',  0, 0x00,
                          0x99, 0x00, 0x0e, 0,   0,   0xFF, 0xFF, 1, 5};
    const Parsed parsed = parse_artnet(bytes);
    const auto* trigger = std::get_if<Trigger>(&parsed);
    ASSERT_NE(trigger, nullptr);
    EXPECT_EQ(trigger->oem, 0xFFFF);
    EXPECT_EQ(trigger_text(*trigger), "macro 5");
    EXPECT_EQ(drop_of(parse_artnet(Bytes(bytes).first(17))), Drop::too_short);
}

TEST(Build, sacn_bytes) {
    std::array<std::uint8_t, 16> cid{};
    cid[0] = 0xAB;
    const Buffer slots = {10, 20};
    const Buffer bytes = build_sacn(258, slots, 7, {150, cid, "Desk"});
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
    EXPECT_EQ(address_text(sacn_group_address(258, false)), "239.255.1.2");
    EXPECT_EQ(address_text(sacn_group_address(258, true)), "ff18::8300:102");
    EXPECT_EQ(address_text(sacn_group_address(64214, true)), "ff18::8300:fad6"); // discovery
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
    reply.ports = {{0x0423, true, true}};
    reply.bind_index = 3;
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
    EXPECT_EQ(bytes[182], 0x88); // levels arrive, of two sources
    EXPECT_EQ(bytes[190], 3);    // universe
    EXPECT_EQ(bytes[200], 0);
    EXPECT_EQ(bytes[207], 127);
    EXPECT_EQ(bytes[211], 3);
    EXPECT_EQ(bytes[212], 0x08);
    EXPECT_EQ(bytes[213], 0x80); // no RDM
    EXPECT_EQ(bytes[214], 0);
    EXPECT_EQ(notice_of(parse_artnet(bytes)), Notice::poll_reply);
}

TEST(Build, poll_reply_of_four_ports) {
    PollReply reply;
    reply.ports = {{0x0124, false}, {0x0125, true}, {0x0128, false}};
    reply.ltp = true;
    const auto bytes = build_poll_reply(reply);
    EXPECT_EQ(bytes[18], 1);
    EXPECT_EQ(bytes[19], 2);
    EXPECT_EQ(bytes[173], 3);
    const auto four = [&](std::size_t at) {
        return std::vector<int>(bytes.begin() + at, bytes.begin() + at + 4);
    };
    EXPECT_EQ(four(174), (std::vector<int>{0x80, 0x80, 0x80, 0}));
    EXPECT_EQ(four(182), (std::vector<int>{0x02, 0x82, 0x02, 0}));
    EXPECT_EQ(four(186), (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(four(190), (std::vector<int>{4, 5, 8, 0}));
    EXPECT_EQ(bytes[200], 0);
    EXPECT_EQ(bytes[211], 1);
}

} // namespace
} // namespace ghost::dmx
