// SPDX-License-Identifier: Apache-2.0
#include "net/port_users.h"

#include <array>
#include <gtest/gtest.h>

namespace ghost::dmx {
namespace {

// As a kernel wrote it.
constexpr const char* kUdp = "   sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   "
                             "uid  timeout inode ref pointer drops\n"
                             "  389: 00000000:1936 00000000:0000 07 00000000:00000000 00:00000000 00000000   "
                             "  0        0 29573 2 0000000000000000 0\n"
                             " 1555: 0201007F:15C0 00000000:0000 07 00000000:00000000 00:00000000 00000000  "
                             "1000        0 30001 2 0000000000000000 0\n"
                             " 1556: 0100007F:0035 00000000:0000 07 00000000:00000000 00:00000000 00000000   "
                             "101        0 30002 2 0000000000000000 0\n"
                             "garbage\n"
                             " 1557: 0100007F:1936 00000000:0000 07 00000000:00000000 00:00000000 00000000   "
                             "101        0 x 2 0000000000000000 0\n"
                             " 1558: 01007F:1936 00000000:0000 07 00000000:00000000 00:00000000 00000000   "
                             "101        0 30003 2 0000000000000000 0\n";
constexpr const char* kUdp6 =
    "  sl  local_address                         remote_address                        st tx_queue rx_queue "
    "tr tm->when retrnsmt   uid  timeout inode ref pointer drops\n"
    " 1555: 000080FE00000000FF005450B6AD1DFE:15C0 00000000000000000000000000000000:0000 07 00000000:00000000 "
    "00:00000000 00000000     0        0 41000 2 0000000000000000 0\n";

TEST(PortUsers, reads_what_the_kernel_lists) {
    const std::array<std::uint16_t, 2> ports{5568, 6454};
    const auto v4 = parse_listed_sockets(kUdp, ports);
    ASSERT_EQ(v4.size(), 2u);
    EXPECT_EQ(v4[0], (ListedSocket{IpAddress(0u), 6454, 29573}));
    EXPECT_EQ(v4[1], (ListedSocket{IpAddress(0x7F000102), 5568, 30001}));
    const auto v6 = parse_listed_sockets(kUdp6, ports);
    ASSERT_EQ(v6.size(), 1u);
    EXPECT_EQ(address_text(v6[0].address), "fe80::5054:ff:fe1d:adb6");
    EXPECT_TRUE(parse_listed_sockets("", ports).empty());
}

TEST(PortUsers, every_truncation_of_the_list_is_harmless) {
    const std::array<std::uint16_t, 1> ports{6454};
    const std::string text = kUdp;
    for (std::size_t size = 0; size < text.size(); ++size)
        EXPECT_LE(parse_listed_sockets(text.substr(0, size), ports).size(), 1u);
}

TEST(PortUsers, have_names) {
    EXPECT_EQ(program_text(PortUser{IpAddress(0u), 6454, 123, "olad"}), "olad (pid 123)");
    EXPECT_EQ(program_text(PortUser{}), "a program of another user");
}

} // namespace
} // namespace ghost::dmx
