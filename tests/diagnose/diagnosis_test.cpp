// SPDX-License-Identifier: Apache-2.0
// Each sentence when it is due, and silence when all is well.
#include "support/diagnosed_network.h"

namespace ghost::scene {
namespace {

using namespace diagnosed_trial;

TEST(diagnosis, SilenceWhenAllIsWell) {
    EXPECT_EQ(Network({1, 2}).sends({1, 2}).troubles(), Troubles{});
    EXPECT_EQ(Network({1, 2}).sends({1, 2}, dmx::Protocol::artnet).troubles(), Troubles{});
    EXPECT_EQ(Network().sends({7}).troubles(), Troubles{}) << "without a show nothing is patched wrongly";
    Network two({1});
    two.sends({1}).sends({1}, dmx::Protocol::artnet); // a backup that merges
    EXPECT_EQ(two.troubles(), Troubles{});
    Network mixed({1, 2, 3});
    mixed.sends({1}).sends({2, 3}, dmx::Protocol::artnet);
    mixed.statistics.port_users = {{dmx::IpAddress(0u), 6454, 12, "olad"}};
    EXPECT_EQ(mixed.troubles(), Troubles{}) << "who shares the port takes nothing away";
}

TEST(diagnosis, NothingArrives) {
    Network silent({1, 2});
    EXPECT_EQ(silent.troubles(), Troubles{Trouble::nothing_arrives});
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"firewall on UDP 5568 and 6454", "eth0 (192.168.1.5/24)", "2.x.x.x or 10.x.x.x"});
    silent.statistics.interfaces[1].address = 0x02000005; // with a mask of 24 bits
    expect_words(silent.text(Trouble::nothing_arrives), {"2.255.255.255 and 10.255.255.255", "2.0.0.255"});
    silent.statistics.interfaces[1].netmask = 0xFF000000;
    expect_words(silent.text(Trouble::nothing_arrives), {"broadcasts to 10.255.255.255 (one in 10.x.x.x"});
    silent.statistics.interfaces.push_back(interface("eth1", 0x0A000005));
    silent.statistics.interfaces[2].netmask = 0xFF000000;
    EXPECT_EQ(silent.text(Trouble::nothing_arrives).find("broadcasts to"), std::string::npos);
    silent.statistics.interfaces.pop_back();
    EXPECT_EQ(silent.text(Trouble::nothing_arrives).find("filter of this machine dropped"),
              std::string::npos);
    silent.statistics.recent.reverse_path = 120;
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"filter of this machine dropped 120 packets", "rp_filter=2"});
    silent.statistics.recent.reverse_path = 0;
    silent.statistics.notices[static_cast<std::size_t>(dmx::Notice::poll)] = 3;
    silent.statistics.packets_artnet = 3;
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"no levels arrive, though 3 other packets did (3 ", "firewall on UDP 5568 in",
                  "'tcpdump -ni any udp port 5568' shows"});
    silent.statistics.recent.refused[static_cast<std::size_t>(dmx::Drop::too_short)] = 260;
    EXPECT_EQ(silent.troubles(), Troubles{Trouble::nothing_arrives});
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"packets arrive, and none of them", "260 too_short", "is its output on"});
    auto& recent = silent.statistics.recent;
    recent.refused = {};
    recent.refused[static_cast<std::size_t>(dmx::Drop::bad_universe)] = 260;
    recent.refused_sacn = recent.refused;
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"260 bad_universe", "a desk that counts from 0 has to count from 1"});
    recent.refused_sacn = {};
    EXPECT_EQ(silent.text(Trouble::nothing_arrives).find("count from 1"), std::string::npos)
        << "Art-Net has a universe 0";
    recent.refused = {};
    silent.statistics.recent.refused[static_cast<std::size_t>(dmx::Drop::too_short)] = 1;
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"though 4 other packets did", "1 too_short", "is the desk's output on"});
    silent.statistics.time = silent.statistics.listening.since + 3s;
    EXPECT_EQ(silent.troubles(), Troubles{}) << "three seconds prove nothing";
}

