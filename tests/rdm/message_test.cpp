// SPDX-License-Identifier: Apache-2.0
#include "rdm/message.h"

#include "support/a_device.h"

namespace ghost::rdm {
namespace {

using Bytes_ = std::vector<std::uint8_t>;

// The example of E1.20-2010, 6.2 (GET STATUS_MESSAGES from 0xCBA987654321 to 0x123456789ABC).
const Bytes_ kExample = {0xCC, 0x01, 0x19, 0x12, 0x34, 0x56, 0x78, 0x9A, 0xBC, 0xCB, 0xA9, 0x87, 0x65, 0x43,
                         0x21, 0x00, 0x01, 0x00, 0x00, 0x00, 0x20, 0x00, 0x30, 0x01, 0x04, 0x06, 0x6A};

TEST(RdmMessage, the_example_of_the_standard) {
    const auto parsed = parse(kExample);
    ASSERT_TRUE(std::holds_alternative<Message>(parsed));
    const Message& message = std::get<Message>(parsed);
    EXPECT_EQ(uid_text(message.to), "1234:56789abc");
    EXPECT_EQ(uid_text(message.from), "cba9:87654321");
    EXPECT_EQ(message.transaction, 0);
    EXPECT_EQ(message.port_or_answer, 1);
    EXPECT_EQ(message.command, Command::get);
    EXPECT_FALSE(message.is_response);
    EXPECT_EQ(message.pid, static_cast<int>(Pid::status_messages));
    EXPECT_EQ(message.data, Bytes_{4});
    EXPECT_EQ(build(message), kExample);
}

TEST(RdmMessage, every_truncation_and_every_flipped_bit_is_no_message) {
    for (std::size_t size = 0; size < kExample.size(); ++size)
        EXPECT_TRUE(std::holds_alternative<Fault>(parse(Bytes(kExample).first(size)))) << size;
    for (std::size_t bit = 0; bit < 8 * kExample.size(); ++bit) {
        Bytes_ bytes = kExample;
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ 1u << bit % 8);
        EXPECT_TRUE(std::holds_alternative<Fault>(parse(bytes))) << bit;
    }
}

TEST(RdmMessage, the_longest_and_what_follows_it) {
    Message message;
    message.data.assign(kMaxDataBytes, 7);
    Bytes_ bytes = build(message);
    EXPECT_EQ(bytes.size(), 257u);
    bytes.resize(300); // Art-Net packets may be longer
    const auto parsed = parse(bytes);
    ASSERT_TRUE(std::holds_alternative<Message>(parsed));
    EXPECT_EQ(std::get<Message>(parsed).data.size(), kMaxDataBytes);
}

TEST(RdmMessage, discovery_answers_and_collisions) {
    const Uid one{0x7FF0, 0x00000001}, other{0x7FF0, 0x00000002};
    const Bytes_ answer = build_discovery_answer(one);
    EXPECT_EQ(answer.size(), 24u);
    EXPECT_EQ(parse_discovery_answer(answer), one);
    for (std::size_t missing = 1; missing <= 7; ++missing) // preambles get lost on a line
        EXPECT_EQ(parse_discovery_answer(Bytes(answer).subspan(missing)), one);
    for (std::size_t size = 0; size < answer.size(); ++size)
        EXPECT_FALSE(parse_discovery_answer(Bytes(answer).first(size)).has_value());
    Bytes_ collided = build_discovery_answer(other);
    for (std::size_t i = 0; i < collided.size(); ++i) collided[i] |= answer[i];
    EXPECT_FALSE(parse_discovery_answer(collided).has_value());
}

TEST(RdmMessage, whom_a_uid_means) {
    const Uid one{0x7FF0, 5};
    EXPECT_TRUE(one.means(one));
    EXPECT_TRUE(kAll.means(one));
    EXPECT_TRUE(kAllOfOurs.means(one));
    EXPECT_FALSE((Uid{0x7FF1, 0xFFFFFFFF}.means(one)));
    EXPECT_FALSE((Uid{0x7FF0, 6}.means(one)));
    EXPECT_EQ(Uid::of(one.number()), one);
}

} // namespace
} // namespace ghost::rdm
