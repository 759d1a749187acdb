#pragma once
// SPDX-License-Identifier: Apache-2.0
// Uploads: fills parts of textures, as many as there are with one submission. Its memory is kept from one use
// to the next. Main thread; the device must outlive it, and a texture the finish() after its add().

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"

#include <cstdint>
#include <vector>

namespace ghost::gpu {

class Uploads {
public:
    explicit Uploads(const Device& device);

    // A rectangle of one layer of one level, each texel once before finish(). rows: its first texel;
    // row_bytes: from a row to the next one; texel_bytes: as the format has them. Copied at once.
    void add(const Texture& to, std::uint32_t layer, std::uint32_t level, const VkRect2D& part,
             const void* rows, std::uint64_t row_bytes, std::uint32_t texel_bytes);
    // All of a layer of a level, tightly packed.
    void add(const Texture& to, std::uint32_t layer, std::uint32_t level, const void* data,
             std::uint32_t texel_bytes);
    // What was added is in its texture. Waits; nothing where nothing was added.
    void finish();

private:
    struct Copy {
        VkImage to = VK_NULL_HANDLE;
        VkBufferImageCopy region{};
    };

    const Device& device_;
    Commands commands_;
    Buffer staging_;
    std::uint64_t used_ = 0; // bytes
    std::vector<Copy> copies_;
};

} // namespace ghost::gpu