TEST(diagnosis, PortsThatWereChosen) {
    Network silent({1});
    for (dmx::SocketStatus& socket : silent.statistics.sockets) ++socket.port;
    expect_words(
        silent.text(Trouble::nothing_arrives),
        {"firewall on UDP 5569 and 6455 in", "'tcpdump -ni any udp port 5569 or udp port 6455' shows"});
}

TEST(diagnosis, APortThatIsTaken) {
    Network out;
    out.statistics.listening.problem = "UDP port 6454: the port is taken by olad (pid 12)";
    EXPECT_EQ(out.troubles(), Troubles{Trouble::not_listening});
    expect_words(out.text(Trouble::not_listening), {"olad (pid 12)"});

    Network shared({1});
    shared.statistics.port_users = {{dmx::IpAddress(0u), 6454, 12, "olad"},
                                    {dmx::IpAddress(0u), 9999, 13, "x"}};
    EXPECT_EQ(shared.troubles(), (Troubles{Trouble::nothing_arrives, Trouble::port_shared}));
    expect_words(shared.text(Trouble::port_shared), {"port 6454", "Art-Net", "olad (pid 12)", "--interface"});
}

TEST(diagnosis, MulticastOfThisVeryMachine) {
    Network same({1});
    same.statistics.port_users = {{dmx::IpAddress(0u), 5568, 12, "qlcplus"}};
    EXPECT_EQ(same.troubles(),
              (Troubles{Trouble::nothing_arrives, Trouble::port_shared, Trouble::same_host}));
    expect_words(same.text(Trouble::same_host), {"qlcplus (pid 12)", "this machine",
                                                 "multicast does not come back", "unicast to 127.0.0.1"});
    same.sends({1}, dmx::Protocol::artnet);
    EXPECT_EQ(same.troubles(), Troubles{}) << "all fixtures are fed";
    same.patch = PatchMap(show_on({1, 5}));
    EXPECT_EQ(same.troubles(), (Troubles{Trouble::port_shared, Trouble::same_host, Trouble::not_received}));
    Network ours({1});
    ours.statistics.port_users = {{dmx::IpAddress(0u), 5568, 12, "ghostlight"}};
    ASSERT_EQ(ours.troubles(), (Troubles{Trouble::nothing_arrives, Trouble::port_shared}));
    EXPECT_FALSE(ours.sentences()[1].is_problem) << "a monitor beside explain";
}

TEST(diagnosis, PollsThatNobodyAnswers) {
    Network network({1});
    network.statistics.recent.polls = 3;
    expect_words(network.text(Trouble::nothing_arrives), {"ArtPoll) and is answered"});
    network.statistics.recent.polls_refused = 3;
    expect_words(network.text(Trouble::nothing_arrives), {"ArtPoll", "asks from another network"});
    network.statistics.listening.answers_polls = false;
    network.statistics.recent.polls_refused = 0;
    expect_words(network.text(Trouble::nothing_arrives), {"ArtPoll", "(--no-poll-reply)"});
    network.statistics.listening.artnet = false;
    EXPECT_EQ(network.text(Trouble::nothing_arrives).find("ArtPoll"), std::string::npos);
}

TEST(diagnosis, LinksThatAreNotThere) {
    Network none({1});
    none.statistics.interfaces.pop_back();
    EXPECT_EQ(none.troubles(), Troubles{Trouble::no_interface});
    none.sends({1});
    EXPECT_EQ(none.troubles(), Troubles{}) << "a desk on this machine will do";

    Network gone({1});
    gone.statistics.listening.interface = "eth1";
    EXPECT_EQ(gone.troubles(), Troubles{Trouble::no_interface});
    expect_words(gone.text(Trouble::no_interface), {"eth1", "down or gone"});
    gone.statistics.listening.interface = "192.168.1.5";
    EXPECT_EQ(gone.troubles(), Troubles{Trouble::nothing_arrives});

    Network pulled({1});
    pulled.statistics.interfaces[1].running = false;
    EXPECT_EQ(pulled.troubles(), Troubles{Trouble::cable});
    expect_words(pulled.text(Trouble::cable), {"eth0", "no cable"});
}

