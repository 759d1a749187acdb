// SPDX-License-Identifier: Apache-2.0
#include "disk/leftovers.h"

#include "disk/own_folder.h"
#include "disk/temporary.h"

#include <cctype>
#include <chrono>
#include <string>

namespace ghost {
namespace {

namespace fs = std::filesystem;

constexpr auto kRest = std::chrono::minutes(1);
constexpr auto kRestElsewhere = std::chrono::hours(24); // by another machine's clock
constexpr int kLevels = 8;                              // .ghost has four; others may nest without end

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

bool is_leftover(const OwnFolder::File& file) {
    const Writer writer = writer_of(file.name);
    return is_temporary_name(file.name) && writer != Writer::here &&
           std::chrono::system_clock::now() - file.written >
               (writer == Writer::elsewhere ? kRestElsewhere : kRest);
}

std::size_t remove_in(const OwnFolder& folder, int levels) {
    std::size_t removed = 0;
    const OwnFolder::Entries entries = folder.entries();
    for (const OwnFolder::File& file : entries.files)
        if (is_leftover(file) && folder.remove_file(file.name)) ++removed;
    if (levels == 0) return removed;
    for (const std::string& name : entries.folders)
        if (const auto below = folder.below(name); below.ok()) removed += remove_in(*below, levels - 1);
    return removed;
}

} // namespace

std::size_t remove_leftovers(const fs::path& folder, const fs::path& home, Below below) {
    const auto opened = OwnFolder::open(folder, home);
    return opened.ok() ? remove_in(*opened, below == Below::included ? kLevels : 0) : 0;
}

} // namespace ghost
