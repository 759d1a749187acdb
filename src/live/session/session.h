#pragma once
// SPDX-License-Identifier: Apache-2.0
// Session: a show opened for drawing: fixtures, passes of one camera (baked where they are missing or older
// than what they show), device and relighter. What render, bench and the window share. Main thread.

#include "base/report.h"
#include "base/result.h"
#include "fixture/motion.h"
#include "gpu/device.h"
#include "light/gobos.h"
#include "light/rig.h"
#include "live/session/atmosphere.h"
#include "live/session/bounce_light.h"
#include "live/session/live_view.h"
#include "live/session/media_player.h"
#include "passes/passes.h"
#include "render/relight/relighter.h"
#include "show/camera.h"
#include "show/looks.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace ghost::app {

struct SessionOptions {
    std::string show;
    std::shared_ptr<const std::string> text; // of show.toml, instead of what the file says
    std::string view;                        // empty: the first camera
    int width = 0; // 0: the camera's own size; else passes of this size are baked beside the others
    int height = 0;
    int supersample = 1; // live only: drawn this many times as large
    int map_size = 0;    // live only: of distance maps, instead of the show's
    std::string device;  // see gpu::DeviceOptions
    bool validation = false;
    bool bake = true; // false: missing passes are an error
    bool quiet = false;
    bool plays_recording = false; // the show's own: an error where it has none
    render::HazeIntegrator beams;
    std::optional<fixture::Motion> motion; // instead of the show's
    std::optional<float> ev100;            // instead of the camera's
    image::Tone tone = image::Tone::agx;
    bool live = false;                // a free camera: no passes
    std::optional<scene::Camera> eye; // instead of a camera of the show; live only
    std::string travel;               // a camera to fly to; live only
    std::string look;                 // one of looks.toml, on top of what DMX asks for
    std::string looks_file;           // instead of the show's own
    bool shadows = true;              // live only
    bool maps_in_background = false;  // live only: LiveOptions
    bool keep_hidden = false;         // live only: LiveOptions
    bool repeatable = false;          // live only: the same bytes in each run (render::Settings)
    bool parks = false;               // live only: Session::look_from
    // Instead of the show's. Where light bounces the picture is live, unless its passes were rendered
    // elsewhere.
    std::optional<scene::BounceDetail> bounce;
    float glare = 0.05f; // share of the light that the camera scatters; 0: neither glare nor lenses
    std::uint64_t image_memory_bytes = std::uint64_t{1} << 30;
    std::uint64_t memory_limit_bytes = 0;            // of the device, see gpu::DeviceOptions
    std::string shaders;                             // likewise
    bool pipeline_statistics = false;                // likewise
    std::uint32_t lights_per_dispatch = 0;           // render::Settings
    bool pixels_on_processor = true;                 // likewise
    MovingMapsBy moving_maps = MovingMapsBy::choice; // live only
    gpu::LoweredLimits lowered_limits;               // gpu::DeviceOptions
    // Draw lights side by side where the device is a processor (gpu/workers.h): for pictures that move, whose
    // last bit may hang on the machine.
    bool workers = false;
    bool presents = false; // gpu::DeviceOptions
    // Asked from time to time by whoever opens: true ends it with an error. Nothing: an interrupt does,
    // unless maps are made in the background.
    std::function<bool()> stop;
};

struct Session {
    ~Session();

    Report report;                     // already printed
    std::size_t of_show_file = 0;      // messages at its begin: those of reading the show
    std::unique_ptr<scene::Show> show; // address is kept by the rig
    std::size_t camera = 0;
    std::optional<scene::Camera> travel_to;
    scene::Passes passes; // without the light pictures, which are on the device
    scene::GoboStack gobos;
    std::unique_ptr<scene::Rig> rig;
    std::unique_ptr<MediaPlayer> media; // null: the show has none
    // Moment that moving pictures show, and whether a picture waits until they are at it (films that are not
    // made live); nothing: draw's time.
    std::optional<double> media_s;
    bool media_waits = false;
    std::unique_ptr<gpu::Device> device;
    std::unique_ptr<LiveView> live;                      // or null: passes
    std::unique_ptr<BounceLight> bounce;                 // reads live; null: no light bounces
    std::shared_ptr<const scene::BounceVolumes> bounced; // as the relighter has it, or null
    std::unique_ptr<render::Relighter> relighter;
    // Of the same picture: with light at half its size where relighter has it at all of it, or the other way.
    std::unique_ptr<render::Relighter> other_light;
    std::unique_ptr<render::Relighter> lux_light; // of the same picture, see live/lux/light_meter.h; or null
    // Those of a picture of another size, or of the flight before it, or after which it is.
    std::unique_ptr<render::Relighter> parked, parked_other_light;
    bool parked_flies = false;
    bool splits_flights = true; // they have pictures of their own, where any is parked: memory is not short
    bool maps_changed_since_parked = false;
    std::map<std::size_t, fixture::Programmer> programmer; // of options.look, for Rig::step
    std::map<std::size_t, std::vector<float>> movers;      // of options.look, by hand
    scene::SceneLook scene_look;                           // that of options.look, or what hands set since
    float haze_density = 1;                                // times that: a remote control's
    float master = 1;                                      // share of all light
    bool shadows = true;                                   // live only
    bool flies = false;                                    // look_from
    SessionOptions options;                                // as it was opened