TEST(diagnosis, FixturesWithoutPacketsAndPacketsWithoutFixtures) {
    const Network network = Network({1, 8, 8}).sends({1, 7, 20});
    // 7 is one beside 8, but so is nothing else: a shift would bring no more together.
    EXPECT_EQ(network.troubles(), (Troubles{Trouble::not_received, Trouble::not_patched}));
    expect_words(network.text(Trouble::not_received),
                 {"2 fixtures on universe 8", "'Spot 2'", "no levels arrive there", "Port-Address 0:0:7"});
    expect_words(network.text(Trouble::not_patched),
                 {"universes 7, 20", "'Desk' (192.168.1.7)", "nothing is patched"});

    Network unlisted({1});
    unlisted.sends({1});
    unlisted.statistics.unlisted_universes = {{30, dmx::Protocol::artnet, dmx::IpAddress(kOurs), 9, 1s}};
    ASSERT_EQ(unlisted.troubles(), Troubles{Trouble::not_patched});
    EXPECT_FALSE(unlisted.sentences()[0].is_problem) << "all fixtures are fed: a big desk sends more";
}

TEST(diagnosis, OffByOne) {
    const Network low = Network({1, 2, 3}).sends({2, 3, 4}, dmx::Protocol::artnet);
    EXPECT_EQ(low.troubles(), Troubles{Trouble::off_by_one}) << "and nothing else about these universes";
    expect_words(low.text(Trouble::off_by_one),
                 {"Art-Net", "universes 2-4", "Port-Address 0:0:1", "universes 1-3", "--artnet-offset 0"});
    Network high({2, 3});
    high.statistics.listening.artnet_offset = 0;
    high.sends({1, 2}, dmx::Protocol::artnet);
    EXPECT_EQ(high.troubles(), Troubles{Trouble::off_by_one});
    expect_words(high.text(Trouble::off_by_one), {"--artnet-offset 1"});
    const Network sacn = Network({5}).sends({4});
    EXPECT_EQ(sacn.troubles(), Troubles{Trouble::off_by_one});
    expect_words(sacn.text(Trouble::off_by_one), {"sACN", "by one"});
    EXPECT_EQ(sacn.text(Trouble::off_by_one).find("artnet"), std::string::npos);
    expect_words(sacn.text(Trouble::off_by_one), {"another system's", "silent", "firewall"});
    // What is only announced, and another universe of which nothing is known.
    Network lists({5, 9});
    dmx::DiscoveredSource list;
    list.name = "Desk";
    list.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{4});
    lists.statistics.discovered = {list};
    EXPECT_EQ(lists.troubles(), (Troubles{Trouble::off_by_one, Trouble::not_received}));
    expect_words(lists.text(Trouble::not_received), {"universe 9"});
    lists.patch = PatchMap(show_on({9}));
    EXPECT_EQ(lists.troubles(), Troubles{Trouble::not_patched});
    expect_words(lists.text(Trouble::not_patched), {"'Desk'", "another system's", "firewall on UDP"});
    Network shared({1});
    shared.sends({1}).sends({2}, dmx::Protocol::artnet);
    EXPECT_EQ(shared.troubles(), Troubles{Trouble::not_patched}) << "the Art-Net is somebody else's";
    EXPECT_FALSE(shared.sentences()[0].is_problem);
}

