// SPDX-License-Identifier: Apache-2.0
// Chunks: id (16 bits), then 15 bits of length and one that says whether chunks are inside; little-endian.
#include "psn_osc/psn.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <iterator>
#include <string_view>
#include <tuple>
#include <utility>

namespace ghost::dmx {

namespace {

constexpr std::uint16_t kDataPacket = 0x6755, kInfoPacket = 0x6756;
constexpr std::uint16_t kDataTrackers = 1, kInfoTrackers = 2;
constexpr std::uint16_t kTrackerName = 0;
constexpr std::uint16_t kTrackerPosition = 0, kTrackerValidity = 3;

struct Chunk {
    std::uint16_t id = 0;
    Bytes data;
};

// The next chunk; nothing at the end, and reader not ok() where one is cut.
std::optional<Chunk> next_chunk(ByteReader& reader) {
    if (!reader.ok() || reader.left() == 0) return std::nullopt;
    const std::uint16_t id = reader.u16_le();
    const std::uint16_t length = reader.u16_le() & 0x7FFF;
    const Bytes data = reader.take(length);
    if (!reader.ok()) return std::nullopt;
    return Chunk{id, data};
}

float read_float(ByteReader& reader) {
    return std::bit_cast<float>(reader.u32_le());
}

bool read_position(const Chunk& tracker, std::vector<PsnPosition>& positions) {
    ByteReader reader(tracker.data);
    PsnPosition result;
    result.id = tracker.id;
    bool placed = false, valid = true;
    while (const auto field = next_chunk(reader)) {
        ByteReader values(field->data);
        if (field->id == kTrackerPosition) {
            for (float& axis : result.position_m) axis = read_float(values);
            placed = values.ok() && std::all_of(result.position_m.begin(), result.position_m.end(),
                                                [](float axis) { return std::isfinite(axis); });
        } else if (field->id == kTrackerValidity) {
            valid = read_float(values) > 0.0f;
        }
        if (!values.ok()) return false;
    }
    if (placed && valid && positions.size() < kMostTrackers) positions.push_back(result);
    return reader.ok();
}

bool read_name(const Chunk& tracker, std::map<std::uint16_t, std::string>& names) {
    ByteReader reader(tracker.data);
    while (const auto field = next_chunk(reader)) {
        if (field->id != kTrackerName || names.size() >= kMostTrackers) continue;
        const Bytes text = field->data.first(std::min(field->data.size(), kMostTrackerName));
        names[tracker.id] = std::string(text.begin(), std::find(text.begin(), text.end(), std::uint8_t{0}));
    }
    return reader.ok();
}

} // namespace

std::optional<PsnPacket> parse_psn(Bytes bytes) {
    ByteReader reader(bytes);
    const auto root = next_chunk(reader);
    if (!root || (root->id != kDataPacket && root->id != kInfoPacket)) return std::nullopt;
    const bool data = root->id == kDataPacket;
    PsnPacket packet;
    ByteReader parts(root->data);
    while (const auto part = next_chunk(parts)) {
        if (part->id != (data ? kDataTrackers : kInfoTrackers)) continue;
        ByteReader list(part->data);
        while (const auto tracker = next_chunk(list))
            if (!(data ? read_position(*tracker, packet.positions) : read_name(*tracker, packet.names)))
                return std::nullopt;
        if (!list.ok()) return std::nullopt;
    }
    if (!parts.ok()) return std::nullopt;
    return packet;
}

void Trackers::expect(std::set<std::uint16_t> ids, std::set<std::string> names) {
    expected_ids_ = std::move(ids);
    expected_names_ = std::move(names);
}

std::map<std::uint16_t, Tracker>::iterator Trackers::least_needed(std::chrono::nanoseconds now) {
    using Heard = std::pair<std::chrono::nanoseconds, std::uint16_t>;
    std::map<std::string_view, std::array<Heard, kMostOfAName>> last; // the last ones first
    for (const auto& [id, tracker] : trackers_) {
        if (!expected_names_.contains(tracker.name)) continue;
        auto& heard = last.try_emplace(tracker.name).first->second;
        if (const Heard one{tracker.seen, id}; one > heard.back()) {
            heard.back() = one;
            std::sort(heard.begin(), heard.end(), std::greater<>());
        }
    }
    const auto worth = [&](std::uint16_t id, const Tracker& one) {
        const auto of_name = last.find(one.name);
        const bool is_needed = expected_ids_.contains(id) ||
                               (of_name != last.end() && Heard{one.seen, id} >= of_name->second.back());
        return std::tuple(is_needed, now - one.seen > kTrackerForgotten ? 0 : one.heard, one.seen);
    };
    auto least = trackers_.begin();
    auto least_worth = worth(least->first, least->second);
    for (auto it = std::next(least); it != trackers_.end(); ++it)
        if (const auto its = worth(it->first, it->second); its < least_worth) {
            least = it;
            least_worth = its;
        }
    return least;
}

Tracker* Trackers::find_or_add(std::uint16_t id, std::chrono::nanoseconds now, int& newcomers) {
    const auto found = trackers_.find(id);
    if (found == trackers_.end() && trackers_.size() >= kMostTrackers) {
        if (!expected_ids_.contains(id) && newcomers-- <= 0) return nullptr;
        trackers_.erase(least_needed(now));
    }
    Tracker& tracker = trackers_[id];
    tracker.seen = now;
    ++tracker.heard;
    return &tracker;
}

void Trackers::feed(const PsnPacket& packet, std::chrono::nanoseconds now) {
    int newcomers = 4; // that take a place: each is a search through all
    for (const PsnPosition& position : packet.positions)
        if (Tracker* tracker = find_or_add(position.id, now, newcomers)) {
            tracker->position_m = position.position_m;
            tracker->placed = true;
        }
    for (const auto& [id, name] : packet.names)
        if (Tracker* tracker = find_or_add(id, now, newcomers)) tracker->name = name;
}

const Tracker* Trackers::find(std::uint16_t id) const {
    const auto found = trackers_.find(id);
    return found != trackers_.end() && found->second.placed ? &found->second : nullptr;
}

const Tracker* Trackers::find(const std::string& name) const {
    for (const auto& [id, tracker] : trackers_)
        if (tracker.placed && tracker.name == name) return &tracker;
    return nullptr;
}

} // namespace ghost::dmx
