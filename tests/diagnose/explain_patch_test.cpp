// SPDX-License-Identifier: Apache-2.0
// Every verdict about what lies before a fixture: its file, its patch, universes and who sends them.
#include "show/show.h"
#include "support/explain_trial.h"

namespace ghost::scene {
namespace {

using namespace trial;
using namespace std::chrono_literals;

TEST(explain, FixtureFileMissing) {
    Trial trial;
    trial.add("Lamp", nullptr, 1);
    trial.report.add(Severity::error, "show.toml:9",
                     "no such file lamps/tiny.gdtf, did you mean 'tony.gdtf'? Its fixtures stay dark.");
    expect(trial.explain(), Visibility::dark, Cause::no_type,
           {"dark because its fixture file lamps/tiny.gdtf is missing or cannot be read",
            "did you mean 'tony.gdtf'?"});
    trial.show.fixtures[0].gdtf.clear();
    expect(trial.explain(), Visibility::dark, Cause::no_type, {"names no fixture file"});
}

TEST(explain, ModeMissing) {
    Trial trial(type_of(kDimmer));
    trial.report.add(Severity::error, "show.toml:9",
                     "[[fixture]] 'Lamp' 'Tiny' has no mode 'Long' (modes: 'Standard'); it gets 'Standard'");
    expect(trial.set(1, 0).explain(), Visibility::dark, Cause::no_mode,
           {"its mode is not in the file: 'Tiny' has no mode 'Long'", "it gets 'Standard'",
            "the dimmer on channel 1"});
    const Explanation lit = trial.set(1, 255).explain();
    expect(lit, Visibility::lit, Cause::none, {});
    ASSERT_TRUE(find(lit, Cause::no_mode));
    EXPECT_FALSE(find(lit, Cause::no_mode)->blocks);
}

TEST(explain, ModeThatNobodyNames) {
    Trial trial(type_of(kDimmer));
    trial.show.fixtures[0].is_mode_known = false;
    const Explanation dark = trial.set(1, 0).explain();
    expect(dark, Visibility::dark, Cause::no_mode,
           {"dark because no mode of its type is chosen: give it one (Mode in the list of fixtures, or mode "
            "= in "
            "the show file); what follows is of mode 'Standard'",
            "the dimmer on channel 1"});
    EXPECT_NE(words_of(dark, trial.reception).find("mode not known, read as 'Standard'"), std::string::npos);
    EXPECT_NE(json_of(dark, trial.reception).find("\"mode_known\": false"), std::string::npos);
    const Explanation lit = trial.set(1, 255).explain();
    expect(lit, Visibility::lit, Cause::none, {});
    ASSERT_TRUE(find(lit, Cause::no_mode));
    EXPECT_FALSE(find(lit, Cause::no_mode)->blocks);
}

TEST(explain, PlaceOrTurnThatNobodySays) {
    Trial trial(type_of(kDimmer));
    trial.set(1, 255);
    EXPECT_TRUE(trial.explain().beams[0].hit);
    trial.show.fixtures[0].is_rotation_known = false;
    const Explanation turned = trial.explain();
    expect(turned, Visibility::lit, Cause::none, {"(nobody says how it is turned)"});
    EXPECT_TRUE(find(turned, Cause::no_place));
    EXPECT_FALSE(turned.beams[0].hit);
    EXPECT_NE(words_of(turned, trial.reception).find("m; where to is not known"), std::string::npos);
    EXPECT_NE(json_of(turned, trial.reception).find("\"direction\": null"), std::string::npos);
    trial.show.fixtures[0].is_place_known = false;
    const Explanation placed = trial.explain();
    expect(placed, Visibility::lit, Cause::none, {"what it hits is not known (nobody says its place)"});
    const std::string words = words_of(placed, trial.reception);
    EXPECT_EQ(words.find("from x "), std::string::npos) << words;
    EXPECT_NE(words.find("hits      not known, nobody says a place that can be used"), std::string::npos)
        << words;
    EXPECT_NE(json_of(placed, trial.reception).find("\"lens_m\": null"), std::string::npos);
}

TEST(explain, AddressThatCannotBeRead) {
    Trial trial(type_of(kDimmer));
    trial.show.fixtures[0].address = 0;
    trial.show.fixtures[0].is_address_known = false;
    const Explanation dark = trial.set(1, 255).explain();
    expect(dark, Visibility::dark, Cause::no_address,
           {"dark because its address cannot be read: without an address its channels keep their defaults",
            "the dimmer on channel 1 is at its default 0"});
    EXPECT_NE(words_of(dark, trial.reception).find("an address that cannot be read (1 channels)"),
              std::string::npos);
}

TEST(explain, NotPatched) {
    Trial trial(type_of(kDimmer));
    trial.show.fixtures[0].address = 0;
    expect(trial.set(1, 255).explain(), Visibility::dark, Cause::not_patched,
           {"it is not patched", "the dimmer on channel 1 is at its default 0"});
}

TEST(explain, NoDmxAtAll) {
    Trial trial(type_of(kDimmer));
    trial.reception = {};
    expect(trial.explain(), Visibility::dark, Cause::no_input,
           {"there is no DMX: the show has no recording", "keep their defaults", "default 0"});
    // A lamp whose defaults shine, does.
    Trial bright(type_of(simple("1", "Dimmer", 0, 1, "Default=\"255/1\"")));
    bright.reception = {};
    const Explanation lit = bright.explain();
    expect(lit, Visibility::lit, Cause::none, {});
    EXPECT_TRUE(find(lit, Cause::no_input));
}

// It would shine, and the picture has it dark.
TEST(explain, HeadThatNobodyAsks) {
    Trial trial(type_of(simple("1", "Dimmer", 0, 1, "Default=\"255/1\"")));
    trial.reception = {};
    trial.leaves_unasked_dark = true;
    const Explanation dark = trial.explain();
    expect(dark, Visibility::dark, Cause::unasked,
           {"dark because nobody asks for it, no desk, no recording and no hand: it is left dark while the "
            "work light is on (by its file alone it would give 100 % of its light)"});
    EXPECT_EQ(dark.beams.at(0).output_lm, 0);
    EXPECT_EQ(dark.beams[0].asked, 0);
    EXPECT_EQ(dark.beams[0].rest, 1);
    ASSERT_TRUE(find(dark, Cause::no_input));
    EXPECT_FALSE(find(dark, Cause::no_input)->blocks) << "it would shine without";
    EXPECT_FALSE(find(dark, Cause::several));
    EXPECT_NE(words_of(dark, trial.reception).find("asked 0 % x dimmer 100 %"), std::string::npos);
    EXPECT_NE(json_of(dark, trial.reception).find("\"cause\": \"unasked\""), std::string::npos);
    EXPECT_EQ(summary_of(trial.all()),
              "1 of 1 dark: 1 because nobody asks for them while the work light is on");
    // No fault of its patch is why, and what its file has dark is so for that.
    trial.show.fixtures[0].address = 0;
    trial.show.fixtures[0].is_mode_known = false;
    expect(trial.explain(), Visibility::dark, Cause::unasked, {"dark because nobody asks for it"});
    Trial closed(type_of(kDimmer));
    closed.reception = {};
    closed.leaves_unasked_dark = true;
    expect(closed.explain(), Visibility::dark, Cause::no_input, {"default 0"});
}

TEST(explain, UniverseNeverReceived) {
    Trial trial(type_of(kDimmer));
    trial.show.fixtures[0].universe = 3;
    expect(
        trial.set(1, 255, 1).set(1, 255, 2).explain(), Visibility::dark, Cause::never_received,
        {"universe 3 is not in the recording, which has 1 and 2", "channel 1 (3.001) is at its default 0"});
    trial.reception.first_frames_s.emplace_back(3, 40.5);
    trial.reception.at_s = 36;
    expect(trial.explain(), Visibility::dark, Cause::never_received,
           {"universe 3 begins in the recording at 40.5 s, this is 36 s"});
    trial.reception = {.kind = Reception::Kind::desk, .listened_s = 5, .packets = 0};
    expect(trial.explain(), Visibility::dark, Cause::never_received,
           {"universe 3 never arrived in 5 s; what arrives is 1 and 2"});
    // What the monitor says of this universe, or of everything.
    trial.reception.diagnosis = {{Trouble::packets_lost, true, "packets got lost", {}},
                                 {Trouble::preview, true, "marked as preview", {3}},
                                 {Trouble::off_by_one, true, "off by one?", {1}}};
    expect(trial.explain(), Visibility::dark, Cause::never_received,
           {"universe 3 never arrived in 5 s: marked as preview"});
    EXPECT_EQ(trial.explain().verdict.find("off by one"), std::string::npos);
    EXPECT_EQ(trial.explain().verdict.find("got lost"), std::string::npos);
    trial.reception.diagnosis = {{Trouble::nothing_arrives, true, "nothing arrives: firewall?", {}}};
    expect(trial.explain(), Visibility::dark, Cause::never_received,
           {"universe 3 never arrived in 5 s: nothing arrives: firewall?"});
}

// Levels as the network's merge makes them.
struct Desks {
    dmx::Merge merge{dmx::MergeOptions{.slot_status = true}};

