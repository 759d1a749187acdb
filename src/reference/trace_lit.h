#pragma once
// SPDX-License-Identifier: Apache-2.0
// The picture that relighting approximates: every sample is lit by the real beams, nothing is baked. For
// tests and for judging the passes. Direct light on surfaces in cd/m^2, linear Rec.2020, with extinction lamp
// -> surface -> camera, without the light that haze scatters.

#include "image/image.h"
#include "shared/gobos.h"
#include "shared/types.h"
#include "show/camera.h"
#include "stage/stage.h"

#include <cstdint>
#include <span>

namespace ghost::bake {

// seed 0: the same samples that a bake of this spp takes; another one: independent samples.
image::ImageF trace_lit(const scene::Stage& stage, const scene::Camera& camera,
                        std::span<const shared::Light> lights, const shared::Gobos& gobos, int spp,
                        const shared::Haze& haze, std::uint32_t seed = 0);

} // namespace ghost::bake
