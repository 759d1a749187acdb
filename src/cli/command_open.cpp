// SPDX-License-Identifier: Apache-2.0
// ghostlight open: the window. A show, live, from anywhere.
#include "base/interrupt.h"
#include "cli/commands.h"
#include "cli/doctor/doctor_files.h"
#include "cli/options/bounce_option.h"
#include "cli/options/checked_run.h"
#include "cli/options/input_options.h"
#include "cli/options/live_options.h"
#include "cli/options/size_option.h"
#include "cli/options/web_options.h"
#include "live/engine/engine.h"
#include "ui/language/language_choice.h"
#include "ui/window/open_window.h"
#include "web/browsers.h"

#include "base/log.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

struct OpenArguments {
    ui::WindowOptions window;
    EngineOptions engine;
    InputOptions input;
    XchangeOptions xchange;
    WebOptions web;
    std::optional<web::ServerOptions> server; // of browsers; none: nothing listens
    std::string save;
    std::string size;
    std::string sound = "default";
    bool no_desk = false;
    bool forget = false;
    bool quiet = false;
};

Result<void> check_usage(OpenArguments& arguments) {
    arguments.input.ltc = arguments.engine.timecode.ltc;
    TRY(arguments.engine.receiver, receiver_options(arguments.input));
    arguments.engine.receiver.listen_wider = true;
    arguments.engine.receiver.slot_status = true; // for the panel that explains
    arguments.engine.listens = arguments.window.takes_desk = !arguments.no_desk;
    arguments.engine.session.quiet = arguments.quiet;
    if (arguments.sound != "off") arguments.engine.sound = arguments.sound;
    warn_of_silent_rdm(arguments.window.rdm != ui::RdmAccess::off, arguments.input);
    if (arguments.no_desk && arguments.window.rdm != ui::RdmAccess::off)
        return Error{"RDM comes by the network, too", "--no-desk/--rdm"};
    TRY_VOID(check_live_controls(arguments.engine.controls));
    TRY_VOID(open_timecode(arguments.engine.timecode));
    if (!arguments.engine.timecode.begin.empty() && arguments.engine.timecode.ltc.empty() &&
        arguments.no_desk)
        return Error{"the time code comes by the network, too", "--no-desk/--timecode"};
    if (!arguments.save.empty()) {
        arguments.xchange.save = arguments.save;
        arguments.xchange.interface = arguments.input.interface;
        arguments.engine.xchange = arguments.xchange;
    }
    if (!arguments.web.web.empty()) {
        TRY(arguments.server, server_options(arguments.web));
    }
    arguments.window.remembers = !arguments.forget;
    if (arguments.size.empty()) return {};
    TRY(const glm::ivec2 size, size_from(arguments.size, {320, 200}, 16384));
    arguments.window.width = size.x;
    arguments.window.height = size.y;
    return {};
}

Result<void> run(OpenArguments& arguments) {
    // A typing mistake is said at once, not in a window.
    std::error_code code;
    if (const std::string& show = arguments.window.show;
        !show.empty() && !std::filesystem::exists(show, code))
        return Error{"no such file or folder", show};
    catch_interrupts();
    prepare_engine();
    ui::Link link;
    web::Browsers browsers(link);
    arguments.window.browsers = &browsers;
    if (arguments.server) {
        TRY_VOID(browsers.open(*arguments.server));
        print_addresses(*browsers.server());
    }
    arguments.window.begin = [&] {
        link.on_news = [&browsers, window = link.on_news] {
            window();
            browsers.news();
        };
        return std::make_shared<Engine>(link, arguments.engine);
    };
    arguments.window.should_close = interrupted;
    arguments.window.demo = own_folder("demo").string();
    arguments.window.fixtures = own_folder("fixtures").string();
    arguments.window.docs = own_folder("../docs/guide").string();
    return ui::open_window(link, arguments.window);
}

} // namespace

void add_open(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("open", "the window: a show, live, with everything at hand");
    const auto a = std::make_shared<OpenArguments>();
    command->add_option("SHOW", a->window.show,
                        "folder with show.toml, or an .mvr; without one, drop it on the window");
    command->add_option("--size", a->size, "WIDTHxHEIGHT of the window")->type_name("WxH");
    command->add_flag("--full-screen", a->window.full_screen, "begin with the picture alone");
    command->add_option("--script", a->window.script, "do these lines of actions (docs/guide/window.md)")
        ->type_name("FILE");
    command->add_option("--socket", a->window.socket, "take lines of actions from this local socket")
        ->type_name("NAME");
    std::vector<std::string> languages;
    for (const ui::LanguageChoice& one : ui::kLanguages) languages.emplace_back(one.code);
    command
        ->add_option(
            "--language", a->window.language,
            "of the window, this time; without it the one that was chosen there (View, Language), else "
            "the desktop's")
        ->check(CLI::IsMember(languages));
    command->add_flag("--forget", a->forget,
                      "neither take over the layout of the last time nor keep this one");
    command->add_flag("--no-desk", a->no_desk, "do not listen to a desk");
    command
        ->add_option("--device", a->engine.session.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command
        ->add_option_function<std::string>(
            "--present",
            [a](const std::string& who) {
                a->engine.present.shower = who == "device"   ? ui::Shower::device
                                           : who == "window" ? ui::Shower::window
                                                             : ui::Shower::measured;
            },
            "who shows the picture: the graphics device itself, the window, which reads it back and paints "
            "it, or whoever is measured to be faster at start")
        ->check(CLI::IsMember({"measured", "device", "window"}))
        ->type_name("WHO")
        ->default_str("window");
    command->add_flag("--hdr", a->engine.present.hdr,
                      "where the graphics device shows the picture and the display has HDR10 or scRGB: with "
                      "its highlights");
    command->add_flag("--validation", a->engine.session.validation, "check our use of Vulkan");
    command
        ->add_option("--shaders", a->engine.session.shaders,
                     "for whoever writes shaders: take them from this folder (generated/shaders of a build), "
                     "and anew when one is written")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory);
    command->add_flag("--quiet", a->quiet, "print warnings and errors only");
    CLI::Option* const save = command
                                  ->add_option("--xchange", a->save,
                                               "take part in MVR-xchange: plots that others commit come to "
                                               "this folder, and the window offers them")
                                  ->type_name("FOLDER");
    command->add_option("--group", a->xchange.group, "of MVR-xchange")->needs(save)->capture_default_str();
    command->add_option("--peer", a->xchange.peers, "a station that mDNS does not reach, like 10.0.0.5:4568")
        ->type_name("ADDRESS:PORT")
        ->allow_extra_args(false)
        ->needs(save);
    command
        ->add_flag("--take-plots", a->engine.takes_plots,
                   "merge them into the show as they come, without asking")
        ->needs(save);
    add_web_options(*command, a->web);
    add_bounce_option(*command, a->engine.session.bounce);
    add_live_control_options(*command, a->engine.controls);
    add_rdm_option(*command, a->window.rdm);
    add_timecode_options(*command, a->engine.timecode, a->input.midi);
    command
        ->add_option("--sound", a->sound,
                     "where the show's sound is heard: an output of ALSA like default or hw:1,0 (aplay -L "
                     "lists them), or off")
        ->type_name("OUTPUT")
        ->capture_default_str();
    add_input_options(*command, a->input);
    command->footer("Example: ghostlight open assets/demo\n"
                    "         ghostlight open tour.mvr --full-screen");
    command->callback([a, &exit_code] {
        exit_code = checked_run(
            a->quiet, [&] { return check_usage(*a); }, [&] { return run(*a); });
    });
}

} // namespace ghost::app
