#pragma once
// SPDX-License-Identifier: Apache-2.0
// DeviceMemory: of one device: how much there is, and what buffers and images have of it. Small ones lie side
// by side in blocks: drivers take long for each piece that they are asked for, round it up to pages and give
// only so many (maxMemoryAllocationCount). Bytes. Memory that is not there is thrown (gpu/device_failures.h).
// Main thread.

#include "gpu/free_ranges.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

class Device;

// What the driver gave at once. mapped: null where it is not visible to us.
struct MemoryPiece {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::uint64_t bytes = 0;
    std::uint8_t* mapped = nullptr;
};

// Images of the driver's own layout lie in blocks of their own: whatever bufferImageGranularity is, they meet
// nothing else within it.
struct MemoryBlock {
    MemoryPiece piece;
    std::uint32_t type = 0;
    bool of_images = false;
    FreeRanges free;
};

// What one buffer or image has.
struct MemoryRange {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint8_t* mapped = nullptr; // at the offset
    MemoryBlock* block = nullptr;   // null: memory of its own
};

class DeviceMemory {
public:
    // limit_bytes: of all that the driver is asked for; 0: what the device has. has_budget: the driver says
    // what is left, other programs counted in.
    DeviceMemory(const Device& device, std::uint64_t limit_bytes, bool has_budget);
    ~DeviceMemory();
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;

    // Gives it memory, with as many of the wanted properties as there is. Of its own is what is large, what
    // the driver wants to be, and all where there are workers, which share whole pages.
    MemoryRange bind(VkBuffer buffer, VkMemoryPropertyFlags wanted);
    MemoryRange bind(VkImage image, VkImageTiling tiling, VkMemoryPropertyFlags wanted);
    void release(const MemoryRange& range);
    // Whether what is allocated here can be shared with a worker: it lies on whole pages, and the driver
    // takes it.
    bool can_share_with(const Device& worker) const;
    // Of a worker: memory of the device that it stands beside, at least so much of it. Counts there;
    // vkFreeMemory gives it back.
    VkDeviceMemory share(void* memory, std::uint64_t bytes) const;

    std::uint64_t local_bytes() const { return local_bytes_; }
    std::uint64_t used_bytes() const { return used_bytes_; } // that buffers and images have
    std::uint64_t held_bytes() const { return held_bytes_; } // that the driver gave: blocks count whole
    std::uint64_t pieces() const { return pieces_; }         // in how many
    std::uint64_t block_bytes() const { return block_bytes_; }
    // What the driver may still be asked for: of the limit, of what it says is left, or of the processor's
    // memory that was free at the start. What is free in blocks comes on top, for what is small. Whoever
    // makes something large asks first.
    std::uint64_t left_bytes() const;

private:
    struct Needs;
    std::uint32_t type_of(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const;
    MemoryRange allocate(const Needs& needs, VkMemoryPropertyFlags wanted);
    std::optional<MemoryRange> range_in_block(const Needs& needs, std::uint32_t type);
    VkResult ask(std::uint64_t bytes, std::uint32_t type, const void* next, MemoryPiece& piece);
    void give_back(const MemoryPiece& piece);
    bool give_back_empty_blocks();
    std::uint64_t empty_bytes() const;

    const Device& device_;
    VkPhysicalDeviceMemoryProperties properties_{};
    std::uint64_t local_bytes_ = 0;
    bool enforced_; // somebody asked for the limit
    bool has_budget_;
    std::uint64_t limit_bytes_;
    std::uint64_t block_bytes_;
    std::uint64_t used_bytes_ = 0;
    std::uint64_t held_bytes_ = 0;
    std::uint64_t pieces_ = 0;
    std::vector<std::unique_ptr<MemoryBlock>> blocks_;
};

} // namespace ghost::gpu
