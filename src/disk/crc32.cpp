// SPDX-License-Identifier: Apache-2.0
#include "disk/crc32.h"

#include <zlib.h>

namespace ghost {

std::uint32_t crc32(Bytes bytes, std::uint32_t before) {
    if (bytes.empty()) return before; // zlib would begin anew where there is no address
    return static_cast<std::uint32_t>(::crc32_z(before, bytes.data(), bytes.size()));
}

} // namespace ghost
