// SPDX-License-Identifier: Apache-2.0
#include "net/reverse_path.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

TEST(ReversePath, the_kernels_table_is_read) {
    EXPECT_EQ(parse_reverse_path_drops("TcpExt: SyncookiesSent IPReversePathFilter TW\nTcpExt: 3 412 9\n"
                                       "IpExt: InNoRoutes\nIpExt: 7\n"),
              412u);
    EXPECT_EQ(parse_reverse_path_drops("IpExt: InNoRoutes\nIpExt: 7\n"
                                       "TcpExt: IPReversePathFilter\nTcpExt: 5"),
              5u);
}

TEST(ReversePath, a_table_without_it_or_that_is_none_says_0) {
    for (const char* text :
         {"", "\n\n", "TcpExt: A\nTcpExt: 1\n", "TcpExt: IPReversePathFilter\n",
          "TcpExt: IPReversePathFilter\nTcpExt:\n", "TcpExt: IPReversePathFilter\nTcpExt: x\n",
          "TcpExt: IPReversePathFilter\nIpExt: 4\n",
          "TcpExt: IPReversePathFilter\nTcpExt: 99999999999999999999999\n"})
        EXPECT_EQ(parse_reverse_path_drops(text), 0u) << text;
}

} // namespace
} // namespace ghost::dmx
