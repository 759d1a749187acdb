// SPDX-License-Identifier: Apache-2.0
// ghostlight monitor: who sends what, now. For the question "why is nothing moving?".
#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "cli/commands.h"
#include "cli/options/input_options.h"
#include "cli/options/live_options.h"
#include "cli/options/number_option.h"
#include "cli/private/monitor_report.h"
#include "diagnose/diagnosis_parts.h"
#include "diagnose/learn.h"
#include "live/inputs/joined_universes.h"
#include "live/inputs/rdm_desk.h"
#include "live/session/session.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

namespace ghost::app {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

struct MonitorOptions {
    InputOptions input;
    double seconds = 0.0;
    double every_s = 1.0;
    std::string show;
    bool rdm = false;
    bool learn = false;
    bool levels = false;
    bool json = false;
    bool quiet = false;
};

// Triggers and changes of the links since the last report.
void log_events(const dmx::Statistics& statistics, std::uint64_t& triggers, std::uint64_t& links) {
    for (const dmx::TriggerStatus& trigger : statistics.triggers)
        if (trigger.number > triggers)
            log_info("ArtTrigger " + dmx::trigger_text(trigger.trigger) + " from " +
                     dmx::address_text(trigger.from));
    for (const dmx::LinkChange& change : statistics.link_changes)
        if (change.number > links) log_info(change.text);
    if (!statistics.triggers.empty()) triggers = statistics.triggers.back().number;
    if (!statistics.link_changes.empty()) links = statistics.link_changes.back().number;
}

// One line for each slot that moved.
void print_moved(const std::vector<scene::Moved>& moved, const MonitorReport& report, bool json) {
    const int offset = report.statistics.listening.artnet_offset;
    for (const scene::Moved& one : moved) {
        const std::string text = scene::moved_text(one, report.patch, offset);
        if (!json) {
            print_text("%s\n", text.c_str());
            continue;
        }
        Json fixtures = Json::array();
        for (const scene::PatchedSlot* slot : report.patch.at(one.universe, one.address))
            fixtures.push_back({{"fixture", slot->fixture_name}, {"channel", slot->channel}});
        const Json line{{"moved", one.universe},
                        {"address", one.address},
                        {"protocol", dmx::protocol_name(one.protocol)},
                        {"from", one.from},
                        {"to", one.to},
                        {"source", one.source},
                        {"fixtures", fixtures},
                        {"text", text}};
        print_text("%s\n", line.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    }
}

class Learning {
public:
    void look(const MonitorReport& report, bool json) {
        const bool listened = learner_.listens_first();
        const std::vector<scene::Moved> moved = learner_.feed(report.statistics);
        if (listened && !learner_.listens_first()) log_info("now move one fader");
        if (learner_.too_many() > 0)
            log_warning(std::to_string(learner_.too_many()) +
                        " slots moved at once: that was no fader; move a single one");
        print_moved(moved, report, json);
    }

private:
    scene::Learner learner_;
};

// What a desk wants of the fixtures by RDM: said, for nothing is edited here.
void log_rdm(RdmDesk& desk, const scene::Show& show) {
    for (const RdmDesk::Wanted& one : desk.take())
        log_info("RDM: " + one_line(one.name) + ": " +
                 one_line(change_text(one.change, show.fixtures[one.fixture])));
}

Result<void> read_patch(const MonitorOptions& options, dmx::ReceiverOptions& input, MonitorReport& report,
                        std::optional<scene::Show>& opened) {
    if (options.show.empty()) return {};
    Report said;
    TRY(opened, open_show(options.show, false, options.quiet, said));
    const scene::Show& show = *opened;
    print_report(said);
    report.has_patch = true;
    report.patch = scene::PatchMap(show);
    input.universes = joined_universes(input.universes, report.patch);
    input.accept_others = input.listen_wider = true; // to say that it comes
    return {};
}

Result<void> monitor(const MonitorOptions& options, dmx::ReceiverOptions input) {
    MonitorReport report;
    std::optional<scene::Show> show;
    TRY_VOID(read_patch(options, input, report, show));
    std::optional<RdmDesk> rdm;
    warn_of_silent_rdm(show && options.rdm, options.input);
    if (show && options.rdm) {
        rdm.emplace(input.artnet_offset, ui::RdmAccess::read);
        rdm->update(*show);
        rdm->listen(input);
        log_info("RDM: " + std::to_string(rdm->devices()) + " fixtures answer");
    }
    input.slot_status = options.learn || show; // of whom all dimmers are at 0
    TRY(const auto receiver, dmx::Receiver::start(input));
    for (const std::string& warning : receiver->warnings()) log_warning(warning);
    if (options.learn) log_info("leave the faders alone for two seconds: what moves by itself is left out");
    std::unique_ptr<LtcInput> ltc;
    if (!options.input.ltc.empty())
        ltc = std::make_unique<LtcInput>(options.input.ltc, [](const auto&, auto) {});
    catch_interrupts();

    std::uint64_t triggers = 0, links = 0; // said so far
    Learning learning;
    const auto start = Clock::now();
    auto next = start;
    for (bool running = true; running;) {
        // A program that was stopped owes no reports.
        next = std::max(next, Clock::now()) +
               std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options.every_s));
        while (Clock::now() < next && running) {
            std::this_thread::sleep_for(20ms);
            const double run_s = std::chrono::duration<double>(Clock::now() - start).count();
            running = !interrupted() && (options.seconds <= 0.0 || run_s < options.seconds);
            if (auto newest = receiver->take_statistics()) {
                report.statistics = std::move(*newest);
                if (options.learn) learning.look(report, options.json);
            }
        }
        report.unix_s =
            std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
        if (auto newest = receiver->take()) report.universes = std::move(*newest);
        if (ltc) report.ltc = ltc->status();
        log_events(report.statistics, triggers, links);
        if (rdm) log_rdm(*rdm, *show);
        if (options.json && !options.learn)
            print_text("%s\n", monitor_json(report, options.levels).c_str());
        else if (!options.learn)
            print_monitor_table(report);
        std::fflush(stdout);
    }
    return {};
}

