// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/poll_answers.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr std::uint32_t kAsker = 0x0A000001, kOurs = 0x0A000005;

std::vector<std::uint16_t> ports(std::size_t count) {
    std::vector<std::uint16_t> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(static_cast<std::uint16_t>(i));
    return result;
}

// All replies of a time, in steps of a millisecond.
std::vector<PollAnswers::Reply> run(PollAnswers& answers, nanoseconds from, nanoseconds to) {
    std::vector<PollAnswers::Reply> result;
    for (nanoseconds now = from; now < to; now += 1ms)
        while (const auto reply = answers.next(now)) result.push_back(*reply);
    return result;
}

TEST(PollAnswers, one_reply_per_port_paced) {
    PollAnswers answers(ports(255));
    EXPECT_FALSE(answers.wait(10s).has_value());
    EXPECT_TRUE(answers.asked({}, kAsker, kOurs, 10s));
    EXPECT_EQ(answers.wait(10s), nanoseconds(5ms)); // the last byte of our address
    EXPECT_TRUE(run(answers, 10s, 10s + 5ms).empty());
    const auto early = run(answers, 10s + 5ms, 10s + 65ms);
    ASSERT_GE(early.size(), 15 * kRepliesAtOnce);
    EXPECT_LE(early.size(), 16 * kRepliesAtOnce);
    const auto late = run(answers, 10s + 65ms, 11s);
    EXPECT_EQ(early.size() + late.size(), 255u);
    EXPECT_EQ(early[0].to_ipv4, kAsker);
    EXPECT_EQ(early[0].our_ipv4, kOurs);
    EXPECT_TRUE(early[0].asked);
    EXPECT_EQ(early[3].ports, std::vector<std::uint16_t>{3});
    EXPECT_EQ(early[3].bind_index, 4);
    EXPECT_EQ(late.back().bind_index, 255);
    EXPECT_EQ(answers.place_of(3)->bind_index, 4);
    EXPECT_EQ(answers.place_of(3)->port, 1);
}

// A desk tells the replies of one address apart by the bind index.
TEST(PollAnswers, more_ports_than_bind_indices_share_replies) {
    for (const std::size_t count : {256u, 512u, 1020u}) {
        PollAnswers answers(ports(count));
        ASSERT_TRUE(answers.asked({}, kAsker, kOurs, 0s));
        std::set<int> seen, indices;
        for (const auto& reply : run(answers, 0s, 2s)) {
            EXPECT_TRUE(indices.insert(reply.bind_index).second) << int{reply.bind_index};
            EXPECT_LE(reply.ports.size(), 4u);
            EXPECT_EQ(answers.place_of(reply.ports.back())->bind_index, reply.bind_index);
            EXPECT_EQ(answers.place_of(reply.ports.back())->port, reply.ports.size());
            for (const std::uint16_t port : reply.ports) {
                EXPECT_EQ(port >> 4, reply.ports[0] >> 4);
                EXPECT_TRUE(seen.insert(port).second) << port;
            }
        }
        EXPECT_EQ(seen.size(), count);
    }
}

TEST(PollAnswers, new_ports_instead_of_those_before) {
    PollAnswers answers(ports(40));
    answers.hello(0x0A0000FF, kOurs, 0s);
    EXPECT_EQ(run(answers, 0s, 1s).size(), 40u);
    ASSERT_TRUE(answers.asked({}, kAsker, kOurs, 2s));
    EXPECT_EQ(run(answers, 2s, 2s + 7ms).size(), kRepliesAtOnce) << "it is just being told";
    answers.announce({7, 9});
    std::vector<int> got;
    for (const auto& reply : run(answers, 2s + 7ms, 4s)) {
        EXPECT_EQ(reply.to_ipv4, kAsker) << "who was told before asks again";
        got.push_back(reply.ports[0]);
    }
    EXPECT_EQ(got, (std::vector<int>{7, 9}));
    EXPECT_FALSE(answers.wait(4s).has_value());
}

