// SPDX-License-Identifier: Apache-2.0
// The demo recording holds what the demo promises: looks, moves, gobos turning both ways, a strobe hit, a
// blackout.
#include "dmx/record/player.h"

#include <gtest/gtest.h>

#include <set>

namespace ghost::dmx {
namespace {

constexpr int kSpots[] = {1, 23, 45, 67, 89}, kWashes[] = {111, 126, 141, 156, 171};

TEST(DemoRecording, is_a_show) {
    auto recording = read_recording(std::filesystem::path(GHOST_SOURCE_DIR) / "assets/demo/demo.show");
    ASSERT_TRUE(recording.ok()) << recording.error().text();
    EXPECT_TRUE(recording->problems.empty());
    const auto universes = recording->first_frames();
    ASSERT_EQ(universes.size(), 1u);
    EXPECT_EQ(universes.begin()->first, 1);
    Player player(std::move(*recording));
    EXPECT_GE(player.duration_s(), 75.0);

    double dark_s = 0.0, longest_dark_s = 0.0, turned_right_s = 0.0, turned_left_s = 0.0, strobed_s = 0.0;
    std::set<int> pans, tilts, colours, wheel, fixed_gobos, rotating_gobos, irises, zooms;
    constexpr double kStep_s = 0.02;
    for (double t = 0.0; t < player.duration_s(); t += kStep_s) {
        const Universes levels = player.at(t);
        const auto at = [&](int address) { return static_cast<int>(levels.level(1, address)); };
        bool lit = false, strobe = true;
        for (const int first : kSpots) {
            lit = lit || at(first) > 0;
            if (at(first) == 0) continue;
            strobe = strobe && at(first + 10) >= 13;
            pans.insert(at(first + 1) << 8 | at(first + 2));
            tilts.insert(at(first + 3) << 8 | at(first + 4));
            colours.insert(at(first + 5) << 16 | at(first + 6) << 8 | at(first + 7));
            wheel.insert(at(first + 8));
            zooms.insert(at(first + 11));
            fixed_gobos.insert(at(first + 12));
            rotating_gobos.insert(at(first + 13));
            irises.insert(at(first + 16));
            const int rotation = at(first + 14) << 8 | at(first + 15);
            if (at(first + 13) > 137) (rotation < 32536 ? turned_right_s : turned_left_s) += kStep_s;
        }
        for (const int first : kWashes) {
            lit = lit || at(first) > 0;
            strobe = strobe && (at(first) == 0 || at(first + 10) >= 13);
        }
        if (lit && strobe) strobed_s += kStep_s;
        dark_s = lit ? 0.0 : dark_s + kStep_s;
        if (t > 10.0 && t < 85.0) longest_dark_s = std::max(longest_dark_s, dark_s);
    }
    EXPECT_GT(longest_dark_s, 1.0); // the blackout
    EXPECT_GT(strobed_s, 1.0);
    EXPECT_GT(turned_right_s, 5.0); // summed over fixtures
    EXPECT_GT(turned_left_s, 5.0);
    EXPECT_GT(pans.size(), 1000u); // moves use all 16 bits
    EXPECT_GT(tilts.size(), 1000u);
    EXPECT_GT(colours.size(), 10u);
    EXPECT_GT(wheel.size(), 10u);
    EXPECT_GT(fixed_gobos.size(), 3u);
    EXPECT_GT(rotating_gobos.size(), 4u);
    EXPECT_GT(irises.size(), 20u);
    EXPECT_GT(zooms.size(), 20u);
}

} // namespace
} // namespace ghost::dmx
