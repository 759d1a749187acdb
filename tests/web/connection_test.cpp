// SPDX-License-Identifier: Apache-2.0
// How long a connection that ends has for what is still to be sent.
#include "support/must.h"
#include "web/private/connection.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace ghost::web {
namespace {

struct Ends {
    Ends() {
        const auto listener = must(dmx::TcpListener::open(0x7F000001, 0));
        peer = must(dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), listener->port()));
        for (int i = 0; i < 1000 && !ours; ++i) {
            ours = listener->accept();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    std::unique_ptr<dmx::TcpStream> peer, ours;
};

TEST(Connection, an_answer_that_nobody_reads_has_a_minute) {
    Ends ends;
    ASSERT_TRUE(ends.ours);
    Connection connection(std::move(ends.ours), 0);
    connection.put(std::vector<std::uint8_t>(64u << 20));
    ASSERT_TRUE(connection.send(0));
    ASSERT_GT(connection.unsent(), 0u);
    EXPECT_FALSE(connection.is_in_answer(0)) << "it does not end yet";
    EXPECT_FALSE(connection.is_over(1000)) << "it does not end yet";
    connection.end(1000);
    EXPECT_FALSE(connection.is_in_answer(1000)) << "nothing moved for long";
    EXPECT_FALSE(connection.is_over(1060));
    EXPECT_TRUE(connection.is_over(1060.01));
}

TEST(Connection, an_answer_that_moves_is_on_its_way) {
    Ends ends;
    ASSERT_TRUE(ends.ours);
    Connection connection(std::move(ends.ours), 0);
    connection.put(std::make_shared<const std::string>(64u << 20, 'a'));
    connection.end(0);
    ASSERT_TRUE(connection.send(10));
    EXPECT_TRUE(connection.is_in_answer(12));
    EXPECT_FALSE(connection.is_in_answer(14));
}

TEST(Connection, what_is_sent_is_read_for_a_second) {
    Ends ends;
    ASSERT_TRUE(ends.ours);
    Connection connection(std::move(ends.ours), 0);
    connection.put("bye");
    ASSERT_TRUE(connection.send(0));
    EXPECT_EQ(connection.unsent(), 0u);
    connection.end(10);
    EXPECT_FALSE(connection.is_over(40));
    EXPECT_FALSE(connection.is_over(41));
    EXPECT_TRUE(connection.is_over(41.01));
}

} // namespace
} // namespace ghost::web
