#pragma once
// SPDX-License-Identifier: Apache-2.0
// What lights have of a device's memory, and what of it is given up first where that ends. Each takes what it
// wants, but at most its share of what is left when it is made: so what is kept from frame to frame goes, as
// a rule, before what is seen, and that before what every frame needs. After all of it the picture itself has
// fewer pixels (live/session/picture_room.h). Main thread.

#include "gpu/device.h"

#include <cstdint>
#include <span>
#include <string>

namespace ghost::render {

enum class Kept { tables, visibility, images, maps, batch };

struct MemoryShare {
    Kept kept;
    std::uint64_t sixteenths; // of what is left
    const char* before;       // words around how many there are
    const char* after;
};

// The first goes first. Tables are of beams in the haze, which are filled again for a light that lost its
// own; visibility is worked out again, images of resting lights are drawn again. Then shadows are coarser.
// Where many lights share a dispatch each has to have its table: fewer share one.
inline constexpr MemoryShare kMemoryOrder[] = {{Kept::tables, 1, "", " kept tables of haze"},
                                               {Kept::visibility, 2, "", " KB of kept visibility"},
                                               {Kept::images, 14, "", " kept images"},
                                               {Kept::maps, 8, "shadow maps of ", " texels a side"},
                                               {Kept::batch, 8, "", " lights at once"}};

// Bytes.
std::uint64_t share_of(Kept kept, const gpu::Device& device);

struct Shortage {
    Kept kept;
    std::uint64_t has = 0;
    std::uint64_t wanted = 0;
};
// "9 kept images instead of 64, shadow maps of 128 texels a side instead of 512", as in kMemoryOrder; ""
// where all have what they want.
std::string sentence_of(std::span<const Shortage> shortages);

} // namespace ghost::render
