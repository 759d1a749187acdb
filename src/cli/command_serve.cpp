// SPDX-License-Identifier: Apache-2.0
// ghostlight serve: a show drawn live without a window, for browsers alone.
#include "base/interrupt.h"
#include "base/log.h"
#include "base/signal.h"
#include "base/steady_time.h"
#include "cli/commands.h"
#include "cli/options/bounce_option.h"
#include "cli/options/checked_run.h"
#include "cli/options/input_options.h"
#include "cli/options/live_options.h"
#include "cli/options/size_option.h"
#include "cli/options/web_options.h"
#include "live/engine/engine.h"
#include "show/looks.h"
#include "show/show.h"
#include "ui/model/look_fade.h"

#include <chrono>
#include <filesystem>
#include <memory>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

struct ServeArguments {
    std::string show;
    std::string view; // camera; empty: the first one
    std::string size = "1280x720";
    int width = 0, height = 0;
    int fps = 25;
    EngineOptions engine;
    InputOptions input;
    WebOptions web;
    web::ServerOptions server;
    bool rdm = false;
    bool no_desk = false;
    bool quiet = false;
};

Result<void> check_usage(ServeArguments& arguments) {
    arguments.input.ltc = arguments.engine.timecode.ltc;
    TRY(arguments.engine.receiver, receiver_options(arguments.input));
    arguments.engine.receiver.listen_wider = true;
    arguments.engine.receiver.slot_status = true; // for the page that explains
    arguments.engine.listens = !arguments.no_desk;
    arguments.engine.session.quiet = arguments.quiet;
    TRY_VOID(check_live_controls(arguments.engine.controls));
    TRY_VOID(open_timecode(arguments.engine.timecode));
    if (!arguments.engine.timecode.begin.empty() && arguments.engine.timecode.ltc.empty() &&
        arguments.no_desk)
        return Error{"the time code comes by the network, too", "--no-desk/--timecode"};
    warn_of_silent_rdm(arguments.rdm, arguments.input);
    if (arguments.rdm && arguments.no_desk) return Error{"RDM comes by the network, too", "--no-desk/--rdm"};
    TRY(arguments.server, server_options(arguments.web));
    TRY(const glm::ivec2 size, size_from(arguments.size, {320, 180}, 3840));
    arguments.width = size.x;
    arguments.height = size.y;
    return {};
}

// What the window does elsewhere: says which show, which camera and which look.
class Onlooker {
public:
    Onlooker(ui::Link& link, const ServeArguments& arguments) : link_(link), arguments_(arguments) {
        request_.show = arguments.show;
        request_.opens = 1;
        request_.quality.fps = arguments.fps;
        request_.rdm = arguments.rdm ? ui::RdmAccess::read : ui::RdmAccess::off;
        request_.camera.width = 0; // nothing is drawn before the show is open
        send();
    }

    // An error is one that ends the command.
    Result<void> read_news() {
        if (const auto news = link_.not_opened.take()) return news->error;
        if (const auto news = link_.failed.take()) return *news;
        if (const auto news = link_.opened.take(); news && !news->is_edit) TRY_VOID(look_at(*news));
        if (const auto call = link_.camera_call.take()) look_from(call->camera);
        if (const auto news = link_.rig.take()) rig_ = *news;
        if (const auto call = link_.look_call.take()) recall(*call);
        if (const auto called = link_.cue_call.take()) follow(*called);
        return {};
    }

    // A fade that is on its way. False: none is.
    bool go_on() {
        if (follows_at_s_ && steady_now_s() >= *follows_at_s_) {
            follows_at_s_.reset();
            (void)link_.commands.put({0, "cue/go", {}});
            link_.wake.raise();
        }
        if (fade_s_ <= 0) return false;
        const double share = (steady_now_s() - fade_begin_s_) / fade_s_;
        if (share >= 1 || !show_) fade_s_ = 0;
        request_.look =
            fade_s_ > 0 ? ui::faded(from_, look_, *show_, rig_, static_cast<float>(share)) : look_;
        send();
        return fade_s_ > 0;
    }

private:
    Result<void> look_at(const ui::Opened& opened) {
        show_ = opened.show;
        look_ = request_.look = {};
        fade_s_ = 0;
        follows_at_s_.reset();
        Report report;
        auto looks = scene::load_looks(scene::looks_file(*show_), report);
        if (!looks.ok()) report.add(Severity::error, looks.error().where, looks.error().what);
        for (const Message& message : report.messages) log_warning(message.where + ": " + message.what);
        looks_ = std::make_shared<const std::vector<scene::StoredLook>>(
            looks.ok() ? std::move(*looks) : std::vector<scene::StoredLook>());
        publish_looks("");
        if (!arguments_.view.empty() || !opened.show->cameras.empty()) {
            TRY(const std::size_t camera, opened.show->find_camera(arguments_.view));
            look_from(opened.show->cameras[camera]);
        } else {
            look_from(opened.overview);
        }
        return {};
    }

