// SPDX-License-Identifier: Apache-2.0
// Markers as ITU-T T.81 B.1 has them; between them a decoder looks for the next 0xff, so this does.
#include "image/private/jpeg_check.h"

#include <cstddef>

namespace ghost::image {
namespace {

constexpr int kMostCodes = 256;      // T.81 B.2.4.2: one for each value of a byte
constexpr std::size_t kLengths = 16; // of codes, 1 to 16 bits
constexpr int kMostScans = 200;      // a progressive picture has 10; each goes over all of it

// Tables of a DHT segment, from behind its length.
bool tables_fit(Bytes bytes, std::size_t at, std::size_t end) {
    while (at < end) {
        int codes = 0;
        for (std::size_t i = 0; i < kLengths && at + 1 + i < bytes.size(); ++i) codes += bytes[at + 1 + i];
        if (codes > kMostCodes) return false;
        at += 1 + kLengths + static_cast<std::size_t>(codes);
    }
    return true;
}

} // namespace

std::string fault_of_jpeg(Bytes bytes) {
    std::size_t at = 0;
    while (at < bytes.size() && bytes[at] == 0xff) ++at;
    if (at == 0 || at >= bytes.size() || bytes[at] != 0xd8) return "";
    ++at;
    int scans = 0;
    while (at + 1 < bytes.size()) {
        if (bytes[at] != 0xff) {
            ++at;
            continue;
        }
        const std::uint8_t marker = bytes[at + 1];
        if (marker == 0xff) { // a fill byte
            ++at;
            continue;
        }
        at += 2;
        if (marker == 0xda && ++scans > kMostScans)
            return "more than " + std::to_string(kMostScans) + " scans";
        // Stuffing in coded data, restarts, start and end: nothing follows that has a length.
        if (marker == 0x00 || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd9)) continue;
        if (at + 2 > bytes.size()) break;
        const std::size_t length = static_cast<std::size_t>(bytes[at]) << 8 | bytes[at + 1];
        if (marker == 0xc4 && length > 2 && !tables_fit(bytes, at + 2, at + length))
            return "a Huffman table of more than 256 codes";
        at += length < 2 ? 2 : length;
    }
    return "";
}

} // namespace ghost::image
