#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the sentences of diagnosis.h are made of: what arrives, words for universes, sources, addresses, and
// the sentences themselves by what they are about. Pure.

#include "diagnose/diagnosis.h"
#include "dmx/receive/statistics.h"

#include <map>
#include <set>
#include <string>

namespace ghost::scene::diagnosed {

inline constexpr std::chrono::seconds kSilent{1}; // too long for a desk whose levels move

// What comes, whether it is shown or not.
struct Arriving {
    explicit Arriving(const dmx::Statistics& statistics);

    std::map<int, std::string> universes; // levels, and from whom, of several the first by name
    std::set<int> shared;                 // that several send
    std::map<dmx::Protocol, std::set<int>> by_protocol;
    struct Listed {
        std::string who;
        dmx::Protocol protocol;
        std::chrono::nanoseconds age; // of the list
    };
    // In the lists of sACN sources (universe discovery); where no levels arrive at all also what senders of
    // Art-Net name in their replies, for they send to those alone that asked for it.
    std::map<int, Listed> listed;

    bool nothing() const { return universes.empty(); }
    bool has(int universe) const { return universes.contains(universe); }
    bool by(dmx::Protocol protocol) const { return by_protocol.contains(protocol); }
    // What comes by a protocol, or would if we had joined it.
    std::set<int> announced(dmx::Protocol protocol) const;
    // "'FOH' (10.0.0.7) announces universes 100-103, ..." of these.
    std::string announced_text(const std::set<int>& universes) const;
};

std::string count_text(std::uint64_t count, const std::string& word); // "1 fixture", "2 fixtures"
std::string universes_text(const std::set<int>& universes);           // "universe 7", "universes 1-4, 9"
std::set<int> numbers_of(const PatchMap& patch);
// 256 of 1: what a sender writes that takes network byte order for its own.
inline int bytes_exchanged(int universe) {
    return (universe & 0xFF) << 8 | universe >> 8;
}
std::string seconds_text(std::chrono::nanoseconds time);
// "'Desk' (10.0.0.2)", "10.0.0.2 (Art-Net)".
std::string source_text(const std::string& name, const std::string& place, dmx::Protocol protocol);
std::string source_text(const dmx::SourceStatus& source);
// "; 'Desk' (10.0.0.2) on universe 1: only priorities per address ..", of the patch; "" where all that comes
// has levels.
std::string empty_text(const dmx::Statistics& statistics, const PatchMap& patch);
// Packets come for it, and none of somebody's has a level.
bool is_without_levels(const dmx::Statistics& statistics, int universe);
// Of the interfaces that we listen on: "eth0 (192.168.1.5/24)".
std::string addresses_text(const dmx::Statistics& statistics);
// ". eth0 has a cable and no IPv4 address: ..", of those that we listen on; "" where each has one.
std::string unaddressed_text(const dmx::Statistics& statistics);
// Which of Art-Net's usual broadcasts (2.255.255.255, 10.255.255.255) no interface of ours takes, and what
// would help; "" where all of them arrive.
std::string broadcasts_text(const dmx::Statistics& statistics);
// An address of none of our networks.
bool is_foreign(const dmx::IpAddress& address, const dmx::Statistics& statistics);
bool synchronisation_is_late(const dmx::SourceStatus& source);
// " (Art-Net Port-Address 0:0:7)" where it is one universe, else nothing.
std::string port_addresses_hint(const std::set<int>& universes, const dmx::Listening& listening);

// The sentences. A problem or a note, about these universes; none: about everything.
Sentence problem(Trouble trouble, std::string text, std::set<int> universes = {});
Sentence note(Trouble trouble, std::string text, std::set<int> universes = {});

using Sentences = std::vector<Sentence>;
void add_links(const dmx::Statistics& statistics, bool any_arrives, Sentences& out);
// all_fed: every universe of the patch arrives.
void add_silence(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
                 bool all_fed, Sentences& out);
void add_patch(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
               Sentences& out);
void add_lost(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out);
void add_ignored(const dmx::Statistics& statistics, Sentences& out);
// Priorities and merges.
void add_ranks(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out);
void add_numbering(const dmx::Statistics& statistics, Sentences& out); // sequence numbers and CIDs
void add_sources(const dmx::Statistics& statistics, Sentences& out);
// "400 bad_priority" of late, where these are more than anybody's; else "".
std::string unreadable_text(const dmx::Statistics& statistics);

} // namespace ghost::scene::diagnosed
