// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/ghostdmx_block.h"

#include <algorithm>

namespace ghost::dmx::ghostdmx {

namespace {

constexpr std::size_t kGap = 2; // so few equal slots between two changed ones are cheaper inside of a run
constexpr std::uint64_t kLost = 1, kNewSlotCount = 2;
constexpr int kFlagBits = 2;

const std::shared_ptr<const Levels>& dark() {
    static const auto levels = std::make_shared<const Levels>();
    return levels;
}

struct Run {
    std::size_t first = 0, count = 0;
};

void put_levels(const Levels& before, const Levels& now, std::vector<std::uint8_t>& out) {
    std::array<Run, kSlots / 2> runs; // kGap or more equal slots lie between two
    std::size_t count = 0;
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
        if (before[slot] == now[slot]) continue;
        Run* last = count > 0 ? &runs[count - 1] : nullptr;
        if (last && slot - (last->first + last->count) <= kGap)
            last->count = slot + 1 - last->first;
        else
            runs[count++] = {slot, 1};
    }
    put_varint(out, count);
    std::size_t end = 0;
    for (std::size_t i = 0; i < count; ++i) {
        put_varint(out, runs[i].first - end);
        put_varint(out, runs[i].count);
        end = runs[i].first + runs[i].count;
        for (std::size_t slot = runs[i].first; slot < end; ++slot)
            out.push_back(static_cast<std::uint8_t>(now[slot] - before[slot]));
    }
}

} // namespace

void encode_key(const States& states, microseconds start, std::uint64_t frame_number,
                std::vector<std::uint8_t>& out) {
    put_varint(out, states.size());
    std::uint16_t before = 0;
    for (const auto& [universe, state] : states) {
        put_varint(out, static_cast<std::uint64_t>(universe - before));
        put_varint(out, static_cast<std::uint64_t>(state.slot_count) << 1 | (state.lost ? kLost : 0));
        put_varint(out, static_cast<std::uint64_t>((start - state.time).count()));
        put_varint(out, frame_number - state.revision);
        put_levels(*dark(), *state.levels, out);
        before = universe;
    }
}

void encode_frame(const RecordedFrame& frame, microseconds before, std::uint64_t frame_number, States& states,
                  std::vector<std::uint8_t>& out) {
    const auto [place, added] = states.try_emplace(frame.universe);
    State& state = place->second;
    if (added) state.levels = dark();
    const bool new_count = added || state.slot_count != frame.slot_count;
    put_varint(out, static_cast<std::uint64_t>((frame.time - before).count()));
    put_varint(out, static_cast<std::uint64_t>(frame.universe) << kFlagBits |
                        (new_count ? kNewSlotCount : 0) | (frame.lost ? kLost : 0));
    if (new_count) put_varint(out, frame.slot_count);
    put_levels(*state.levels, *frame.levels, out);
    if (added || *state.levels != *frame.levels) state.revision = frame_number + 1;
    state.time = frame.time;
    state.slot_count = frame.slot_count;
    state.lost = frame.lost;
    state.levels = frame.levels;
}

BlockCursor::BlockCursor(std::vector<std::uint8_t> bytes, const BlockPlace& place)
    : bytes_(std::move(bytes)), time_(place.start), frame_number_(place.first_frame) {
    read_key(place);
    if (malformed_) states_.clear();
    read_time();
}

std::shared_ptr<const Levels> BlockCursor::read_levels(const std::shared_ptr<const Levels>& before) {
    ByteReader reader(Bytes(bytes_).subspan(position_));
    const std::uint64_t runs = read_varint(reader);
    std::shared_ptr<const Levels> result = before;
    if (runs > 0 && runs <= kSlots) {
        auto levels = std::make_shared<Levels>(*before);
        std::size_t slot = 0;
        for (std::uint64_t run = 0; run < runs && reader.ok(); ++run) {
            const std::uint64_t skip = read_varint(reader), count = read_varint(reader);
            if (skip > kSlots - slot || count > kSlots - slot - skip) {
                malformed_ = true;
                return before;
            }
            slot += static_cast<std::size_t>(skip);
            for (const std::uint8_t change : reader.take(static_cast<std::size_t>(count))) {
                (*levels)[slot] = static_cast<std::uint8_t>((*levels)[slot] + change);
                ++slot;
            }
        }
        result = std::move(levels);
    }
    if (!reader.ok() || runs > kSlots) malformed_ = true;
    position_ += reader.position();
    return result;
}

void BlockCursor::read_key(const BlockPlace& place) {
    ByteReader reader{Bytes(bytes_)};
    const std::uint64_t count = read_varint(reader);
    position_ = reader.position();
    malformed_ = !reader.ok() || count > kMaxRecordedUniverses;
    std::uint64_t universe = 0;
    for (std::uint64_t i = 0; i < count && !malformed_; ++i) {
        ByteReader entry(Bytes(bytes_).subspan(position_));
        const std::uint64_t step = read_varint(entry), flags = read_varint(entry), age = read_varint(entry),
                            unchanged = read_varint(entry);
        position_ += entry.position();
        malformed_ = !entry.ok() || step == 0 || step > kMaxUniverse - universe || flags >> 1 > kSlots ||
                     age > static_cast<std::uint64_t>(place.start.count()) || unchanged >= place.first_frame;
        if (malformed_) return;
        universe += step;
        State& state = states_[static_cast<std::uint16_t>(universe)];
        state.time = place.start - microseconds(static_cast<std::int64_t>(age));
        state.revision = place.first_frame - unchanged;
        state.slot_count = static_cast<std::uint16_t>(flags >> 1);
        state.lost = (flags & kLost) != 0;
        state.levels = read_levels(dark());
    }
}

void BlockCursor::read_time() {
    next_time_.reset();
    if (malformed_ || position_ == bytes_.size()) return;
    ByteReader reader(Bytes(bytes_).subspan(position_));
    const std::uint64_t pause = read_varint(reader);
    malformed_ = !reader.ok() || pause > static_cast<std::uint64_t>((kLongestRecording - time_).count());
    if (malformed_) return;
    position_ += reader.position();
    next_time_ = time_ + microseconds(static_cast<std::int64_t>(pause));
}

std::uint16_t BlockCursor::next() {
    ByteReader reader(Bytes(bytes_).subspan(position_));
    const std::uint64_t flags = read_varint(reader);
    const std::uint64_t universe = flags >> kFlagBits;
    const std::uint64_t slots = (flags & kNewSlotCount) ? read_varint(reader) : 0;
    const auto known = states_.find(static_cast<std::uint16_t>(universe));
    const bool added = known == states_.end();
    position_ += reader.position();
    if (!reader.ok() || universe < 1 || universe > kMaxUniverse || slots > kSlots ||
        (added && states_.size() == kMaxRecordedUniverses))
        malformed_ = true;
    const auto levels = malformed_ ? nullptr : read_levels(added ? dark() : known->second.levels);
    if (malformed_) {
        next_time_.reset();
        return 0;
    }
    State& state = states_[static_cast<std::uint16_t>(universe)];
    if (added || *levels != *state.levels) state.revision = frame_number_ + 1;
    if (flags & kNewSlotCount) state.slot_count = static_cast<std::uint16_t>(slots);
    state.levels = levels;
    state.lost = (flags & kLost) != 0;
    state.time = time_ = *next_time_;
    ++frame_number_;
    read_time();
    return static_cast<std::uint16_t>(universe);
}

} // namespace ghost::dmx::ghostdmx
