#pragma once
// SPDX-License-Identifier: Apache-2.0
// Bounced light in a picture of a free camera: added to the finished frame from the volumes of the solver
// (bounce/bounce_volumes.h), before walls, lenses and glare. Never part of a kept image. Main thread; the
// device must outlive it.

#include "bounce/bounce_volumes.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "gpu/uploads.h"
#include "render/geometry/fragments.h"
#include "render/geometry/g_buffer.h"
#include "shared/room_light.h"

#include <cstdint>
#include <string>

namespace ghost::render {

class RoomLight {
public:
    explicit RoomLight(const gpu::Device& device);

    // What they need and this device has not: "pictures of ..., and this device has ..."; "" where it fits.
    static std::string beyond_device(const gpu::Device& device, const scene::BounceVolumes& volumes);
    // Of volumes that fit. From the next record on; the glow is that of an eye.
    void set(const scene::BounceVolumes& volumes);
    // as_lux: adds what falls on surfaces instead of what they show.
    void record(gpu::Commands& commands, const GBuffer& g_buffer, bool as_lux, const gpu::Texture& frame);

    std::uint64_t memory_bytes() const;

private:
    void make(const scene::BounceVolume& volume, gpu::Texture& texture) const;
    void upload(const scene::BounceVolume& volume, const gpu::Texture& texture);

    const gpu::Device& device_;
    gpu::LateProgram glow_program_, program_;
    gpu::Uploads uploads_;
    gpu::Texture surfaces_, air_, glow_, slices_;
    shared::RoomLightPush push_{};
};

} // namespace ghost::render
