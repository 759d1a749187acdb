#pragma once
// SPDX-License-Identifier: Apache-2.0
// DeviceMemory: of one device: how much there is, and how much of it all that was made from the device has.
// Bytes. Memory that is not there is thrown (gpu/device_failures.h). Main thread.

#include <cstdint>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

class Device;

class DeviceMemory {
public:
    // limit_bytes: of all buffers and textures; 0: what the device has. has_budget: the driver says what is
    // left, other programs counted in.
    DeviceMemory(const Device& device, std::uint64_t limit_bytes, bool has_budget);

    // Of a buffer or image, with as many of the wanted properties as there is; type: its index.
    VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted,
                            std::uint32_t& type);
    void release(VkDeviceMemory memory, std::uint64_t bytes);
    // Whether what is allocated here can be shared with a worker: it lies on whole pages, and the driver
    // takes it.
    bool can_share_with(const Device& worker) const;
    // Of a worker: memory of the device that it stands beside, at least so much of it. Counts there;
    // vkFreeMemory gives it back.
    VkDeviceMemory share(void* memory, std::uint64_t bytes) const;

    std::uint64_t local_bytes() const { return local_bytes_; }
    std::uint64_t used_bytes() const { return used_bytes_; }
    // What may still be allocated: of the limit, of what the driver says is left, or of the processor's
    // memory that was free at the start. Whoever makes something large asks first.
    std::uint64_t left_bytes() const;

private:
    std::uint32_t type_of(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const;

    const Device& device_;
    VkPhysicalDeviceMemoryProperties properties_{};
    std::uint64_t local_bytes_ = 0;
    bool enforced_; // somebody asked for the limit
    bool has_budget_;
    std::uint64_t limit_bytes_;
    std::uint64_t used_bytes_ = 0;
};

} // namespace ghost::gpu
