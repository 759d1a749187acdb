// SPDX-License-Identifier: Apache-2.0
// Each sentence when it is due, and silence when all is well.
#include "diagnose/diagnosis.h"

#include "show/show.h"
#include "support/explain_trial.h"

namespace ghost::scene {
namespace {

using namespace std::chrono_literals;
using Troubles = std::vector<Trouble>;

constexpr std::uint32_t kOurs = 0xC0A80105; // 192.168.1.5

Show show_on(std::initializer_list<int> universes) {
    Show show;
    for (const int universe : universes) {
        PatchedFixture fixture;
        fixture.name = "Spot " + std::to_string(show.fixtures.size() + 1);
        fixture.type = trial::type_of(trial::kDimmer + trial::simple("2,3", "Pan", -270, 270));
        fixture.universe = universe;
        fixture.address = 10;
        show.fixtures.push_back(fixture);
    }
    return show;
}

dmx::NetInterface interface(const std::string& name, std::uint32_t address, bool loopback = false) {
    dmx::NetInterface one;
    one.name = name;
    one.index = loopback ? 1 : 2;
    one.address = address;
    one.netmask = loopback ? 0xFF000000 : 0xFFFFFF00;
    one.loopback = loopback;
    return one;
}

dmx::SourceStatus source(int universe, dmx::Protocol protocol, std::size_t slots_held = 512) {
    dmx::SourceStatus one;
    one.universe = static_cast<std::uint16_t>(universe);
    one.protocol = protocol;
    one.priority = 100;
    one.slot_count = 512;
    one.slots_held = slots_held;
    one.from = dmx::IpAddress(0xC0A80107);
    one.id = protocol == dmx::Protocol::artnet ? "192.168.1.7" : "01000000000000000000000000000000";
    if (protocol == dmx::Protocol::sacn) one.name = "Desk";
    return one;
}

// Listening for a minute, on one network.
struct Network {
    dmx::Statistics statistics;
    PatchMap patch;

    explicit Network(std::initializer_list<int> patched = {}) {
        statistics.time = 100s;
        statistics.listening.since = 40s;
        statistics.interfaces = {interface("lo", 0x7F000001, true), interface("eth0", kOurs)};
        for (const auto protocol : {dmx::Protocol::sacn, dmx::Protocol::artnet}) {
            dmx::SocketStatus socket;
            socket.protocol = protocol;
            socket.port = protocol == dmx::Protocol::sacn ? 5568 : 6454;
            statistics.sockets.push_back(socket);
        }
        patch = PatchMap(show_on(patched));
    }
    Network& sends(std::initializer_list<int> universes, dmx::Protocol protocol = dmx::Protocol::sacn) {
        for (const int universe : universes) statistics.sources.push_back(source(universe, protocol));
        return *this;
    }
    std::vector<Sentence> sentences() const { return diagnose(statistics, patch); }
    Troubles troubles() const {
        Troubles list;
        for (const Sentence& sentence : sentences()) list.push_back(sentence.trouble);
        return list;
    }
    std::string text(Trouble trouble) const {
        for (const Sentence& sentence : sentences())
            if (sentence.trouble == trouble) return sentence.text;
        return "not said";
    }
};

void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

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
    silent.statistics.notices[static_cast<std::size_t>(dmx::Notice::poll)] = 3;
    silent.statistics.packets_artnet = 3;
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"no levels arrive, though 3 other packets did (3 ", "firewall on UDP 5568 in",
                  "'tcpdump -ni any udp port 5568' shows"});
    silent.statistics.recent.refused[static_cast<std::size_t>(dmx::Drop::too_short)] = 260;
    EXPECT_EQ(silent.troubles(), Troubles{Trouble::nothing_arrives});
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"packets arrive, and none of them", "260 too_short", "is its output on"});
    silent.statistics.recent.refused[static_cast<std::size_t>(dmx::Drop::too_short)] = 1;
    expect_words(silent.text(Trouble::nothing_arrives),
                 {"though 4 other packets did", "1 too_short", "is the desk's output on"});
    silent.statistics.time = silent.statistics.listening.since + 3s;
    EXPECT_EQ(silent.troubles(), Troubles{}) << "three seconds prove nothing";
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
    Network shared({1});
    shared.sends({1}).sends({2}, dmx::Protocol::artnet);
    EXPECT_EQ(shared.troubles(), Troubles{Trouble::not_patched}) << "the Art-Net is somebody else's";
    EXPECT_FALSE(shared.sentences()[0].is_problem);
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
    network.statistics.lost = {{3, true, 70s}};
    expect_words(network.text(Trouble::lost), {"black", "70 s"});
    Network all({3});
    all.statistics.lost = {{3, false, 12s}};
    EXPECT_EQ(all.troubles(), Troubles{Trouble::lost});
}

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
    desk.back_hz = 1;
    EXPECT_EQ(network.troubles(), Troubles{}) << "it was started anew";
    desk.back_hz = 20;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::same_identity});
    expect_words(network.text(Trouble::same_identity), {"'Desk' (192.168.1.7)", "back and forth"});
    desk.port = 6454;
    desk.other_port = 40021;
    expect_words(network.text(Trouble::same_identity),
                 {"by turns from the ports 6454 and 40021", "two programs"});
    desk.late_hz = 44;
    desk.rate_hz = 0.4;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::numbering})
        << "one number that stands still, other levels";
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

TEST(diagnosis, NetSubNetAndUniverseInAnotherOrder) {
    Network network({17});                       // 0:1:0
    network.sends({257}, dmx::Protocol::artnet); // 1:0:0
    expect_words(network.text(Trouble::not_patched),
                 {"1:0:0", "0:1:0", "another order", "wants universe 17"});
    Network other({3});
    other.sends({300}, dmx::Protocol::artnet);
    EXPECT_EQ(other.text(Trouble::not_patched).find("another order"), std::string::npos);
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

TEST(diagnosis, LevelsThatWaitForASynchronisationThatStopped) {
    Network network({1});
    network.sends({1});
    network.statistics.sources[0].held = true;
    network.statistics.sources[0].sync_universe = 10;
    dmx::SyncStatus sync;
    sync.source.id[0] = 1;
    sync.universe = 10;
    sync.age = 20ms;
    network.statistics.sync = {sync};
    EXPECT_EQ(network.troubles(), Troubles{}) << "between two frames";
    network.statistics.sync[0].age = 3s;
    EXPECT_EQ(network.troubles(), Troubles{Trouble::waits_for_sync});
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
    expect_words(network.text(Trouble::packets_lost), {"1 packet got lost on the way"});
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
