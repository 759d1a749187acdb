// SPDX-License-Identifier: Apache-2.0
#include "gpu/buffer.h"

#include "base/check.h"
#include "gpu/commands.h"

#include <algorithm>
#include <cstring>

namespace ghost::gpu {
namespace {

VkMemoryPropertyFlags wanted_memory(Access access) {
    constexpr VkMemoryPropertyFlags kMapped =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    switch (access) {
    case Access::readback:
        return kMapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
    case Access::upload:
        return kMapped;
    case Access::device:
        break;
    }
    return VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
}

VkBufferCreateInfo buffer_info(std::uint64_t bytes) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                 VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT |
                 VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    return info;
}

} // namespace

Buffer::Buffer(const Device& device, std::uint64_t bytes, Access access)
    : device_(&device), bytes_(std::max<std::uint64_t>(bytes, 16)) {
    const VkBufferCreateInfo info = buffer_info(bytes_);
    VK_CALL(vkCreateBuffer(device.handle(), &info, nullptr, &buffer_));
    try {
        memory_ = device.memory().bind(buffer_, wanted_memory(access));
    } catch (...) {
        vkDestroyBuffer(device.handle(), buffer_, nullptr);
        throw;
    }
    // Where it is not visible to us, staging is needed.
    CHECK(memory_.mapped || access == Access::device);
}

VkBuffer Buffer::on_worker(const Device& worker) const {
    for (const OnWorker& known : on_workers_)
        if (known.worker == &worker) return known.buffer;
    OnWorker made{&worker, VK_NULL_HANDLE, VK_NULL_HANDLE};
    VkExternalMemoryBufferCreateInfo shared{};
    shared.sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_BUFFER_CREATE_INFO;
    shared.handleTypes = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT;
    VkBufferCreateInfo info = buffer_info(bytes_);
    info.pNext = &shared;
    VK_CALL(vkCreateBuffer(worker.handle(), &info, nullptr, &made.buffer));
    made.memory = worker.memory().share(memory_.mapped, memory_.bytes);
    VK_CALL(vkBindBufferMemory(worker.handle(), made.buffer, made.memory, 0));
    on_workers_.push_back(made);
    return made.buffer;
}

Buffer::~Buffer() {
    if (!device_) return;
    for (const OnWorker& on : on_workers_) {
        vkDestroyBuffer(on.worker->handle(), on.buffer, nullptr);
        vkFreeMemory(on.worker->handle(), on.memory, nullptr);
    }
    vkDestroyBuffer(device_->handle(), buffer_, nullptr);
    device_->memory().release(memory_);
}

void Buffer::swap(Buffer& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(buffer_, other.buffer_);
    std::swap(memory_, other.memory_);
    std::swap(bytes_, other.bytes_);
    std::swap(on_workers_, other.on_workers_);
}

void Buffer::write(const void* data, std::uint64_t bytes) {
    CHECK(bytes <= bytes_);
    if (bytes == 0) return;
    if (memory_.mapped) {
        std::memcpy(memory_.mapped, data, bytes);
        return;
    }
    const Buffer staging(*device_, bytes, Access::upload);
    std::memcpy(staging.mapped(), data, bytes);
    Commands commands(*device_);
    commands.begin();
    commands.copy(staging, *this, bytes);
    commands.submit_and_wait();
}

} // namespace ghost::gpu
