// SPDX-License-Identifier: Apache-2.0
#include "base/leftovers.h"

#include "base/files.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <string>

namespace ghost {
namespace {

namespace fs = std::filesystem;

constexpr auto kRest = std::chrono::minutes(1);

// ".NAME.partPID_NUMBER", with or without an ending.
bool is_temporary_name(const std::string& name) {
    const std::size_t part = name.rfind(".part");
    if (part == std::string::npos || part == 0 || name[0] != '.') return false;
    const auto digits_from = [&](std::size_t begin) {
        std::size_t end = begin;
        while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end]))) ++end;
        return end;
    };
    const std::size_t pid = part + 5, after_pid = digits_from(pid);
    if (after_pid == pid || after_pid >= name.size() || name[after_pid] != '_') return false;
    const std::size_t number = after_pid + 1, after_number = digits_from(number);
    return after_number > number && (after_number == name.size() || name[after_number] == '.');
}

bool is_leftover(const fs::directory_entry& entry) {
    std::error_code code;
    if (!entry.is_regular_file(code) || entry.is_symlink(code)) return false;
    if (!is_temporary_name(entry.path().filename().string()) || is_temporary_in_use(entry.path()))
        return false;
    const auto written = entry.last_write_time(code);
    return !code && fs::file_time_type::clock::now() - written > kRest;
}

template <class Iterator>
std::size_t remove_in(const fs::path& folder) {
    std::size_t removed = 0;
    std::error_code code;
    Iterator at(folder, fs::directory_options::skip_permission_denied, code);
    while (!code && at != Iterator()) {
        std::error_code unremovable;
        if (is_leftover(*at) && fs::remove(at->path(), unremovable)) ++removed;
        at.increment(code);
    }
    return removed;
}

} // namespace

std::size_t remove_leftovers(const fs::path& folder, Below below) {
    return below == Below::included ? remove_in<fs::recursive_directory_iterator>(folder)
                                    : remove_in<fs::directory_iterator>(folder);
}

} // namespace ghost
