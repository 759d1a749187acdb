#pragma once
// SPDX-License-Identifier: Apache-2.0
// Discovery: the lists of universes that sACN sources announce every 10 s (E1.31-2018 section 8, and its
// draft of 2014), and those that senders of Art-Net name in ArtPollReply: what is on the network, whether we
// listen to it or not. A list counts when all its pages came. No clock. Bounded: kMaxDiscovered sources, of
// one with more pages than kMaxPages the first.

#include "dmx/wire/packet.h"

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ghost::dmx {

inline constexpr std::uint16_t kDiscoveryUniverse = 64214; // its group, 239.255.250.214
inline constexpr std::size_t kMaxDiscovered = 64;
inline constexpr std::size_t kMaxPages = 125;                  // 64000 universes
inline constexpr std::chrono::seconds kDiscoveryForgotten{25}; // two announcements missed

// For people.
struct DiscoveredSource {
    std::string id; // CID as 32 hex digits, or an address
    std::string name;
    IpAddress from;
    std::shared_ptr<const std::vector<std::uint16_t>> universes; // sorted, each once
    std::chrono::nanoseconds age{0};                             // since its last page
    Protocol protocol = Protocol::sacn;
};

class Discovery {
public:
    void feed(const DiscoveryPacket& packet, std::chrono::nanoseconds now);
    // Lets sources go that were silent for kDiscoveryForgotten.
    void tick(std::chrono::nanoseconds now);
    std::vector<DiscoveredSource> list(std::chrono::nanoseconds now) const;
    std::uint64_t too_many() const { return too_many_; }

private:
    struct Source {
        std::string name;
        IpAddress from;
        std::map<std::uint8_t, std::vector<std::uint16_t>> pages; // of the list that is coming in
        std::uint8_t last_page = 0;
        std::shared_ptr<const std::vector<std::uint16_t>> universes;
        std::chrono::nanoseconds last{0};
    };

    std::map<SourceKey, Source> sources_;
    std::uint64_t too_many_ = 0;
};

} // namespace ghost::dmx
