// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/private/groups.h"

#include "dmx/wire/build.h"

#include <algorithm>
#include <string>

namespace ghost::dmx {

std::size_t Groups::joined_by(const UdpSocket* socket) const {
    const auto same = [&](const Filled& one) { return one.socket == socket; };
    const auto found = std::find_if(sockets_.begin(), sockets_.end(), same);
    return found == sockets_.end() ? 0 : found->groups;
}

Result<Groups::Filled*> Groups::socket_with_room() {
    for (Filled& one : sockets_)
        if (one.groups < (ipv6_ ? kIpv6GroupsPerSocket : kGroupsPerSocket)) return &one;
    if (sockets_.size() >= kMostGroupSockets)
        return Error{"universes on all interfaces are more multicast groups than the " +
                         std::to_string(kMostGroupSockets) +
                         " sockets hold that may be open; choose the interface of the lighting network",
                     "--interface"};
    TRY(UdpSocket * opened, open_());
    return &sockets_.emplace_back(Filled{opened, 0});
}

void Groups::update(const std::vector<std::uint16_t>& universes,
                    const std::vector<NetInterface>& interfaces) {
    failures_.clear();
    for (auto member = members_.begin(); member != members_.end();) {
        const auto& [index, universe] = member->first;
        const bool wanted =
            std::binary_search(universes.begin(), universes.end(), universe) &&
            std::any_of(interfaces.begin(), interfaces.end(),
                        [&, i = index](const auto& one) { return one.index == i && (!ipv6_ || one.ipv6); });
        if (!wanted) {
            UdpSocket* socket = member->second.socket;
            socket->leave(sacn_group_address(universe, ipv6_), member->second.interface);
            for (Filled& one : sockets_) one.groups -= one.socket == socket ? 1 : 0;
        }
        member = wanted ? std::next(member) : members_.erase(member);
    }
    for (const std::uint16_t universe : universes)
        for (const NetInterface& interface : interfaces) {
            if (ipv6_ ? !interface.ipv6 : interface.address == 0) continue;
            if (members_.contains({interface.index, universe})) continue;
            const auto socket = socket_with_room();
            if (!socket.ok()) {
                failures_.push_back(socket.error().text());
                return; // no socket for this one, none for the next
            }
            UdpSocket* to = (*socket)->socket;
            const auto joined = to->join(sacn_group_address(universe, ipv6_), interface);
            (*socket)->groups += joined.ok() ? 1 : 0;
            if (joined.ok())
                members_[{interface.index, universe}] = {to, interface};
            else
                failures_.push_back(joined.error().text());
        }
}

} // namespace ghost::dmx
