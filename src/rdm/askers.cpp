// SPDX-License-Identifier: Apache-2.0
#include "rdm/askers.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ghost::rdm {

void Askers::asked(std::uint32_t ipv4, std::uint16_t port_address, std::chrono::nanoseconds now) {
    if (!askers_.contains(ipv4) && askers_.size() >= kMaxAskers)
        forget(std::min_element(askers_.begin(), askers_.end(), [](const auto& a, const auto& b) {
                   return a.second.heard < b.second.heard;
               })->first);
    Asker& asker = askers_[ipv4];
    asker.heard = now;
    if (asker.tables.size() >= kMaxAskedPorts && !asker.tables.contains(port_address)) return;
    if (std::exchange(asker.tables[port_address].is_due, false)) std::erase(due_, Due{ipv4, port_address});
}

void Askers::heard(std::uint32_t ipv4, std::chrono::nanoseconds now) {
    if (const auto found = askers_.find(ipv4); found != askers_.end()) found->second.heard = now;
}

void Askers::changed(std::uint16_t port_address) {
    for (auto& [ipv4, asker] : askers_)
        if (const auto table = asker.tables.find(port_address);
            table != asker.tables.end() && !std::exchange(table->second.is_due, true))
            due_.push_back({ipv4, port_address});
}

std::optional<Askers::Due> Askers::next(std::chrono::nanoseconds now) {
    if (due_.empty()) return std::nullopt;
    std::vector<std::uint32_t> gone;
    for (const auto& [ipv4, asker] : askers_)
        if (now - asker.heard >= kAskerStays) gone.push_back(ipv4);
    for (const std::uint32_t ipv4 : gone) forget(ipv4);
    for (auto one = due_.begin(); one != due_.end(); ++one) {
        Table& table = askers_.at(one->ipv4).tables.at(one->port_address);
        if (table.rests > now) continue;
        table = {now + kTableRest, false};
        const Due due = *one;
        due_.erase(one);
        return due;
    }
    return std::nullopt;
}

void Askers::forget(std::uint32_t ipv4) {
    askers_.erase(ipv4);
    std::erase_if(due_, [&](const Due& one) { return one.ipv4 == ipv4; });
}

} // namespace ghost::rdm
