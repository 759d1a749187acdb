// SPDX-License-Identifier: Apache-2.0
#include "base/memory.h"

#include "base/zeroed_memory.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

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

// Of a file with a name and a number in a line of its own, among others.
std::optional<std::uint64_t> value_of(const fs::path& path, const std::string& wanted) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t value = 0;
        if (words >> name >> value && name == wanted) return value;
    }
    return std::nullopt;
}

std::optional<std::uint64_t> free_of_machine(const fs::path& root) {
    const auto kilobytes = value_of(root / "proc/meminfo", "MemAvailable:");
    if (kilobytes) return *kilobytes * 1024;
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
            // Files that were read once count as used, but are given back at once.
            const auto cached = value_of(top / group / "memory.stat", "inactive_file").value_or(0);
            if (most && used) {
                const std::uint64_t kept = *used - std::min(*used, cached);
                least = std::min(least.value_or(UINT64_MAX), *most - std::min(*most, kept));
            }
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

std::uint64_t used_memory_bytes(const fs::path& root) {
    return 1024 * value_of(root / "proc/self/status", "VmRSS:").value_or(0);
}

void return_large_blocks() {
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, kLargeBlock_bytes); // a threshold that is set does not grow by itself
#endif
}

void give_back_free_memory() {
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
}

ZeroedMemory::ZeroedMemory() {
#if defined(__GLIBC__)
    mallopt(M_PERTURB, 0xff); // blocks are filled with the complement
#endif
}

ZeroedMemory::~ZeroedMemory() {
#if defined(__GLIBC__)
    mallopt(M_PERTURB, 0);
#endif
}

} // namespace ghost
