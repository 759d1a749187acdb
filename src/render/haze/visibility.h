#pragma once
// SPDX-License-Identifier: Apache-2.0
// Visibility: what fragments see of the lamps' lenses, kept while lamps, stage and camera rest
// (shaders/shared/visibility.h). Pages are handed out by cull.comp and filled and read by surface_live.comp;
// here is which lights share a place, what is stale, and the memory: a pool that begins anew when it is full,
// but not more often than every kLeastFrames, for a pool too small for what is seen would never keep
// anything; a light without a page is drawn as if nothing were kept. Main thread; device and G-buffer must
// outlive it.

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/geometry/fragments.h"
#include "render/geometry/screen_area.h"
#include "render/haze/memory_order.h"
#include "shared/types.h"
#include "shared/visibility.h"

#include <cstdint>
#include <vector>

namespace ghost::render {

class Visibility {
public:
    // rooms: shared::TileRoom of each tile. map_count: distance maps; one place each. draws: chunks of a
    // frame, at most. most_bytes: for pages and entries; fewer where memory is short.
    Visibility(const gpu::Device& device, const Fragments& fragments, const gpu::Buffer& rooms,
               std::size_t map_count, std::uint64_t draws, std::uint64_t most_bytes);

    // Everything is stale: the camera moved, or shadows changed.
    void forget() { forgotten_ = true; }
    // The fragments in these rectangles are others; extras_moved: extra fragments lie elsewhere.
    void touch(const std::vector<PixelRect>& rects, bool extras_moved);
    // is_full: a page was wanted in the frame before, and there was none.
    void begin_frame(gpu::Commands& commands, bool is_full);
    struct Chunk {
        std::uint64_t offset = 0; // of its Keeps in keeps()
        std::uint32_t now = 0;
    };
    Chunk add(const std::vector<shared::Light>& lights);

    const gpu::Buffer& keeps() const { return keeps_; }
    const gpu::Buffer& entries() const { return entries_; }
    // Of a place + 1 (shared::Keep), where memory is seen by the host: two words a unit.
    const std::uint32_t* entries_of(std::uint32_t place) const;
    const gpu::Buffer& changed_at() const { return changed_at_; }
    const gpu::Texture& pages() const { return pages_; }
    std::uint32_t page_count() const { return page_count_; }
    std::uint32_t units() const { return units_; }
    Shortage shortage() const { return shortage_; }
    std::uint64_t memory_bytes() const {
        return keeps_.bytes() + entries_.bytes() + changed_at_.bytes() + tile_list_.bytes() + pages_.bytes();
    }

private:
    static constexpr int kLeastFrames = 100;

    // Which lens a place is of, and since when.
    struct Place {
        float lens_m = -1;
        std::uint32_t since = 0;
        std::uint32_t used = 0; // `now` of the chunk
    };
    const Fragments& fragments_;
    const gpu::Buffer& rooms_;
    gpu::Program touch_;
    std::vector<Place> places_;
    std::uint32_t units_;
    std::uint32_t page_count_ = 0;
    Shortage shortage_{Kept::visibility};
    std::uint32_t now_ = 1;
    bool forgotten_ = true;
    int frames_ = kLeastFrames; // since the pool began
    TileSet touched_;
    std::uint64_t keeps_used_ = 0; // bytes
    gpu::Buffer keeps_, entries_, changed_at_, tile_list_;
    gpu::Texture pages_;
};

} // namespace ghost::render
