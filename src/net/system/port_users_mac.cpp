// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
#include "net/private/listed_sockets.h"

namespace ghost::dmx {

// Without root macOS shows a program its own sockets alone.
std::vector<ListedSocket> listed_elsewhere(std::span<const std::uint16_t>) {
    return {};
}

std::vector<PortUser> named_users(std::vector<ListedSocket>) {
    return {};
}

} // namespace ghost::dmx
