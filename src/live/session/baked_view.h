#pragma once
// SPDX-License-Identifier: Apache-2.0
// BakedView: the passes of a camera of the show, relit on the device of a live session in the place of its
// picture. load_baked reads them from disk and may run on any thread while the show's names, fixtures and
// files stay as they are; the rest is of the main thread. Session and device must outlive it.

#include "live/session/session.h"
#include "passes/passes.h"

#include <functional>
#include <memory>
#include <string>

namespace ghost::app {

struct BakedPasses {
    scene::Camera camera;
    scene::Passes passes;
    std::string why_not; // why they are not to be shown; empty: they are fresh
};
BakedPasses load_baked(const scene::Show& show, const scene::Camera& camera);

// Why a live picture of a window of that many pixels is finer; empty: it is not.
std::string why_too_coarse(const scene::Camera& passes, const glm::ivec2& window);

class BakedView {
public:
    // Error: the device has no room for them.
    static Result<std::unique_ptr<BakedView>> create(const Session& session, BakedPasses baked);

    // Of the camera, with the size of its passes.
    const scene::Camera& camera() const { return camera_; }
    std::size_t pass_count() const { return passes_.lights.size(); }
    render::Relighter& relighter() { return *relighter_; }
    const render::Relighter& relighter() const { return *relighter_; }
    // What the rig does now, under the exposure of that camera. haze: from the grid
    // (render/haze/private/haze_grid.h) while things move. stop: as Relighter::draw has it.
    render::FrameStatistics draw(const scene::Camera& exposure, double air_s, const render::HazeQuality& haze,
                                 const std::function<bool()>& stop);

private:
    BakedView(const Session& session, BakedPasses baked);
    scene::FrameLights lit() const;

    const Session& session_;
    scene::Camera camera_;
    scene::Passes passes_; // without their pictures
    std::unique_ptr<render::Relighter> relighter_;
};

} // namespace ghost::app
