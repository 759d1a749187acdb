// SPDX-License-Identifier: Apache-2.0
// What is said of sources that arrive: blind, ranked, in a fight, one of two, without levels, late.
#include "support/diagnosed_network.h"

namespace ghost::scene {
namespace {

using namespace diagnosed_trial;

TEST(diagnosis, PreviewIsNotShown) {
    Network network({1});
    network.statistics.ignored = {
        {1, dmx::Protocol::sacn, dmx::IgnoredSource::Why::preview, "Eos", dmx::IpAddress(kOurs), 4, 0s}};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::preview});
    expect_words(network.text(Trouble::preview),
                 {"'Eos' (192.168.1.5)", "universe 1", "blind", "--show-preview"});
}

TEST(diagnosis, ALowerPriority) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus backup = source(1, dmx::Protocol::sacn, 0);
    backup.name = "Backup";
    backup.id[0] = '2';
    backup.priority = 90;
    network.statistics.sources.push_back(backup);
    ASSERT_EQ(network.troubles(), Troubles{Trouble::low_priority});
    EXPECT_FALSE(network.sentences()[0].is_problem);
    expect_words(network.text(Trouble::low_priority), {"'Backup' (192.168.1.7) (priority 90)",
                                                       "'Desk' (192.168.1.7) (priority 100) has a higher"});
    const auto& all = network.statistics.sources;
    EXPECT_EQ(role_text(all[0], all), "shown");
    EXPECT_EQ(role_text(all[1], all), "lower priority");
    network.statistics.sources[0].is_dark = true;
    expect_words(network.text(Trouble::low_priority), {"has a higher priority, and sends 0 alone"});
    network.statistics.sources[0].slots_held = 110; // it sends no more
    network.statistics.sources[0].highest_priority = 100;
    network.statistics.sources[1].slots_held = 402;
    network.statistics.sources[1].highest_priority = 90;
    expect_words(
        network.text(Trouble::low_priority),
        {"'Backup' (192.168.1.7) (priority 90) is shown only in part on universe 1", "and sends 0 alone"});
    network.statistics.sources[1].slots_held = 0;
    network.statistics.sources[1].is_dark = true;
    EXPECT_EQ(network.text(Trouble::low_priority).find("sends 0"), std::string::npos) << "it hides nothing";
}

