// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/catch_up.h"

#include <gtest/gtest.h>

#include <map>

namespace ghost::dmx {
namespace {

using namespace std::chrono_literals;

// Levels of universes that grow: revision and level are the same number.
Universes looks(const std::map<std::uint16_t, std::uint8_t>& levels) {
    Universes result;
    for (const auto& [number, level] : levels) {
        auto slots = std::make_shared<Levels>();
        slots->fill(level);
        Universe& universe = result.at(number);
        universe.levels = slots;
        universe.revision = level;
        result.revision = std::max<std::uint64_t>(result.revision, level);
    }
    return result;
}

bool heard(std::uint16_t) {
    return true;
}
bool not_heard(std::uint16_t) {
    return false;
}

TEST(CatchUp, without_a_pause_all_is_shown) {
    CatchUp catch_up;
    EXPECT_FALSE(catch_up.active());
    EXPECT_EQ(catch_up.view(looks({{1, 7}}), not_heard).level(1, 1), 7);
    EXPECT_FALSE(catch_up.expire(100s));
}

TEST(CatchUp, what_waited_is_not_shown_before_all_of_it_was_read) {
    CatchUp catch_up;
    catch_up.begin(looks({{1, 3}}), 10s);
    EXPECT_TRUE(catch_up.reading());
    EXPECT_EQ(catch_up.view(looks({{1, 5}}), heard).level(1, 1), 3);
    catch_up.read_all(false);
    EXPECT_FALSE(catch_up.active());
    EXPECT_EQ(catch_up.view(looks({{1, 6}}), not_heard).level(1, 1), 6);
}

TEST(CatchUp, where_something_was_lost_each_universe_waits_for_its_sources) {
    CatchUp catch_up;
    catch_up.begin(looks({{1, 3}, {2, 4}}), 10s);
    catch_up.read_all(true);
    EXPECT_TRUE(catch_up.active());
    EXPECT_FALSE(catch_up.reading());
    const Universes newest = looks({{1, 5}, {2, 9}, {3, 20}});
    const Universes first = catch_up.view(newest, [](std::uint16_t universe) { return universe == 2; });
    EXPECT_EQ(first.level(1, 1), 3);
    EXPECT_EQ(first.level(2, 1), 9);
    EXPECT_EQ(first.find(3), nullptr) << "it came in the pause";
    // Who looks at revisions only must see each step.
    EXPECT_EQ(first.revision, 9u);
    const Universes all = catch_up.view(newest, heard);
    EXPECT_EQ(all.level(1, 1), 5);
    EXPECT_EQ(all.level(3, 1), 20);
    EXPECT_GT(all.revision, first.revision);
    EXPECT_FALSE(catch_up.active());
}

TEST(CatchUp, nothing_is_held_back_for_longer_than_a_second) {
    CatchUp catch_up;
    catch_up.begin(looks({{1, 3}}), 10s);
    EXPECT_FALSE(catch_up.expire(10999ms));
    // Pause after pause, and a flood that never lets the sockets run dry.
    catch_up.begin(looks({{1, 4}}), 10500ms);
    EXPECT_EQ(catch_up.view(looks({{1, 5}}), heard).level(1, 1), 3);
    EXPECT_EQ(catch_up.since(), 10500ms);
    EXPECT_TRUE(catch_up.expire(11s));
    EXPECT_EQ(catch_up.view(looks({{1, 5}}), not_heard).level(1, 1), 5);
    EXPECT_FALSE(catch_up.expire(12s));
}

} // namespace
} // namespace ghost::dmx
