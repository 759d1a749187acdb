#pragma once
// SPDX-License-Identifier: Apache-2.0
// SyncStreams: who sends synchronisation packets, and so whose levels wait for the next one.
//
// sACN (E1.31-2018 6.2.4.1, 6.2.6 and 6.3): levels that name a synchronisation universe are held from that
// source's first sync packet of that universe on. Before it, and for a sender that never sends one, they show
// at once. When sync packets stop for 2.5 s, a source with Force_Synchronization goes on without; one without
// the bit holds as the standard asks, but not for ever: after 10 s it goes on, too. Art-Net 4: ArtSync holds
// the ArtDmx of its sender; 4 s after the last one they show at once again. No clock: every call gets the
// time. Bounded: kMaxSyncStreams, the rest is counted.

#include "dmx/wire/packet.h"
#include "dmx/wire/sequence.h"

#include <chrono>
#include <set>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kMaxSyncStreams = 64;
inline constexpr std::chrono::milliseconds kSacnSyncLoss{2500};
inline constexpr std::chrono::milliseconds kSacnSyncHold{10000};
inline constexpr std::chrono::milliseconds kArtnetSyncLoss{4000};
inline constexpr std::chrono::milliseconds kSyncForgotten{60000};

// For people.
struct SyncStatus {
    SourceKey source;
    std::uint16_t universe = 0; // 0: Art-Net
    std::uint64_t packets = 0;
    std::uint64_t late = 0; // dropped by their number
    std::chrono::nanoseconds age{0};
};

// The sender alone: of Art-Net the address, whatever the Physical of its levels, and for preview the same.
SourceKey sender_of(SourceKey source);

class SyncStreams {
public:
    // The universes of which levels wait for it; none for a late packet and for one stream too many.
    std::set<std::uint16_t> heard(const SyncPacket& packet, std::chrono::nanoseconds now);
    // Whether levels of this source have to wait at this time.
    bool holds(const SourceKey& source, std::uint16_t universe, bool force,
               std::chrono::nanoseconds now) const;
    // Levels of a universe wait for the next packet of a stream that holds().
    void wait(const SourceKey& source, std::uint16_t universe, std::uint16_t waiting);
    // Lets streams go that were silent for kSyncForgotten.
    void tick(std::chrono::nanoseconds now);
    // We did not listen for this long: that was no silence, and the next number counts whatever it is.
    void resume(std::chrono::nanoseconds pause, std::chrono::nanoseconds now);

    std::vector<SyncStatus> list(std::chrono::nanoseconds now) const;
    std::uint64_t too_many() const { return too_many_; }

private:
    struct Stream {
        SourceKey source;
        std::uint16_t universe = 0;
        Sequence sequence;
        std::uint64_t packets = 0, late = 0;
        std::chrono::nanoseconds last{0};
        std::set<std::uint16_t> waiting;
    };
    // streams_.size(): none is there.
    std::size_t place_of(const SourceKey& source, std::uint16_t universe) const;

    std::vector<Stream> streams_;
    std::uint64_t too_many_ = 0;
};

} // namespace ghost::dmx
