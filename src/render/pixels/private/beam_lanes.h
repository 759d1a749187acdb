#pragma once
// SPDX-License-Identifier: Apache-2.0
// The beam and what reflects it, of shaders/shared, for eight pixels at once: the same lines, read once more
// with real and truth of lane_types.h. What is of a light is one number for all eight. Only within functions
// that are VECTORS.

#include "render/pixels/private/lane_types.h"
#include "render/pixels/private/texture_lanes.h"
#include "shared/attenuation.h"
#include "shared/beam.h"
#include "shared/brdf.h"
#include "shared/haze.h"
#include "shared/octahedral.h"

#if defined(__x86_64__)
namespace ghost::shared::lanes {

// As large as they are, they are only looked at.
using Light = const shared::Light&;
using Wheel = const shared::Wheel&;
using Disc = const shared::Disc&;
using Blade = const shared::Blade&;
using Slide = const shared::Slide&;
using LaserCurve = const shared::LaserCurve&;
using Haze = const shared::Haze&;

} // namespace ghost::shared::lanes

#pragma push_macro("SHARED_BEGIN")
#pragma push_macro("SHARED_FN")
#pragma push_macro("SHARED_SIZE")
#undef SHARED_BEGIN
#undef SHARED_FN
#undef SHARED_SIZE
#define SHARED_BEGIN namespace ghost::shared::lanes {
#define SHARED_FN INLINE_VECTORS
#define SHARED_SIZE(type, bytes) static_assert(sizeof(type) >= (bytes))
// To be read once more.
#undef GHOST_SHARED_ATTENUATION_H
#undef GHOST_SHARED_BEAM_H
#undef GHOST_SHARED_BRDF_H
#undef GHOST_SHARED_FIGURE_H
#undef GHOST_SHARED_HAZE_H
#undef GHOST_SHARED_OCTAHEDRAL_H
#undef GHOST_SHARED_OPTICS_H
#include "shared/attenuation.h"
#include "shared/beam.h"
#include "shared/brdf.h"
#include "shared/haze.h"
#include "shared/octahedral.h"
#pragma pop_macro("SHARED_SIZE")
#pragma pop_macro("SHARED_FN")
#pragma pop_macro("SHARED_BEGIN")
#endif
