// SPDX-License-Identifier: Apache-2.0
// Processors that the steps are not written for (has_vectors): nothing here is ever called.
#if !defined(__x86_64__)
#include "base/check.h"
#include "render/pixels/develop.h"
#include "render/pixels/fold.h"
#include "render/pixels/glare.h"
#include "render/pixels/room_light.h"
#include "render/pixels/spread.h"
#include "render/pixels/sum.h"
#include "render/pixels/surfaces.h"

namespace ghost::render {

void add_pixels(const ImageAddition&, const Plane&, const Plane&) {
    CHECK(false);
}
void keep_pixels(const ImageAddition&, const Plane&, int, const Plane&) {
    CHECK(false);
}
void add_points(const ImageAddition&, const Plane&, const Plane&) {
    CHECK(false);
}
void spread_points(const CoarsePlanes&, const Plane&, const Plane&) {
    CHECK(false);
}
void fold_extras(const CoarsePlanes&, const Plane&) {
    CHECK(false);
}
void fold_fragments(const FragmentPlanes&) {
    CHECK(false);
}
void light_passes(const PassSurfaces&, const std::vector<MarkedLight>&, const Plane&) {
    CHECK(false);
}
void light_stage(const LiveSurfaces&, const std::vector<MarkedLight>&, const Plane&) {
    CHECK(false);
}
void sum_glow(const RoomPlanes&, GlowSlices&) {
    CHECK(false);
}
void add_room_light(const RoomPlanes&, const GlowSlices&, const Plane&) {
    CHECK(false);
}
void glare_down(const Plane&, const Plane&, float, bool) {
    CHECK(false);
}
void glare_tail(const Plane&, const Plane&, float, float) {
    CHECK(false);
}
void glare_up(const Plane&, const Plane&, float, float) {
    CHECK(false);
}
void develop(const SeenFrame&, float, std::uint32_t, const Plane&) {
    CHECK(false);
}
float metered_ev100(const SeenFrame&) {
    CHECK(false);
    return 0;
}

} // namespace ghost::render
#endif