TEST(diagnosis, ChannelsThatAreGivenAway) {
    Network network({1}); // channels 10 to 12
    network.sends({1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.per_address_priority = true;
    desk.priority_count = 512;
    desk.highest_priority = 100;
    dmx::SourceSlots slots;
    slots.rank.fill(101);
    const auto set = [](dmx::SourceStatus& one, const dmx::SourceSlots& to) {
        one.slots = std::make_shared<const dmx::SourceSlots>(to);
    };
    set(desk, slots);
    EXPECT_EQ(network.troubles(), Troubles{});
    slots.rank[10] = 0; // channel 11
    set(desk, slots);
    ASSERT_EQ(network.troubles(), Troubles{Trouble::bad_priorities});
    EXPECT_FALSE(network.sentences()[0].is_problem) << "a channel that the desk does not know";
    expect_words(network.text(Trouble::bad_priorities),
                 {"'Desk' (192.168.1.7) gives 1 of 3 patched channels on universe 1 away", "nobody else"});
    slots.rank.fill(0);
    set(desk, slots);
    EXPECT_TRUE(network.sentences()[0].is_problem);
    expect_words(network.text(Trouble::bad_priorities), {"gives 3 of 3 patched channels"});
    dmx::SourceStatus other = source(1, dmx::Protocol::sacn);
    other.id[0] = '2';
    slots.rank.fill(51);
    set(other, slots);
    network.statistics.sources.push_back(other);
    EXPECT_EQ(network.text(Trouble::bad_priorities), "not said") << "another sends them";
}

TEST(diagnosis, TwoDesksThatFight) {
    Network network({1});
    network.sends({1}).sends({1});
    dmx::SourceStatus& other = network.statistics.sources[1];
    other.id[0] = '2';
    other.name = "Other";
    other.rate_hz = 44;
    EXPECT_EQ(network.troubles(), Troubles{}) << "a backup that sends the same";
    other.slots_overruled = 12;
    ASSERT_EQ(network.troubles(), Troubles{Trouble::two_desks});
    EXPECT_FALSE(network.sentences()[0].is_problem) << "each has channels of its own";
    expect_words(network.text(Trouble::two_desks), {"may be meant to share"});
    other.slots_overruled = 0;
    for (dmx::SourceStatus& one : network.statistics.sources) one.slots_shared = 10;
    ASSERT_EQ(network.troubles(), Troubles{Trouble::two_desks});
    EXPECT_FALSE(network.sentences()[0].is_problem) << "two operators play the same lamps";
    expect_words(network.text(Trouble::two_desks),
                 {"10 channels up at different times", "a backup, it is out of step"});
    other.slots_overruled = 12;
    other.slots_contested = 1;
    EXPECT_TRUE(network.sentences()[0].is_problem);
    expect_words(network.text(Trouble::two_desks),
                 {"universe 1 comes", "'Desk' (192.168.1.7) with 512 slots", "'Other' (192.168.1.7)",
                  "at 44 Hz", "up to 12 channels", "HTP"});
    for (dmx::SourceStatus& one : network.statistics.sources) one.protocol = dmx::Protocol::artnet;
    network.statistics.listening.artnet_ltp = true;
    expect_words(network.text(Trouble::two_desks), {"LTP"});
}

TEST(diagnosis, ALowerPriorityOfEachAddress) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus backup = source(1, dmx::Protocol::sacn, 0);
    backup.name = "Backup";
    backup.id[0] = '2';
    backup.priority = 150;
    backup.per_address_priority = true;
    backup.highest_priority = 50;
    network.statistics.sources.push_back(backup);
    expect_words(network.text(Trouble::low_priority),
                 {"(priority 50 at most, one for each address) is not shown", "(priority 100) has a higher"});
}

TEST(diagnosis, TwoSendersThatAreOneByTheirIdentity) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.rate_hz = 44;
    desk.double_from = dmx::IpAddress(0xC0A80108);
    EXPECT_EQ(network.troubles(), Troubles{Trouble::same_identity});
    expect_words(network.text(Trouble::same_identity),
                 {"'Desk' (192.168.1.7)", "one at 192.168.1.8", "universe 1", "CID"});
    desk.double_from.reset();
    EXPECT_EQ(network.troubles(), Troubles{});
    desk.is_shared = true;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::same_identity});
    expect_words(network.text(Trouble::same_identity), {"'Desk' (192.168.1.7)", "two rows of numbers",
                                                        "two programs", "gives two packets one number"});
    desk.port = 6454;
    desk.other_port = 40021;
    expect_words(network.text(Trouble::same_identity),
                 {"by turns from the ports 6454 and 40021", "two programs", "one by two sockets"});
    desk.late_hz = 44;
    desk.rate_hz = 0.4;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::same_identity}) << "most of the second's are late";
    desk.is_shared = false;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::numbering});
}

TEST(diagnosis, PacketsWithoutLevels) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.slot_count = 0;
    desk.slots_held = 0;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::nothing_arrives});
    expect_words(network.text(Trouble::nothing_arrives),
                 {"'Desk' (192.168.1.7) on universe 1: only priorities per address"});
    desk.packets = 400;
    expect_words(network.text(Trouble::nothing_arrives), {"packets without a single level"});
    Network beside({1, 2});
    beside.sends({1, 2});
    beside.statistics.sources[1].slot_count = 0;
    beside.statistics.sources[1].slots_held = 0;
    EXPECT_EQ(beside.troubles(), Troubles{Trouble::not_received});
    expect_words(beside.text(Trouble::not_received), {"on universe 2", "only priorities per address"});
}

TEST(diagnosis, WhatIsNoneOfTheShowIsNoProblem) {
    Network network({1});
    network.sends({1, 9, 9});
    for (const std::size_t stranger : {1u, 2u}) {
        network.statistics.sources[stranger].slots_overruled = 7;
        network.statistics.sources[stranger].slots_contested = 7;
    }
    network.statistics.sources[2].name = "Other";
    EXPECT_EQ(network.text(Trouble::two_desks), "not said") << "a window does not listen for it, either";
    network.patch = PatchMap(show_on({1, 9}));
    const std::vector<Sentence> of_the_show = network.sentences();
    EXPECT_TRUE(std::any_of(of_the_show.begin(), of_the_show.end(),
                            [](const Sentence& one) { return one.is_problem; }));
}

