#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the command render does once a show is open: pictures of a recording, or of what a desk sends now.
// Film time is seconds from its first frame. Errors: what cannot be read or written. Main thread.

#include "cli/options/input_options.h"
#include "cli/render/reference_render.h"
#include "farm/farm.h"
#include "live/engine/live_controls.h"
#include "live/inputs/timecode_input.h"
#include "live/session/picture_writer.h"
#include "live/session/session.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ghost::app {

// First and last frame of the range, which is given in seconds.
std::pair<long, long> film_frames(double from_s, double to_s, int fps);

struct RenderArguments {
    SessionOptions session;
    InputOptions input;
    LiveControlOptions controls;
    std::string out;
    std::string size;
    std::string frames;    // "240-479": only these of a film, without its sound; "": all
    long first_frame = -1; // of them
    long last_frame = -1;
    int threads = 0; // 0: one per core
    FarmOptions farm;
    std::string beams = "gate";
    std::string moving_maps; // processor, device; empty: as the device has it
    std::string replay;
    TimeCodeOptions timecode; // live: the recording by time code instead of a desk
    std::string motion;       // empty: the show's
    double at_s = -1;
    double from_s = -1;
    double to_s = -1;
    int fps = 30;
    bool live_input = false;
    double seconds = 10;
    int hold_fps = 0; // 0: quality stays
    bool no_caption = false;
    float ev100 = 0;
    bool has_ev100 = false;
    bool has_steps = false;
    int image_memory_mb = 1024;
    std::vector<float> eye_m;
    std::vector<float> target_m;
    float fov_y_deg = 40;
    bool auto_exposure = false; // of the free camera
    bool no_shadows = false;
    ReferenceArguments reference;
    bool json = false;
};

struct Tally {
    std::vector<double> draw_ms;
    dmx::Latency latency; // packet to picture
    int late = 0;         // film frames that repeat a picture because drawing took too long
    int additions = 0;
    int drawn = 0;
    int quality_changes = 0;
    std::size_t quality_level = 0;            // 0 is the best
    std::map<std::pair<int, int>, int> sizes; // frames by the pixels that they were drawn with

    void add(const render::FrameStatistics& frame) {
        draw_ms.push_back(frame.draw_ms);
        additions += frame.additions;
        drawn += frame.drawn;
    }
};

void print_tally(const RenderArguments& arguments, const Session& session, const PictureWriter& writer,
                 const Tally& tally);

// The rig is run from the start of the recording, because wheels and gobos turn: a frame is the same wherever
// it is asked from. Where that is more than ten minutes, from a minute before: only what turns without end
// may then stand at another angle.
Result<void> render_recording(const RenderArguments& arguments, Session& session, PictureWriter& writer,
                              Tally& tally);
// Film time is wall time: a picture that takes longer than a frame is shown for several.
Result<void> render_live(const RenderArguments& arguments, Session& session, PictureWriter& writer,
                         Tally& tally);

} // namespace ghost::app