    void look_from(const scene::Camera& camera) {
        request_.camera = camera;
        request_.frame = {camera.width, camera.height};
        request_.camera.width = arguments_.width;
        request_.camera.height = arguments_.height;
        send();
    }

    void recall(const ui::LookCall& call) {
        if (!show_) return;
        const Result<std::size_t> index = scene::find_look(*looks_, call.name);
        if (!index.ok()) return log_warning("remote control: " + index.error().text());
        const scene::StoredLook& stored = (*looks_)[*index];
        from_ = request_.look;
        look_.fixtures = scene::programmer_of(stored, *show_);
        look_.movers = scene::movers_of(stored, *show_);
        look_.scene = stored.scene;
        fade_s_ = call.seconds < 0 ? static_cast<double>(stored.fade_s) : call.seconds;
        fade_begin_s_ = steady_now_s();
        publish_looks(stored.name);
        if (fade_s_ > 0) return;
        request_.look = look_;
        send();
    }

    // Where a cue says seconds of "follow" the next one goes by itself.
    void follow(const std::string& called) {
        follows_at_s_.reset();
        if (!show_) return;
        const auto cue = std::ranges::find(show_->cues, called, &scene::Cue::name);
        if (cue != show_->cues.end() && cue->follow_s && cue + 1 != show_->cues.end())
            follows_at_s_ = steady_now_s() + static_cast<double>(*cue->follow_s);
    }

    void publish_looks(const std::string& current) {
        link_.looks.put({looks_, current});
        link_.on_news();
    }

    void send() {
        ++request_.number;
        link_.request.put(request_);
        link_.wake.raise();
    }

    ui::Link& link_;
    const ServeArguments& arguments_;
    ui::ViewRequest request_;
    std::shared_ptr<const scene::Show> show_; // null: none is open
    std::shared_ptr<const std::vector<scene::StoredLook>> looks_;
    ui::RigNow rig_;
    ui::Look look_, from_; // that is meant, and that it fades from
    double fade_s_ = 0, fade_begin_s_ = 0;
    std::optional<double> follows_at_s_; // when the next cue goes; none: by itself it does not
};

Result<void> run(const ServeArguments& arguments) {
    std::error_code code;
    if (!std::filesystem::exists(arguments.show, code))
        return Error{"no such file or folder", arguments.show};
    catch_interrupts();
    prepare_engine();
    ui::Link link;
    Signal news;
    TRY(const std::unique_ptr<web::Server> server, web::Server::open(link, arguments.server));
    link.on_news = [&] {
        news.raise();
        server->news();
    };
    print_addresses(*server);
    const Engine engine(link, arguments.engine);
    Onlooker onlooker(link, arguments);
    while (!interrupted()) {
        TRY_VOID(onlooker.read_news());
        (void)news.wait_for(onlooker.go_on() ? 33ms : 200ms);
    }
    return {};
}

} // namespace

void add_serve(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("serve", "a show drawn live for browsers, without a window");
    const auto a = std::make_shared<ServeArguments>();
    command->add_option("SHOW", a->show, "folder with show.toml, or an .mvr")->required();
    add_web_options(*command, a->web)->required();
    command->add_option("--view", a->view, "camera of the show; default: the first one")->type_name("NAME");
    command->add_option("--size", a->size, "WIDTHxHEIGHT of the picture")
        ->type_name("WxH")
        ->capture_default_str();
    command
        ->add_option("--fps", a->fps,
                     "pictures a second; the picture gets coarser while it moves, to hold it")
        ->check(CLI::Range(1, 60))
        ->capture_default_str();
    command->add_flag("--no-desk", a->no_desk, "do not listen to a desk");
    command
        ->add_option("--device", a->engine.session.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command->add_flag("--validation", a->engine.session.validation, "check our use of Vulkan");
    command->add_flag("--quiet", a->quiet, "print warnings and errors only");
    add_bounce_option(*command, a->engine.session.bounce);
    add_live_control_options(*command, a->engine.controls);
    command->add_flag("--rdm", a->rdm,
                      "answer RDM by Art-Net for every patched fixture, so that a desk finds, reads and "
                      "identifies them; nothing is changed");
    add_timecode_options(*command, a->engine.timecode, a->input.midi);
    add_input_options(*command, a->input);
    command->footer("Example: ghostlight serve assets/demo --web 8010\n"
                    "         ghostlight serve tour.mvr --web 0.0.0.0:8010 --view house");
    command->callback([a, &exit_code] {
        exit_code = checked_run(
            a->quiet, [&] { return check_usage(*a); }, [&] { return run(*a); });
    });
}

} // namespace ghost::app