// What would bring one together and the rest apart, and what lies further away.
TEST(diagnosis, WhatLooksLikeOffByOne) {
    Network part = Network({1, 2, 3, 4}).sends({2, 3, 4, 5, 6, 7, 8});
    EXPECT_EQ(part.troubles(), (Troubles{Trouble::off_by_one, Trouble::not_received, Trouble::not_patched}));
    expect_words(part.text(Trouble::off_by_one),
                 {"sACN comes for universes 2-8", "either nothing is sent for universe 1 or it does not",
                  "or all of them are one off: then move the desk's output"});
    part.statistics.lost = {{1, false, 12s}};
    EXPECT_EQ(part.troubles(), (Troubles{Trouble::not_patched, Trouble::lost})) << "it was there";
    const Network four = Network({1, 2, 3, 4}).sends({5, 6, 7, 8}, dmx::Protocol::artnet);
    EXPECT_EQ(four.troubles(), (Troubles{Trouble::not_received, Trouble::not_patched}));
    expect_words(four.text(Trouble::not_patched),
                 {"packets for universes 5-8", "the show wants universes 1-4"});
    const Network ten = Network({11, 12, 13}).sends({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    EXPECT_EQ(ten.troubles(), (Troubles{Trouble::not_received, Trouble::not_patched}));
    const Network hall = Network({1}).sends({2, 100});
    EXPECT_EQ(hall.troubles(), (Troubles{Trouble::off_by_one, Trouble::not_patched}));
    expect_words(hall.text(Trouble::not_patched), {"universe 100"});
}

TEST(diagnosis, NumbersInAnotherOrder) {
    const auto said = [](std::initializer_list<int> patch, std::initializer_list<int> sent) {
        return Network(patch).sends(sent, dmx::Protocol::artnet).text(Trouble::not_patched);
    };
    // Net 1, Sub-Net 0, Universe 0 is universe 257.
    expect_words(said({257, 258, 259, 260}, {1, 2, 3, 4}),
                 {"Net:Sub-Net:Universe 0:0:0, the show wants 1:0:0: another Net"});
    expect_words(said({18}, {34}), {"0:2:1, the show wants 0:1:1: another Sub-Net"});
    const std::string both = said({1}, {1 + 256 + 16}); // Net and Sub-Net
    EXPECT_EQ(both.find("Net:Sub-Net"), std::string::npos) << both;
    const std::string mixed = said({2, 257}, {17, 40}); // 17 is 0:1:0, of which 2 alone is an exchange
    EXPECT_EQ(mixed.find("Net:Sub-Net"), std::string::npos) << mixed;
}

// Multicast of universes that nobody patched is not joined: what a source says it sends will do.
TEST(diagnosis, OffByOneByTheListOfASource) {
    Network network({1, 2});
    network.sends({2});
    dmx::DiscoveredSource desk;
    desk.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{2, 3});
    network.statistics.discovered = {desk};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::off_by_one});
}

// OLA sends Art-Net to those alone that asked for it, so of one that counts otherwise its replies alone come.
TEST(diagnosis, WhatArtnetRepliesName) {
    dmx::DiscoveredSource desk;
    desk.name = "OLA";
    desk.from = dmx::IpAddress(0xC0A80107);
    desk.protocol = dmx::Protocol::artnet;
    const auto names = [&](std::initializer_list<std::uint16_t> universes) {
        desk.universes = std::make_shared<const std::vector<std::uint16_t>>(universes);
        return std::vector{desk};
    };
    Network network({1});
    network.statistics.discovered = names({2});
    EXPECT_EQ(network.troubles(), (Troubles{Trouble::nothing_arrives, Trouble::off_by_one}))
        << "it may be idle";
    expect_words(network.text(Trouble::off_by_one),
                 {"Art-Net is announced for universe 2", "Port-Address 0:0:1", "by 'OLA' (192.168.1.7)",
                  "--artnet-offset 0"});
    network.statistics.discovered = names({17});
    EXPECT_EQ(network.troubles(), (Troubles{Trouble::nothing_arrives, Trouble::not_patched}));
    expect_words(network.text(Trouble::not_patched), {"announces universe 17", "the show wants universe 1"});
    network.statistics.packets_artnet = 7;
    network.statistics.discovered = names({1});
    EXPECT_EQ(network.troubles(), Troubles{Trouble::nothing_arrives}) << "no switch holds Art-Net back";
    expect_words(network.text(Trouble::nothing_arrives),
                 {"'OLA' (192.168.1.7) announces universe 1", "firewall on UDP 5568 in the way"});
    network.sends({1});
    network.statistics.discovered = names({2});
    EXPECT_EQ(network.troubles(), Troubles{}) << "a node's input beside a desk that lights the show";
}

