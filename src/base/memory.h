#pragma once
// SPDX-License-Identifier: Apache-2.0
// What this machine's memory still holds, and what this program has of it. Any thread.

#include <cstdint>
#include <filesystem>

namespace ghost {

// Of the machine, or of the control group that the program runs in (containers) where that has less; 0 where
// neither says. root: where /proc and /sys are, for tests.
std::uint64_t free_memory_bytes(const std::filesystem::path& root = "/");

// Of this program, in memory now (resident); 0 where the system does not say.
std::uint64_t used_memory_bytes(const std::filesystem::path& root = "/");

} // namespace ghost
