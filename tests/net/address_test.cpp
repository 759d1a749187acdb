// SPDX-License-Identifier: Apache-2.0
#include "net/address.h"
#include "net/socket.h"

#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

TEST(Address, text_of_both_kinds) {
    EXPECT_EQ(address_text(0x0A000102), "10.0.1.2");
    EXPECT_EQ(address_text({}), "-");
    // RFC 5952
    for (const char* text : {"fe80::1", "::1", "2001:db8::", "2001:db8:0:1:1:1:1:1", "2001:0:0:1::1",
                             "ff18::8300:1", "1:2:3:4:5:6:7:8"}) {
        const auto address = parse_address(text);
        ASSERT_TRUE(address.ok()) << text;
        EXPECT_EQ(address_text(*address), text);
        EXPECT_FALSE(address->is_ipv4());
        EXPECT_EQ(address->ipv4(), 0u);
    }
    EXPECT_FALSE(parse_address("10.0.0").ok());
    EXPECT_EQ(*parse_address("10.0.0.2"), IpAddress(0x0A000002));
}

TEST(Address, kinds) {
    EXPECT_TRUE(IpAddress(0xEFFF0001).is_multicast());
    EXPECT_TRUE(parse_address("ff18::8300:1")->is_multicast());
    EXPECT_FALSE(IpAddress(0x0A000001).is_multicast());
    EXPECT_TRUE(IpAddress(0x7F000002).is_loopback());
    EXPECT_TRUE(parse_address("::1")->is_loopback());
    EXPECT_FALSE(IpAddress().is_loopback());
    EXPECT_EQ(IpAddress(0x0A000102).ipv4(), 0x0A000102u);
}

} // namespace
} // namespace ghost::dmx