TEST(diagnosis, ALostUniverse) {
    Network network({3, 4});
    network.sends({4});
    network.statistics.lost = {{3, false, 12s}, {9, false, 5s}};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::lost});
    expect_words(network.text(Trouble::lost),
                 {"universe 3 any more", "since 12 s", "last look is held", "a firewall"});
    network.statistics.lost = {{3, false, 12s, true}};
    expect_words(network.text(Trouble::lost), {"universe 3 any more", "said that it ends this stream"});
    EXPECT_EQ(network.text(Trouble::lost).find("firewall"), std::string::npos);
    network.statistics.lost = {{3, false, 12s, false, 16s, 2}};
    auto& changes = network.statistics.link_changes;
    changes = {{1, "eth0: cable plugged in", network.statistics.time - 14s},
               {2, "eth0: cable pulled", network.statistics.time - 40s, true, 2}};
    expect_words(network.text(Trouble::lost), {"a firewall"});
    changes.push_back({3, "eth0: cable pulled", network.statistics.time - 17s, true, 2});
    expect_words(network.text(Trouble::lost), {"a firewall"}); // levels came after it
    changes.push_back({4, "eth1: cable pulled", network.statistics.time - 15s, true, 3});
    expect_words(network.text(Trouble::lost), {"a firewall"}); // they came by another card
    changes.push_back({5, "eth0: cable pulled", network.statistics.time - 15s, true, 2});
    expect_words(network.text(Trouble::lost), {"last look is held. eth0: cable pulled 15 s ago"});
    network.statistics.lost = {{3, true, 70s}};
    expect_words(network.text(Trouble::lost), {"black", "70 s"});
    EXPECT_EQ(network.text(Trouble::lost).find("heard all the while"), std::string::npos);
    network.statistics.sources[0].id = "desk";
    network.statistics.lost = {{3, false, 12s, false, 16s, 0, "another"}};
    expect_words(network.text(Trouble::lost), {"Its desk has stopped", "less often"});
    network.statistics.lost = {{3, false, 12s, false, 16s, 0, "desk"}};
    expect_words(network.text(Trouble::lost), {"is heard all the while, with universe 4", "IGMP snooping"});
    network.statistics.sources[0].id.clear(); // nobody told whose it was
    network.statistics.lost = {{3, false, 12s}};
    EXPECT_EQ(network.text(Trouble::lost).find("heard all the while"), std::string::npos);
    Network all({3});
    all.statistics.lost = {{3, false, 12s}};
    EXPECT_EQ(all.troubles(), Troubles{Trouble::lost});
}

// Each with its own time and reason.
TEST(diagnosis, UniversesThatAreLostOneAfterTheOther) {
    Network network({1, 2, 3, 4});
    network.sends({4});
    network.statistics.sources[0].id = "desk";
    network.statistics.lost = {{1, false, 22s, false, 24s, 0, "another"},
                               {2, false, 5s, false, 7s, 0, "another"},
                               {3, false, 21s, false, 23s, 0, "desk"}};
    EXPECT_EQ(network.troubles(), (Troubles{Trouble::lost, Trouble::lost, Trouble::lost}));
    std::map<std::set<int>, std::string> said;
    for (const Sentence& sentence : network.sentences()) said[sentence.universes] = sentence.text;
    // From their last levels on, not from when they passed for lost.
    expect_words(said[{1}], {"universe 1 any more, since 24 s", "Its desk has stopped"});
    expect_words(said[{2}], {"universe 2 any more, since 7 s", "Its desk has stopped"});
    expect_words(said[{3}], {"universe 3 any more, since 23 s", "heard all the while, with universe 4"});
    network.statistics.lost[1].silent = 23s;
    EXPECT_EQ(network.troubles(), (Troubles{Trouble::lost, Trouble::lost})) << "one cable, one sentence";
}

