// SPDX-License-Identifier: Apache-2.0
#include "image/private/exr_header.h"

#include "base/byte_reader.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>

namespace ghost::image {

Result<void> check_exr_attributes(const std::filesystem::path& path) {
    constexpr std::uint32_t kManyParts = 0x1000; // of the version
    constexpr std::size_t kLongestName = 255;
    std::error_code code;
    const std::uint64_t file_bytes = std::filesystem::file_size(path, code);
    std::ifstream file(path, std::ios::binary);
    const auto read_u32 = [&] {
        std::array<std::uint8_t, 4> four{};
        file.read(reinterpret_cast<char*>(four.data()), four.size());
        return ByteReader(Bytes(four)).u32_le();
    };
    (void)read_u32(); // what it is
    const bool has_parts = read_u32() & kManyParts;
    const auto read_name = [&] {
        std::string name;
        for (int letter = file.get(); file && letter != 0 && name.size() <= kLongestName; letter = file.get())
            name += static_cast<char>(letter);
        return name;
    };
    bool was_end = !has_parts; // the last one was the end of a part's header; an empty header ends them all
    while (file) {
        const std::string name = read_name();
        if (name.empty() && was_end) break;
        was_end = name.empty() || !has_parts;
        if (name.empty()) continue;
        (void)read_name(); // its type
        const std::uint32_t size = read_u32();
        const std::streamoff at = file.tellg();
        if (!file) break;
        if (size > file_bytes - static_cast<std::uint64_t>(at))
            return Error{"not a readable OpenEXR image: an attribute of it says that it is " +
                             std::to_string(size) + " bytes long, but the file ends at byte " +
                             std::to_string(file_bytes),
                         ""};
        file.seekg(size, std::ios::cur);
    }
    return {};
}

} // namespace ghost::image
