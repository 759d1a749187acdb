// SPDX-License-Identifier: Apache-2.0
#include "base/memory.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace ghost {
namespace {

namespace fs = std::filesystem;

// "max" and a file that is not there: nothing.
std::optional<std::uint64_t> number_in(const fs::path& path) {
    std::ifstream file(path);
    std::uint64_t value = 0;
    if (file >> value) return value;
    return std::nullopt;
}

std::optional<std::uint64_t> free_of_machine(const fs::path& root) {
    std::ifstream file(root / "proc/meminfo");
    std::string name, unit;
    std::uint64_t kilobytes = 0;
    while (file >> name >> kilobytes) {
        if (name == "MemAvailable:") return kilobytes * 1024;
        std::getline(file, unit);
    }
    return std::nullopt;
}

// Of the narrowest group from ours upwards (control groups, version 2).
std::optional<std::uint64_t> free_of_group(const fs::path& root) {
    std::ifstream file(root / "proc/self/cgroup");
    std::string line;
    std::optional<std::uint64_t> least;
    while (std::getline(file, line)) {
        if (line.rfind("0::/", 0) != 0) continue;
        const fs::path top = root / "sys/fs/cgroup";
        for (fs::path group = fs::path(line.substr(4));; group = group.parent_path()) {
            const auto most = number_in(top / group / "memory.max");
            const auto used = number_in(top / group / "memory.current");
            if (most && used) least = std::min(least.value_or(UINT64_MAX), *most - std::min(*most, *used));
            if (group.empty()) break;
        }
    }
    return least;
}

} // namespace

std::uint64_t free_memory_bytes(const fs::path& root) {
    const auto machine = free_of_machine(root);
    const auto group = free_of_group(root);
    if (!machine) return group.value_or(0);
    return group ? std::min(*machine, *group) : *machine;
}

} // namespace ghost
