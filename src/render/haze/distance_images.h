#pragma once
// SPDX-License-Identifier: Apache-2.0
// The distance maps of a show on the device: one layer of half floats each, in the order of DistanceMaps;
// layer + 1 is shared::Light::map. A map that comes later (it was being made) can be set at any time; what
// was set is on the device after finish(). Main thread; the device must outlive it.
//
// Beside them lie their texels summed up in cells, for soft shadows (render/haze/private/blockers.h).
//
// Where half of the memory that is left on the device would not hold them, only every 2nd, 4th, .. texel is
// kept: shadows get coarser. Maps beyond the layers that an image of the device can have are left out.
//
// The device may draw them itself (render/haze/map_drawer.h): then they are what was drawn or set last.

#include "gpu/device.h"
#include "gpu/texture.h"
#include "gpu/uploads.h"
#include "passes/distance_maps.h"
#include "render/geometry/beam_reach.h"
#include "render/haze/map_drawer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ghost::render {

struct Blockers; // render/haze/private/blockers.h

class DistanceImages {
public:
    enum class Made { elsewhere, by_the_device };
    // by_the_device: it can draw them, too, unless lack() says why not.
    DistanceImages(const gpu::Device& device, const scene::DistanceMaps& maps, Made made = Made::elsewhere);
    ~DistanceImages();

    // Of a map that was left out: nothing happens.
    void set(std::size_t index, const std::vector<std::uint16_t>& distance);
    // The same of maps of which only some blocks of kDistanceBlock texels a side changed since they were set,
    // each map once. Uses all cores.
    struct Change {
        std::size_t index = 0;
        const std::vector<std::uint16_t>& distance;
        const std::vector<int>& blocks; // row by row
    };
    void set_blocks(const std::vector<Change>& changes);
    // The device draws these, of what stops light now, and they are there. Those that were left out do not
    // count.
    void draw(const StageModel& model, const std::vector<MapDrawer::Job>& jobs);
    bool can_draw() const { return drawer_ != nullptr; }
    const std::string& lack() const { return lack_; } // why it cannot, where it was asked to
    std::vector<gpu::Span> drawing_spans() const;     // of the last time
    // All that was set goes to the device at once. Waits.
    void finish() { uploads_.finish(); }
    std::size_t count() const { return texture_.shape().layers; }
    const gpu::Texture& texture() const { return texture_; }
    const gpu::Texture& blockers() const { return blockers_; }
    std::uint64_t bytes() const {
        return texture_.bytes() + blockers_.bytes() + (drawer_ ? drawer_->bytes() : 0);
    }
    std::uint32_t side() const { return texture_.shape().width; } // texels
    // How far along a light's beam there may be haze: a surface ends it (render/geometry/beam_reach.h).
    float reach_m(const shared::Light& light) const;
    std::uint32_t wanted_side() const { return wanted_side_; } // more than side(): memory ran short

private:
    void begin_drawing(const gpu::Device& device, Made made);
    void add_blocks(const Change& change);
    void add_whole(std::uint32_t layer, const std::vector<std::uint16_t>& distance,
                   const std::vector<std::vector<Blockers>>& levels);

    std::uint32_t wanted_side_;
    gpu::Texture texture_;
    gpu::Texture blockers_;
    gpu::Uploads uploads_;
    std::unique_ptr<MapDrawer> drawer_; // or null
    std::string lack_;
    std::vector<FarParts> far_;                            // of each map
    std::vector<std::vector<std::vector<Blockers>>> kept_; // likewise, of those of which blocks were set
};

} // namespace ghost::render
