#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the system tells of UDP sockets of other programs; where it does not, nothing. Any thread.

#include "net/port_users.h"

namespace ghost::dmx {

std::vector<ListedSocket> listed_elsewhere(std::span<const std::uint16_t> ports); // in order
std::vector<PortUser> named_users(std::vector<ListedSocket> sockets);

} // namespace ghost::dmx