TEST(diagnosis, ADeskThatHasJustFallenSilentIsNotNothing) {
    Network network({3});
    network.sends({3});
    network.statistics.sources[0].state = dmx::SourceState::silent;
    EXPECT_EQ(network.troubles(), Troubles{}) << "at the next tick it is lost";
}

TEST(diagnosis, FewerChannelsThanArePatched) {
    Network network({1});
    network.sends({1});
    network.statistics.sources[0].slot_count = 9;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::short_universe});
    EXPECT_FALSE(network.sentences()[0].is_problem) << "whoever is not patched there may be spare";
    expect_words(network.text(Trouble::short_universe),
                 {"comes with 9 channels,", "1 fixture ('Spot 1') is"});
    network.statistics.sources[0].most_slots = 512;
    expect_words(network.text(Trouble::short_universe), {"comes with 9 channels (512 in some packets), and"});
    for (std::uint16_t arriving = 10; arriving < 13; ++arriving) {
        network.statistics.sources[0].slot_count = arriving;
        EXPECT_EQ(network.troubles(), Troubles{}) << "a desk leaves out what it never touched";
    }
}

TEST(diagnosis, AnInterfaceWithoutAnAddress) {
    Network network({1});
    network.statistics.interfaces.push_back(interface("eth1", 0));
    expect_words(network.text(Trouble::nothing_arrives), {"eth1 has a cable and no IPv4 address", "DHCP"});
    network.statistics.interfaces[2].running = false;
    EXPECT_EQ(network.text(Trouble::nothing_arrives).find("no IPv4"), std::string::npos);
    network.statistics.interfaces[2] = interface("eth1", 0xA9FE0304);
    expect_words(network.text(Trouble::nothing_arrives), {"eth1 gave itself 169.254.3.4"});
    network.statistics.listening.interface = "eth0";
    EXPECT_EQ(network.text(Trouble::nothing_arrives).find("gave itself"), std::string::npos);
    network.statistics.listening.interface = "";
    network.sends({1});
    EXPECT_EQ(network.troubles(), Troubles{});
}

TEST(diagnosis, TheWrongInterface) {
    Network network({1, 2});
    network.statistics.listening.interface = "eth0";
    network.statistics.interfaces.push_back(interface("eth1", 0x0A000005));
    network.statistics.interfaces[2].index = 3;
    network.statistics.elsewhere_universes = {
        {3, 1, dmx::Protocol::sacn, "FOH", dmx::IpAddress(0x0A000007), 9, 0s},
        {3, 2, dmx::Protocol::sacn, "FOH", dmx::IpAddress(0x0A000007), 9, 0s},
        {3, 9, dmx::Protocol::sacn, "FOH", dmx::IpAddress(0x0A000007), 9, 0s}};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::wrong_interface});
    expect_words(network.text(Trouble::wrong_interface),
                 {"'FOH' (10.0.0.7)", "universes 1-2", "eth1", "we listen on eth0 (192.168.1.5/24) only",
                  "--interface eth1"});
    network.sends({1, 2});
    EXPECT_EQ(network.troubles(), Troubles{}) << "it comes by both";
    Network other({5});
    other.statistics.listening.interface = "eth0";
    other.statistics.interfaces = network.statistics.interfaces;
    other.statistics.elsewhere_universes = network.statistics.elsewhere_universes;
    expect_words(other.text(Trouble::wrong_interface), {"'FOH' (10.0.0.7) sends universes 1-2, 9", "eth1"});
    EXPECT_EQ(other.text(Trouble::nothing_arrives), "not said") << "packets do come";
}

