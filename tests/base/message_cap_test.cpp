// SPDX-License-Identifier: Apache-2.0
// Which messages are kept of a file that gives rise to thousands.
#include "base/message_list.h"

#include <gtest/gtest.h>

namespace ghost::fixture {
namespace {

TEST(message_cap, keeps_the_first_of_every_kind_and_counts_the_rest) {
    MessageList list;
    for (int i = 0; i < 3000; ++i) list.say(Severity::note, "a.qxf:1", "odd value " + std::to_string(i));
    for (int i = 0; i < 3; ++i)
        list.say(Severity::error, "a.qxf:9", "more than " + std::to_string(i) + " modes");
    const std::vector<Message> messages = std::move(list).take();
    ASSERT_EQ(messages.size(), kMaxMessages + 2);
    EXPECT_EQ(messages[0].what, "odd value 0 (and 2500 more of this kind)");
    EXPECT_EQ(messages[kMaxMessages].what, "more than 0 modes (and 2 more of this kind)");
    EXPECT_EQ(messages.back().what,
              "2502 more messages are not listed, but the first of each kind: 2 losses, 2500 notes");
    EXPECT_EQ(messages.back().severity, Severity::error);
    // Sentences without end stay bounded.
    MessageCap cap;
    std::size_t taken = 0;
    for (int i = 0; i < 5000; ++i) {
        std::string letters;
        for (int left = i; left > 0; left /= 20) letters += static_cast<char>('a' + left % 20);
        taken += cap.takes(2, letters, taken);
    }
    EXPECT_LE(taken, kMaxMessages + kMaxMessageKinds);
}

} // namespace
} // namespace ghost::fixture
