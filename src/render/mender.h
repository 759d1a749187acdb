#pragma once
// SPDX-License-Identifier: Apache-2.0
// Mender: which parts of the kept images of resting lights are stale since something moved in front of the
// camera, and what it takes to draw these parts again and nothing else. Bounds for cull.comp in which only
// stale tiles are left; lights that cannot reach them are left out. Main thread; device and G-buffer must
// outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "render/g_buffer.h"
#include "render/light_tree.h"
#include "render/screen_area.h"
#include "shared/types.h"

#include <map>
#include <vector>

namespace ghost::render {

class Mender {
public:
    Mender(const gpu::Device& device, const GBuffer& g_buffer);

    // The G-buffer changed in these rectangles: every image made so far is stale there.
    void touch(const std::vector<PixelRect>& rects);
    // An image was made (ImageSum::target >= 0) from lights and other images.
    void made(const ImageSum& sum);
    void forget() { kept_.clear(); }

    bool is_stale(int slot) const;
    // What to draw where an image is stale: into the frame's own layer, for a target of its own it has not.
    ImageSum mend(int slot, const std::vector<shared::Light>& lights) const;
    // Records bounds() for this image.
    void record_bounds(gpu::Commands& commands, int slot) const;
    const gpu::Buffer& bounds() const { return bounds_; }
    std::vector<VkRect2D> stale_parts(int slot) const;
    void mended(int slot);
    std::uint64_t memory_bytes() const { return bounds_.bytes() + wanted_.bytes(); }

private:
    struct Kept {
        std::vector<int> lights; // all that it shows
        bool base = false;
        TileSet stale;
    };
    const GBuffer& g_buffer_;
    gpu::Program program_;
    gpu::Buffer bounds_, wanted_;
    std::map<int, Kept> kept_; // by slot
};

// Whether a beam may be seen in these pixels, in the air or on a surface. Conservative.
bool may_reach(const shared::Light& light, const shared::View& view, const PixelRect& rect);

} // namespace ghost::render
