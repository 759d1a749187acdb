// SPDX-License-Identifier: Apache-2.0
// ghostlight explain: why a fixture shines or does not, from the packet to what its beam hits. For the
// question "why is it dark?".
#include "base/interrupt.h"
#include "cli/commands.h"
#include "cli/options/bounce_option.h"
#include "cli/options/checked_run.h"
#include "cli/options/input_options.h"
#include "cli/options/number_option.h"
#include "diagnose/explain_print.h"
#include "dmx/record/recording_tasks.h"
#include "light/bodies.h"
#include "live/inputs/joined_universes.h"
#include "live/lux/light_meter.h"
#include "live/session/bounce_light.h"
#include "live/session/media_player.h"
#include "live/session/session.h"
#include "rays/tracer.h"

#include "base/log.h"
#include "base/print.h"
#include "base/suggest.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using scene::Reception;

constexpr double kSilence_s = 12;     // where something is missing: lists of who sends what come every 10 s
constexpr double kSettled_s = 1;      // until it is known who sends what came late
constexpr double kLongestLamp_s = 10; // for a lamp's channel that does not rest
constexpr double kSteps_hz = 30;      // as render steps, so that a strobe is where the picture has it

struct ExplainOptions {
    std::string show;
    std::string fixture;
    bool all = false;
    std::string replay;
    double at_s = -1;
    bool live_input = false;
    double for_s = 5;
    InputOptions input;
    std::optional<scene::BounceDetail> bounce; // instead of the show's
    bool json = false;
    bool quiet = false;
};

struct Moment {
    Reception reception;
    dmx::Universes universes;
    double now_s = 0;
};

double in_seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

// " (fixtures: 'a', 'b', ...)".
std::string listed(const std::string& kind, const std::vector<std::string>& names) {
    constexpr std::size_t kListed = 20;
    std::string text = " (" + kind + ":";
    for (std::size_t i = 0; i < names.size() && i < kListed; ++i) text += (i ? ", '" : " '") + names[i] + "'";
    return text + (names.size() > kListed ? ", ...)" : ")");
}

struct Wanted {
    std::size_t fixture = 0;
    int beam = -1; // all of them
};

// "Bar 3/Pixel 7": a beam by its name in the file, or "Bar 3/7" by its number, from 1.
Result<int> find_beam(const scene::PatchedFixture& fixture, const std::string& cell,
                      const std::string& file) {
    std::vector<std::string> names;
    if (fixture.type) {
        const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
        for (const int node : mode.beams) names.push_back(mode.nodes[static_cast<std::size_t>(node)].name);
    }
    const auto found = std::find(names.begin(), names.end(), cell);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    int number = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error == std::errc{} && end == cell.data() + cell.size() && number >= 1 &&
        number <= static_cast<int>(names.size()))
        return number - 1;
    if (names.empty()) return Error{"'" + fixture.name + "' has no cells: no beam is known of it", file};
    return Error{"'" + fixture.name + "' has no cell '" + cell + "'" + did_you_mean(cell, names) + ", nor " +
                     "is that a number of 1 to " + std::to_string(names.size()) + listed("cells", names),
                 file};
}

Result<Wanted> find_fixture(const scene::Show& show, const std::string& wanted) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        if (show.fixtures[i].name == wanted) return Wanted{i};
        names.push_back(show.fixtures[i].name);
    }
    // A name may hold a slash itself.
    for (std::size_t slash = wanted.rfind('/'); slash != std::string::npos && slash > 0;
         slash = wanted.rfind('/', slash - 1)) {
        const auto fixture = std::find(names.begin(), names.end(), wanted.substr(0, slash));
        if (fixture == names.end()) continue;
        const auto index = static_cast<std::size_t>(fixture - names.begin());
        TRY(const int beam, find_beam(show.fixtures[index], wanted.substr(slash + 1), show.file.string()));
        return Wanted{index, beam};
    }
    return Error{"has no fixture '" + wanted + "'" + did_you_mean(wanted, names) + listed("fixtures", names),
                 show.file.string()};
}

