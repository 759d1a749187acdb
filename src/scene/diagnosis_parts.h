#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the sentences of diagnosis.h are made of: what arrives, and words for universes, sources, addresses.
// Pure.

#include "dmx/statistics.h"

#include <map>
#include <set>
#include <string>

namespace ghost::scene::diagnosed {

// What comes, whether it is shown or not.
struct Arriving {
    explicit Arriving(const dmx::Statistics& statistics);

    std::map<int, std::string> universes; // levels, and from whom
    std::map<dmx::Protocol, std::set<int>> by_protocol;
    std::set<int> listed; // in the lists of sACN sources (universe discovery)

    bool nothing() const { return universes.empty(); }
    bool has(int universe) const { return universes.contains(universe); }
    bool by(dmx::Protocol protocol) const { return by_protocol.contains(protocol); }
    // What comes by a protocol, or would if we had joined it.
    std::set<int> announced(dmx::Protocol protocol) const;
};

std::string printable(const std::string& text); // a name that somebody on the network chose
std::string count_text(std::uint64_t count, const std::string& word); // "1 fixture", "2 fixtures"
std::string universes_text(const std::set<int>& universes);           // "universe 7", "universes 1-4, 9"
std::string seconds_text(std::chrono::nanoseconds time);
// "'Desk' (10.0.0.2)", "10.0.0.2 (Art-Net)".
std::string source_text(const std::string& name, const std::string& place, dmx::Protocol protocol);
// Of the interfaces that we listen on: "eth0 (192.168.1.5/24)".
std::string addresses_text(const dmx::Statistics& statistics);
// One of them is in 2.0.0.0/8 or 10.0.0.0/8.
bool has_artnet_address(const dmx::Statistics& statistics);
// An address of none of our networks.
bool is_foreign(const dmx::IpAddress& address, const dmx::Statistics& statistics);
bool synchronisation_is_late(const dmx::SourceStatus& source, const std::vector<dmx::SyncStatus>& sync);
// " (Art-Net Port-Address 0:0:7)" where it is one universe, else nothing.
std::string port_addresses_hint(const std::set<int>& universes, const dmx::Listening& listening);

} // namespace ghost::scene::diagnosed
