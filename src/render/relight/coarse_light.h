#pragma once
// SPDX-License-Identifier: Apache-2.0
// CoarseLight: lights at half the sides of a G-buffer's picture, silhouettes and materials at all of them
// (shaders/shared/coarse.h). Makes the points that lights are drawn on and the weights by which pixels share
// in them, again where the G-buffer changed; spreads a sum of lights over the picture. Units: the points are
// fragments like those of a picture of half the size, without extra ones. Main thread; device and G-buffer
// must outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/geometry/fragments.h"
#include "render/geometry/g_buffer.h"
#include "render/geometry/screen_area.h"
#include "render/pixels/spread.h"
#include "shared/coarse.h"

#include <cstdint>
#include <vector>

namespace ghost::render {

class CoarseLight {
public:
    CoarseLight(const gpu::Device& device, const GBuffer& g_buffer);

    // The G-buffer was drawn anew.
    void forget();
    // It changed in these rectangles. Returns where its points did, in points.
    std::vector<PixelRect> touch(const std::vector<PixelRect>& rects);
    // Records what was forgotten and touched since.
    void update(gpu::Commands& commands);
    // Records: the frame becomes the picture without lights plus the light in sums().
    void spread(gpu::Commands& commands, const gpu::Texture& frame);

    const Fragments& fragments() const { return points_; }
    const gpu::Texture& diffuse() const { return diffuse_; }
    const gpu::Texture& specular() const { return specular_; }
    const gpu::Texture& normals() const { return normals_; }
    const gpu::Buffer& rooms() const { return rooms_; } // of no extra fragments
    const gpu::Texture& sums() const { return sums_; }
    CoarsePlanes planes() const; // for spread() on this processor, whose memory all textures lie in
    std::uint64_t memory_bytes() const;

private:
    shared::CoarsePush push_of(std::uint32_t tiles_x, bool listed, std::uint32_t count) const;
    void record_points(gpu::Commands& commands, bool listed);
    void record_cells(gpu::Commands& commands, bool listed);
    void record_extras(gpu::Commands& commands, bool listed);

    const GBuffer& g_buffer_;
    gpu::Program make_points_, make_cells_, make_extras_;
    gpu::LateProgram spread_, fold_;
    Fragments points_;
    bool forgotten_ = true, extras_moved_ = false;
    TileSet stale_points_, stale_cells_, stale_tiles_; // the last ones of the picture
    gpu::Buffer rooms_, point_list_, cell_list_, tile_list_;
    gpu::Texture diffuse_, specular_, normals_, sums_, cells_, extras_;
};

} // namespace ghost::render
