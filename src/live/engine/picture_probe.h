#pragma once
// SPDX-License-Identifier: Apache-2.0
// PictureProbe: what is asked of a picture that is shown: false colours in its place, cd/m^2 and lux under
// the mouse, what a click meets, the picture as a file. Answers go by the link. Engine thread.

#include "link/link.h"
#include "live/lux/light_meter.h"
#include "live/session/session.h"
#include "rays/tracer.h"

#include <future>
#include <memory>
#include <optional>

namespace ghost::app {

// What is shown now.
struct ShownPicture {
    Session& session;
    render::Relighter& relighter; // of the live picture, or of a baked one
    const scene::FrameLights& lights;
    const scene::Camera& camera;
};

class PictureProbe {
public:
    explicit PictureProbe(ui::Link& link) : link_(link) {}

    // rests: nothing moves in it.
    std::shared_ptr<const image::Image8> false_colours(const ui::FalseColour& wanted,
                                                       const ShownPicture& shown, bool rests);
    // drew: it is another picture than at the last call.
    void probe(const std::optional<glm::vec2>& place, const ShownPicture& shown, double now_s, bool drew);
    // The same of a picture from elsewhere; luminance: of its pixels.
    ui::SideMeasure measure(const glm::vec2& place, const image::ImageF& luminance,
                            const scene::Camera& camera, const Session& session,
                            const scene::FrameLights& lit);
    void pick(const ui::Pick& pick, const Session& session);
    void save(const ui::SaveFrame& wanted, const ShownPicture& shown);

    // Rays through the stage as it is shown now.
    const bake::Tracer& tracer(const Session& session);
    // The same for what can wait, for of a large stage it takes longer to make than a picture: null until it
    // is there.
    const bake::Tracer* tracer_if_made(const Session& session);

    // The session is another one; the picture is of another camera.
    void forget();
    void forget_frame() { frame_ = {}; }

private:
    void begin_tracer(const Session& session);

    ui::Link& link_;
    scene::Stage traced_stage_;
    std::uint64_t traced_changes_ = 0;
    std::unique_ptr<bake::Tracer> tracer_; // made when something is to be explained or measured
    std::future<std::unique_ptr<bake::Tracer>> coming_tracer_; // reads the stage: waited for before that goes
    image::ImageF frame_; // cd/m^2 of the picture, made when they are asked for
    std::optional<glm::vec2> probed_place_;
    double probed_s_ = 0;
    std::uint64_t saved_ = 0, picked_ = 0; // numbers of the last requests
};

} // namespace ghost::app
