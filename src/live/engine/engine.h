#pragma once
// SPDX-License-Identifier: Apache-2.0
// Engine: the thread behind the window. It owns the session, the desk's receiver and the rig, draws what the
// request asks for, live (live/engine/live_picture.h) or from passes (live/engine/baked_supply.h), and puts
// news into the link; the window never waits for it.

#include "image/image_pool.h"
#include "link/link.h"
#include "live/engine/baked_supply.h"
#include "live/engine/bounce_news.h"
#include "live/engine/camera_pictures.h"
#include "live/engine/desk_listener.h"
#include "live/engine/desk_recorder.h"
#include "live/engine/live_controls.h"
#include "live/engine/live_picture.h"
#include "live/engine/look_pictures.h"
#include "live/engine/message_board.h"
#include "live/engine/picture_probe.h"
#include "live/engine/plot_inbox.h"
#include "live/engine/rig_news.h"
#include "live/engine/show_sound.h"
#include "live/engine/side_views.h"
#include "live/inputs/live_input.h"
#include "live/inputs/rdm_heads.h"
#include "live/present/presentation.h"
#include "live/session/applied_look.h"
#include "live/session/opening.h"
#include "live/session/session.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace ghost::app {

struct EngineOptions {
    SessionOptions session; // show, view and size come from the request
    dmx::ReceiverOptions receiver;
    bool listens = true;                   // to a desk
    LiveControlOptions controls;           // remote control and trackers
    TimeCodeOptions timecode;              // what the recording follows
    std::string sound;                     // output of the show's sound (show_sound.h); empty: none
    std::optional<XchangeOptions> xchange; // where plots come from
    bool takes_plots = false;              // at once, without asking
    PresentationOptions present;
};

// Once in a program that will have an engine, before it has other threads (gpu/workers.h).
void prepare_engine();

class Engine {
public:
    // Starts at once; the link must outlive it.
    Engine(ui::Link& link, EngineOptions options);
    // Waits for the frame, or the part of loading, that it is at.
    ~Engine();
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

private:
    using Clock = std::chrono::steady_clock;

    void run();
    void step();
    void wait(double step_begin_s);
    void replace_device(const std::string& why);
    void draw_with_less(const std::string& why);
    void open_on_new_device(const std::string& why);
    void take_shaders();
    void begin_inputs();
    void listen();
    void listen_to_patch();
    SessionOptions session_options(const std::string& path) const;
    void open(const std::string& path);
    void adopt(std::unique_ptr<Session> session, Opening::Kind kind);
    void clean();
    void begin_controls(Opening::Kind kind);
    void forget_baked();
    double now_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    // engine_frame.cpp
    void frame();
    // What a remote control asks for now. True: the camera sees something else.
    bool hear_remote(double now_s);
    // Of the request, exposed as the remote control says, turned to the tracker that it follows: trackers are
    // heard, and what else follows them does.
    scene::Camera wanted_camera();
    bool is_moving(double now_s) const;
    bool has_work_light() const;
    bool has_input() const; // a recording, or a desk that was heard
    bool leaves_unasked_dark() const;
    std::string needs_live() const;
    render::FrameStatistics draw_live(const scene::Camera& asked, double begin_s);
    render::FrameStatistics draw_baked(const scene::Camera& wanted, double begin_s);
    std::function<bool()> stop_of(double begin_s);
    void draw_beside(double begin_s);
    void forget_beside();
    // That of the picture that is shown.
    render::Relighter& relighter() {
        return shown_.is_baked ? baked_.view().relighter() : *session_->relighter;
    }
    ShownPicture shown() { return {*session_, relighter(), shown_.lights, shown_.camera}; }

    // The show that is open has another text; engine_edits.cpp.
    void take_edit();
    // Of the request, by the indices of the show that is drawn.
    const ui::Look& look_of_drawn();
    std::optional<std::size_t> fixture_of_drawn(const std::optional<std::size_t>& fixture) const; // likewise
    void take_air(const scene::Show& edited);
    void choose_recording();

    // engine_plots.cpp
    void look_for_plots();
    void take_plot();
    void adopt_opened();

    // engine_news.cpp
    void publish_opened(Opening::Kind kind);
    void publish_picture(const render::FrameStatistics& statistics, double draw_ms);
    // What a window may paint.
    std::shared_ptr<const image::Image8> window_image();
    // The device shows the pictures, and this one moves: nobody asks for its bytes.
    bool leaves_on_device(double now_s) const;
    void present(bool is_new, double draw_ms); // the picture is
    void publish_rest(double now_s, bool drew);
    void tell_unseen(double now_s); // once when the camera rests

    ui::Link& link_;
    EngineOptions options_;
    const Clock::time_point start_ = Clock::now();
    ui::ViewRequest request_;
    std::string tried_;                             // the show that was asked for last, open or not
    std::uint64_t opens_ = 0;                       // of the request then
    std::shared_ptr<const std::string> text_;       // of it, likewise
    std::shared_ptr<const std::string> drawn_text_; // that the session was opened with
    ui::Look counted_;                              // the look, where indices are others there
    std::string played_; // of the request: what is played instead of the show's own
    DeskRecorder recorder_{link_};
    MessageBoard messages_{link_};
    image::ImagePool pictures_;                            // for the window
    RdmHeads rdm_{link_, options_.receiver.artnet_offset}; // the receiver asks it, and goes first
    DeskListener desk_{options_.receiver, recorder_, messages_, link_};
    scene::PatchMap patch_; // of the session's show
    RigNews rig_news_{link_};
    BounceNews bounce_news_{link_};
    double bounce_ms_ = 0; // of drawing the last picture
    int losses_ = 0;       // of the device, and of its memory
    LiveControls controls_;
    ShowSound sound_{options_.sound};
    PlotInbox plots_{link_};

    // Of the show that is open.
    std::unique_ptr<Session> session_;
    std::unique_ptr<LiveInput> input_;
    std::unique_ptr<AppliedLook> look_;
    PictureProbe probe_{link_};
    // These refer to the session, and go before it.
    CameraPictures camera_pictures_{link_};
    LookPictures look_pictures_{link_};
    SideViews side_views_{link_};
    Presentation presentation_{link_, options_.present};       // likewise
    ui::FalseColour false_colour_;                             // of the picture that was published last
    fixture::Motion motion_ = fixture::Motion::as_the_machine; // of the show
    LivePicture live_{messages_};
    BakedSupply baked_; // refers to the session, and goes before it
    struct {
        bool is_baked = false;
        scene::Camera camera;
        ui::Framed framed;
        scene::FrameLights lights;
        std::vector<glm::mat4> moved; // by movers
        bool is_black = false;
    } shown_;
    struct {
        scene::Camera camera;
        bool is_black = false, is_known = false;
        ui::UnseenStage news;
    } unseen_;                                   // what was looked for last
    std::string supply_sent_;                    // words of the picture that was published last
    std::shared_ptr<const image::Image8> image_; // likewise
    bool is_image_older_ = false;                // likewise
    std::size_t missing_maps_sent_ = 0;
    double last_step_s_ = 0;
    double air_s_ = 0; // age of the swirls
    double last_change_s_ = 0;
    std::uint64_t settled_ = 0;           // number of the request
    std::chrono::nanoseconds arrival_{0}; // of packets that no picture shows yet

    Opening opening_; // what becomes of the session; waited for before all others go
    std::atomic<bool> stop_{false};
    std::thread thread_; // the last member: it uses all others
};

} // namespace ghost::app
