#pragma once
// SPDX-License-Identifier: Apache-2.0
// Diagnosis: what is wrong between a desk and a show, in sentences that say what to do: the monitor prints
// them, the window shows them. Pure function of the receiver's statistics and the patch; where all is well it
// has nothing to say.

#include "diagnose/patch_map.h"
#include "dmx/receive/statistics.h"

#include <set>
#include <string>
#include <vector>

namespace ghost::scene {

enum class Trouble {
    not_listening,   // a port is taken, or the interface is not there
    no_interface,    // none is up but loopback, or the chosen one is gone
    cable,           // the chosen interface has none
    nothing_arrives, // of no source at all
    port_shared,     // another program has the port open
    same_host,       // a desk on this machine, whose multicast does not come back
    wrong_interface, // it comes by one that we were told not to listen on
    held_back,       // announced by sACN, and none of it arrives
    off_by_one,      // universes arrive one beside those of the patch
    not_received,    // fixtures, and no levels arrive
    not_patched,     // levels arrive, and no fixture
    short_universe,  // fewer channels arrive than are patched
    lost,            // the last source of a universe is gone
    preview,         // levels are marked for blind
    low_priority,    // another source ranks higher everywhere
    bad_priorities,  // per address, that give up or do not hold what has levels
    two_desks,       // of equal priority, that differ
    same_identity,   // two senders that are one by their CID
    numbering,       // sequence numbers that do not count up: packets are dropped as late
    too_many,        // of sources on a universe
    too_many_universes,
    waits_for_sync, // levels wait for a synchronisation packet
    other_network,  // Art-Net from a network that ours cannot answer
    wrong_group,    // levels by another universe's multicast group
    wrong_length,   // packets that declare more levels than come
    packets_lost,   // on the way, or in this machine
    two_timecodes,  // that run at one time
};
const char* trouble_name(Trouble trouble); // "off_by_one"

struct Sentence {
    Trouble trouble = Trouble::nothing_arrives;
    bool is_problem = true; // else worth knowing: a backup desk in waiting
    std::string text;
    std::set<int> universes; // that it is about; none: all
};

// What is wrong, the most telling first. Without a patch nothing is said of fixtures. The first seconds of
// listening prove no silence.
std::vector<Sentence> diagnose(const dmx::Statistics& statistics, const PatchMap& patch);

// How a source takes part: "shown", "merged", "lower priority", "in part", "waits", "silent", "held".
std::string role_text(const dmx::SourceStatus& source, const std::vector<dmx::SourceStatus>& all);

// "0:0:3" (net, sub-net, universe) of the Port-Address that is this universe of ours; "" where there is none.
std::string port_address_text(int universe, int artnet_offset);

} // namespace ghost::scene
