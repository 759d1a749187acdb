// SPDX-License-Identifier: Apache-2.0
#include "net/socket.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

TEST(OnLink, neighbours_share_the_network_of_the_interface) {
    NetInterface interface;
    interface.address = 0xC0A80105; // 192.168.1.5/24
    interface.netmask = 0xFFFFFF00;
    EXPECT_TRUE(is_on_link(interface, 0xC0A801FEu));
    EXPECT_TRUE(is_on_link(interface, 0xC0A80105u));
    EXPECT_FALSE(is_on_link(interface, 0xC0A80205u));
    EXPECT_FALSE(is_on_link(interface, 0x08080808u));
    EXPECT_TRUE(is_on_link(interface, *parse_address("fe80::1")));
    EXPECT_FALSE(is_on_link(interface, *parse_address("2001:db8::1")));
    interface.address = 0; // IPv6 only
    EXPECT_FALSE(is_on_link(interface, 0xC0A801FEu));
}

} // namespace
} // namespace ghost::dmx
