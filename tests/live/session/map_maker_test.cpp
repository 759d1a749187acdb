// SPDX-License-Identifier: Apache-2.0
// Distance maps that are made while something else goes on: all of them arrive once, they are the maps that
// waiting gives, and an interruption keeps what is finished.
#include "live/session/map_maker.h"

#include "bake/distance_maps.h"
#include "passes/distance_maps_file.h"

#include "support/test_show.h"

#include <chrono>
#include <map>
#include <thread>

namespace ghost::app {
namespace {

constexpr int kSize = 64;

scene::Show lamps(const std::filesystem::path& folder, int count) {
    scene::Show show;
    show.folder = folder;
    show.stage = bake::edgy_stage();
    for (int k = 0; k < count; ++k)
        bake::add_fixture(show, "Lamp " + std::to_string(k + 1),
                          {-2.0f + 0.3f * static_cast<float>(k), 1.0f, 3.2f});
    return show;
}

struct Arrived {
    std::map<std::size_t, scene::DistanceMap> maps;
    std::size_t deliveries = 0;
    MapMaker::Outcome outcome;
};

void add(Arrived& arrived, MapMaker& maker) {
    while (auto made = maker.take()) {
        ++arrived.deliveries;
        arrived.maps[made->index] = std::move(made->map);
    }
}

Arrived wait_for_all(MapMaker& maker) {
    Arrived arrived;
    for (int k = 0; k < 60000; ++k) {
        add(arrived, maker);
        if (auto outcome = maker.outcome()) {
            arrived.outcome = std::move(*outcome);
            return arrived;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ADD_FAILURE() << "no outcome after a minute";
    return arrived;
}

scene::DistanceMaps made_at_once(const scene::Show& show) {
    scene::DistanceMaps maps;
    Report report;
    bake::DistanceMapOptions options;
    options.size = kSize;
    EXPECT_TRUE(bake::update_distance_maps(show, show.stage, options, maps, report).ok());
    return maps;
}

TEST(map_maker, AllMapsArriveOnceAndAreWhatWaitingGives) {
    const bake::TestFolder here, there;
    const scene::Show show = lamps(here.path, 9);
    MapMaker maker(show, show.stage, kSize, {});
    const Arrived arrived = wait_for_all(maker);
    EXPECT_FALSE(arrived.outcome.error);
    EXPECT_FALSE(arrived.outcome.interrupted);
    EXPECT_EQ(arrived.deliveries, 9u);
    EXPECT_FALSE(maker.outcome()) << "only once";
    const scene::DistanceMaps expected = made_at_once(lamps(there.path, 9));
    ASSERT_EQ(arrived.maps.size(), expected.maps.size());
    for (const auto& [index, map] : arrived.maps) {
        EXPECT_EQ(map.fixture, expected.maps[index].fixture);
        EXPECT_EQ(map.distance, expected.maps[index].distance);
        EXPECT_EQ(map.nearest_m, expected.maps[index].nearest_m);
        EXPECT_EQ(map.farthest_m, expected.maps[index].farthest_m);
    }
}

TEST(map_maker, KeptMapsArriveTooUnlessTheyAreKnown) {
    const bake::TestFolder folder;
    const scene::Show show = lamps(folder.path, 4);
    made_at_once(show);
    MapMaker ignorant(show, show.stage, kSize, {});
    EXPECT_EQ(wait_for_all(ignorant).maps.size(), 4u);
    MapMaker knowing(show, show.stage, kSize, {0, 2, 3});
    const Arrived arrived = wait_for_all(knowing);
    ASSERT_EQ(arrived.deliveries, 1u);
    EXPECT_EQ(arrived.maps.begin()->first, 1u);
}

// Of a few hundred that would be seconds, for which a closed window would stay.
TEST(map_maker, OneThatIsStoppedReadsNoKeptMapAndLosesNone) {
    const bake::TestFolder folder;
    scene::Show show = lamps(folder.path, 4);
    made_at_once(show);
    const scene::Stage stage = show.stage;
    for (scene::Instance& instance : show.stage.instances)
        if (instance.world[3].y > 5) instance.world[3].x += 50; // to where no lamp sees it
    bake::DistanceMapOptions options;
    options.size = kSize;
    scene::DistanceMaps maps;
    Report report;
    options.stop = [] { return true; };
    const auto stopped = bake::update_distance_maps(show, show.stage, options, maps, report);
    ASSERT_TRUE(stopped.ok());
    EXPECT_TRUE(stopped->interrupted);
    EXPECT_EQ(stopped->kept, 0);
    show.stage = stage;
    options.stop = {};
    const auto again = bake::update_distance_maps(show, show.stage, options, maps, report);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->kept, 4);
}

TEST(map_maker, AKnownMapOfAnotherStageIsReplaced) {
    const bake::TestFolder folder;
    scene::Show show = lamps(folder.path, 3);
    const scene::DistanceMaps before = made_at_once(show);
    for (scene::Instance& instance : show.stage.instances) instance.world[3].z += 0.25f;
    MapMaker maker(show, show.stage, kSize, {0, 1, 2});
    const Arrived arrived = wait_for_all(maker);
    ASSERT_EQ(arrived.maps.size(), 3u);
    for (const auto& [index, map] : arrived.maps) EXPECT_NE(map.distance, before.maps[index].distance);
}

TEST(map_maker, AnInterruptionKeepsWhatIsFinished) {
    const bake::TestFolder folder;
    const scene::Show show = lamps(folder.path, 40);
    Arrived first;
    {
        MapMaker maker(show, show.stage, kSize, {});
        while (first.maps.empty()) add(first, maker);
    } // stopped and waited for
    scene::DistanceMaps all;
    Report report;
    bake::DistanceMapOptions options;
    options.size = kSize;
    const auto stats = bake::update_distance_maps(show, show.stage, options, all, report);
    ASSERT_TRUE(stats.ok());
    EXPECT_GE(stats->kept, static_cast<int>(first.maps.size()));
    ASSERT_EQ(all.maps.size(), 40u);
    for (const auto& [index, map] : first.maps) EXPECT_EQ(map.distance, all.maps[index].distance);
    for (int k = 0; k < 20; ++k) MapMaker(show, show.stage, kSize, {}); // at once
}

TEST(map_maker, AWrongSizeIsAnOutcome) {
    const bake::TestFolder folder;
    const scene::Show show = lamps(folder.path, 1);
    MapMaker maker(show, show.stage, 3, {});
    const Arrived arrived = wait_for_all(maker);
    EXPECT_TRUE(arrived.outcome.error);
    EXPECT_EQ(arrived.deliveries, 0u);
}

} // namespace
} // namespace ghost::app
