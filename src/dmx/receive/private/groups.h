#pragma once
// SPDX-License-Identifier: Apache-2.0
// Groups: memberships in the multicast groups of sACN universes on all interfaces, spread over as many
// sockets as they need (the kernel allows 20 each for IPv4). update() brings them in line with what is wanted
// and with the interfaces that are there now; one that came back is joined again.

#include "base/result.h"
#include "net/socket.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kGroupsPerSocket = 20;      // net.ipv4.igmp_max_memberships
inline constexpr std::size_t kIpv6GroupsPerSocket = 100; // a quarter of what net.core.optmem_max has room for
// A process has 1,024 descriptors where nobody says else, and needs some to save a show.
inline constexpr std::size_t kMostGroupSockets = 256;

class Groups {
public:
    using Open = std::function<Result<UdpSocket*>()>; // another socket; it must outlive this

    Groups(bool ipv6, Open open) : ipv6_(ipv6), open_(std::move(open)) {}

    // Joins what is missing, leaves what is not wanted. Sorted universes. Problems are said in failures();
    // what failed is tried again with the next call.
    void update(const std::vector<std::uint16_t>& universes, const std::vector<NetInterface>& interfaces);
    const std::vector<std::string>& failures() const { return failures_; } // of the last update
    std::size_t joined_by(const UdpSocket* socket) const;

private:
    struct Member {
        UdpSocket* socket = nullptr;
        NetInterface interface;
    };
    struct Filled {
        UdpSocket* socket = nullptr;
        std::size_t groups = 0;
    };
    Result<Filled*> socket_with_room();

    bool ipv6_;
    Open open_;
    std::vector<Filled> sockets_;
    std::map<std::pair<unsigned, std::uint16_t>, Member> members_; // interface index, universe
    std::vector<std::string> failures_;
};

} // namespace ghost::dmx
