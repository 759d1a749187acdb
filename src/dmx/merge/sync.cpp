// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/sync.h"

#include <algorithm>
#include <utility>

namespace ghost::dmx {

SourceKey sender_of(SourceKey source) {
    if (source.protocol == Protocol::artnet) source.id[4] = 0;
    source.preview = false;
    return source;
}

std::size_t SyncStreams::place_of(const SourceKey& source, std::uint16_t universe) const {
    const SourceKey key = sender_of(source);
    const auto same = [&](const Stream& s) { return s.universe == universe && s.source == key; };
    return static_cast<std::size_t>(std::find_if(streams_.begin(), streams_.end(), same) - streams_.begin());
}

std::set<std::uint16_t> SyncStreams::heard(const SyncPacket& packet, std::chrono::nanoseconds now) {
    const std::size_t place = place_of(packet.source, packet.universe);
    if (place == kMaxSyncStreams) {
        ++too_many_;
        return {};
    }
    if (place == streams_.size()) {
        streams_.emplace_back();
        streams_.back().source = sender_of(packet.source);
        streams_.back().universe = packet.universe;
    }
    Stream& stream = streams_[place];
    if (packet.source.protocol == Protocol::sacn) {
        if (now - stream.last > kSacnSyncLoss) stream.sequence.forget();
        if (!stream.sequence.accept(packet.sequence)) {
            ++stream.late;
            return {};
        }
    }
    ++stream.packets;
    stream.last = std::max(stream.last, now);
    return std::exchange(stream.waiting, {});
}

void SyncStreams::wait(const SourceKey& source, std::uint16_t universe, std::uint16_t waiting) {
    const std::size_t place = place_of(source, universe);
    if (place < streams_.size()) streams_[place].waiting.insert(waiting);
}

bool SyncStreams::holds(const SourceKey& source, std::uint16_t universe, bool force,
                        std::chrono::nanoseconds now) const {
    const std::size_t place = place_of(source, universe);
    if (place == streams_.size() || streams_[place].packets == 0) return false;
    const auto limit = source.protocol == Protocol::artnet ? kArtnetSyncLoss
                       : force                             ? kSacnSyncLoss
                                                           : kSacnSyncHold;
    return now - streams_[place].last <= limit;
}

void SyncStreams::tick(std::chrono::nanoseconds now) {
    std::erase_if(streams_, [&](const Stream& stream) { return now - stream.last > kSyncForgotten; });
}

void SyncStreams::resume(std::chrono::nanoseconds pause, std::chrono::nanoseconds now) {
    for (Stream& stream : streams_) {
        stream.last = std::max(stream.last, std::min(stream.last + pause, now));
        stream.sequence.forget();
    }
}

std::vector<SyncStatus> SyncStreams::list(std::chrono::nanoseconds now) const {
    std::vector<SyncStatus> result;
    for (const Stream& stream : streams_)
        result.push_back({stream.source, stream.universe, stream.packets, stream.late, now - stream.last});
    return result;
}

} // namespace ghost::dmx
