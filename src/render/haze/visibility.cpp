// SPDX-License-Identifier: Apache-2.0
#include "render/haze/visibility.h"

#include "base/check.h"
#include "shaders/visibility_touch.h"

#include <algorithm>
#include <cstring>

namespace ghost::render {
namespace {

constexpr std::uint64_t kKeepAlign = 256; // offset of a uniform buffer, at most, on every device
constexpr std::uint64_t kKeepBytes = shared::kLightsPerChunk * sizeof(shared::Keep);
constexpr std::uint64_t kEntryBytes = 2 * sizeof(std::uint32_t);
constexpr std::uint64_t kHeadBytes = 8;  // how many pages are used
constexpr std::uint64_t kTexelBytes = 4; // rg16
constexpr std::uint64_t kPageBytes = kTexelBytes * shared::kTilePixels;
constexpr std::uint32_t kGroup = 64;        // visibility_touch.comp
constexpr std::size_t kMostTouched = 16384; // tiles that can be listed; more: everything is stale
constexpr std::uint64_t kUsual = 4;         // beams reach about one in so many units of a picture
constexpr std::uint64_t kFewPlaces = 16;    // of which every page has room
constexpr std::uint32_t kMostNow = (~0u >> shared::kTimeShift) / 2;
constexpr std::uint64_t kMostLayers = 2048; // of an image, on every device

std::uint32_t units_of(const Fragments& f) {
    const std::uint64_t extras = std::uint64_t{f.places.shape().height - f.height} * f.width;
    return f.tiles_x * f.tiles_y + static_cast<std::uint32_t>(extras / shared::kTilePixels) + 1;
}

struct Pool {
    std::uint64_t places, pages;
    std::uint64_t bytes(std::uint64_t units) const {
        return places * units * kEntryBytes + pages * kPageBytes;
    }
};

Pool pool_of(std::uint64_t memory_bytes, std::uint64_t units, std::size_t map_count) {
    // A quarter for entries at most: lights beyond keep nothing.
    const std::uint64_t places = std::min<std::uint64_t>(map_count, memory_bytes / 4 / (kEntryBytes * units));
    const std::uint64_t all = places * units;
    const std::uint64_t wanted = std::min(all, std::max(kFewPlaces * units, all / kUsual));
    const std::uint64_t room = (memory_bytes - all * kEntryBytes) / kPageBytes;
    const std::uint64_t most = kMostLayers * shared::kPagesOfLayer;
    return {places, std::max<std::uint64_t>(std::min({wanted, room, most}), 1)};
}

} // namespace

Visibility::Visibility(const gpu::Device& device, const Fragments& fragments, const gpu::Buffer& rooms,
                       std::size_t map_count, std::uint64_t draws, std::uint64_t most_bytes)
    : fragments_(fragments), rooms_(rooms), touch_(device, shaders::kShader_visibility_touch),
      units_(units_of(fragments)),
      touched_(static_cast<int>(fragments.width), static_cast<int>(fragments.height)) {
    const Pool pool = pool_of(std::min(most_bytes, share_of(Kept::visibility, device)), units_, map_count);
    shortage_.has = pool.bytes(units_) >> 10;
    shortage_.wanted = pool_of(most_bytes, units_, map_count).bytes(units_) >> 10;
    places_.resize(pool.places);
    const std::uint64_t rows = (pool.pages + shared::kPagesAcross - 1) / shared::kPagesAcross;
    const std::uint64_t layers = (rows + shared::kPagesAcross - 1) / shared::kPagesAcross;
    const std::uint64_t rows_of_layer = layers > 1 ? shared::kPagesAcross : rows;
    page_count_ = static_cast<std::uint32_t>(layers * rows_of_layer * shared::kPagesAcross);
    pages_ =
        gpu::Texture(device, {shared::kPagesAcross * shared::kTileWidth,
                              static_cast<std::uint32_t>(rows_of_layer) * shared::kTileHeight,
                              static_cast<std::uint32_t>(layers), 1, VK_FORMAT_R16G16_UNORM, true, false});
    entries_ = gpu::Buffer(device, kHeadBytes + pool.places * units_ * kEntryBytes, gpu::Access::device);
    changed_at_ = gpu::Buffer(device, std::uint64_t{4} * units_, gpu::Access::device);
    tile_list_ = gpu::Buffer(device, kMostTouched * sizeof(std::uint32_t), gpu::Access::device);
    keeps_ = gpu::Buffer(device, draws * kKeepAlign + kKeepBytes, gpu::Access::upload);
}

void Visibility::touch(const std::vector<PixelRect>& rects, bool extras_moved) {
    forgotten_ = forgotten_ || extras_moved;
    for (const PixelRect& rect : rects) touched_.add(rect);
}

void Visibility::begin_frame(gpu::Commands& commands, bool is_full) {
    keeps_used_ = 0;
    ++frames_;
    if (now_ > kMostNow) { // times are kept in fewer bits
        for (Place& place : places_) place = {};
        now_ = 1;
        forgotten_ = true;
    }
    const bool anew = forgotten_ || touched_.count() > kMostTouched || (is_full && frames_ >= kLeastFrames);
    const Fragments& f = fragments_;
    ++now_;
    if (anew) {
        commands.fill_zero(entries_);
        commands.fill_zero(changed_at_);
        commands.barrier();
        frames_ = 0;
    } else if (!touched_.empty()) {
        const std::vector<std::uint32_t> list = touched_.list();
        const auto count = static_cast<std::uint32_t>(list.size());
        commands.write(tile_list_, list);
        commands.dispatch(touch_, shared::VisibilityTouchPush{count, f.tiles_x * f.tiles_y, now_},
                          shaders::VisibilityTouchBindings{.tile_list = gpu::storage(tile_list_),
                                                           .rooms = gpu::storage(rooms_),
                                                           .changed = gpu::storage(changed_at_)},
                          gpu::groups(count, kGroup));
        commands.barrier();
    }
    forgotten_ = false;
    touched_ = TileSet(static_cast<int>(f.width), static_cast<int>(f.height));
}

const std::uint32_t* Visibility::entries_of(std::uint32_t place) const {
    return static_cast<const std::uint32_t*>(entries_.mapped()) +
           (kHeadBytes + std::uint64_t{place - 1} * units_ * kEntryBytes) / sizeof(std::uint32_t);
}

Visibility::Chunk Visibility::add(const std::vector<shared::Light>& lights) {
    CHECK(keeps_used_ + kKeepBytes <= keeps_.bytes());
    ++now_;
    const Chunk chunk{keeps_used_, now_};
    auto* keeps = reinterpret_cast<shared::Keep*>(static_cast<std::uint8_t*>(keeps_.mapped()) + keeps_used_);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const std::size_t place = lights[k].map; // its layer + 1
        keeps[k] = {};
        if (place == 0 || place > places_.size()) continue;
        Place& kept = places_[place - 1];
        const float lens_m = lights[k].disc_radius_m;
        if (kept.lens_m != lens_m) {
            if (kept.used == now_) continue; // another lens in the same place has it now
            kept.lens_m = lens_m;
            kept.since = now_;
        }
        kept.used = now_;
        keeps[k] = {static_cast<std::uint32_t>(place), kept.since};
    }
    keeps_used_ += (lights.size() * sizeof(shared::Keep) + kKeepAlign - 1) / kKeepAlign * kKeepAlign;
    return chunk;
}

} // namespace ghost::render
