// SPDX-License-Identifier: Apache-2.0
// Who reads a slot: movers beside fixtures, so that a receiver joins their universes.
#include "diagnose/patch_map.h"
#include "show/show.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

TEST(PatchMap, movers_read_their_channels) {
    Show show;
    Mover& lift = show.movers.emplace_back();
    lift.name = "Lift";
    MoverAxis& height = lift.axes.emplace_back();
    height.name = "height";
    height.levels = {{9, 10}, {9, 11}};
    const PatchMap patch(show);
    EXPECT_EQ(patch.universe_numbers(), (std::vector<std::uint16_t>{9}));
    EXPECT_EQ(patch.universes()[0].first, "Lift");
    ASSERT_EQ(patch.at(9, 11).size(), 1u);
    EXPECT_EQ(patch.at(9, 11)[0]->fixture_name, "Lift");
    EXPECT_EQ(patch.at(9, 11)[0]->channel, "height (2 of 2)");
    EXPECT_TRUE(patch.at(9, 12).empty());
}

} // namespace
} // namespace ghost::scene
