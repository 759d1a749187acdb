#pragma once
// SPDX-License-Identifier: Apache-2.0
// Texture: a 2D array image that shaders sample, fetch or store to. It lives in the GENERAL layout from the
// start. Moves, never copies; must not outlive its Device.
//
// Why images and not buffers by address: on lavapipe a load from a buffer in a shader is a loop over the
// lanes, one by one (measured: the relight shader is 10 times slower); images and uniform buffers are
// gathered at once.

#include "gpu/device.h"
#include "gpu/device_memory.h"

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ghost::gpu {

struct TextureShape {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t layers = 1;
    std::uint32_t levels = 1;
    VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
    bool storage = false;      // shaders store to it
    bool linear = false;       // sampled trilinearly, clamped; else nearest
    bool repeat = false;       // sampled as if tiled without end, instead of clamped
    bool attachment = false;   // drawn to (Raster); its aspect follows from the format
    std::uint32_t samples = 1; // above 1: an attachment with one layer and one level, seen as a 2DMS image
};

// Of device memory, before it is made.
std::uint64_t texture_bytes(const Device& device, const TextureShape& shape);

class Texture {
public:
    Texture() = default;
    Texture(const Device& device, const TextureShape& shape);
    ~Texture();
    Texture(Texture&& other) noexcept { swap(other); }
    Texture& operator=(Texture&& other) noexcept {
        swap(other);
        return *this;
    }

    // Fills all layers of one level; bytes: layer after layer, tightly packed. Waits.
    void write(std::uint32_t level, const void* data, std::uint64_t bytes);
    // Fills one layer of one level. Waits.
    void write_layer(std::uint32_t layer, const void* data, std::uint64_t bytes, std::uint32_t level = 0);

    VkImage image() const { return own_.image; }
    VkImageView view() const { return own_.view; }
    VkSampler sampler() const { return own_.sampler; }
    // Of one level alone, of a texture that shaders store to.
    VkImageView level_view(std::uint32_t level) const {
        return level_views_.empty() ? own_.view : level_views_[level];
    }
    struct Handles {
        VkImage image = VK_NULL_HANDLE;
        VkImageView view = VK_NULL_HANDLE;
        VkSampler sampler = VK_NULL_HANDLE;
        VkDeviceMemory memory = VK_NULL_HANDLE; // of a worker: the texture's, shared
    };
    // As commands on this device, or on one of its workers, name it. Main thread.
    const Handles& handles(const Device& on) const {
        return on.worker() < 0 || &on == device_ ? own_ : on_worker(on);
    }
    const TextureShape& shape() const { return shape_; }
    VkImageAspectFlags aspect() const;                    // colour or depth
    std::uint64_t bytes() const { return memory_.bytes; } // of device memory
    // Texels of a layer, where the device is this processor and shaders store to the only level; null
    // elsewhere. Ours while nothing is submitted.
    std::uint8_t* mapped(std::uint32_t layer = 0) const {
        return mapped_ ? mapped_ + std::uint64_t{layer} * layer_bytes_ : nullptr;
    }
    std::uint64_t row_bytes() const { return row_bytes_; } // of what is mapped

private:
    void swap(Texture& other) noexcept;
    void find_texels();
    const Handles& on_worker(const Device& worker) const;
    void upload(std::uint32_t level, std::uint32_t layer, std::uint32_t layers, const void* data,
                std::uint64_t bytes);

    const Device* device_ = nullptr;
    TextureShape shape_;
    Handles own_;
    std::vector<VkImageView> level_views_; // of those that are stored to, where there are several
    mutable std::map<const Device*, Handles> on_workers_; // those that have asked
    MemoryRange memory_;
    std::uint8_t* mapped_ = nullptr;
    std::uint64_t row_bytes_ = 0, layer_bytes_ = 0;
};

} // namespace ghost::gpu
