// SPDX-License-Identifier: Apache-2.0
// ghostlight xchange: a station of MVR-xchange: saves the plots that others commit, gives out ours, brings a
// show up to date.
#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "cli/commands.h"
#include "cli/options/interface_option.h"
#include "cli/options/number_option.h"
#include "live/session/session.h"
#include "plots/import_plot.h"
#include "show_folder/load_show.h"
#include "xchange/xchange.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <thread>

namespace ghost::app {

namespace {

using nlohmann::ordered_json;
using namespace std::chrono_literals;

struct XchangeArguments {
    XchangeOptions station;
    std::string save;
    std::vector<std::string> share;
    std::string show;
    double seconds = 0;
    int files = 0;
    bool json = false;
    bool quiet = false;
};

void print_event(const ordered_json& line) {
    print_text("%s\n", line.dump(-1, ' ', false, ordered_json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

// The plot takes the place of the show's older version. True: it did.
bool take_over(const XchangeEvent& event, const XchangeArguments& arguments) {
    Report report;
    const auto opened = scene::load_show(event.file, true, report, {{}, interrupted});
    const auto imported = opened.ok() ? scene::import_plot(*opened, arguments.show, report)
                                      : Result<scene::ImportedPlot>(opened.error());
    print_report(report);
    if (!imported.ok()) {
        log_error(imported.error().text());
        return false;
    }
    const std::string merged = imported->merge ? scene::text_of(*imported->merge) : std::string();
    if (arguments.json)
        print_event({{"event", "merged"}, {"show", imported->show_file.string()}, {"text", merged}});
    else
        print_text("%s%s: %zu objects, %zu fixtures\n", merged.c_str(),
                   one_line(imported->show_file.string()).c_str(), imported->objects, imported->fixtures);
    std::fflush(stdout);
    return true;
}

// What happened, to say why --files was not met.
struct Tally {
    int found = 0, joined = 0, offered = 0, received = 0;

    void add(XchangeEvent::Kind kind) {
        found += kind == XchangeEvent::Kind::found;
        joined += kind == XchangeEvent::Kind::joined;
        offered += kind == XchangeEvent::Kind::offered;
        received += kind == XchangeEvent::Kind::received;
    }
};

std::string why_not(const Tally& tally, const XchangeArguments& arguments) {
    const std::string group = "'" + arguments.station.group + "'";
    const auto count = [](int number, const char* word) {
        return std::to_string(number) + " " + word + (number == 1 ? "" : "s");
    };
    if (tally.offered > 0) return count(tally.offered, "plot") + " offered; what kept them away stands above";
    if (tally.joined > 0)
        return count(tally.joined, "station") + " in group " + group + ", which offered none";
    if (tally.found > 0) return count(tally.found, "station") + " found, and none could be joined";
    if (!arguments.station.finds) return "no --peer could be joined";
    return "no station of group " + group +
           " was found; is one running, and is no firewall on UDP 5353 in the way?";
}

int run(XchangeArguments& arguments) {
    if (arguments.quiet) set_log_level(LogLevel::warning);
    arguments.station.save = arguments.save;
    arguments.station.share.assign(arguments.share.begin(), arguments.share.end());
    auto xchange = Xchange::start(arguments.station);
    if (!xchange.ok()) {
        log_error(xchange.error().text());
        return 1;
    }
    catch_interrupts();
    log_info("MVR-xchange, group '" + arguments.station.group + "', TCP port " +
             std::to_string((*xchange)->port()) + "; Ctrl-C ends it");
    const auto start = std::chrono::steady_clock::now();
    Tally tally;
    bool good = true;
    const auto over = [&] {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        return (arguments.seconds > 0 && passed.count() >= arguments.seconds) ||
               (arguments.files > 0 && tally.received >= arguments.files);
    };
    while (!interrupted() && !over()) {
        for (const XchangeEvent& event : (*xchange)->take()) {
            const bool file = event.kind == XchangeEvent::Kind::received;
            tally.add(event.kind);
            if (arguments.json) {
                ordered_json line{
                    {"event", name_of(event.kind)}, {"station", event.station}, {"text", event.text}};
                if (file) line["file"] = event.file.string();
                if (file) line["comment"] = event.comment;
                print_event(line);
            } else if (!arguments.quiet || file || event.kind == XchangeEvent::Kind::trouble) {
                print_text("%-9s %s%s%s\n", name_of(event.kind), one_line(event.station).c_str(),
                           event.station.empty() ? "" : ": ", one_line(event.text).c_str());
                std::fflush(stdout);
            }
            if (file && !arguments.show.empty()) good = take_over(event, arguments) && good;
        }
        std::this_thread::sleep_for(20ms);
    }
    if (tally.received < arguments.files)
        log_error(std::to_string(tally.received) + " of " + std::to_string(arguments.files) +
                  " plots came: " + why_not(tally, arguments));
    return good && tally.received >= arguments.files ? 0 : 1;
}

} // namespace

void add_xchange(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "xchange", "MVR-xchange: plots from Vectorworks, grandMA3, BlenderDMX over the network, and to them");
    const auto a = std::make_shared<XchangeArguments>();
    command->add_option("--group", a->station.group, "of stations that belong together")
        ->capture_default_str();
    CLI::Option* const save =
        command->add_option("--save", a->save, "folder for what they commit; without it stations are listed")
            ->type_name("FOLDER");
    command->add_option("--share", a->share, ".mvr that others may have; may be given more than once")
        ->type_name("FILE")
        ->check(CLI::ExistingFile)
        ->allow_extra_args(false);
    command
        ->add_option("--show", a->show,
                     "folder of a show that is brought up to date with every plot, as import does; made if "
                     "it is not there")
        ->type_name("FOLDER")
        ->needs(save);
    command->add_option("--station", a->station.station,
                        "our name (default: Ghostlight on this machine's name)");
    add_interface_option(*command, a->station.interface);
    command
        ->add_option("--peer", a->station.peers,
                     "a station that mDNS does not reach, like 10.0.0.5:4568; may be given more than once")
        ->type_name("ADDRESS:PORT")
        ->allow_extra_args(false);
    command->add_option("--port", a->station.port, "TCP port of ours; 0: one that is free")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command->add_flag("!--no-find", a->station.finds, "neither look for stations nor be found; with --peer");
    command->add_option("--files", a->files, "end after so many plots; exit code 1 if they do not come")
        ->check(CLI::Range(0, 1000000))
        ->needs(save);
    command->add_option("--seconds", a->seconds, "end after this time; default: at Ctrl-C")
        ->check(number_in(0.0, kLongest_s));
    command->add_flag("--json", a->json, "one JSON object a line");
    command->add_flag("--quiet", a->quiet, "received plots, warnings and errors only");
    command->footer("Example: ghostlight xchange --group Default --save plots --show tour\n"
                    "         ghostlight xchange --share tour.mvr");
    command->callback([a, &exit_code] { exit_code = run(*a); });
}

} // namespace ghost::app
