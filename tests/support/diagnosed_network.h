#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a receiver knows of a network and a show on it, for tests of the diagnosis.

#include "diagnose/diagnosis.h"
#include "show/show.h"
#include "support/explain_trial.h"

#include <gtest/gtest.h>

#include <chrono>
#include <initializer_list>
#include <string>
#include <vector>

namespace ghost::scene::diagnosed_trial {

using namespace std::chrono_literals;
using Troubles = std::vector<Trouble>;

inline constexpr std::uint32_t kOurs = 0xC0A80105; // 192.168.1.5

inline Show show_on(std::initializer_list<int> universes) {
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

inline dmx::NetInterface interface(const std::string& name, std::uint32_t address, bool loopback = false) {
    dmx::NetInterface one;
    one.name = name;
    one.index = loopback ? 1 : 2;
    one.address = address;
    one.netmask = loopback ? 0xFF000000 : 0xFFFFFF00;
    one.loopback = loopback;
    return one;
}

inline dmx::SourceStatus source(int universe, dmx::Protocol protocol, std::size_t slots_held = 512) {
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

inline void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

} // namespace ghost::scene::diagnosed_trial
