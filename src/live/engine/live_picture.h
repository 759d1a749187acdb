#pragma once
// SPDX-License-Identifier: Apache-2.0
// LivePicture: the picture that is drawn live, into the session. While anything moves it has as many pixels
// and lights as the wanted rate leaves time for (live/engine/pace.h), at rest all of them, or as many as
// memory holds, which is said. While its camera moves the session leaves out what takes long
// (Session::look_from). Seconds of any steady clock. Engine thread.

#include "link/link.h"
#include "live/engine/message_board.h"
#include "live/engine/pace.h"
#include "live/session/session.h"
#include "render/haze/quality.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace ghost::app {

class LivePicture {
public:
    // Without a change, until the picture is drawn with all its pixels.
    static constexpr double kRest_s = 0.2;

    // messages: where short memory is said.
    explicit LivePicture(MessageBoard& messages) : messages_(messages) {}

    // Another session is drawn from now on.
    void begin();
    // Of a show of so many fixtures: nothing is known of how fast it is drawn.
    void begin_show(std::size_t fixtures) { paces_ = {Pace(fixtures), Pace(fixtures), Pace(fixtures)}; }

    struct Wanted {
        const scene::Camera& camera; // size: pixels of the window
        ui::PictureQuality quality;
        bool has_work_light;
        ui::Measure measure; // shown of it in its place
        bool moves;          // something does, beside what draw() sees
        double air_s;        // age of the swirls
    };
    struct Drawn {
        render::FrameStatistics statistics;
        std::optional<scene::Camera> from; // nothing: it was stopped before it was begun
        bool changed = false;              // its camera moves, or it has other work light
    };
    // shown: what a person saw the stage from until now. stop: as Relighter::draw has it, for a picture at
    // rest.
    Drawn draw(Session& session, const Wanted& wanted, const scene::Camera& shown, double now_s,
               const std::function<bool()>& stop);
    // What the picture that was drawn last has cost, of all things that move.
    void learn(const render::FrameStatistics& statistics, double draw_ms, int frames_per_s);

    // The camera sees something else from the next picture on.
    void look_anew() { sees_else_ = true; }
    // Likewise: the session has other air.
    void take_air(Session& session);
    // True: they are others, and all is drawn anew.
    bool set_haze_samples(int samples, const Session& session);
    // Of any picture of the session.
    const render::HazeQuality& haze(bool moves);

    // A picture from that camera has all pixels that memory holds.
    bool is_whole(const scene::Camera& camera) const { return camera.width >= whole_.x; }
    bool has_work_light() const { return work_lux_ > 0; } // in the one that was drawn last

private:
    bool set_work_light(const Wanted& wanted, const Session& session);
    // True: all of it was done before.
    bool prepare_part(const scene::Camera& camera, double part_s, Session& session);
    void fit_into_memory(const scene::Camera& wanted, Session& session);
    scene::Camera camera_for(const Wanted& wanted, bool moves) const;
    int lights_in(double frame_ms) const;
    std::size_t kind() const { return measure_ == ui::Measure::lux ? 2 : flies_ ? 1 : 0; } // of paces_
    const Pace& pace() const { return paces_[kind()]; }

    MessageBoard& messages_;
    // Of a camera that stands, of one that flies, and of lux, which cost a second picture.
    std::array<Pace, 3> paces_{Pace(0), Pace(0), Pace(0)};
    render::HazeQuality haze_;           // of the relighter
    glm::ivec2 whole_{0}, whole_for_{0}; // pixels that memory holds; of those that are wanted
    scene::Camera from_;                 // of the one that was drawn last
    bool sees_else_ = false;             // since then
    bool is_unusual_ = false;            // it has another size, or a camera that begins or ends to fly
    bool was_prepared_ = false;          // the next size, in the picture before
    double flew_s_ = -1;                 // when its camera moved last
    double drew_ms_ = 0;                 // what it took, without what was made beside it
    bool flies_ = false;                 // drawn as Session::look_from says
    ui::Measure measure_ = ui::Measure::none;
    float work_lux_ = 0;
    double light_ms_ = 0; // of a light that turns, where many do; 0: not known
};

} // namespace ghost::app
