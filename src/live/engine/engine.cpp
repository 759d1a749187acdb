// SPDX-License-Identifier: Apache-2.0
#include "live/engine/engine.h"

#include "base/interrupt.h"
#include "gpu/device_failures.h"
#include "gpu/device_memory.h"
#include "gpu/workers.h"
#include "show/same_fixtures.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/text.h"
#include "disk/leftovers.h"

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace ghost::app {
namespace {

constexpr double kShortestStep_s = 1.0 / 120; // whatever comes: a display shows no more
constexpr double kMovingStep_s = 1.0 / 60;
constexpr double kRestingStep_s = 0.04;
constexpr int kMostLosses = 20; // of a device, in one window: a driver that breaks each time must end

} // namespace

void prepare_engine() {
    gpu::prepare_workers();
}

Engine::Engine(ui::Link& link, EngineOptions options)
    : link_(link), options_(std::move(options)), thread_([this] { run(); }) {}

Engine::~Engine() {
    stop_ = true;
    link_.wake.raise();
    thread_.join();
}

void Engine::run() {
    try {
        begin_inputs();
        while (!stop_ && !interrupted()) {
            const double begin_s = now_s();
            try {
                step();
            } catch (const gpu::DeviceLost& lost) {
                replace_device(lost.what());
            } catch (const gpu::OutOfDeviceMemory& shortage) {
                draw_with_less(shortage.what());
            }
            wait(begin_s);
        }
    } catch (const std::exception& problem) { // no memory, as a rule
        link_.failed.put({std::string("the picture stopped: ") + problem.what(), request_.show});
        link_.on_news();
    }
}

// Until something changes, or what moves by itself has moved on.
void Engine::wait(double step_begin_s) {
    const auto for_s = [](double seconds) {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(
            std::chrono::duration<double>(std::max(seconds, 0.0)));
    };
    std::this_thread::sleep_for(for_s(kShortestStep_s - (now_s() - step_begin_s)));
    const bool rests = now_s() - last_change_s_ > LivePicture::kRest_s;
    (void)link_.wake.wait_for(for_s((rests ? kRestingStep_s : kMovingStep_s) - (now_s() - step_begin_s)));
}

void Engine::step() {
    listen();
    if (std::optional<ui::ViewRequest> newest = link_.request.take()) {
        request_ = std::move(*newest);
        if (request_.show != tried_ || request_.opens != opens_) open(request_.show);
    }
    if (session_ && request_.text && request_.text != text_) take_edit();
    if (session_ && !opening_.is_running() && session_->device->have_shaders_changed()) take_shaders();
    look_for_plots();
    if (session_) choose_recording();
    recorder_.record(request_.record_to, desk_.receiver() ? &desk_.options() : nullptr,
                     input_ ? &input_->desk() : nullptr);
    if (session_ && request_.camera.width > 0) frame();
}

// The show is opened again on whatever device there is now; nothing that the window knows changes.
void Engine::replace_device(const std::string& why) {
    log_warning(why);
    if (!session_ || ++losses_ > kMostLosses) throw std::runtime_error(why);
    messages_.add(Severity::warning, session_->device->name(), why + "; it is drawn anew");
    open_on_new_device(why);
}

// What draws plans by the memory that there is: first less is kept (render/haze/memory_order.h), then shadow
// maps are smaller, then the picture, each with a word.
void Engine::draw_with_less(const std::string& why) {
    log_warning(why);
    if (!session_ || ++losses_ > kMostLosses) throw std::runtime_error(why);
    const std::uint64_t used = session_->device->memory().used_bytes();
    messages_.add(
        Severity::warning, session_->device->name(),
        "it has no more memory for drawing, " + std::to_string(used >> 20) +
            " MB were in use; from now on it is drawn with less: fewer kept pictures, smaller shadow maps, "
            "a smaller picture");
    forget_baked();
    probe_.forget();
    forget_beside();
    look_.reset();
    presentation_.end();
    session_->stop_drawing(); // else what is there now and what comes would be there at once
    options_.session.image_memory_bytes /= 8;
    std::uint64_t most = used;
    while (true) {
        options_.session.memory_limit_bytes = most;
        try {
            open_on_new_device(why);
            return;
        } catch (const gpu::OutOfDeviceMemory& again) {
            log_warning(again.what());
        }
        most = most / 8 * 7;
        if (most < used / 2) throw std::runtime_error(why); // what is left cannot be given up
    }
}

void Engine::open_on_new_device(const std::string& why) {
    link_.activity.put("drawing anew on the graphics device");
    link_.on_news();
    auto opened = open_session(session_options(session_->options.show));
    link_.activity.put("");
    if (!opened.ok()) throw std::runtime_error(why + ", and " + opened.error().text());
    adopt(std::move(*opened), Opening::Kind::edit);
}

// SessionOptions::shaders has newer ones: what was drawn with the ones before stays if they do not work.
void Engine::take_shaders() {
    opening_.begin(Opening::Kind::edit,
                   [options = session_options(session_->options.show)] { return open_session(options); });
}

void Engine::begin_inputs() {
    if (options_.xchange) {
        if (const Result<void> begun = plots_.begin(*options_.xchange); !begun.ok())
            messages_.add(Severity::error, begun.error().where, begun.error().what);
    }
    if (options_.controls.psn) {
        if (const Result<void> opened = controls_.open_trackers(options_.receiver.interface); !opened.ok())
            messages_.add(Severity::error, opened.error().where, opened.error().what);
    }
    desk_.answer(rdm_);
    desk_.follow(options_.timecode);
}

void Engine::listen() {
    if (!options_.listens || !desk_.listen(now_s())) return;
    if (input_) input_->set_receiver(desk_.receiver());
    listen_to_patch();
}

void Engine::listen_to_patch() {
    patch_ = session_ ? scene::PatchMap(*session_->show) : scene::PatchMap();
    if (session_) desk_.listen_to(patch_);
}

void Engine::open(const std::string& path) {
    tried_ = path;
    opens_ = request_.opens;
    text_ = request_.text;
    link_.activity.put("opening " + path);
    link_.on_news();
    auto opened = open_session(session_options(path));
    link_.activity.put("");
    if (!opened.ok()) {
        link_.not_opened.put({opened.error(), opens_});
        link_.on_news();
        return;
    }
    opening_.drop(); // an edit or a plot of the show before would take this one's place
    adopt(std::move(*opened), Opening::Kind::another);
}

SessionOptions Engine::session_options(const std::string& path) const {
    SessionOptions options = options_.session;
    options.show = path;
    // A plot has none: the text is that of a show in whose place it came from the network.
    if (lower(std::filesystem::path(path).extension().string()) != ".mvr") options.text = text_;
    options.live = true;
    options.workers = true;
    options.maps_in_background = true;
    options.beams.grid = true; // while things move
    options.parks = true;
    options.keep_hidden = true;
    options.presents = presentation_.wants_device();
    options.bake = false;
    options.stop = [this] { return stop_.load(); };
    options.width = 320; // until the window says how large it is
    options.height = 180;
    return options;
}

void Engine::adopt(std::unique_ptr<Session> session, Opening::Kind kind) {
    forget_baked(); // all of them refer to the session before
    probe_.forget();
    forget_beside();
    look_.reset();
    presentation_.end();
    std::unique_ptr<Session> session_before = std::exchange(session_, std::move(session));
    drawn_text_ = text_;
    presentation_.begin(*session_->device);
    if (kind != Opening::Kind::another && session_before)
        session_->rig->go_on_from(*session_before->rig,
                                  scene::same_fixtures(*session_before->show, *session_->show));
    begin_controls(kind);
    const std::unique_ptr<LiveInput> before = std::move(input_);
    look_ = std::make_unique<AppliedLook>(*session_);
    motion_ = session_->show->motion;
    input_ = std::make_unique<LiveInput>(desk_.receiver(), desk_.timecode());
    sound_.use(session_->show->sound);
    listen_to_patch();
    rdm_.begin(kind == Opening::Kind::another);
    if (kind == Opening::Kind::another) {
        request_.recording.clear();
        played_.clear();
    }
    const std::filesystem::path played =
        played_.empty() ? session_->show->recording : std::filesystem::path(played_);
    if (auto loaded = input_->load_recording(played, session_->report); !loaded.ok())
        session_->report.add(Severity::warning, loaded.error().where, loaded.error().what);
    if (kind != Opening::Kind::another && before) input_->go_on_from(*before);
    shown_.camera = {};
    shown_.lights = {};
    missing_maps_sent_ = session_->live->missing_maps();
    live_.begin();
    if (kind == Opening::Kind::another) live_.begin_show(session_->show->fixtures.size());
    if (session_before) {
        session_before.reset();
        give_back_free_memory();
    }
    last_step_s_ = now_s();
    if (kind != Opening::Kind::edit) { // those of the show before are none of this one
        request_.look = {};
        request_.explained.reset();
    }
    if (kind == Opening::Kind::another) {
        for (const ui::Command& command : link_.commands.take())
            (void)link_.command_answers.put({command.number, "another show was opened"});
        request_.camera.width = 0;
        clean();
    }
    publish_opened(kind);
}

void Engine::forget_baked() {
    baked_.forget();
    shown_.is_baked = false;
}

void Engine::forget_beside() {
    camera_pictures_.forget();
    look_pictures_.forget();
    side_views_.forget();
}

// What programs left that were killed while they wrote.
void Engine::clean() {
    const scene::Show& show = *session_->show;
    const std::size_t count = remove_leftovers(show.folder, show.folder, Below::left_alone) +
                              remove_leftovers(show.cache_folder(), show.cache_home(), Below::included);
    if (count > 0)
        log_info("removed " + std::to_string(count) + " unfinished files of programs that were killed in " +
                 show.folder.string());
}

void Engine::begin_controls(Opening::Kind kind) {
    controls_.begin(*session_, kind == Opening::Kind::another ? LiveControls::Of::another_show
                                                              : LiveControls::Of::the_same_show);
    const std::string& osc = options_.controls.osc;
    if (osc.empty() || controls_.has_remote()) return;
    if (const Result<void> opened = controls_.open_remote(osc, *session_->show); !opened.ok())
        session_->report.add(Severity::error, opened.error().where, opened.error().what);
}

} // namespace ghost::app
