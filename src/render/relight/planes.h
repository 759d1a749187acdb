#pragma once
// SPDX-License-Identifier: Apache-2.0
// Textures as planes in memory, where the device is this processor (gpu/texture.h).

#include "gpu/texture.h"
#include "render/pixels/plane.h"

namespace ghost::render {

inline Plane plane_of(const gpu::Texture& texture, std::uint32_t layer = 0) {
    return {texture.mapped(layer), texture.row_bytes(), static_cast<int>(texture.shape().width),
            static_cast<int>(texture.shape().height)};
}

} // namespace ghost::render