    // Of the show, with scene_look and haze_density; a live picture has it from the next look_from on.
    Atmosphere atmosphere() const { return atmosphere_of(*show, scene_look, haze_density); }

    // Moves the moving pictures on to this time, or to media_s; draw does so, too.
    void show_media(double time_s);
    // With the master, and without shadows where those are off.
    scene::FrameLights lit() const;
    // One frame of what the rig does now; time_s moves the haze. Live: heads turn, maps that were made
    // meanwhile throw their shadows.
    render::FrameStatistics draw(double time_s = 0, const std::function<bool()>& stop = {});
    // Moves a live camera, and shows what the atmosphere is now. A camera of
    // another size gets another picture; stage and distance maps stay on the device. SessionOptions::parks:
    // the picture before is kept, where there is memory, and taken up again when its size is asked for.
    // goes_on: soon it looks from elsewhere, so nothing that is seen from there is kept, and the stage has
    // less detail. coarse: use_coarse_light, too; else it stays as it is.
    void look_from(const scene::Camera& from, bool goes_on = false);
    void look_from(const scene::Camera& from, bool goes_on, bool coarse);
    // Before a look_from that does not go on, of another size or after a flight, where the picture before is
    // parked: does what takes long, for as long as stop is false. False: it was stopped; what is shown stays,
    // and the next one goes on from there.
    bool prepare(const scene::Camera& from, const std::function<bool()>& stop);
    void drop_parked();
    // Whether a picture from there, or of a flight through there, is another one than that which is shown.
    bool is_another(const scene::Camera& from, bool goes_on) const;
    // Gives back all memory of the device. Nothing is drawn any more; show and rig stay.
    void stop_drawing();
    // Live: light bounces from the next frame on, or no more. Links are made in the background, or draw waits
    // for them, as SessionOptions::maps_in_background says.
    void set_bounce(scene::BounceDetail level);
    scene::BounceDetail bounce_detail() const { return bounce_detail_; }
    // The making of links is given up, or begins anew; nothing where they are there.
    void stop_bounce(bool stops);
    // Whether the picture has the bounced light of the newest lights, or never will.
    bool is_bounce_settled() const { return !bounce || bounce->is_up_to_date(); }
    // Live: from the next frame on light is drawn at half the size of the picture
    // (render/relight/coarse_light.h), or at all of it. Of either what is kept stays, where there is memory.
    void use_coarse_light(bool coarse);

private:
    bool parks(const scene::Camera& from) const;
    // Each that draws the picture that is shown.
    void on_lights(const std::function<void(render::Relighter&)>& what) const;
    void take_bounced();
    std::unique_ptr<render::Relighter> make_relighter(const scene::Camera& from, bool coarse) const;
    void update_bounce(const scene::FrameLights& lit);
    scene::BounceDetail bounce_detail_ = scene::BounceDetail::off;
    bool is_short_ = false; // render/relight/light_budget.h, of the last picture
    int behind_ = 0;        // pictures since heads turned
};

Result<std::unique_ptr<Session>> open_session(const SessionOptions& options);

// scene::load_show with a bar, and Ctrl-C ends it. text: instead of what show.toml says.
Result<scene::Show> open_show(const std::string& path, bool load_stage, bool quiet, Report& report,
                              const std::shared_ptr<const std::string>& text = nullptr);

// The stage, if it can be read. A show without one still has its beams.
bool load_stage(scene::Show& show, Report& report);

// Settings of the relighter for a camera of a show.
render::Settings draw_settings(const Atmosphere& air, const scene::Camera& camera,
                               const SessionOptions& options);

// Prints what a report holds beyond the first `skip` messages.
void print_report(const Report& report, std::size_t skip = 0);

} // namespace ghost::app
