// SPDX-License-Identifier: Apache-2.0
#include "gpu/device_memory.h"

#include "base/check.h"
#include "base/log.h"
#include "base/memory.h"
#include "gpu/device.h"

#include <algorithm>
#include <string>

namespace ghost::gpu {
namespace {

constexpr double kOfFreeMemory = 0.8; // of a processor's: the rest of the program and others need some, too
constexpr double kOfLocalMemory = 0.9;
constexpr std::uint64_t kPageBytes = 4096; // that a processor's driver allocates in

std::string megabytes(std::uint64_t bytes) {
    return std::to_string(bytes >> 20) + " MB";
}

} // namespace

DeviceMemory::DeviceMemory(const Device& device, std::uint64_t limit_bytes, bool has_budget)
    : device_(device), enforced_(limit_bytes > 0),
      has_budget_(has_budget && limit_bytes == 0 && !device.is_cpu()) {
    vkGetPhysicalDeviceMemoryProperties(device.physical(), &properties_);
    for (std::uint32_t i = 0; i < properties_.memoryHeapCount; ++i)
        if (properties_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            local_bytes_ = std::max<std::uint64_t>(local_bytes_, properties_.memoryHeaps[i].size);
    // What a processor's driver calls its heap is a number of its own (lavapipe: 2 GB) that it does not keep
    // to.
    const std::uint64_t free_bytes = device.is_cpu() ? free_memory_bytes() : 0;
    limit_bytes_ = enforced_ ? limit_bytes
                   : free_bytes > 0
                       ? static_cast<std::uint64_t>(kOfFreeMemory * static_cast<double>(free_bytes))
                       : static_cast<std::uint64_t>(kOfLocalMemory * static_cast<double>(local_bytes_));
}

std::uint32_t DeviceMemory::type_of(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
    std::uint32_t best = 0;
    int best_score = -1;
    for (std::uint32_t i = 0; i < properties_.memoryTypeCount; ++i) {
        if (!(allowed & (1u << i))) continue;
        const VkMemoryPropertyFlags has = properties_.memoryTypes[i].propertyFlags;
        int score = 0;
        for (std::uint32_t bit = 0; bit < 32; ++bit)
            if ((wanted & (1u << bit)) && (has & (1u << bit))) ++score;
        if (score > best_score) {
            best_score = score;
            best = i;
        }
    }
    return best;
}

VkDeviceMemory DeviceMemory::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted,
                                      std::uint32_t& type) {
    type = type_of(needs.memoryTypeBits, wanted);
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = type;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    const bool beyond = enforced_ && used_bytes_ + needs.size > limit_bytes_;
    const VkResult result =
        beyond ? VK_ERROR_OUT_OF_DEVICE_MEMORY : vkAllocateMemory(device_.handle(), &info, nullptr, &memory);
    if (result != VK_SUCCESS)
        log_error("asked for " + megabytes(needs.size) + " of memory of " + device_.name() + ", " +
                  megabytes(used_bytes_) + " were in use");
    VK_CALL(result);
    used_bytes_ += needs.size;
    return memory;
}

namespace {

VkResult import_memory(const Device& worker, void* memory, std::uint64_t bytes, VkDeviceMemory& shared) {
    VkImportMemoryHostPointerInfoEXT import{};
    import.sType = VK_STRUCTURE_TYPE_IMPORT_MEMORY_HOST_POINTER_INFO_EXT;
    import.handleType = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT;
    import.pHostPointer = memory;
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.pNext = &import;
    info.allocationSize = (bytes + kPageBytes - 1) / kPageBytes * kPageBytes;
    return vkAllocateMemory(worker.handle(), &info, nullptr, &shared);
}

bool is_on_pages(const void* memory) {
    return memory && reinterpret_cast<std::uintptr_t>(memory) % kPageBytes == 0;
}

} // namespace

bool DeviceMemory::can_share_with(const Device& worker) const {
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = kPageBytes;
    VkDeviceMemory memory = VK_NULL_HANDLE, shared = VK_NULL_HANDLE;
    if (vkAllocateMemory(device_.handle(), &info, nullptr, &memory) != VK_SUCCESS) return false;
    void* mapped = nullptr;
    const bool can = vkMapMemory(device_.handle(), memory, 0, VK_WHOLE_SIZE, 0, &mapped) == VK_SUCCESS &&
                     is_on_pages(mapped) && import_memory(worker, mapped, kPageBytes, shared) == VK_SUCCESS;
    vkFreeMemory(worker.handle(), shared, nullptr);
    vkFreeMemory(device_.handle(), memory, nullptr);
    return can;
}

VkDeviceMemory DeviceMemory::share(void* memory, std::uint64_t bytes) const {
    CHECK(is_on_pages(memory));
    VkDeviceMemory shared = VK_NULL_HANDLE;
    VK_CALL(import_memory(device_, memory, bytes, shared));
    return shared;
}

void DeviceMemory::release(VkDeviceMemory memory, std::uint64_t bytes) {
    if (memory == VK_NULL_HANDLE) return;
    vkFreeMemory(device_.handle(), memory, nullptr);
    used_bytes_ -= bytes;
}

std::uint64_t DeviceMemory::left_bytes() const {
    std::uint64_t left = limit_bytes_ > used_bytes_ ? limit_bytes_ - used_bytes_ : 0;
    // Others may have taken some meanwhile.
    if (const std::uint64_t free_bytes = device_.is_cpu() && !enforced_ ? free_memory_bytes() : 0;
        free_bytes > 0)
        left = std::min(left, static_cast<std::uint64_t>(kOfFreeMemory * static_cast<double>(free_bytes)));
    if (!has_budget_) return left;
    VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{};
    budget.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT;
    VkPhysicalDeviceMemoryProperties2 asked{};
    asked.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2;
    asked.pNext = &budget;
    vkGetPhysicalDeviceMemoryProperties2(device_.physical(), &asked);
    std::uint64_t largest = 0;
    for (std::uint32_t i = 0; i < properties_.memoryHeapCount; ++i) {
        const bool local = properties_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT;
        if (!local || budget.heapBudget[i] <= budget.heapUsage[i]) continue;
        largest = std::max<std::uint64_t>(largest, budget.heapBudget[i] - budget.heapUsage[i]);
    }
    return std::min(left, largest);
}

} // namespace ghost::gpu
