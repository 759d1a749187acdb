// SPDX-License-Identifier: Apache-2.0
#include "diagnose/learn.h"

#include "show/show.h"
#include "support/explain_trial.h"

namespace ghost::scene {
namespace {

using namespace std::chrono_literals;

struct Desk {
    Learner learner;
    dmx::Levels levels{};
    dmx::Protocol protocol = dmx::Protocol::artnet;
    std::chrono::nanoseconds now = 100s;

    std::vector<Moved> look(std::chrono::nanoseconds later = 250ms) {
        dmx::Statistics statistics;
        statistics.time = now += later;
        dmx::SourceStatus source;
        source.universe = 2;
        source.protocol = protocol;
        source.id = "10.0.0.5";
        source.from = dmx::IpAddress(0x0A000005);
        source.slot_count = 512;
        dmx::SourceSlots slots;
        slots.levels = levels;
        source.slots = std::make_shared<const dmx::SourceSlots>(slots);
        statistics.sources = {source};
        return learner.feed(statistics);
    }
    void listen() {
        while (learner.listens_first()) EXPECT_TRUE(look().empty());
    }
};

TEST(Learner, SaysWhichFaderMovedOnce) {
    Desk desk;
    desk.levels[99] = 40;
    desk.listen();
    EXPECT_TRUE(desk.look().empty());
    desk.levels[99] = 47;
    EXPECT_TRUE(desk.look().empty()) << "less than a move";
    desk.levels[99] = 60;
    const auto moved = desk.look();
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_EQ(moved[0].universe, 2);
    EXPECT_EQ(moved[0].address, 100);
    EXPECT_EQ(moved[0].from, 40);
    EXPECT_EQ(moved[0].to, 60);
    for (int level = 80; level < 250; level += 20) {
        desk.levels[99] = static_cast<std::uint8_t>(level);
        EXPECT_TRUE(desk.look().empty()) << "it goes on moving";
    }
    EXPECT_TRUE(desk.look(1s).empty());
    desk.levels[99] = 0;
    EXPECT_EQ(desk.look().size(), 1u) << "it rested, and moves again";
}

TEST(Learner, LeavesOutWhatMovesByItself) {
    Desk desk;
    std::uint8_t chase = 0;
    while (desk.learner.listens_first()) {
        desk.levels[5] = chase += 50;
        EXPECT_TRUE(desk.look().empty());
    }
    for (int i = 0; i < 20; ++i) {
        desk.levels[5] = chase += 50;
        if (i == 10) desk.levels[6] = 255;
        const auto moved = desk.look();
        ASSERT_EQ(moved.size(), i == 10 ? 1u : 0u);
        if (i == 10) {
            EXPECT_EQ(moved[0].address, 7);
        }
    }
}

TEST(Learner, ACueIsNoFader) {
    Desk desk;
    desk.listen();
    desk.levels.fill(200);
    EXPECT_TRUE(desk.look().empty());
    EXPECT_EQ(desk.learner.too_many(), 512u);
    desk.levels[0] = 0;
    EXPECT_EQ(desk.look(1s).size(), 1u);
    EXPECT_EQ(desk.learner.too_many(), 0u);
}

TEST(Learner, NamesTheFixtureHereOrOneBeside) {
    Show show;
    PatchedFixture fixture;
    fixture.name = "Spot 1";
    fixture.type = trial::type_of(trial::kDimmer);
    fixture.universe = 2;
    fixture.address = 17;
    show.fixtures = {fixture};
    const PatchMap patch(show);
    Moved moved{2, 17, 0, 255, dmx::Protocol::artnet, "10.0.0.5 (Art-Net)"};
    EXPECT_EQ(moved_text(moved, patch, 1),
              "universe 2 address 17 (Port-Address 0:0:1) from 10.0.0.5 (Art-Net): "
              "0 -> 255 is 'Spot 1' Beam_Dimmer");
    moved.universe = 3;
    EXPECT_EQ(
        moved_text(moved, patch, 1),
        "universe 3 address 17 (Port-Address 0:0:2) from 10.0.0.5 (Art-Net): 0 -> 255, nothing is patched "
        "there; off by one? on universe 2 it would be 'Spot 1' Beam_Dimmer (--artnet-offset 0)");
    moved = {1, 17, 0, 255, dmx::Protocol::sacn, "'Desk' (10.0.0.5)"};
    const std::string text = moved_text(moved, patch, 1);
    EXPECT_NE(text.find("on universe 2 it would be 'Spot 1' Beam_Dimmer (the desk's output"),
              std::string::npos)
        << text;
    moved.address = 18;
    EXPECT_NE(moved_text(moved, patch, 1).find("nothing is patched there"), std::string::npos);
    EXPECT_EQ(moved_text(moved, PatchMap(), 1).find("patched"), std::string::npos);
}

} // namespace
} // namespace ghost::scene
