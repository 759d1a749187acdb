#pragma once
// SPDX-License-Identifier: Apache-2.0
// CRC-32 as in zip, PNG and Ethernet (polynomial 0x04C11DB7 reflected). Any thread.

#include "base/byte_reader.h"

#include <cstdint>

namespace ghost {

// before: the CRC of the bytes that stand before these, 0 where these are the first.
std::uint32_t crc32(Bytes bytes, std::uint32_t before = 0);

} // namespace ghost
