#pragma once
// SPDX-License-Identifier: Apache-2.0
// SHA-1 (RFC 3174), which a WebSocket's handshake asks for; it keeps no secret there. Pure.

#include "base/byte_reader.h"

#include <array>
#include <cstdint>

namespace ghost::web {

std::array<std::uint8_t, 20> sha1(Bytes bytes);

} // namespace ghost::web
