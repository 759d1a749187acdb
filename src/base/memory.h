#pragma once
// SPDX-License-Identifier: Apache-2.0
// What this machine's memory still holds, and what this program has of it. Any thread.

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace ghost {

// Of the machine, or of the control group that the program runs in (containers) where that has less; 0 where
// neither says. root: where /proc and /sys are, for tests.
std::uint64_t free_memory_bytes(const std::filesystem::path& root = "/");

// Of this program, in memory now (resident); 0 where the system does not say.
std::uint64_t used_memory_bytes(const std::filesystem::path& root = "/");

// From now on each block of kLargeBlock_bytes and more is mapped by itself and goes back to the system when
// it is freed, for as long as the program runs; where the C library does not know how, nothing changes. For
// programs that stay open: glibc by itself takes what was freed once as the measure of what is kept in its
// heaps (up to 32 MB), and pictures of many sizes, which a driver that draws on the processor has there,
// leave them full of holes. Call it before other threads start. A block costs a system call and fresh pages
// then.
constexpr std::size_t kLargeBlock_bytes = std::size_t{256} << 10;
void return_large_blocks();

// What is free in the heaps of the C library goes back to the system, also between what stays: after a show
// was replaced that is half of a window's memory. Not for every frame: it walks all heaps.
void give_back_free_memory();

} // namespace ghost
