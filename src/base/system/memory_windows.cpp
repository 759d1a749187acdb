// SPDX-License-Identifier: Apache-2.0
#include "base/memory.h"

#include "base/zeroed_memory.h"

#include <algorithm>

#include <windows.h>

#include <psapi.h>

namespace ghost {

// root: Windows has no files that say it.
std::uint64_t free_memory_bytes(const std::filesystem::path&) {
    MEMORYSTATUSEX memory{};
    memory.dwLength = sizeof memory;
    std::uint64_t free = ::GlobalMemoryStatusEx(&memory) ? memory.ullAvailPhys : 0;
    // A job is what a container is elsewhere.
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION job{};
    if (::QueryInformationJobObject(nullptr, JobObjectExtendedLimitInformation, &job, sizeof job, nullptr) &&
        (job.BasicLimitInformation.LimitFlags & JOB_OBJECT_LIMIT_JOB_MEMORY) != 0) {
        const std::uint64_t used = used_memory_bytes(), most = job.JobMemoryLimit;
        free = std::min(free, most - std::min(most, used));
    }
    return free;
}

std::uint64_t used_memory_bytes(const std::filesystem::path&) {
    PROCESS_MEMORY_COUNTERS counters{};
    return ::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof counters) ? counters.WorkingSetSize
                                                                                     : 0;
}

// The heaps of Windows map large blocks by themselves anyway.
void return_large_blocks() {}

void give_back_free_memory() {
    (void)::HeapCompact(::GetProcessHeap(), 0);
}

ZeroedMemory::ZeroedMemory() = default;
ZeroedMemory::~ZeroedMemory() = default;

} // namespace ghost
