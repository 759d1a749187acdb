#pragma once
// SPDX-License-Identifier: Apache-2.0
// What HelperStream asks of the system: one stream of bytes between two processes. Each end on one thread at
// a time.

#include "base/byte_reader.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ghost {

inline constexpr int kHelperDescriptor = 3; // in the helper, after the three that every process has

// How many bytes went, at least one; 0 and less: the other end is gone.
std::ptrdiff_t write_to_helper(int descriptor, Bytes bytes);
std::ptrdiff_t read_of_helper(int descriptor, std::span<std::uint8_t> bytes);
bool wait_for_helper(int descriptor, int wait_ms);

} // namespace ghost
