// SPDX-License-Identifier: Apache-2.0
// Memberships are a budget: however many universes are wanted, descriptors are left for everything else.
#include "dmx/receive/private/groups.h"

#include "support/must.h"

#include <gtest/gtest.h>

#include <numeric>

namespace ghost::dmx {
namespace {

TEST(Groups, sockets_have_an_end_which_is_said) {
    std::vector<std::unique_ptr<UdpSocket>> opened;
    Groups groups(false, [&]() -> Result<UdpSocket*> {
        TRY(auto socket, UdpSocket::open(0, 0, 1 << 12));
        return opened.emplace_back(std::move(socket)).get();
    });
    const NetInterface loopback = must(find_interface("127.0.0.1"));
    std::vector<std::uint16_t> universes(kMostGroupSockets * kGroupsPerSocket + 100);
    std::iota(universes.begin(), universes.end(), std::uint16_t{1});
    groups.update(universes, {loopback});
    EXPECT_EQ(opened.size(), kMostGroupSockets);
    ASSERT_EQ(groups.failures().size(), 1u);
    EXPECT_NE(groups.failures()[0].find("choose the interface"), std::string::npos) << groups.failures()[0];
    universes.resize(kGroupsPerSocket);
    groups.update(universes, {loopback});
    EXPECT_TRUE(groups.failures().empty());
    EXPECT_EQ(groups.joined_by(opened.front().get()), kGroupsPerSocket);
    EXPECT_EQ(groups.joined_by(opened.back().get()), 0u);
}

} // namespace
} // namespace ghost::dmx