    dmx::Packet packet(int desk, int priority, std::vector<int> values) {
        dmx::Packet result;
        result.source.id[0] = static_cast<std::uint8_t>(desk);
        result.source_name = "Desk " + std::to_string(desk);
        result.from = 0x0a000000u + static_cast<std::uint32_t>(desk);
        result.universe = 1;
        result.priority = static_cast<std::uint8_t>(priority);
        result.sequence = ++sequence_;
        for (const int value : values) result.slots[result.slot_count++] = static_cast<std::uint8_t>(value);
        return result;
    }
    void into(Trial& trial, std::chrono::nanoseconds now) {
        trial.universes = merge.universes();
        trial.reception = {.kind = Reception::Kind::desk, .listened_s = 5, .packets = 9};
        trial.reception.sources = merge.sources(now);
    }

private:
    std::uint8_t sequence_ = 0;
};

TEST(explain, UniverseLostAndHeld) {
    Trial trial(type_of(kDimmer));
    Desks desks;
    desks.merge.feed(desks.packet(1, 100, {0}), 1s);
    desks.merge.tick(4s);
    desks.into(trial, 4s);
    expect(trial.explain(), Visibility::dark, Cause::lost,
           {"universe 1 is lost: its last packet came 9 s ago", "last look is held",
            "the dimmer on channel 1 (1.001) is at 0"});
}

TEST(explain, UniverseWithFewerChannels) {
    Trial trial(type_of(kDimmer + simple("2,3", "Pan", -270, 270)));
    trial.show.fixtures[0].address = 5;
    Desks desks;
    desks.merge.feed(desks.packet(1, 100, {255, 255, 255, 255}), 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::dark, Cause::not_sent,
           {"universe 1 comes with 4 channels, and 3 of the fixture lie past these",
            "the dimmer on channel 1 (1.005) is at 0"});
    trial.reception.sources[0].most_slots = 512;
    expect(trial.explain(), Visibility::dark, Cause::not_sent,
           {"universe 1 comes with 4 channels (512 in some packets), and 3 of"});
    desks.merge.feed(desks.packet(1, 100, {0, 0, 0, 0, 255, 128}), 1s);
    desks.into(trial, 1s);
    const Explanation lit = trial.explain();
    EXPECT_NE(lit.visibility, Visibility::dark) << "what is left out makes nothing dark";
    EXPECT_TRUE(std::any_of(lit.findings.begin(), lit.findings.end(),
                            [](const Reason& one) { return one.cause == Cause::not_sent && !one.blocks; }));
}

// Flags of colour at HTP: each desk alone would light it, both together do not.
TEST(explain, TwoDesksOfEqualPriority) {
    Trial trial(type_of(kDimmer + simple("2", "ColorSub_C", 0, 1) + simple("3", "ColorSub_M", 0, 1) +
                        simple("4", "ColorSub_Y", 0, 1)));
    Desks desks;
    desks.merge.feed(desks.packet(1, 100, {255, 255, 0, 0}), 1s);
    desks.merge.feed(desks.packet(2, 100, {255, 0, 255, 255}), 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::nearly_dark, Cause::two_desks,
           {"'Desk 1'", "'Desk 2'", "priority 100", "have the same say", "alone would light it"});
    Desks alike;
    alike.merge.feed(alike.packet(1, 100, {255, 0, 0, 0}), 1s);
    alike.merge.feed(alike.packet(2, 100, {255, 0, 0, 0}), 1s);
    alike.into(trial, 1s);
    for (const Reason& reason : trial.explain().findings) EXPECT_NE(reason.cause, Cause::two_desks);
}

TEST(explain, OfTwoDesksTheOneThatChangedLast) {
    Trial trial(type_of(kDimmer));
    Desks desks;
    desks.merge = dmx::Merge(dmx::MergeOptions{.slot_status = true, .artnet_ltp = true});
    for (const auto& [desk, level] : {std::pair(1, 255), {2, 0}, {1, 254}, {2, 1}}) {
        dmx::Packet packet = desks.packet(desk, 100, {level});
        packet.protocol = packet.source.protocol = dmx::Protocol::artnet;
        desks.merge.feed(packet, 1s);
    }
    desks.into(trial, 1s);
    trial.reception.artnet_ltp = true;
    expect(trial.explain(), Visibility::nearly_dark, Cause::two_desks,
           {"they send 254 and 1, and 1 shows, for it changed last (LTP)"});
}

TEST(explain, PreviewIsShownInsteadOfTheLiveLookAndFightsNobody) {
    Trial trial(type_of(kDimmer));
    Desks desks;
    desks.merge = dmx::Merge(dmx::MergeOptions{.show_preview = true, .slot_status = true});
    desks.merge.feed(desks.packet(1, 100, {255}), 1s);
    dmx::Packet blind = desks.packet(2, 100, {0});
    blind.source.preview = true;
    desks.merge.feed(blind, 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::dark, Cause::dimmer, {"channel 1 (1.001) is at 0"});
    blind.priority = 150;
    blind.sequence = static_cast<std::uint8_t>(blind.sequence + 1);
    desks.merge.feed(blind, 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::dark, Cause::dimmer, {"channel 1 (1.001) is at 0"});
}

TEST(explain, WhatIsWrongWithTheNetworkIsSaidBesideTheVerdict) {
    Trial trial(type_of(kDimmer));
    Desks desks;
    desks.merge.feed(desks.packet(1, 100, {0}), 1s);
    desks.into(trial, 1s);
    trial.reception.diagnosis = {{Trouble::same_identity, true, "two programs send as one", {1}},
                                 {Trouble::low_priority, false, "a backup waits", {1}},
                                 {Trouble::not_received, true, "no levels there", {7}}};
    const std::string words = words_of(trial.explain(), trial.reception);
    EXPECT_NE(words.find("network   two programs send as one\n"), std::string::npos) << words;
    EXPECT_EQ(words.find("a backup waits"), std::string::npos);
    EXPECT_EQ(words.find("no levels there"), std::string::npos);
}

TEST(explain, HigherPriorityOverrides) {
    Trial trial(type_of(kDimmer));
    Desks desks;
    desks.merge.feed(desks.packet(1, 100, {255}), 1s);
    desks.merge.feed(desks.packet(2, 150, {0}), 1s);
    desks.into(trial, 1s);
    const Explanation dark = trial.explain();
    expect(dark, Visibility::dark, Cause::overridden,
           {"'Desk 2' (sACN, 10.0.0.2, priority 150) overrides 'Desk 1' (sACN, 10.0.0.1, priority 100), "
            "which would light it",
            "on channel 1 (1.001) it sends 0 instead of 255"});
    ASSERT_EQ(dark.universes.size(), 1u);
    ASSERT_EQ(dark.universes[0].senders.size(), 2u);
    EXPECT_EQ(dark.universes[0].senders[0].channels_held, 0);
    EXPECT_EQ(dark.universes[0].senders[1].channels_held, 1);
    // A loser that would leave it dark, too, is not to blame.
    Trial both(type_of(kDimmer + kShutter));
    Desks more;
    more.merge.feed(more.packet(1, 100, {200, 0}), 1s);
    more.merge.feed(more.packet(2, 150, {0, 0}), 1s);
    more.into(both, 1s);
    expect(both.explain(), Visibility::dark, Cause::dimmer, {});
}

TEST(explain, PriorityPerAddressOverrides) {
    Trial trial(type_of(kDimmer));
    Desks desks;
    desks.merge.feed(desks.packet(1, 100, {255}), 1s);
    dmx::Packet priorities = desks.packet(1, 100, {0});
    priorities.start_code = 0xDD;
    desks.merge.feed(priorities, 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::dark, Cause::overridden,
           {"'Desk 1'", "sends 255 on channel 1 (1.001)", "priority per address", "nobody holds it"});
    priorities = desks.packet(1, 100, {255});
    priorities.start_code = 0xDD;
    desks.merge.feed(priorities, 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::dark, Cause::overridden,
           {"above 200, which is none", "nobody holds it"});
    priorities = desks.packet(1, 100, {});
    priorities.start_code = 0xDD;
    desks.merge.feed(priorities, 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::dark, Cause::overridden,
           {"ends before that channel", "nobody holds it"});
    desks.merge.feed(desks.packet(2, 10, {0}), 1s);
    desks.into(trial, 1s);
    expect(trial.explain(), Visibility::dark, Cause::overridden,
           {"'Desk 2' (sACN, 10.0.0.2, priority 10) overrides 'Desk 1' (sACN, 10.0.0.1, priority none for "
            "this address)"});
}

TEST(explain, AnotherFixtureOnTheSameAddress) {
    Trial trial(type_of(kDimmer + kShutter));
    trial.add("Other", type_of(kDimmer), 1);
    expect(trial.set(1, 0).set(2, 8).explain(), Visibility::dark, Cause::same_address,
           {"'Other', another kind of fixture, has the same address 1.001",
            "the dimmer on channel 1 (1.001) is at 0"});
    // Of two of a kind that is meant.
    Trial twins(type_of(kDimmer));
    twins.add("Twin", twins.show.fixtures[0].type, 1);
    const Explanation dark = twins.set(1, 0).explain();
    expect(dark, Visibility::dark, Cause::dimmer, {});
    ASSERT_TRUE(find(dark, Cause::same_address));
    EXPECT_NE(find(dark, Cause::same_address)->text.find("'Twin' has the same address and does the same"),
              string::npos);
}

TEST(explain, TheNextFixtureBeginsInside) {
    Trial trial(type_of(kDimmer + kShutter)); // two channels, the second is the neighbour's dimmer
    trial.add("Next", type_of(kDimmer), 2);
    expect(trial.set(1, 255).set(2, 3).explain(), Visibility::dark, Cause::overlap,
           {"it (2 channels from 1.001) and 'Next' (1 channels from 1.002)", "wrong length",
            "'Closed' (DMX 0-7)"});
    // What is dark for a channel of its own is not the neighbour's fault.
    expect(trial.set(1, 0).set(2, 8).explain(), Visibility::dark, Cause::dimmer, {});
}

} // namespace
} // namespace ghost::scene