Result<Moment> run_recording(const fs::path& file, const ExplainOptions& options, scene::Rig& rig) {
    const double at_s = options.at_s;
    TRY(dmx::Recording recording, open_recording(file, capture_options(options.input), options.quiet));
    Moment moment;
    moment.reception.kind = Reception::Kind::recording;
    moment.reception.recording = file.string();
    for (const auto& [universe, time] : recording.first_frames())
        moment.reception.first_frames_s.emplace_back(universe, in_seconds(time));
    dmx::Player player(std::move(recording));
    char text[96];
    std::snprintf(text, sizeof text, "there is no second %g: the recording ends at %.2f s", at_s,
                  player.duration_s());
    if (at_s > player.duration_s()) return Error{text, file.string()};

    const long last = std::lround(std::max(at_s, 0.0) * kSteps_hz);
    for (long frame = 0; frame <= last; ++frame) {
        if (interrupted()) return Error{"interrupted", ""};
        moment.universes = player.at(static_cast<double>(frame) / kSteps_hz);
        rig.step(moment.universes, 1.0 / kSteps_hz);
    }
    log_damage(player);
    moment.now_s = static_cast<double>(last) / kSteps_hz;
    moment.reception.at_s = moment.now_s;
    moment.reception.end_s = player.duration_s();
    return moment;
}

bool all_arrive(const scene::PatchMap& patch, const dmx::Universes& universes) {
    return std::all_of(patch.universes().begin(), patch.universes().end(),
                       [&](const scene::PatchedUniverse& one) { return universes.find(one.universe); });
}

// A lamp that is told to go on or off does so when it was told for a while, as in the picture.
bool lamp_waits(const scene::Rig& rig) {
    return std::any_of(rig.states().begin(), rig.states().end(), [](const fixture::State& state) {
        const fixture::LampCommand told = state.lamp.command;
        return told != fixture::LampCommand::none && state.lamp.lit != (told == fixture::LampCommand::on);
    });
}

Result<Moment> listen(const ExplainOptions& options, const scene::PatchMap& patch, scene::Rig& rig) {
    TRY(dmx::ReceiverOptions receiver_wants, receiver_options(options.input));
    receiver_wants.slot_status = true;
    receiver_wants.universes = joined_universes(receiver_wants.universes, patch);
    receiver_wants.listen_wider = true;
    TRY(const auto receiver, dmx::Receiver::start(receiver_wants));
    for (const std::string& warning : receiver->warnings()) log_warning(warning);
    wait_for_sources(*receiver);
    char text[64];
    std::snprintf(text, sizeof text, "listening for %g s", options.for_s);
    log_info(text);

    Moment moment;
    dmx::Statistics statistics;
    const Clock::time_point start = Clock::now();
    Clock::time_point before = start;
    double silent_s = 0; // the last time that something was missing
    for (bool running = true; running;) {
        std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / kSteps_hz));
        const Clock::time_point now = Clock::now();
        if (auto newest = receiver->take()) moment.universes = std::move(*newest);
        if (auto newest = receiver->take_statistics()) statistics = std::move(*newest);
        rig.step(moment.universes, std::chrono::duration<double>(now - before).count());
        before = now;
        const double passed_s = std::chrono::duration<double>(now - start).count();
        if (!all_arrive(patch, moment.universes)) silent_s = passed_s;
        const double enough_s = silent_s >= passed_s ? kSilence_s : silent_s > 0 ? silent_s + kSettled_s : 0;
        const bool is_enough =
            passed_s >= std::max(options.for_s, enough_s) && (!lamp_waits(rig) || passed_s >= kLongestLamp_s);
        running = !interrupted() && !is_enough;
    }
    moment.now_s = in_seconds(before.time_since_epoch());
    moment.reception =
        scene::reception_of(statistics, patch, std::chrono::duration<double>(before - start).count());
    return moment;
}

Result<Moment> run_input(const ExplainOptions& options, const scene::Show& show, scene::Rig& rig) {
    if (options.live_input) return listen(options, scene::PatchMap(show), rig);
    if (!options.replay.empty()) return run_recording(options.replay, options, rig);
    std::error_code code;
    if (!show.recording.empty() && fs::exists(show.recording, code))
        return run_recording(show.recording, options, rig);
    Moment moment;
    if (!show.recording.empty())
        moment.reception.recording = "its recording " + show.recording.string() + " is missing";
    if (options.at_s >= 0)
        log_warning("--at says nothing: there is no recording; name one with --replay FILE");
    rig.step(moment.universes, 1.0 / kSteps_hz);
    return moment;
}

// Of the show's films.
double show_time_s(const Moment& moment) {
    return moment.reception.kind == Reception::Kind::desk ? moment.reception.listened_s
                                                          : moment.reception.at_s;
}

