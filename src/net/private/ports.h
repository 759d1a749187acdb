#pragma once
// SPDX-License-Identifier: Apache-2.0
// What is said of a UDP port, on every system alike.

#include "net/socket.h"

#include <cstdint>
#include <string>

namespace ghost::dmx {

std::string port_place(IpVersion version, std::uint32_t address, std::uint16_t port);
Error port_taken(std::uint16_t port, const std::string& place); // and by whom

} // namespace ghost::dmx
