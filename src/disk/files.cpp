// SPDX-License-Identifier: Apache-2.0
#include "disk/files.h"

#include "disk/crc32.h"
#include "disk/own_folder.h"
#include "disk/private/system_files.h"
#include "disk/temporary.h"

#include <atomic>
#include <charconv>
#include <random>

namespace ghost {
namespace fs = std::filesystem;
namespace {

// Two machines may have processes of the same number.
std::uint32_t host_code() {
    const std::string name = host_name();
    return crc32(Bytes(reinterpret_cast<const std::uint8_t*>(name.data()), name.size()));
}

template <class Container>
Result<Container> read_into(const fs::path& path, std::uintmax_t limit_bytes) {
    std::error_code code;
    if (!fs::exists(path, code)) return Error{"no such file", path.string()};
    if (!fs::is_regular_file(path, code)) return Error{"not a plain file", path.string()};
    const std::uintmax_t size = fs::file_size(path, code);
    if (code) return Error{"cannot read its size: " + code.message(), path.string()};
    if (size > limit_bytes)
        return Error{"is " + std::to_string(size) + " bytes, more than the limit of " +
                         std::to_string(limit_bytes),
                     path.string()};
    Container content(static_cast<std::size_t>(size), typename Container::value_type{});
    TRY(const std::size_t done, read_bytes(path, {reinterpret_cast<char*>(content.data()), content.size()}));
    content.resize(done);
    return content;
}

} // namespace

Result<std::vector<std::uint8_t>> read_file(const fs::path& path, std::uintmax_t limit_bytes) {
    return read_into<std::vector<std::uint8_t>>(path, limit_bytes);
}

Result<std::string> read_text_file(const fs::path& path, std::uintmax_t limit_bytes) {
    return read_into<std::string>(path, limit_bytes);
}

fs::path temporary_beside(const fs::path& path) {
    static std::atomic<std::uint32_t> counter{std::random_device{}()};
    const std::uint64_t number = std::uint64_t{host_code()} << 32 | counter++;
    fs::path result = path;
    // The extension stays last: writers choose their format by it.
    result.replace_filename("." + path.stem().string() + ".part" + std::to_string(own_process()) + "_" +
                            std::to_string(number) + path.extension().string());
    return result;
}

Writer writer_of(const fs::path& path) {
    const std::string name = path.filename().string();
    const std::size_t part = name.rfind(".part");
    if (part == std::string::npos || name[0] != '.') return Writer::none;
    int pid = 0;
    const char* const digits = name.c_str() + part + 5;
    const char* const name_end = name.c_str() + name.size();
    const auto [end, error] = std::from_chars(digits, name_end, pid);
    if (error != std::errc() || pid <= 0 || *end != '_') return Writer::none;
    std::uint64_t number = 0;
    if (std::from_chars(end + 1, name_end, number).ec == std::errc() && number >> 32 != 0 &&
        number >> 32 != host_code())
        return Writer::elsewhere;
    return is_running(pid) ? Writer::here : Writer::gone;
}

bool is_temporary_in_use(const fs::path& path) {
    const Writer writer = writer_of(path);
    return writer == Writer::here || writer == Writer::elsewhere;
}

Result<void> make_folders(const fs::path& folder, const fs::path& home) {
    TRY_VOID(OwnFolder::open(folder, home, OwnFolder::Missing::is_made));
    return {};
}

Result<void> write_file_atomic(const fs::path& path, std::string_view text) {
    return write_file_atomic(path, Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

} // namespace ghost
