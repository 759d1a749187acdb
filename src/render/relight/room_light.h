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
#include "render/pixels/room_light.h"
#include "shared/room_light.h"

#include <cstdint>
#include <memory>
#include <string>

namespace ghost::render {

class RoomLight {
public:
    explicit RoomLight(const gpu::Device& device);

    // What they need and this device has not: "pictures of ..., and this device has ..."; "" where it fits.
    static std::string beyond_device(const gpu::Device& device, const scene::BounceVolumes& volumes);
    // Of volumes that fit. From the next picture on; the glow is that of an eye. on_processor: for planes(),
    // else for record().
    void set(std::shared_ptr<const scene::BounceVolumes> volumes, bool on_processor);
    // as_lux: adds what falls on surfaces instead of what they show.
    void record(gpu::Commands& commands, const GBuffer& g_buffer, bool as_lux, const gpu::Texture& frame);
    // The same for the steps of render/pixels; of textures that lie in the processor's memory.
    RoomPlanes planes(const GBuffer& g_buffer, bool as_lux) const;
    GlowSlices& glow() { return glow_slices_; }

    std::uint64_t memory_bytes() const;

private:
    shared::RoomLightPush push_of(const Fragments& fragments, bool as_lux) const;
    void make(const scene::BounceVolume& volume, gpu::Texture& texture) const;
    void upload(const scene::BounceVolume& volume, const gpu::Texture& texture);

    const gpu::Device& device_;
    gpu::LateProgram glow_program_, program_;
    gpu::Uploads uploads_;
    gpu::Texture surfaces_, air_, glow_, slices_;
    std::shared_ptr<const scene::BounceVolumes> volumes_;
    GlowSlices glow_slices_; // of planes()
};

} // namespace ghost::render