TEST(diagnosis, WhatASourceAnnouncesAndDoesNotArrive) {
    Network network({1});
    dmx::DiscoveredSource desk;
    desk.name = "FOH";
    desk.from = dmx::IpAddress(0xC0A80107);
    desk.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{1, 2});
    network.statistics.discovered = {desk};
    auto& recent = network.statistics.recent;
    recent.refused[static_cast<std::size_t>(dmx::Drop::bad_priority)] = 400;
    recent.refused_sacn = recent.refused;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::nothing_arrives}) << "it comes, and cannot be read";
    recent.refused_sacn = {};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::held_back}) << "somebody's Art-Net cannot be read";
    recent.refused = {};
    network.statistics.drops[static_cast<std::size_t>(dmx::Drop::bad_priority)] = 400; // long ago
    EXPECT_EQ(network.troubles(), Troubles{Trouble::held_back});
    expect_words(network.text(Trouble::held_back),
                 {"'FOH' (192.168.1.7) announces universe 1", "unicast", "IGMP snooping"});
    desk.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{7, 8});
    network.statistics.discovered = {desk};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::not_patched});
    expect_words(network.text(Trouble::not_patched),
                 {"announces universes 7-8", "the show wants universe 1"});
    dmx::DiscoveredSource backup = desk;
    backup.name = "Backup";
    backup.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{9});
    network.statistics.discovered.push_back(backup);
    expect_words(network.text(Trouble::not_patched), {"'Backup' (192.168.1.7) announces universe 9",
                                                      "'FOH' (192.168.1.7) announces universes 7-8"});
    Network open;
    open.statistics.discovered = {desk};
    expect_words(open.text(Trouble::nothing_arrives), {"announces universes 7-8", "--universes"});
}

TEST(diagnosis, WhatWasAnnouncedByADeskThatIsGone) {
    Network network({1});
    dmx::DiscoveredSource desk;
    desk.name = "FOH";
    desk.from = dmx::IpAddress(0xC0A80107);
    desk.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{1});
    desk.age = 9s;
    network.statistics.discovered = {desk};
    dmx::LostUniverse lost;
    lost.universe = 1;
    lost.since = 3s;
    lost.silent = 6s;
    network.statistics.lost = {lost};
    EXPECT_EQ(network.troubles(), Troubles{Trouble::lost}) << "its list outlives it";
    network.statistics.discovered[0].age = 2s;
    EXPECT_EQ(network.troubles(), (Troubles{Trouble::held_back, Trouble::lost})) << "it goes on announcing";
    network.statistics.lost.clear();
    network.sends({1});
    network.statistics.sources[0].state = dmx::SourceState::silent;
    EXPECT_EQ(network.troubles(), Troubles{}) << "between its last packet and the loss";
}

TEST(diagnosis, OneOfFourThatWouldFitIsNoShift) {
    Network hall({1, 2, 3, 4});
    hall.sends({5});
    EXPECT_EQ(hall.text(Trouble::off_by_one), "not said");
    Network half({1, 2, 3, 4});
    half.sends({4, 5});
    EXPECT_EQ(half.text(Trouble::off_by_one), "not said") << "4 is right as it is";
    Network all({1, 2});
    all.sends({2, 3});
    expect_words(all.text(Trouble::off_by_one), {"move the desk's output"});
}

TEST(diagnosis, WhoListensOnThisMachineAloneIsTold) {
    Network network({1});
    network.statistics.listening.interface = "lo";
    expect_words(network.text(Trouble::nothing_arrives), {"By lo only programs of this machine are heard"});
    network.statistics.recent.polls = 5;
    expect_words(network.text(Trouble::nothing_arrives), {"(ArtPoll) and is answered", "UDP 6454"});
}

