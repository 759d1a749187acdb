// SPDX-License-Identifier: Apache-2.0
#include "net/address.h"

#include <cstdio>

namespace ghost::dmx {

std::string address_text(const IpAddress& address) {
    const auto& b = address.bytes;
    char part[16];
    if (address.is_ipv4()) {
        std::snprintf(part, sizeof part, "%d.%d.%d.%d", b[12], b[13], b[14], b[15]);
        return part;
    }
    if (address == IpAddress()) return "-";
    std::array<int, 8> words{};
    for (std::size_t i = 0; i < 8; ++i) words[i] = b[2 * i] << 8 | b[2 * i + 1];
    // The longest run of zeros, two or more, becomes "::".
    std::size_t zeros_from = 8, zeros = 1;
    for (std::size_t i = 0; i < 8; ++i) {
        std::size_t end = i;
        while (end < 8 && words[end] == 0) ++end;
        if (end - i > zeros) {
            zeros_from = i;
            zeros = end - i;
        }
    }
    std::string text;
    for (std::size_t i = 0; i < 8; ++i) {
        if (i == zeros_from) {
            text += "::";
            i += zeros - 1;
            continue;
        }
        std::snprintf(part, sizeof part, "%x", words[i]);
        if (!text.empty() && text.back() != ':') text += ':';
        text += part;
    }
    return text;
}

} // namespace ghost::dmx