TEST(diagnosis, AnOperatorInBlindBesideTheLiveDesk) {
    Network network({1});
    network.sends({1});
    dmx::IgnoredSource blind;
    blind.universe = 1;
    blind.name = "Assistant";
    blind.from = dmx::IpAddress(0xC0A80108);
    network.statistics.ignored = {blind};
    ASSERT_EQ(network.troubles(), Troubles{Trouble::preview});
    EXPECT_FALSE(network.sentences()[0].is_problem) << "the stage is lit";
    expect_words(network.text(Trouble::preview), {"'Assistant' (192.168.1.8) marks universe 1 as preview"});
    network.statistics.sources.clear();
    EXPECT_TRUE(network.sentences()[0].is_problem);
}

TEST(diagnosis, PacketsWithoutLevelsAreNeitherHeldBackNorGone) {
    Network network({1});
    network.sends({1});
    network.statistics.sources[0].slot_count = 0;
    network.statistics.sources[0].slots_held = 0;
    dmx::DiscoveredSource list;
    list.name = "Desk";
    list.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{1});
    network.statistics.discovered = {list};
    EXPECT_EQ(network.text(Trouble::held_back), "not said");
    network.statistics.lost = {{1, false, 4s}};
    expect_words(network.text(Trouble::lost),
                 {"any more, since 4 s", "Packets still come, without levels", "only priorities"});
    EXPECT_EQ(network.text(Trouble::lost).find("firewall"), std::string::npos);
}

TEST(diagnosis, ABlackOutThatAnotherDeskHides) {
    Network network({1});
    network.sends({1, 1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.name = "FOH";
    desk.slots_overruled = 7;
    desk.is_dark = true;
    EXPECT_FALSE(network.sentences().at(0).is_problem);
    expect_words(network.text(Trouble::two_desks), {"'FOH' (192.168.1.7) sends 0 alone", "black-out"});
    desk.is_dark = false;
    expect_words(network.text(Trouble::two_desks), {"meant to share"});
    // The dimmer of its fixture, at address 10, is at 0, its colours stay.
    dmx::SourceSlots slots;
    slots.levels[10] = 200;
    desk.slots = std::make_shared<const dmx::SourceSlots>(slots);
    expect_words(network.text(Trouble::two_desks), {"meant to share"}); // it passes through 0
    slots.stands.set();
    desk.slots = std::make_shared<const dmx::SourceSlots>(slots);
    slots.levels[9] = 255;
    network.statistics.sources[1].slots = std::make_shared<const dmx::SourceSlots>(slots);
    expect_words(network.text(Trouble::two_desks), {"'FOH' (192.168.1.7) has all dimmers at 0", "black-out"});
    network.statistics.sources[1].slots = desk.slots;
    expect_words(network.text(Trouble::two_desks), {"meant to share"});
}

TEST(diagnosis, TwoOfOneNameAndAddressAreToldApart) {
    Network network({1});
    network.sends({1, 1});
    dmx::SourceStatus& other = network.statistics.sources[1];
    other.id[1] = '2';
    other.slots_overruled = other.slots_contested = 3;
    expect_words(network.text(Trouble::two_desks),
                 {"'Desk' (192.168.1.7, CID 01000000", "'Desk' (192.168.1.7, CID 02000000"});
    for (dmx::SourceStatus& one : network.statistics.sources) {
        one.protocol = dmx::Protocol::artnet;
        one.name = "";
        one.id = "192.168.1.7";
    }
    other.id = "192.168.1.7/1";
    expect_words(network.text(Trouble::two_desks),
                 {"192.168.1.7 (Art-Net) with", "192.168.1.7/1 (Art-Net) with",
                  "192.168.1.7 names more than one Physical"});
    network.statistics.sources[0] = source(1, dmx::Protocol::sacn);
    other.id = "192.168.1.7";
    expect_words(network.text(Trouble::two_desks), {"192.168.1.7 sends by sACN and by Art-Net"});
}

TEST(diagnosis, PrioritiesPerAddressThatGiveLevelsUp) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.per_address_priority = true;
    desk.priority_count = 512;
    EXPECT_EQ(network.troubles(), Troubles{});
    desk.bad_priorities = 512;
    ASSERT_EQ(network.troubles(), Troubles{Trouble::bad_priorities});
    EXPECT_TRUE(network.sentences()[0].is_problem);
    expect_words(network.text(Trouble::bad_priorities),
                 {"'Desk' (192.168.1.7)", "above 200 on universe 1 for 512 channels"});
    desk.bad_priorities = 100;
    ASSERT_EQ(network.troubles(), Troubles{Trouble::bad_priorities});
    EXPECT_FALSE(network.sentences()[0].is_problem) << "they may be channels that nothing reads";
    desk.bad_priorities = 0;
    desk.priority_count = 9; // the fixture begins at 10
    ASSERT_EQ(network.troubles(), Troubles{Trouble::bad_priorities});
    EXPECT_FALSE(network.sentences()[0].is_problem);
    expect_words(network.text(Trouble::bad_priorities), {"512 levels", "for 9 alone", "gives the others up"});
    desk.priority_count = 12;
    EXPECT_EQ(network.troubles(), Troubles{});
}

TEST(diagnosis, TwoTimeCodes) {
    Network network({1});
    network.sends({1});
    dmx::TimeCodeStatus one, other;
    auto& [newest, before] = network.statistics.followed_timecodes;
    one.from = dmx::IpAddress(0xC0A80107);
    other.from = dmx::IpAddress(0xC0A80108);
    one.arrival = other.arrival = network.statistics.time - 40ms;
    newest = one;
    EXPECT_EQ(network.troubles(), Troubles{});
    before = other;
    EXPECT_EQ(network.troubles(), Troubles{}) << "both say the same: one sender with two cards";
    before->time.minutes = 3;
    ASSERT_EQ(network.troubles(), Troubles{Trouble::two_timecodes});
    expect_words(network.text(Trouble::two_timecodes), {"192.168.1.7 and 192.168.1.8", "came first"});
    before->arrival -= 5s;
    EXPECT_EQ(network.troubles(), Troubles{}) << "it came before";
}

TEST(diagnosis, NumbersThatDoNotCountUp) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.rate_hz = 44;
    desk.late_hz = 44;
    EXPECT_EQ(network.troubles(), Troubles{}) << "the network brings every packet twice";
    desk.rate_hz = 0.4;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::numbering});
    expect_words(network.text(Trouble::numbering),
                 {"'Desk' (192.168.1.7)", "44 of 44 a second", "stands still"});
}

