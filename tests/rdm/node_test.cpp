// SPDX-License-Identifier: Apache-2.0
#include "rdm/node.h"

#include "support/a_device.h"

#include <set>

namespace ghost::rdm {
namespace {

using Data = std::vector<std::uint8_t>;

constexpr Node::Sender kDesk{0x0A000001, kNow};
constexpr std::uint16_t kAnnounced = 0x12; // ports

std::optional<Port> port_of(std::uint16_t port_address) {
    if (port_address >= kAnnounced) return std::nullopt;
    return Port{static_cast<std::uint8_t>(port_address), 2};
}

std::vector<Device> heads(std::uint32_t count, std::uint16_t universe = 1) {
    std::vector<Device> result;
    for (std::uint32_t i = 1; i <= count; ++i) {
        result.push_back(head(i));
        result.back().universe = universe;
    }
    return result;
}

TodData table_of(const Node::Packets& packets) {
    const ArtPacket parsed = packets.empty() ? ArtPacket() : parse_artnet(packets[0]);
    const TodData* const table = std::get_if<TodData>(&parsed);
    return table ? *table : TodData{};
}

// The table that goes back; nothing: no packet does.
std::optional<TodData> ask_table(Node& node, std::uint16_t port_address, const Node::Sender& from = kDesk) {
    const Node::Packets packets = node.take(build_tod_request({{port_address}}), from, nobody_may, port_of);
    return packets.empty() ? std::nullopt : std::optional(table_of(packets));
}

TEST(RdmNode, the_table_of_a_port_in_as_many_packets_as_it_needs) {
    Node node(1);
    node.update(heads(450, 18));
    Leave leave;
    const Data request = build_tod_request({{0x0011, 0x0012}});
    EXPECT_TRUE(is_rdm(request));
    const Node::Packets packets = node.take(request, kDesk, leave.wants(), port_of);
    ASSERT_EQ(packets.size(), 3u);
    std::set<Uid> uids;
    for (std::size_t i = 0; i < packets.size(); ++i) {
        EXPECT_TRUE(is_rdm(packets[i]));
        const ArtPacket parsed = parse_artnet(packets[i]);
        ASSERT_TRUE(std::holds_alternative<TodData>(parsed));
        const TodData& data = std::get<TodData>(parsed);
        EXPECT_EQ(data.port_address, 0x11);
        EXPECT_EQ(data.total, 450);
        EXPECT_EQ(data.block, i);
        EXPECT_EQ(data.port.bind_index, 0x11) << "as the poll reply that names the port";
        EXPECT_EQ(data.port.number, 2);
        uids.insert(data.uids.begin(), data.uids.end());
    }
    EXPECT_EQ(uids.size(), 450u);
    EXPECT_TRUE(node.take(build_tod_request({{0x0013}}), kDesk, leave.wants(), port_of).empty())
        << "not ours";
}

TEST(RdmNode, answers_for_so_many_and_no_more) {
    Node node(1);
    std::vector<Device> many = heads(kMaxDevices + 1);
    const Uid last_of_all = many.back().uid, last = many[kMaxDevices - 1].uid;
    node.update(std::move(many));
    EXPECT_NE(node.find(last), nullptr);
    EXPECT_EQ(node.find(last_of_all), nullptr);
}

// Art-Net 4: 24 bytes before the addresses; a table request of one port, byte by byte.
TEST(RdmNode, packets_as_art_net_has_them) {
    const Data request = build_tod_request({{0x0203}});
    EXPECT_EQ(request, (Data{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x80, 0, 14, 0,
                             0,   0,   0,   0,   0,   0,   0,   0, 2,    0,    1, 3}));
    TodData table;
    table.port_address = 0x0203;
    table.total = 1;
    table.uids = {{0x7FF0, 0x01020304}};
    EXPECT_EQ(build_tod_data(table),
              (Data{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x81, 0, 14,   1,    1, 0, 0, 0,
                    0,   0,   0,   1,   2,   0,   3,   0, 1,    0,    1, 0x7F, 0xF0, 1, 2, 3, 4}));
    const Data rdm = build_art_rdm(0x0203, ask(Command::get, Pid::device_info));
    EXPECT_EQ((Data{rdm.begin(), rdm.begin() + 26}),
              (Data{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x83, 0, 14, 1,
                    0,   0,   0,   0,   0,   0,   0,   0, 2,    0,    3, 1,  24}))
        << "without the start code";
}

TEST(RdmNode, messages_reach_their_device_and_answers_come_back) {
    Node node(1);
    node.update(heads(3));
    Leave leave;
    const auto answer = [&](const Message& message, std::uint16_t port = 0) {
        return node.take(build_art_rdm(port, message), kDesk, leave.wants(), port_of);
    };
    const Node::Packets packets = answer(ask(Command::get, Pid::device_label, {}, {kMaker, 2}));
    ASSERT_EQ(packets.size(), 1u);
    const ArtPacket back = parse_artnet(packets[0]);
    const Message response = std::get<Message>(std::get<ArtRdm>(back).message);
    EXPECT_EQ(std::string(response.data.begin(), response.data.end()), "Spot 2");
    EXPECT_EQ(response.from, (Uid{kMaker, 2}));
    EXPECT_TRUE(answer(ask(Command::get, Pid::device_label, {}, {kMaker, 9})).empty());
    EXPECT_TRUE(answer(ask(Command::get, Pid::device_label, {}, {kMaker, 2}), 1).empty()) << "another port";
    EXPECT_TRUE(answer(ask(Command::set, Pid::identify_device, {1}, kAll)).empty());
    EXPECT_EQ(leave.changes.size(), 3u) << "each of them";
    Data broken = build_art_rdm(0, ask(Command::get, Pid::device_label));
    broken.back() ^= 1;
    EXPECT_TRUE(node.take(broken, kDesk, leave.wants(), port_of).empty());
    EXPECT_EQ(node.faults(), 1u);
    for (std::size_t size = 0; size < broken.size(); ++size)
        EXPECT_TRUE(node.take(Bytes(broken).first(size), kDesk, leave.wants(), port_of).empty()) << size;
}

TEST(RdmNode, devices_that_come_go_and_move) {
    Node node(1);
    node.update(heads(3));
    EXPECT_TRUE(ask_table(node, 0).has_value());
    node.update(heads(3));
    EXPECT_FALSE(node.news(kNow, port_of)) << "as it was";
    std::vector<Device> two = heads(2);
    two[1].universe = 7;
    node.update(two);
    EXPECT_EQ(node.devices(), 2u);
    EXPECT_EQ(node.find({kMaker, 3}), nullptr);
    two[0].universe = 0;
    node.update(two);
    Leave leave;
    const Node::Packets first = node.take(build_tod_request({{0, 6}}), kDesk, leave.wants(), port_of);
    ASSERT_EQ(first.size(), 2u);
    EXPECT_EQ(table_of(first).total, 0) << "what is not patched is at no port";
    EXPECT_EQ(std::get<TodData>(parse_artnet(first[1])).port_address, 6);
    EXPECT_EQ(std::get<TodData>(parse_artnet(first[1])).total, 1);
}

TEST(RdmNode, of_a_port_without_devices_says_that_nobody_is_there) {
    Node node(1);
    const std::optional<TodData> table = ask_table(node, 3);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->port_address, 3);
    EXPECT_EQ(table->total, 0);
    EXPECT_TRUE(table->uids.empty());
    EXPECT_EQ(table->port.bind_index, 3) << "as the poll reply that names the port";
    const Data flush{'A', 'r', 't', '-', 'N', 'e', 't', 0, 0x00, 0x82, 0, 14,
                     0,   0,   0,   0,   0,   0,   0,   0, 0,    0,    1, 3};
    const Node::Packets flushed = node.take(flush, kDesk, nobody_may, port_of);
    ASSERT_EQ(flushed.size(), 1u);
    EXPECT_EQ(table_of(flushed).port_address, 3);
    EXPECT_FALSE(ask_table(node, kAnnounced)) << "not ours";
    node.update(heads(1, kAnnounced + 1));
    EXPECT_EQ(ask_table(node, kAnnounced)->total, 1);
    node.update({});
    EXPECT_EQ(ask_table(node, kAnnounced)->total, 0) << "it had one";
}

TEST(RdmNode, who_asked_for_a_table_gets_it_when_it_changes) {
    Node node(1);
    node.update(heads(450));
    EXPECT_EQ(ask_table(node, 0)->total, 450);
    const Node::Sender other{0x0A000002, kNow};
    (void)ask_table(node, 5, other);
    EXPECT_FALSE(node.news(kNow, port_of));
    std::vector<Device> moved = heads(450);
    moved[0].universe = 6;
    node.update(moved);
    const auto first = node.news(kNow, port_of), second = node.news(kNow, port_of);
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->to_ipv4, kDesk.ipv4);
    EXPECT_EQ(first->packets.size(), 3u) << "the whole table";
    EXPECT_EQ(table_of(first->packets).total, 449);
    EXPECT_EQ(second->to_ipv4, other.ipv4);
    EXPECT_EQ(table_of(second->packets).port_address, 5);
    EXPECT_EQ(table_of(second->packets).total, 1);
    EXPECT_TRUE(node.heard(moved[0].uid).is_found);
    EXPECT_FALSE(node.news(kNow, port_of)) << "once";
    node.update({});
    const auto last = node.news(kNow + kTableRest, port_of);
    ASSERT_TRUE(last);
    EXPECT_EQ(last->packets.size(), 1u);
    EXPECT_EQ(table_of(last->packets).total, 0) << "the last one left";
}

} // namespace
} // namespace ghost::rdm
