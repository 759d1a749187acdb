#pragma once
// SPDX-License-Identifier: Apache-2.0
// What was written reaches the disk itself, so that a loss of power keeps it. May take as long as a disk
// does. Any thread.

#include <cstdio>

namespace ghost {

// The file's buffer must be flushed (std::fflush). False: the disk says no.
bool sync_to_disk(std::FILE* file);

} // namespace ghost
