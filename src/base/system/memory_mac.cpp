// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
#include "base/memory.h"

#include "base/zeroed_memory.h"

#include <mach/mach.h>
#include <malloc/malloc.h>

namespace ghost {

// root: macOS has no files that say it. What is "inactive" is given up when somebody needs it.
std::uint64_t free_memory_bytes(const std::filesystem::path&) {
    vm_statistics64_data_t memory{};
    mach_msg_type_number_t count = HOST_VM_INFO64_COUNT;
    vm_size_t page = 0;
    const mach_port_t host = mach_host_self();
    if (host_page_size(host, &page) != KERN_SUCCESS ||
        host_statistics64(host, HOST_VM_INFO64, reinterpret_cast<host_info64_t>(&memory), &count) !=
            KERN_SUCCESS)
        return 0;
    return (std::uint64_t{memory.free_count} + memory.inactive_count) * page;
}

std::uint64_t used_memory_bytes(const std::filesystem::path&) {
    mach_task_basic_info_data_t task{};
    mach_msg_type_number_t count = MACH_TASK_BASIC_INFO_COUNT;
    return task_info(mach_task_self(), MACH_TASK_BASIC_INFO, reinterpret_cast<task_info_t>(&task), &count) ==
                   KERN_SUCCESS
               ? task.resident_size
               : 0;
}

// The allocator of macOS maps large blocks by themselves anyway.
void return_large_blocks() {}

void give_back_free_memory() {
    (void)malloc_zone_pressure_relief(nullptr, 0);
}

ZeroedMemory::ZeroedMemory() = default;
ZeroedMemory::~ZeroedMemory() = default;

} // namespace ghost
