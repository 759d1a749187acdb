// SPDX-License-Identifier: Apache-2.0
#include "cli/options/live_options.h"

#include "base/log.h"
#include "cli/options/number_option.h"

#include <algorithm>
#include <iterator>

namespace ghost::app {
namespace {

constexpr double kLongestFreewheel_s = 3600;

} // namespace

CLI::Option* add_timecode_options(CLI::App& command, TimeCodeOptions& options, std::string& midi) {
    CLI::Option* const timecode =
        command
            .add_option("--timecode", options.begin,
                        "the recording follows the time code of the network (Art-Net), of --midi or of "
                        "--ltc, and begins at this one, like 10:00:00:00 or 0")
            ->type_name("TIME");
    CLI::Option* const port = add_midi_option(command, midi)->needs(timecode);
    add_ltc_option(command, options.ltc)->needs(timecode)->excludes(port);
    command
        .add_option("--freewheel", options.freewheel_s,
                    "where no time code comes any more the recording goes on for so many seconds, then it "
                    "stands")
        ->check(number_in(0.0, kLongestFreewheel_s))
        ->needs(timecode)
        ->capture_default_str();
    return timecode;
}

CLI::Option* add_ltc_option(CLI::App& command, std::string& name) {
    return command
        .add_option("--ltc", name,
                    "time code that is a sound (LTC), instead of Art-Net's: an input of ALSA like default or "
                    "hw:1,0 (arecord -L lists them), or a sound file, which plays once")
        ->type_name("INPUT|FILE");
}

void warn_of_silent_rdm(bool answers_rdm, const InputOptions& input) {
    if (answers_rdm && input.no_poll_reply)
        log_warning(
            "--rdm with --no-poll-reply: a desk that looks for nodes by ArtPoll does not find this one, "
            "and asks it nothing by RDM");
}

void add_rdm_option(CLI::App& command, ui::RdmAccess& access) {
    command
        .add_option_function<std::string>(
            "--rdm",
            [&access](const std::string& word) {
                const auto found = std::find(std::begin(ui::kRdmAccess), std::end(ui::kRdmAccess), word);
                access = static_cast<ui::RdmAccess>(found - std::begin(ui::kRdmAccess));
            },
            "answer RDM by Art-Net for every patched fixture, so that a desk finds, reads and identifies "
            "them; edit: it may also set address, mode and name, which can be undone")
        ->check(CLI::IsMember({"off", "read", "edit"}))
        ->default_str("off");
}

void add_live_control_options(CLI::App& command, LiveControlOptions& options) {
    command
        .add_option(
            "--osc", options.osc,
            "listen to a remote control (OSC) at this UDP port of 127.0.0.1, or at an address of ours like "
            "0.0.0.0:9000")
        ->type_name("[ADDRESS:]PORT");
    command.add_flag(
        "--psn", options.psn,
        "follow trackers (PosiStageNet, 236.10.10.10:56565) as the show's [[tracker]] entries say");
}

void add_farm_options(CLI::App& command, FarmOptions& options) {
    CLI::Option* const farm = command
                                  .add_option("--farm", options.engine,
                                              "cut into tasks: slurm, or local: processes of this machine")
                                  ->check(CLI::IsMember({"local", "slurm"}));
    command
        .add_option("--farm-options", options.options, "words for Slurm: \"--partition=gpu --gres=gpu:1\"")
        ->type_name("WORDS")
        ->needs(farm);
    command.add_option("--farm-jobs", options.jobs, "tasks at the same time, with --farm local")
        ->check(CLI::Range(1, 1024))
        ->needs(farm)
        ->capture_default_str();
}

} // namespace ghost::app