Result<void> run(const ExplainOptions& options) {
    catch_interrupts();
    Report report;
    TRY(scene::Show show, open_show(options.show, false, options.quiet, report));
    std::vector<Wanted> wanted;
    if (options.all) {
        for (std::size_t i = 0; i < show.fixtures.size(); ++i) wanted.push_back({i});
    } else {
        TRY(const Wanted found, find_fixture(show, options.fixture));
        wanted.push_back(found);
    }
    scene::Rig rig(show);
    TRY(const Moment moment, run_input(options, show, rig));
    scene::GoboStack gobos = scene::build_gobos(show, report);
    MediaPlayer player(show, gobos);
    player.show(show_time_s(moment), true, gobos, report);
    const bool has_stage = load_stage(show, report) && !show.stage.instances.empty();
    const scene::Stage stage = has_stage ? scene::stage_with_bodies(show, report) : scene::Stage{};
    print_report(report);

    TRY(const auto bounced, bounced_now(show, stage, options.bounce.value_or(show.bounce), rig, gobos,
                                        atmosphere_of(show).medium(), options.quiet));
    const bake::DenormalsOff mode;
    const bake::Tracer tracer(stage);
    const scene::ExplainInput input{
        .show = show,
        .report = report,
        .rig = rig,
        .gobos = gobos,
        .universes = moment.universes,
        .reception = moment.reception,
        .now_s = moment.now_s,
        .stage = has_stage ? &stage : nullptr,
        // Heads stop no light in the picture either.
        .first_hit =
            [&](const glm::vec3& origin, const glm::vec3& direction) {
                const bake::Surface hit = tracer.first_hit(origin, direction, -1.0f, bake::Sees::no_bodies);
                return scene::ExplainInput::Seen{hit.instance, hit.distance_m, hit.facet_normal};
            },
        .bounced_lx = bounced_lx_in(bounced.get()),
    };
    const scene::Explainer explainer(input);
    std::vector<scene::Explanation> explanations;
    for (const auto& [fixture, beam] : wanted) {
        if (interrupted()) return Error{"interrupted", ""};
        explanations.push_back(explainer.explain(fixture, beam));
    }
    std::string text;
    if (options.json) {
        text = options.all ? scene::json_of(explanations, moment.reception)
                           : scene::json_of(explanations.front(), moment.reception);
    } else if (options.all) {
        for (const scene::Explanation& explanation : explanations) text += scene::line_of(explanation) + "\n";
        text += scene::summary_of(explanations) + "\n";
    } else {
        text = scene::words_of(explanations.front(), moment.reception);
    }
    print_text("%s", text.c_str());
    return {};
}

// What the command line asks for, checked before anything is opened.
Result<void> check_usage(const ExplainOptions& options) {
    if (options.all == !options.fixture.empty())
        return Error{options.all ? "one fixture or all of them, not both" : "which one? Its name, or --all",
                     "FIXTURE"};
    if (options.live_input) TRY_VOID(receiver_options(options.input));
    return {};
}

} // namespace

void add_explain(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<ExplainOptions>();
    CLI::App* command = app.add_subcommand(
        "explain", "why a fixture is dark, or where its light goes: from packet to optics");
    command->footer("Example: ghostlight explain assets/demo \"Spot 3\" --at 36\n"
                    "         ghostlight explain assets/demo --all --live-input --for 5");
    command->add_option("SHOW", options->show, "folder with show.toml, or an .mvr")->required();
    command->add_option("FIXTURE", options->fixture,
                        "its name in the show, or of one cell: \"Bar 3/Pixel 7\", \"Bar 3/7\"");
    command->add_flag("--all", options->all, "one line for every fixture, and a summary");
    CLI::Option* replay =
        command->add_option("--replay", options->replay, "DMX recording (default: the show's own)")
            ->type_name("FILE");
    CLI::Option* at = command->add_option("--at", options->at_s, "second of the recording; default 0")
                          ->check(number_in(0.0, 86400.0));
    CLI::Option* live = command
                            ->add_flag("--live-input", options->live_input,
                                       "listen to what a desk sends now, by sACN or Art-Net")
                            ->excludes(replay)
                            ->excludes(at);
    command
        ->add_option("--for", options->for_s,
                     "seconds to listen for --live-input; where a patched universe is silent at least 12")
        ->check(number_in(0.1, 3600.0))
        ->needs(live)
        ->capture_default_str();
    add_bounce_option(*command, options->bounce);
    command->add_flag("--json", options->json, "all facts as one JSON object");
    command->add_flag("--quiet", options->quiet, "print warnings and errors only, beside the answer");
    add_input_options(*command, options->input);
    command->callback([options, &exit_code] {
        exit_code = checked_run(
            options->quiet, [&] { return check_usage(*options); }, [&] { return run(*options); });
    });
}

} // namespace ghost::app