TEST(PollAnswers, only_the_ports_that_are_meant) {
    PollAnswers answers(ports(100));
    ASSERT_TRUE(answers.asked({10, 12}, kAsker, kOurs, 0s));
    std::vector<int> got;
    for (const auto& reply : run(answers, 0s, 1s)) got.push_back(reply.ports[0]);
    EXPECT_EQ(got, (std::vector<int>{10, 11, 12}));
}

TEST(PollAnswers, an_address_is_answered_once_in_two_seconds) {
    PollAnswers answers(ports(4));
    std::size_t replies = 0;
    for (auto t = 0ms; t < 10s; t += 10ms) {
        (void)answers.asked({}, kAsker, kOurs, t);
        replies += run(answers, t, t + 10ms).size();
    }
    EXPECT_EQ(replies, 5 * 4u);
}

// Two programs of one address, which ask in turn, a second apart.
TEST(PollAnswers, whoever_asks_while_the_address_rests_is_answered_at_its_end) {
    PollAnswers answers(ports(4));
    EXPECT_TRUE(answers.asked({}, kAsker, kOurs, 0s));
    EXPECT_EQ(run(answers, 0s, 1s).size(), 4u);
    EXPECT_TRUE(answers.asked({}, kAsker, kOurs, 1s));
    EXPECT_FALSE(answers.asked({}, kAsker, kOurs, 1100ms)) << "one answer is for both";
    EXPECT_EQ(answers.wait(1100ms), nanoseconds(900ms));
    EXPECT_TRUE(run(answers, 1100ms, 2s).empty());
    EXPECT_EQ(run(answers, 2s, 3s).size(), 4u);
    EXPECT_TRUE(answers.asked({}, kAsker, kOurs, 3s));
    EXPECT_EQ(run(answers, 3s, 5s).size(), 4u);
    EXPECT_FALSE(answers.wait(5s).has_value());
}

// Whoever sends polls in the name of others gets no more out of us than one honest asker, and the others are
// served in turn.
TEST(PollAnswers, a_flood_of_askers_is_bounded) {
    PollAnswers answers(ports(512));
    std::map<std::uint32_t, std::size_t> got;
    std::size_t refused = 0, replies = 0;
    for (auto t = 0ms; t < 1s; t += 1ms) {
        for (std::uint32_t k = 0; k < 100; ++k)
            refused +=
                answers.asked({}, 0x0A010000 + static_cast<std::uint32_t>(t.count()) * 100 + k, kOurs, t) ? 0
                                                                                                          : 1;
        for (const auto& reply : run(answers, t, t + 1ms)) {
            ++got[reply.to_ipv4];
            ++replies;
        }
    }
    EXPECT_LE(replies, 2000u);
    EXPECT_GT(replies, 1500u);
    EXPECT_EQ(got.size(), kMaxPollers);
    EXPECT_EQ(refused, 100000 - kMaxPollers);
}

TEST(PollAnswers, hello_goes_out_once) {
    PollAnswers answers(ports(3));
    answers.hello(0x0A0000FF, kOurs, 0s);
    const auto sent = run(answers, 0s, 10s);
    ASSERT_EQ(sent.size(), 3u);
    EXPECT_EQ(sent[0].to_ipv4, 0x0A0000FFu);
    EXPECT_FALSE(sent[0].asked);
}

TEST(PollAnswers, the_internet_is_not_answered) {
    NetInterface stage;
    stage.address = 0xC6336401; // 198.51.100.1/24
    stage.netmask = 0xFFFFFF00;
    const std::vector<NetInterface> ours = {stage};
    for (const std::uint32_t good :
         {0x0A000001u, 0xC0A80101u, 0xAC1F0001u, 0xA9FE0001u, 0x7F000001u, 0x02000001u, 0xC63364FEu})
        EXPECT_TRUE(is_local(good, ours)) << ipv4_text(good);
    for (const std::uint32_t bad : {0x08080808u, 0xC6336501u, 0xAC200001u, 0xC0A90001u, 0u})
        EXPECT_FALSE(is_local(bad, ours)) << ipv4_text(bad);
}

} // namespace
} // namespace ghost::dmx
