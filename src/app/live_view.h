#pragma once
// SPDX-License-Identifier: Apache-2.0
// LiveView: the stage of a show on the device, seen from a camera that may go anywhere: its meshes, the
// G-buffer of the camera, the distance maps of all lights. Main thread; show and device must outlive it.

#include "gpu/device.h"
#include "render/distance_images.h"
#include "render/g_buffer.h"
#include "render/stage_model.h"
#include "scene/distance_maps.h"
#include "scene/show.h"

#include <memory>

namespace ghost::app {

class LiveView {
public:
    // Loads the stage if that was not done, makes the distance maps that are missing (with a progress bar
    // unless quiet) and draws the G-buffer. A show without a stage that can be read has its beams all the
    // same. Error: interrupted.
    static Result<std::unique_ptr<LiveView>> open(const gpu::Device& device, scene::Show& show,
                                                  const scene::Camera& camera, bool shadows, bool quiet,
                                                  scene::Report& report);

    // The same picture size as before.
    void look_from(const scene::Camera& camera);

    const render::GBuffer& g_buffer() const { return g_buffer_; }
    const render::DistanceImages* distances() const { return distances_.get(); }
    const scene::DistanceMaps& maps() const {
        return maps_;
    } // without the distances, which are on the device
    const scene::Stage& stage() const { return stage_; }

private:
    LiveView(const gpu::Device& device, const scene::Show& show, scene::Stage stage,
             const scene::Camera& camera, scene::Report& report);

    const scene::Show& show_;
    scene::Stage stage_; // with fixture bodies
    render::StageModel model_;
    render::GBuffer g_buffer_;
    scene::DistanceMaps maps_;
    std::unique_ptr<render::DistanceImages> distances_;
};

// The way of a free camera between two others: smooth start and stop, share 0..1.
scene::Camera camera_between(const scene::Camera& from, const scene::Camera& to, float share);

} // namespace ghost::app
