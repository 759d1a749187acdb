#pragma once
// SPDX-License-Identifier: Apache-2.0
// For fuzzers of archives: a zip archive of members that are stored as they are, with right checksums, so
// that what is in them gets to its parser.

#include "base/byte_reader.h"
#include "disk/crc32.h"

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace ghost {

using ZipMember = std::pair<std::string_view, Bytes>;

inline std::vector<std::uint8_t> stored_zip(const std::vector<ZipMember>& members) {
    std::vector<std::uint8_t> zip, directory;
    const auto put = [](std::vector<std::uint8_t>& out, std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    for (const auto& [name, content] : members) {
        const auto start = static_cast<std::uint32_t>(zip.size());
        const auto size = static_cast<std::uint32_t>(content.size());
        std::vector<std::uint8_t> common;
        for (const std::uint32_t field : {20u, 0u, 0u, 0u, 0x21u}) put(common, field, 2);
        for (const std::uint32_t field : {crc32(content), size, size}) put(common, field, 4);
        put(common, static_cast<std::uint32_t>(name.size()), 2);
        put(common, 0, 2);
        put(zip, 0x04034b50, 4);
        zip.insert(zip.end(), common.begin(), common.end());
        zip.insert(zip.end(), name.begin(), name.end());
        zip.insert(zip.end(), content.begin(), content.end());
        put(directory, 0x02014b50, 4);
        put(directory, 20, 2);
        directory.insert(directory.end(), common.begin(), common.end());
        for (const int bytes : {2, 2, 2, 4}) put(directory, 0, bytes);
        put(directory, start, 4);
        directory.insert(directory.end(), name.begin(), name.end());
    }
    const auto start = static_cast<std::uint32_t>(zip.size());
    zip.insert(zip.end(), directory.begin(), directory.end());
    put(zip, 0x06054b50, 4);
    put(zip, 0, 4);
    put(zip, static_cast<std::uint32_t>(members.size()), 2);
    put(zip, static_cast<std::uint32_t>(members.size()), 2);
    put(zip, static_cast<std::uint32_t>(directory.size()), 4);
    put(zip, start, 4);
    put(zip, 0, 2);
    return zip;
}

} // namespace ghost
