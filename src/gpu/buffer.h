#pragma once
// SPDX-License-Identifier: Apache-2.0
// Buffer: memory that shaders bind. Moves, never copies; frees itself; must not outlive its
// Device. Every buffer is mapped where the device allows it (integrated GPUs, lavapipe, resizable BAR);
// write() stages otherwise.

#include "gpu/device.h"
#include "gpu/device_memory.h"

#include <utility>
#include <vector>

namespace ghost::gpu {

enum class Access {
    device,   // written by shaders or by write(), read by shaders
    readback, // written by shaders, read by us through mapped()
    upload,   // written by us through mapped(), read by shaders
};

class Buffer {
public:
    Buffer() = default;
    // bytes 0 gives a buffer of 16 bytes, so that it can be bound.
    Buffer(const Device& device, std::uint64_t bytes, Access access);
    ~Buffer();
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        swap(other);
        return *this;
    }

    VkBuffer handle() const { return buffer_; }
    // As commands on this device, or on one of its workers, name it. Main thread.
    VkBuffer handle(const Device& on) const {
        return on.worker() < 0 || &on == device_ ? buffer_ : on_worker(on);
    }
    std::uint64_t bytes() const { return bytes_; }
    bool valid() const { return buffer_ != VK_NULL_HANDLE; }
    // Null where the memory is not visible to us; never null for readback and upload.
    void* mapped() const { return memory_.mapped; }

    // Copies data to the start of the buffer and waits until it is there. Not while the GPU uses the buffer.
    void write(const void* data, std::uint64_t bytes);
    template <class T>
    void write(const std::vector<T>& data) {
        write(data.data(), data.size() * sizeof(T));
    }

private:
    void swap(Buffer& other) noexcept;
    VkBuffer on_worker(const Device& worker) const;

    struct OnWorker {
        const Device* worker = nullptr;
        VkBuffer buffer = VK_NULL_HANDLE;
        VkDeviceMemory memory = VK_NULL_HANDLE;
    };
    const Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    MemoryRange memory_;
    std::uint64_t bytes_ = 0;
    mutable std::vector<OnWorker> on_workers_; // those that have asked
};

} // namespace ghost::gpu