TEST(diagnosis, BlindBesideLive) {
    Network network({1});
    network.sends({1});
    network.statistics.ignored = {{1, dmx::Protocol::sacn, dmx::IgnoredSource::Why::preview, "Desk",
                                   dmx::IpAddress(0xC0A80107), 4, 0s}};
    ASSERT_EQ(network.troubles(), Troubles{Trouble::preview});
    EXPECT_FALSE(network.sentences()[0].is_problem) << "its live look is shown";
}

TEST(diagnosis, MoreSacnSourcesThanPlaces) {
    Network network({1});
    network.sends({1});
    for (int i = 0; i < 3; ++i)
        network.statistics.ignored.push_back({1, dmx::Protocol::sacn, dmx::IgnoredSource::Why::too_many,
                                              "S" + std::to_string(i), dmx::IpAddress(kOurs), 4, 0s});
    ASSERT_EQ(network.troubles(), Troubles{Trouble::too_many}) << "one sentence for all";
    expect_words(network.text(Trouble::too_many), {"'S0'", "'S2'", "16 are merged", "highest priority"});
    EXPECT_EQ(network.text(Trouble::too_many).find("Art-Net"), std::string::npos);
}

TEST(diagnosis, RolesOfSources) {
    std::vector<dmx::SourceStatus> all = {source(1, dmx::Protocol::sacn), source(1, dmx::Protocol::sacn),
                                          source(2, dmx::Protocol::sacn, 100),
                                          source(3, dmx::Protocol::sacn, 0)};
    all[1].id[0] = '3';
    EXPECT_EQ(role_text(all[0], all), "merged");
    EXPECT_EQ(role_text(all[2], all), "in part");
    EXPECT_EQ(role_text(all[3], all), "holds no slot");
    all[0].slots_held = 0;
    all[1].preview = true;
    EXPECT_EQ(role_text(all[0], all), "behind preview");
    all[2].state = dmx::SourceState::waiting;
    EXPECT_EQ(role_text(all[2], all), "waiting");
}

