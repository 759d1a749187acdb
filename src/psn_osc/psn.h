#pragma once
// SPDX-License-Identifier: Apache-2.0
// PosiStageNet 2: where trackers on a stage are, as a tracking system multicasts it. Pure parser of one
// packet, and a table of trackers fed with them. Metres in the sender's own axes. Any bytes are taken; no
// clock: calls get the time.

#include "base/byte_reader.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ghost::dmx {

inline constexpr std::uint32_t kPsnGroup = 0xEC0A0A0A; // 236.10.10.10
inline constexpr std::uint16_t kPsnPort = 56565;
inline constexpr std::size_t kMostTrackers = 1024;
inline constexpr std::size_t kMostTrackerName = 128;         // bytes
inline constexpr std::size_t kMostOfAName = 2;               // trackers of one name that keep their places
inline constexpr std::chrono::seconds kTrackerForgotten{60}; // where others want its place

struct PsnPosition {
    std::uint16_t id = 0;
    std::array<float, 3> position_m{}; // finite
};

struct PsnPacket {
    std::vector<PsnPosition> positions; // of a data packet; trackers without a valid position are left out
    std::map<std::uint16_t, std::string> names; // of an info packet
};

// Nothing where it is no PSN packet or ends inside of a chunk.
std::optional<PsnPacket> parse_psn(Bytes bytes);

struct Tracker {
    std::array<float, 3> position_m{};
    std::string name; // empty: not told yet
    std::chrono::nanoseconds seen{0};
    bool placed = false;     // a position arrived
    std::uint64_t heard = 0; // packets with it
};

// At most kMostTrackers: a new one takes the place of one that is silent for kTrackerForgotten, else of the
// one that was heard of least, so that no number of others drives out those that go on; never of one that is
// expected: of a show's numbers, which are fewer than there are places, and of each of its names the
// kMostOfAName that were heard last, for anybody may take a name.
class Trackers {
public:
    // Those that a show names, whether they are there or not.
    void expect(std::set<std::uint16_t> ids, std::set<std::string> names);
    void feed(const PsnPacket& packet, std::chrono::nanoseconds now);
    // Null: never heard of, or without a position. A tracker that was lost stays where it was.
    const Tracker* find(std::uint16_t id) const;
    const Tracker* find(const std::string& name) const;
    const std::map<std::uint16_t, Tracker>& all() const { return trackers_; }

private:
    Tracker* find_or_add(std::uint16_t id, std::chrono::nanoseconds now, int& newcomers);
    // Whose place a new one takes; there is one.
    std::map<std::uint16_t, Tracker>::iterator least_needed(std::chrono::nanoseconds now);

    std::map<std::uint16_t, Tracker> trackers_;
    std::set<std::uint16_t> expected_ids_;
    std::set<std::string> expected_names_;
};

} // namespace ghost::dmx
