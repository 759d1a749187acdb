#pragma once
// SPDX-License-Identifier: Apache-2.0
// LED walls as the camera sees them (docs/design/led-walls.md): their pictures on the surfaces that lie on
// them, added to the finished frame, before lenses and glare. Never part of a kept image. Main thread; the
// device must outlive it.

#include "gpu/commands.h"
#include "gpu/texture.h"
#include "render/geometry/fragments.h"
#include "shared/led_wall.h"

#include <vector>

namespace ghost::render {

// Pixels that a wall may cover; false where it is behind the eye, turned away or beside the picture.
bool wall_in_view(const shared::LedWall& wall, const shared::View& view, glm::uvec2& low, glm::uvec2& high);

class LedWallPass {
public:
    explicit LedWallPass(const gpu::Device& device);

    // Adds to layer 0 of frame.
    void record(gpu::Commands& commands, const Fragments& fragments,
                const std::vector<shared::LedWall>& walls, const gpu::Texture& gobos,
                const gpu::Texture& slides, const gpu::Texture& frame);

    // cd/m^2 that a pixel got at most in the last record.
    float brightest() const { return brightest_; }

private:
    gpu::LateProgram program_;
    float brightest_ = 0;
};

} // namespace ghost::render
