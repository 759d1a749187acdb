// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/private/wider.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;
using Numbers = std::vector<std::uint16_t>;

DiscoveredSource desk(const Numbers& universes) {
    DiscoveredSource result;
    result.universes = std::make_shared<const Numbers>(universes);
    return result;
}

bool has(const Numbers& list, std::uint16_t universe) {
    return std::binary_search(list.begin(), list.end(), universe);
}

TEST(Wider, neighbours_what_is_announced_and_the_first) {
    const Numbers chosen = wider_universes({300, 63999}, {desk({7, 4000, 64214})});
    for (const std::uint16_t universe : Numbers{299, 301, 63998, 1, 64, 7, 4000})
        EXPECT_TRUE(has(chosen, universe));
    EXPECT_FALSE(has(chosen, 64000));
    EXPECT_FALSE(has(chosen, 64214));
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
}

TEST(Wider, however_much_is_silent_or_announced_it_stays_within_its_budget) {
    Numbers silent, announced;
    for (int i = 0; i < 512; ++i) {
        silent.push_back(static_cast<std::uint16_t>(1000 + 3 * i));
        announced.push_back(static_cast<std::uint16_t>(20000 + i));
    }
    const Numbers chosen = wider_universes(silent, {desk(announced), desk(announced)});
    EXPECT_EQ(chosen.size(), kMostWider);
    EXPECT_TRUE(has(chosen, 1));
    EXPECT_TRUE(has(chosen, 20000)) << "something of each";
    EXPECT_TRUE(has(chosen, 999));
}

TEST(Wider, only_while_something_is_silent) {
    Wider wider;
    wider.update({5}, {}, 10s);
    EXPECT_TRUE(wider.universes().empty()) << "it may be about to come";
    wider.update({5}, {}, 12s);
    EXPECT_TRUE(has(wider.universes(), 4));
    wider.update({}, {}, 13s);
    EXPECT_FALSE(wider.universes().empty()) << "it may go again";
    wider.update({5}, {}, 16s);
    wider.update({}, {}, 17s);
    EXPECT_FALSE(wider.universes().empty());
    wider.update({}, {}, 22s);
    EXPECT_TRUE(wider.universes().empty());
    wider.update({5}, {}, 30s);
    EXPECT_TRUE(wider.universes().empty());
}

} // namespace
} // namespace ghost::dmx
