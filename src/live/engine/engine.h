#pragma once
// SPDX-License-Identifier: Apache-2.0
// Engine: the thread behind the window. It owns the session, the desk's receiver and the rig, draws what the
// request asks for and puts news into the link; the window never waits for it. While the picture moves it
// has as many pixels as the wanted rate allows (live/engine/pace.h); when it rests it is drawn once more,
// with all of them.

#include "link/link.h"
#include "live/engine/baked_supply.h"
#include "live/engine/desk_recorder.h"
#include "live/engine/followers.h"
#include "live/engine/live_controls.h"
#include "live/engine/message_board.h"
#include "live/engine/pace.h"
#include "live/engine/picture_probe.h"
#include "live/engine/plot_inbox.h"
#include "live/engine/rig_news.h"
#include "live/engine/show_sound.h"
#include "live/inputs/live_input.h"
#include "live/session/applied_look.h"
#include "live/session/session.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
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
};

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
    // Without a change, until the picture is drawn with all its pixels.
    static constexpr double kRest_s = 0.2;

    void run();
    void step();
    void wait(double step_begin_s);
    void replace_device(const std::string& why);
    void take_shaders();
    void begin_inputs();
    void listen();
    void listen_to_patch();
    SessionOptions session_options(const std::string& path) const;
    void open(const std::string& path);
    enum class Opening { another, newer_plot, edit }; // the latter two: of the show that is open
    void adopt(std::unique_ptr<Session> session, Opening opening);
    void clean();
    void begin_controls();
    void frame();
    // A remote control and trackers, before the rig's step. True: the camera sees something else now.
    bool apply_controls(double now_s);

    // The show that is open has another text; engine_edits.cpp.
    void take_edit();
    void take_air(const scene::Show& edited);

    void choose_recording();

    // engine_plots.cpp
    void look_for_plots();
    void take_plot();
    // Beside the show that is drawn until then; adopt_reopened takes it.
    void reopen(std::function<Result<std::unique_ptr<Session>>()> open);
    void adopt_reopened();

    // The camera for this frame: the wanted one, with fewer pixels while the picture moves, and as many as
    // memory holds at most, which is said.
    scene::Camera camera_for(double now_s);
    bool is_moving(double now_s) const;
    void fit_into_memory();
    // engine_news.cpp
    void publish_picture(const render::FrameStatistics& statistics, double draw_ms);
    std::string needs_live() const;
    bool has_work_light() const;
    float wanted_work_lux() const;
    void forget_baked();
    // That of the picture that is shown.
    const render::Relighter& relighter() const {
        return shows_baked_ ? baked_.view().relighter() : *session_->relighter;
    }
    render::FrameStatistics draw_live(double begin_s, double air_s);
    render::FrameStatistics draw_baked(double begin_s, double air_s);
    std::function<bool()> stop_of(double begin_s);
    int lights_in(double frame_ms) const;
    void learn_light_ms(const render::FrameStatistics& statistics, double draw_ms);
    ShownPicture shown() const { return {*session_, relighter(), drawn_, drawn_from_}; }
    void publish_opened(Opening opening);
    void publish_rest(double now_s, bool drew);
    double now_s() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    ui::Link& link_;
    EngineOptions options_;
    const Clock::time_point start_ = Clock::now();
    ui::ViewRequest request_;
    std::string tried_;                       // the show that was asked for last, open or not
    std::uint64_t opens_ = 0;                 // of the request then
    std::shared_ptr<const std::string> text_; // of it, likewise
    std::string played_;                      // of the request: what is played instead of the show's own
    DeskRecorder recorder_{link_};
    std::unique_ptr<TimeCodeInput> timecode_; // the receiver feeds this and the recorder, and goes first
    std::unique_ptr<dmx::Receiver> receiver_;
    scene::PatchMap patch_; // of the session's show
    MessageBoard messages_{link_};
    RigNews rig_news_{link_};
    double listens_again_s_ = 0; // where a port was taken
    int losses_ = 0;             // of the device
    std::unique_ptr<TrackerInput> trackers_;
    ShowSound sound_{options_.sound};
    PlotInbox plots_{link_};
    // A show that is opened while another one is drawn.
    std::future<Result<std::unique_ptr<Session>>> reopening_;
    Opening reopening_as_ = Opening::newer_plot;

    // Of the show that is open.
    std::unique_ptr<Session> session_;
    std::unique_ptr<LiveInput> input_;
    std::unique_ptr<AppliedLook> look_;
    PictureProbe probe_{link_};
    ui::FalseColour false_colour_; // of the picture that was published last
    std::unique_ptr<RemoteInput> remote_;
    Followers followers_;
    RemoteRequest remote_request_;       // those that hold
    scene::Camera wanted_camera_;        // of the request, turned to the tracker that it follows
    scene::Camera drawn_from_;           // the picture that is shown
    ui::Framed framed_;                  // likewise
    scene::Camera live_from_;            // the live one, which may not be shown
    glm::ivec2 whole_{0}, whole_for_{0}; // pixels that memory holds of those that are wanted; of which wish
    scene::FrameLights drawn_;
    Pace pace_{0};
    render::HazeQuality haze_;                                 // of the relighter
    fixture::Motion motion_ = fixture::Motion::as_the_machine; // of the show
    BakedSupply baked_;                                        // refers to the session, and goes before it
    bool shows_baked_ = false;
    std::string supply_sent_;  // words of the picture that was published last
    double light_ms_ = 0;      // of a light that turns, where many do; 0: not known
    bool sees_else_ = false;   // the live picture, since it was drawn last
    bool was_resized_ = false; // by the frame that is drawn
    double flew_s_ = -1;       // when its camera moved last
    bool flies_ = false;       // drawn as Session::look_from says
    float work_lux_ = 0;       // of the live picture's work light
    double last_step_s_ = 0;
    double air_s_ = 0; // age of the swirls
    double last_change_s_ = 0;
    std::uint64_t settled_ = 0;           // number of the request
    std::chrono::nanoseconds arrival_{0}; // of packets that no picture shows yet

    std::atomic<bool> stop_{false};
    std::thread thread_; // the last member: it uses all others
};

} // namespace ghost::app
