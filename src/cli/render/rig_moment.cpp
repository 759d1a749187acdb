// SPDX-License-Identifier: Apache-2.0
#include "cli/render/rig_moment.h"

#include "book/book_plan.h"
#include "dmx/record/player.h"
#include "dmx/record/recording_tasks.h"
#include "live/session/settle.h"
#include "show/looks.h"
#include "show/show.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace ghost::app {
namespace {

Result<scene::PlannedEntry> cue_of(const scene::Show& show, const std::vector<scene::StoredLook>& looks,
                                   const std::string& name, const scene::PrintStyle& style) {
    TRY(const scene::BookPlan plan, scene::plan_book(show, looks, scene::BookKind::cues, {}, style));
    const auto found =
        std::find_if(plan.entries.begin(), plan.entries.end(),
                     [&](const scene::PlannedEntry& planned) { return planned.entry.name == name; });
    if (found == plan.entries.end())
        return Error{"has no cue '" + name + "'; the first one is '" + plan.entries.front().entry.name + "'",
                     show.file.string()};
    return *found;
}

struct Recorded {
    dmx::Universes levels;
    bool is_behind = false; // the recording ends before it
};

Result<Recorded> recorded_at(const scene::Show& show, double at_s, bool quiet) {
    TRY(dmx::Recording recording, dmx::open_recording(show.recording, {}, quiet));
    dmx::Player player(std::move(recording));
    const bool is_behind = at_s > player.duration_s();
    return Recorded{dmx::Universes(player.at(at_s)), is_behind};
}

} // namespace

Result<RigMoment> moment_of(const scene::Show& show, const RigMomentOptions& options,
                            const scene::PrintStyle& style, Report& report) {
    RigMoment moment{{}, scene::MoverMotion(show.movers), {}};
    moment.said = style("As they are when nothing is sent.");
    TRY(const std::vector<scene::StoredLook> looks, scene::load_looks(scene::looks_file(show), report));
    std::optional<std::size_t> look;
    Recorded recorded;
    std::optional<double> at_s = options.at_s;
    if (!options.cue.empty()) {
        TRY(const scene::PlannedEntry planned, cue_of(show, looks, options.cue, style));
        look = planned.look;
        moment.said = style("As in cue '%1'.", {options.cue});
        if (!at_s) at_s = planned.entry.at_s;
        if (planned.entry.at_s && !show.recording.empty()) {
            TRY(recorded, recorded_at(show, *planned.entry.at_s, options.quiet));
        }
        for (const std::string& sentence : planned.entry.unknown) moment.said += " " + sentence + ".";
    } else if (!options.look.empty()) {
        TRY(look, scene::find_look(looks, options.look));
        moment.said = style("As in look '%1'.", {options.look});
    }
    if (options.at_s) {
        if (show.recording.empty()) return Error{"has no recording for --at", show.file.string()};
        TRY(recorded, recorded_at(show, *options.at_s, options.quiet));
        moment.said = style("As the recording has it at %1 s.", {style.number(*options.at_s, 2)});
    }
    if (recorded.is_behind) {
        moment.said.pop_back(); // its full stop
        moment.said += "; " + style("the recording ends before it: this is its last look") + ".";
    }
    scene::Rig rig(show);
    if (look) rig.movers().drive(scene::movers_of(looks[*look], show));
    rig.set_time(at_s);
    settle(rig, recorded.levels,
           look ? scene::programmer_of(looks[*look], show) : std::map<std::size_t, fixture::Programmer>{});
    moment.states = rig.states();
    moment.movers = rig.movers();
    return moment;
}

} // namespace ghost::app
