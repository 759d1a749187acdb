// SPDX-License-Identifier: Apache-2.0
// Packets of multicast DNS: literal bytes as others send them, and whatever else may come.
#include "net/mdns.h"

#include <gtest/gtest.h>

#include <random>

namespace ghost::dmx {
namespace {

using Buffer = std::vector<std::uint8_t>;

Buffer bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

Buffer operator+(Buffer a, const Buffer& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// An answer as python-zeroconf packs it (BlenderDMX): names point back to where they stood first.
const Buffer kAnswer =
    Buffer{0, 0, 0x84, 0, 0, 0, 0, 4, 0, 0, 0, 0} +
    // 12: _mvrxchange._tcp.local PTR Default.(12)
    bytes_of("\x0B_mvrxchange\x04_tcp\x05local") + Buffer{0, 0, 12, 0, 1, 0, 0, 0x11, 0x94, 0, 10} +
    bytes_of("\x07"
             "Default") +
    Buffer{0xC0, 12} +
    // 46 is "Default": SRV, flush
    Buffer{0xC0, 46, 0, 33, 0x80, 1, 0, 0, 0, 120, 0, 13, 0, 0, 0, 0, 0x23, 0x28} + bytes_of("\x04mary") +
    Buffer{0xC0, 29} +
    // TXT
    Buffer{0xC0, 46, 0, 16, 0x80, 1, 0, 0, 0x11, 0x94, 0, 18} + bytes_of("\x11StationName=Mary!") +
    // mary.local A
    bytes_of("\x04mary") + Buffer{0xC0, 29, 0, 1, 0x80, 1, 0, 0, 0, 120, 0, 4, 10, 0, 0, 7};

TEST(Mdns, an_answer_with_compressed_names) {
    const auto packet = parse_dns(kAnswer);
    ASSERT_TRUE(packet.has_value());
    EXPECT_TRUE(packet->response);
    ASSERT_EQ(packet->records.size(), 4u);
    const DnsName group{"Default", "_mvrxchange", "_tcp", "local"};
    EXPECT_EQ(name_text(packet->records[0].name), "_mvrxchange._tcp.local");
    EXPECT_EQ(packet->records[0].target, group);
    EXPECT_EQ(packet->records[0].ttl_s, 4500u);
    EXPECT_EQ(packet->records[1].type, DnsType::srv);
    EXPECT_EQ(packet->records[1].name, group);
    EXPECT_EQ(packet->records[1].port, 9000);
    EXPECT_EQ(name_text(packet->records[1].target), "mary.local");
    EXPECT_EQ(packet->records[2].texts, std::vector<std::string>{"StationName=Mary!"});
    EXPECT_EQ(packet->records[3].address, IpAddress(0x0A000007));
}

TEST(Mdns, what_is_built_is_read_again) {
    DnsPacket packet{true, {{{"a", "b.c"}, DnsType::ptr}}, {}};
    packet.records.push_back({{"x", "local"}, DnsType::ptr, 7, {"Y z", "local"}, 0, {}, {}});
    packet.records.push_back({{"x", "local"}, DnsType::srv, 0x12345678, {"h"}, 65535, {}, {}});
    packet.records.push_back(
        {{"x", "local"}, DnsType::txt, 0, {}, 0, {}, {"k=v", "l=" + std::string(250, 'm')}});
    packet.records.push_back({{"h"}, DnsType::a, 1, {}, 0, IpAddress(0xC0A80102), {}});
    std::array<std::uint8_t, 16> six{0xFE, 0x80};
    six[15] = 9;
    packet.records.push_back({{"h"}, DnsType::aaaa, 1, {}, 0, IpAddress(six), {}});
    EXPECT_EQ(parse_dns(build_dns(packet)), packet);
}

TEST(Mdns, names_that_loop_or_never_end_are_refused) {
    const Buffer head{0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0};
    const Buffer tail{0, 12, 0, 1};
    // To itself; forwards; to a name that points back here; a label beyond the end; 255 bytes and more.
    EXPECT_TRUE(parse_dns(head + Buffer{0xC0, 12} + tail)->questions.empty());
    EXPECT_TRUE(parse_dns(head + Buffer{0xC0, 40} + tail)->questions.empty());
    EXPECT_TRUE(parse_dns(head + Buffer{1, 'a', 0xC0, 12} + tail)->questions.empty());
    EXPECT_TRUE(parse_dns(head + Buffer{40, 'a', 'b'})->questions.empty());
    EXPECT_TRUE(parse_dns(head + Buffer{0x80, 'a', 0} + tail)->questions.empty());
    Buffer longest = head;
    for (int i = 0; i < 4; ++i) longest = longest + Buffer{63} + Buffer(63, 'x');
    EXPECT_TRUE(parse_dns(longest + Buffer{0} + tail)->questions.empty());
    // A question whose name points to one whose name points on, each further back, is a name.
    const Buffer chain = Buffer{0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0} + Buffer{1, 'a', 0} + tail +
                         Buffer{1, 'b', 0xC0, 12} + tail + Buffer{1, 'c', 0xC0, 19} + tail;
    ASSERT_EQ(parse_dns(chain)->questions.size(), 3u);
    EXPECT_EQ(parse_dns(chain)->questions[2].name, (DnsName{"c", "b", "a"}));
}

TEST(Mdns, every_truncation_and_flipped_bit_is_taken) {
    const auto whole = parse_dns(kAnswer);
    for (std::size_t size = 0; size < kAnswer.size(); ++size) {
        const auto packet = parse_dns(Bytes(kAnswer).first(size));
        ASSERT_EQ(packet.has_value(), size >= 12);
        if (packet) {
            EXPECT_LT(packet->records.size(), whole->records.size()) << size;
        }
    }
    for (std::size_t bit = 0; bit < kAnswer.size() * 8; ++bit) {
        Buffer flipped = kAnswer;
        flipped[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
        (void)parse_dns(flipped);
    }
}

TEST(Mdns, a_packet_is_bounded) {
    Buffer many{0, 0, 0x84, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
    for (int i = 0; i < 65535; ++i) many = i == 0 ? many + Buffer{0, 0, 12, 0, 1} : many;
    for (int i = 1; i < 65535; ++i) many.insert(many.end(), {0, 0, 12, 0, 1});
    for (int i = 0; i < 1000; ++i) many.insert(many.end(), {0, 0, 12, 0, 1, 0, 0, 0, 9, 0, 1, 0});
    const auto packet = parse_dns(many);
    EXPECT_EQ(packet->questions.size(), kMostDnsQuestions);
    EXPECT_EQ(packet->records.size(), kMostDnsRecords);
}

TEST(Mdns, names_know_no_capitals) {
    EXPECT_TRUE(same_name({"Default", "LOCAL"}, {"default", "local"}));
    EXPECT_FALSE(same_name({"Default"}, {"Default", "local"}));
    EXPECT_TRUE(ends_with({"x", "_TCP", "local"}, {"_tcp", "local"}));
    EXPECT_FALSE(ends_with({"local"}, {"_tcp", "local"}));
    EXPECT_EQ(name_text({"a\x1B", "b"}), "a?.b");
}

} // namespace
} // namespace ghost::dmx