TEST(diagnosis, OneArtnetSourceTooMany) {
    Network network({1});
    network.sends({1}, dmx::Protocol::artnet);
    network.statistics.ignored = {
        {1, dmx::Protocol::artnet, dmx::IgnoredSource::Why::too_many, "", dmx::IpAddress(kOurs), 4, 0s}};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::too_many});
    expect_words(network.text(Trouble::too_many), {"192.168.1.5 (Art-Net)", "merges two"});
    EXPECT_EQ(network.text(Trouble::too_many).find("have the places"), std::string::npos);
    network.sends({1}, dmx::Protocol::artnet);
    network.statistics.sources[1].id = "192.168.1.8";
    network.statistics.sources[1].age = 4s;
    expect_words(network.text(Trouble::too_many),
                 {"there 192.168.1.7 and 192.168.1.8 (silent for 4 s) have the places of Art-Net",
                  "silent for 10 s makes room"});
}

TEST(diagnosis, EachUniverseHasItsOwnTwo) {
    Network network({1, 2});
    network.sends({1, 1, 2, 2}, dmx::Protocol::artnet);
    const char* const holders[] = {"10.0.0.1", "10.0.0.11", "10.0.0.11", "10.0.0.12"};
    for (std::size_t k = 0; k < 4; ++k) network.statistics.sources[k].id = holders[k];
    for (const std::uint16_t universe : {std::uint16_t{1}, std::uint16_t{2}})
        network.statistics.ignored.push_back({universe, dmx::Protocol::artnet,
                                              dmx::IgnoredSource::Why::too_many, "", dmx::IpAddress(kOurs), 4,
                                              0s});
    std::map<std::set<int>, std::string> said;
    for (const Sentence& sentence : network.sentences()) said[sentence.universes] = sentence.text;
    expect_words(said[{1}], {"there 10.0.0.1 and 10.0.0.11 have"});
    expect_words(said[{2}], {"there 10.0.0.11 and 10.0.0.12 have"});
}

// Each has the look on one universe and nothing on the other.
TEST(diagnosis, WhoIsDarkWhere) {
    Network network({1, 2});
    network.sends({1, 1, 2, 2});
    for (std::size_t k = 0; k < 4; ++k) {
        dmx::SourceStatus& one = network.statistics.sources[k];
        one.name = one.id = k % 2 == 0 ? "A" : "B";
        one.is_dark = k == 1 || k == 2;
        one.slots_overruled = 7;
        one.rate_hz = 40 + static_cast<double>(k);
    }
    std::map<std::set<int>, std::string> said;
    for (const Sentence& sentence : network.sentences()) said[sentence.universes] = sentence.text;
    expect_words(said[{1}], {"'B' (192.168.1.7) sends 0 alone"});
    expect_words(said[{2}], {"'A' (192.168.1.7) sends 0 alone"});
    for (dmx::SourceStatus& one : network.statistics.sources) one.is_dark = one.name == "B";
    ASSERT_EQ(network.troubles(), Troubles{Trouble::two_desks}) << "rates do not tell them apart";
}

// Of three, of which the lowest alone sends past slot 100.
TEST(diagnosis, WhoOutranksWhom) {
    Network network({1});
    network.sends({1, 1, 1});
    const char* const names[] = {"House", "Main", "LX"};
    const std::uint8_t priorities[] = {150, 100, 50};
    for (std::size_t k = 0; k < 3; ++k) {
        dmx::SourceStatus& one = network.statistics.sources[k];
        one.name = one.id = names[k];
        one.priority = one.highest_priority = priorities[k];
        one.slot_count = k == 2 ? 512 : 100;
        one.slots_held = k == 0 ? 100 : k == 1 ? 0 : 412;
        dmx::SourceSlots slots;
        for (std::size_t slot = 0; slot < one.slot_count; ++slot)
            slots.rank[slot] = static_cast<std::uint8_t>(priorities[k] + 1);
        one.slots = std::make_shared<const dmx::SourceSlots>(slots);
    }
    expect_words(network.text(Trouble::low_priority), {"'Main' (192.168.1.7) (priority 100) is not shown",
                                                       "'House' (192.168.1.7) (priority 150)"});
}

