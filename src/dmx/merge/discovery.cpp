// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/discovery.h"

#include "dmx/merge/source_status.h"

#include <algorithm>

namespace ghost::dmx {

void Discovery::feed(const DiscoveryPacket& packet, std::chrono::nanoseconds now) {
    auto place = sources_.find(packet.source);
    if (place == sources_.end()) {
        if (sources_.size() >= kMaxDiscovered) {
            ++too_many_;
            return;
        }
        place = sources_.emplace(packet.source, Source{}).first;
    }
    Source& source = place->second;
    source.name = packet.source_name;
    source.from = packet.from;
    source.last = now;
    if (packet.page >= kMaxPages) {
        ++too_many_;
        return;
    }
    if (packet.page == 0 || packet.last_page != source.last_page) source.pages.clear();
    source.last_page = packet.last_page;
    source.pages[packet.page] = packet.universes;
    if (source.pages.size() <= std::min<std::size_t>(source.last_page, kMaxPages - 1)) return;

    std::vector<std::uint16_t> all;
    for (const auto& [page, universes] : source.pages)
        for (const std::uint16_t universe : universes)
            if (universe >= 1 && universe <= kMaxUniverse) all.push_back(universe);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    source.universes = std::make_shared<const std::vector<std::uint16_t>>(std::move(all));
    source.pages.clear();
}

void Discovery::tick(std::chrono::nanoseconds now) {
    std::erase_if(sources_, [&](const auto& entry) { return now - entry.second.last > kDiscoveryForgotten; });
}

std::vector<DiscoveredSource> Discovery::list(std::chrono::nanoseconds now) const {
    static const auto kNone = std::make_shared<const std::vector<std::uint16_t>>();
    std::vector<DiscoveredSource> result;
    for (const auto& [key, source] : sources_)
        result.push_back({source_id(key), source.name, source.from,
                          source.universes ? source.universes : kNone, now - source.last, key.protocol});
    return result;
}

} // namespace ghost::dmx
