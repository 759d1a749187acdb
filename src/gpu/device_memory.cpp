// SPDX-License-Identifier: Apache-2.0
// How much memory there is, and who has it.
#include "gpu/device.h"

#include "base/log.h"
#include "base/memory.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace ghost::gpu {
namespace {

constexpr double kOfFreeMemory = 0.8; // of a processor's: the rest of the program and others need some, too
constexpr double kOfLocalMemory = 0.9;

std::string megabytes(std::uint64_t bytes) {
    return std::to_string(bytes >> 20) + " MB";
}

} // namespace

void Device::find_memory(std::uint64_t limit_bytes) {
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
    for (std::uint32_t i = 0; i < memory_.memoryHeapCount; ++i)
        if (memory_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            local_memory_bytes_ = std::max<std::uint64_t>(local_memory_bytes_, memory_.memoryHeaps[i].size);
    enforced_ = limit_bytes > 0;
    has_budget_ = has_budget_ && !enforced_ && !is_cpu_;
    // What a processor's driver calls its heap is a number of its own (lavapipe: 2 GB) that it does not keep
    // to.
    const std::uint64_t free_bytes = is_cpu_ ? free_memory_bytes() : 0;
    limit_bytes_ =
        enforced_ ? limit_bytes
        : free_bytes > 0
            ? static_cast<std::uint64_t>(kOfFreeMemory * static_cast<double>(free_bytes))
            : static_cast<std::uint64_t>(kOfLocalMemory * static_cast<double>(local_memory_bytes_));
}

std::uint32_t Device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
    std::uint32_t best = 0;
    int best_score = -1;
    for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
        if (!(allowed & (1u << i))) continue;
        const VkMemoryPropertyFlags has = memory_.memoryTypes[i].propertyFlags;
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

VkDeviceMemory Device::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted,
                                std::uint32_t& type) const {
    type = memory_type(needs.memoryTypeBits, wanted);
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = type;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    const bool beyond = enforced_ && used_bytes_ + needs.size > limit_bytes_;
    const VkResult result =
        beyond ? VK_ERROR_OUT_OF_DEVICE_MEMORY : vkAllocateMemory(device_, &info, nullptr, &memory);
    if (result != VK_SUCCESS)
        log_error("asked for " + megabytes(needs.size) + " of memory of " + name_ + ", " +
                  megabytes(used_bytes_) + " were in use");
    VK_CALL(result);
    used_bytes_ += needs.size;
    return memory;
}

void Device::release(VkDeviceMemory memory, std::uint64_t bytes) const {
    if (memory == VK_NULL_HANDLE) return;
    vkFreeMemory(device_, memory, nullptr);
    used_bytes_ -= bytes;
}

std::uint64_t Device::memory_left_bytes() const {
    std::uint64_t left = limit_bytes_ > used_bytes_ ? limit_bytes_ - used_bytes_ : 0;
    // Others may have taken some meanwhile.
    if (const std::uint64_t free_bytes = is_cpu_ && !enforced_ ? free_memory_bytes() : 0; free_bytes > 0)
        left = std::min(left, static_cast<std::uint64_t>(kOfFreeMemory * static_cast<double>(free_bytes)));
    if (!has_budget_) return left;
    VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{};
    budget.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT;
    VkPhysicalDeviceMemoryProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2;
    properties.pNext = &budget;
    vkGetPhysicalDeviceMemoryProperties2(physical_, &properties);
    std::uint64_t largest = 0;
    for (std::uint32_t i = 0; i < memory_.memoryHeapCount; ++i) {
        const bool local = memory_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT;
        if (!local || budget.heapBudget[i] <= budget.heapUsage[i]) continue;
        largest = std::max<std::uint64_t>(largest, budget.heapBudget[i] - budget.heapUsage[i]);
    }
    return std::min(left, largest);
}

} // namespace ghost::gpu