TEST(diagnosis, PacketsThatDeclareMoreThanTheyHold) {
    Network network({1, 2});
    network.sends({1, 2});
    for (dmx::SourceStatus& one : network.statistics.sources) one.wrong_length = true;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::wrong_length});
    expect_words(network.text(Trouble::wrong_length),
                 {"'Desk' (192.168.1.7)", "more levels on universes 1-2", "are used"});
}

TEST(diagnosis, MoreUniversesThanAreShown) {
    Network network({1});
    network.sends({1});
    network.statistics.merge.too_many_universes = 1000;
    EXPECT_EQ(network.troubles(), Troubles{}) << "long ago";
    network.statistics.recent.too_many_universes = 3;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::too_many_universes});
    expect_words(network.text(Trouble::too_many_universes), {"4096", "--universes"});
}

TEST(diagnosis, LevelsThatWaitForASynchronisation) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.held = true;
    dmx::SyncStatus sync;
    sync.age = 9s; // of a desk at rest
    network.statistics.sync = {sync};
    desk.held_for = 60ms;
    EXPECT_EQ(network.troubles(), Troubles{}) << "between two frames";
    desk.held_for = 3s;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::waits_for_sync});
    expect_words(network.text(Trouble::waits_for_sync), {"does not come, or seldom", "10 s at most"});
}

TEST(diagnosis, AnotherOrderThanTheyWereSent) {
    Network network({1});
    network.sends({1});
    dmx::SourceStatus& desk = network.statistics.sources[0];
    desk.is_reordered = true;
    desk.rate_hz = 20;
    desk.late_hz = 20;
    ASSERT_EQ(network.troubles(), Troubles{Trouble::numbering});
    EXPECT_FALSE(network.sentences()[0].is_problem);
    expect_words(network.text(Trouble::numbering), {"another order", "20 of 40 a second are late"});
}

TEST(diagnosis, AnArtNetDeskThatDiedCountsForAWhile) {
    Network network({1});
    network.sends({1, 1}, dmx::Protocol::artnet);
    for (dmx::SourceStatus& source : network.statistics.sources)
        source.slots_overruled = source.slots_contested = 3;
    dmx::SourceStatus& dead = network.statistics.sources[1];
    dead.id = "192.168.1.8";
    dead.from = dmx::IpAddress(0xC0A80108);
    dead.age = 3s;
    ASSERT_EQ(network.troubles(), Troubles{Trouble::two_desks});
    EXPECT_TRUE(network.sentences()[0].is_problem) << "a desk at rest sends every four seconds";
    dead.age = 5s;
    EXPECT_FALSE(network.sentences()[0].is_problem);
    expect_words(network.text(Trouble::two_desks),
                 {"192.168.1.8 (Art-Net) is silent, and counts until 10 s"});
}

TEST(diagnosis, AnotherNetworkAndAnotherGroup) {
    Network network({1});
    network.sends({1}, dmx::Protocol::artnet);
    network.statistics.sources[0].from = dmx::IpAddress(0x0A000007);
    EXPECT_EQ(network.troubles(), Troubles{Trouble::other_network});
    expect_words(network.text(Trouble::other_network), {"eth0 (192.168.1.5/24)", "another network"});
    network.statistics.sources[0].from = dmx::IpAddress(0x7F000001);
    EXPECT_EQ(network.troubles(), Troubles{});
    network.statistics.sources[0].wrong_group = true;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::wrong_group});
}

TEST(diagnosis, PacketsLostLately) {
    Network network({1});
    network.sends({1});
    network.statistics.overflow = network.statistics.merge.missed = 1000;
    EXPECT_EQ(network.troubles(), Troubles{}) << "long ago";
    network.statistics.recent = {12, 12};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::packets_lost});
    expect_words(network.text(Trouble::packets_lost), {"this machine dropped 12 packets", "rmem_max"});
    network.statistics.recent = {1, 0};
    expect_words(network.text(Trouble::packets_lost), {"1 packet is missing", "firewall", "skips numbers"});
}

} // namespace
} // namespace ghost::scene
