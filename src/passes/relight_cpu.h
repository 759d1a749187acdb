#pragma once
// SPDX-License-Identifier: Apache-2.0
// Relighting of passes on the CPU: the surfaces of shaders/relight/surface.comp without haze in the air
// (Screen Space Re-Rendering 2.1), for tests of the baker and of the GPU. cd/m^2, linear Rec.2020, with
// extinction lamp -> surface -> camera. Pure.

#include "image/image.h"
#include "passes/passes.h"
#include "shared/gobos.h"
#include "shared/types.h"

#include <span>

namespace ghost::scene {

// Light::pass indexes passes.lights (beyond them: dark). 3 channels.
image::ImageF relight_cpu(const Passes& passes, std::span<const shared::Light> lights,
                          const shared::Gobos& gobos, const shared::Haze& haze);

} // namespace ghost::scene
