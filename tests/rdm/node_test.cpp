// SPDX-License-Identifier: Apache-2.0
#include "rdm/node.h"

#include "support/a_device.h"

#include <set>

namespace ghost::rdm {
namespace {

using Data = std::vector<std::uint8_t>;

Port port_of(std::uint16_t port_address) {
    return {static_cast<std::uint8_t>(port_address), 2};
}

std::vector<Device> heads(std::uint32_t count, std::uint16_t universe = 1) {
    std::vector<Device> result;
    for (std::uint32_t i = 1; i <= count; ++i) {
        result.push_back(head(i));
        result.back().universe = universe;
    }
    return result;
}

TEST(RdmNode, the_table_of_a_port_in_as_many_packets_as_it_needs) {
    Node node(1);
    EXPECT_TRUE(node.update(heads(450, 18)));
    Leave leave;
    const Data request = build_tod_request({{0x0011, 0x0012}});
    EXPECT_TRUE(is_rdm(request));
    const Node::Packets packets = node.take(request, leave.wants(), port_of);
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
    EXPECT_TRUE(node.take(build_tod_request({{0x0013}}), leave.wants(), port_of).empty()) << "not ours";
}

// Art-Net 4: 24 bytes before the addresses; a table request of one port, byte by byte.
TEST(RdmNode, answers_for_so_many_and_no_more) {
    Node node(1);
    std::vector<Device> many = heads(kMaxDevices + 1);
    const Uid last_of_all = many.back().uid, last = many[kMaxDevices - 1].uid;
    EXPECT_TRUE(node.update(std::move(many)));
    EXPECT_NE(node.find(last), nullptr);
    EXPECT_EQ(node.find(last_of_all), nullptr);
}

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
        return node.take(build_art_rdm(port, message), leave.wants(), port_of);
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
    EXPECT_TRUE(node.take(broken, leave.wants(), port_of).empty());
    EXPECT_EQ(node.faults(), 1u);
    for (std::size_t size = 0; size < broken.size(); ++size)
        EXPECT_TRUE(node.take(Bytes(broken).first(size), leave.wants(), port_of).empty()) << size;
}

TEST(RdmNode, devices_that_come_go_and_move) {
    Node node(1);
    EXPECT_TRUE(node.update(heads(3)));
    EXPECT_FALSE(node.update(heads(3)));
    std::vector<Device> two = heads(2);
    two[1].universe = 7;
    EXPECT_TRUE(node.update(two));
    EXPECT_EQ(node.devices(), 2u);
    EXPECT_EQ(node.find({kMaker, 3}), nullptr);
    two[0].universe = 0;
    EXPECT_TRUE(node.update(two));
    Leave leave;
    const Node::Packets first = node.take(build_tod_request({{0, 6}}), leave.wants(), port_of);
    ASSERT_EQ(first.size(), 1u) << "what is not patched is at no port";
    EXPECT_EQ(std::get<TodData>(parse_artnet(first[0])).port_address, 6);
}

} // namespace
} // namespace ghost::rdm