int run_monitor(const MonitorOptions& options) {
    if (options.quiet) set_log_level(LogLevel::error);
    const auto input = receiver_options(options.input);
    if (!input.ok()) {
        log_error(input.error().text());
        return 2;
    }
    const Result<void> done = monitor(options, *input);
    if (done.ok()) return 0;
    log_error(done.error().text());
    return 1;
}

} // namespace

void add_monitor(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<MonitorOptions>();
    CLI::App* command =
        app.add_subcommand("monitor", "who sends what, now: universes, sources, priorities, rates, loss");
    command->footer("Example: ghostlight monitor --interface eth0 --universes 1-4\n"
                    "         ghostlight monitor --show myshow --learn");
    add_input_options(*command, options->input);
    add_midi_option(*command, options->input.midi);
    add_ltc_option(*command, options->input.ltc);
    command->add_option("--seconds", options->seconds, "stop after this long; 0 and default: until Ctrl-C")
        ->check(number_in(0.0, kLongest_s));
    command->add_option("--every", options->every_s, "seconds between two reports")
        ->check(number_in(0.1, 3600.0))
        ->capture_default_str();
    command
        ->add_option(
            "--show", options->show,
            "folder with show.toml, or an .mvr: joins its universes, says what is patched and what is "
            "missing")
        ->type_name("SHOW");
    command
        ->add_flag(
            "--rdm", options->rdm,
            "answer RDM by Art-Net for every fixture of --show: a desk finds them, reads what they are and "
            "may "
            "identify them, which is said; nothing is changed")
        ->needs(command->get_option("--show"));
    command->add_flag("--learn", options->learn,
                      "move one fader: says which address of which source it is, and what --show has there");
    command->add_flag("--levels", options->levels, "with --json: all 512 levels of each universe");
    command->add_flag("--json", options->json, "one JSON object per line and report");
    command->add_flag("--quiet", options->quiet, "no warnings");
    command->callback([options, &exit_code] { exit_code = run_monitor(*options); });
}

} // namespace ghost::app