TEST(diagnosis, TheBytesOfAUniverseInAnotherOrder) {
    Network network({1});
    network.sends({256});
    network.statistics.sources[0].wrong_group = true; // of universe 1
    dmx::DiscoveredSource desk;
    desk.name = "Desk";
    desk.from = dmx::IpAddress(0xC0A80107);
    desk.universes = std::make_shared<const std::vector<std::uint16_t>>(std::vector<std::uint16_t>{1});
    network.statistics.discovered = {desk};
    EXPECT_EQ(network.text(Trouble::held_back), "not said") << "no switch holds what comes";
    expect_words(network.text(Trouble::not_patched),
                 {"the show wants universe 1", "256 is 1 with its two bytes exchanged"});
    EXPECT_EQ(network.text(Trouble::wrong_group), "not said") << "of a universe that nobody patched";
    network.statistics.discovered.clear();
    expect_words(network.text(Trouble::not_patched),
                 {"256 is 1 with its two bytes exchanged: if that is meant", "another system's"});
    network.statistics.sources[0].universe = 257;
    EXPECT_EQ(network.text(Trouble::not_patched).find("bytes exchanged"), std::string::npos);
}

TEST(diagnosis, NetSubNetAndUniverseInAnotherOrder) {
    Network network({17});                       // 0:1:0
    network.sends({257}, dmx::Protocol::artnet); // 1:0:0
    expect_words(network.text(Trouble::not_patched),
                 {"1:0:0", "0:1:0", "another order", "wants universe 17"});
    Network other({3});
    other.sends({300}, dmx::Protocol::artnet);
    EXPECT_EQ(other.text(Trouble::not_patched).find("another order"), std::string::npos);
}

TEST(diagnosis, NamesFromTheNetworkAreMadeHarmless) {
    Network network({1});
    network.statistics.ignored = {{1, dmx::Protocol::sacn, dmx::IgnoredSource::Why::preview, "a\x1b[2Jb",
                                   dmx::IpAddress(kOurs), 4, 0s}};
    EXPECT_EQ(network.text(Trouble::preview).find('\x1b'), std::string::npos);
}

TEST(diagnosis, EveryFindingHasAName) {
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(Trouble::packets_lost); ++i)
        EXPECT_TRUE(names.insert(trouble_name(static_cast<Trouble>(i))).second);
    EXPECT_FALSE(names.contains("?"));
}

TEST(PatchMap, SlotsAndUniverses) {
    Show show = show_on({1, 3});
    show.fixtures[1].address = 511; // runs into universe 4
    show.fixtures[0].track = Track{{}, 7, 512};
    const PatchMap map(show);
    EXPECT_EQ(map.universe_numbers(), (std::vector<std::uint16_t>{1, 3, 4, 7, 8}));
    EXPECT_TRUE(map.has(4));
    EXPECT_FALSE(map.has(2));
    const auto name = [&](int universe, int address) {
        const auto found = map.at(universe, address);
        return found.size() == 1 ? found[0]->fixture_name + ": " + found[0]->channel
                                 : std::to_string(found.size());
    };
    EXPECT_EQ(name(1, 10), "Spot 1: Beam_Dimmer");
    EXPECT_EQ(name(1, 11), "Spot 1: Beam_Pan (1 of 2)");
    EXPECT_EQ(name(1, 12), "Spot 1: Beam_Pan (2 of 2)");
    EXPECT_EQ(name(1, 13), "0");
    EXPECT_EQ(name(3, 512), "Spot 2: Beam_Pan (1 of 2)");
    EXPECT_EQ(name(4, 1), "Spot 2: Beam_Pan (2 of 2)");
    EXPECT_EQ(name(8, 1), "Spot 1: track (2 of 2)");
    show.fixtures[1].address = 0;
    show.fixtures[0].track.reset();
    EXPECT_EQ(PatchMap(show).universe_numbers(), std::vector<std::uint16_t>{1});
    EXPECT_TRUE(PatchMap(Show{}).universes().empty());
}

} // namespace
} // namespace ghost::scene
