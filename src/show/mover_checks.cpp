// SPDX-License-Identifier: Apache-2.0
// What a show has for its movers: parents, channels of fixtures, and what is carried.
#include "show/movers.h"

#include "base/suggest.h"
#include "base/text.h"
#include "show/show.h"

#include <algorithm>

namespace ghost::scene {
namespace {

std::string called(const Mover& mover) {
    return "[[mover]] '" + mover.name.substr(0, 60) + "'";
}

void find_parents(std::vector<Mover>& movers, Report& report) {
    std::vector<std::string> names;
    for (const Mover& mover : movers) names.push_back(mover.name);
    for (Mover& mover : movers) {
        mover.parent = kNoMover;
        if (mover.parent_name.empty()) continue;
        const auto found = std::find(names.begin(), names.end(), mover.parent_name);
        if (found == names.end())
            report.add(Severity::error, mover.where,
                       called(mover) + " hangs on '" + mover.parent_name.substr(0, 60) +
                           "', which is no mover of the show" + did_you_mean(mover.parent_name, names));
        else
            mover.parent = static_cast<int>(found - names.begin());
    }
    for (std::size_t k = 0; k < movers.size(); ++k) {
        std::string loop = "'" + movers[k].name.substr(0, 60) + "'";
        int at = movers[k].parent;
        for (std::size_t steps = 0; at != kNoMover && at != static_cast<int>(k) && steps < movers.size();
             ++steps) {
            loop += " on '" + movers[static_cast<std::size_t>(at)].name.substr(0, 60) + "'";
            at = movers[static_cast<std::size_t>(at)].parent;
        }
        if (at != static_cast<int>(k)) continue;
        report.add(Severity::error, movers[k].where,
                   called(movers[k]) + " drives itself: " + loop + " on itself; it hangs on nothing");
        movers[k].parent = kNoMover;
    }
}

// The channel of a fixture, as its file has it.
void find_channel(const Show& show, const Mover& mover, MoverAxis& axis, Report& report) {
    if (axis.fixture.empty() || axis.attribute.empty()) return;
    const auto say = [&](const std::string& what) {
        report.add(Severity::error, axis.where,
                   called(mover) + " axis '" + axis.name + "' " + what + "; no channel drives it");
    };
    std::vector<std::string> names;
    for (const PatchedFixture& fixture : show.fixtures) names.push_back(fixture.name);
    const auto found = std::find(names.begin(), names.end(), axis.fixture);
    if (found == names.end())
        return say("names fixture '" + axis.fixture.substr(0, 60) + "', which the show does not have" +
                   did_you_mean(axis.fixture, names));
    const PatchedFixture& fixture = show.fixtures[static_cast<std::size_t>(found - names.begin())];
    if (!fixture.type) return say("is driven by '" + axis.fixture + "', whose file cannot be read");
    const fixture::Patch patch = fixture.patch();
    std::vector<std::string> known;
    for (const fixture::Channel& channel : patch.mode_of().channels) {
        for (const fixture::ChannelFunction& function : channel.functions) {
            known.push_back(function.attribute);
            if (function.attribute != axis.attribute) continue;
            const auto at = static_cast<std::size_t>(std::max(channel.dmx_break, 1) - 1);
            if (channel.offsets.empty() || at >= patch.addresses.size() || patch.addresses[at].channel == 0)
                return say("is driven by '" + axis.attribute + "' of '" + axis.fixture +
                           "', which is not patched");
            for (const int offset : channel.offsets)
                axis.levels.push_back({patch.addresses[at].universe, patch.addresses[at].channel + offset});
            if (axis.from == axis.to) {
                axis.from = function.physical_from;
                axis.to = function.physical_to;
                if (axis.low == axis.high) {
                    axis.low = std::min(axis.from, axis.to);
                    axis.high = std::max(axis.from, axis.to);
                }
            }
            return;
        }
    }
    say("names attribute '" + axis.attribute.substr(0, 60) + "', which '" + axis.fixture + "' does not have" +
        did_you_mean(axis.attribute, known));
}

// Loads of one kind, each carried by the first that names it.
template <class Thing>
void load(std::vector<Thing>& things, const std::vector<Mover>& movers, const char* kind,
          const std::vector<std::string> Mover::*patterns, Report& report) {
    std::vector<std::string> names;
    for (Thing& thing : things) {
        names.push_back(thing.name);
        thing.mover = kNoMover;
    }
    Suggestions suggestions;
    for (std::size_t m = 0; m < movers.size(); ++m)
        for (const std::string& pattern : movers[m].*patterns) {
            bool found = false;
            for (Thing& thing : things) {
                if (!matches(pattern, thing.name)) continue;
                found = true;
                if (thing.mover == kNoMover) {
                    thing.mover = static_cast<int>(m);
                } else if (thing.mover != static_cast<int>(m)) {
                    report.add(Severity::error, movers[m].where,
                               called(movers[m]) + " carries " + kind + " '" + thing.name + "', which '" +
                                   movers[static_cast<std::size_t>(thing.mover)].name +
                                   "' carries already; it goes with that one");
                }
            }
            if (!found)
                report.add(Severity::error, movers[m].where,
                           called(movers[m]) + " carries " + kind + " '" + pattern.substr(0, 60) +
                               "', which the show does not have" + suggestions.did_you_mean(pattern, names));
        }
}

std::vector<std::string> names_of(const Stage& stage, const Instance& instance) {
    if (instance.mesh < 0 || instance.mesh >= static_cast<int>(stage.meshes.size())) return {instance.name};
    return {instance.name, stage.meshes[static_cast<std::size_t>(instance.mesh)].name};
}

} // namespace

void check_movers(Show& show, Report& report) {
    find_parents(show.movers, report);
    for (Mover& mover : show.movers) {
        for (MoverAxis& axis : mover.axes) find_channel(show, mover, axis, report);
        const bool carries_mover =
            std::any_of(show.movers.begin(), show.movers.end(),
                        [&](const Mover& other) { return other.parent_name == mover.name; });
        if (mover.carries_nothing() && !carries_mover)
            report.add(Severity::error, mover.where,
                       called(mover) + (mover.kind == MoverKind::hoists ? " has no truss" : " has no load") +
                           ", expected fixtures, objects or cameras = a list of names");
    }
    load(show.fixtures, show.movers, "fixture", &Mover::fixtures, report);
    load(show.cameras, show.movers, "camera", &Mover::cameras, report);
}

std::vector<int> movers_of_instances(const Show& show, const Stage& stage) {
    std::vector<int> result(stage.instances.size(), kNoMover);
    std::vector<std::pair<std::string, int>> walls; // their panels are objects of the stage
    for (const PatchedFixture& fixture : show.fixtures)
        if (fixture.wall && fixture.mover != kNoMover) walls.emplace_back(fixture.name, fixture.mover);
    for (std::size_t k = 0; k < result.size(); ++k) {
        const Instance& instance = stage.instances[k];
        if (instance.fixture != kNone) {
            result[k] = show.fixtures[static_cast<std::size_t>(instance.fixture)].mover;
            continue;
        }
        for (const auto& [name, mover] : walls)
            if (instance.name == name) result[k] = mover;
    }
    // As [[object]] does: the name of the object, else that of its mesh.
    for (std::size_t m = 0; m < show.movers.size(); ++m)
        for (const std::string& pattern : show.movers[m].objects)
            for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
                bool found = false;
                for (std::size_t k = 0; k < result.size(); ++k) {
                    if (stage.instances[k].fixture != kNone) continue;
                    const std::vector<std::string> names = names_of(stage, stage.instances[k]);
                    if (which >= names.size() || !matches(pattern, names[which])) continue;
                    found = true;
                    if (result[k] == kNoMover) result[k] = static_cast<int>(m);
                }
                if (found) break;
            }
    return result;
}

void check_moved_objects(const Show& show, const Stage& stage, Report& report) {
    if (stage.instances.empty()) return; // said already
    std::vector<std::string> known;
    for (const Instance& instance : stage.instances) known.push_back(instance.name);
    Suggestions suggestions;
    for (const Mover& mover : show.movers)
        for (const std::string& pattern : mover.objects) {
            const auto has_name = [&](const Instance& instance) {
                const std::vector<std::string> names = names_of(stage, instance);
                return std::any_of(names.begin(), names.end(),
                                   [&](const std::string& name) { return matches(pattern, name); });
            };
            if (std::none_of(stage.instances.begin(), stage.instances.end(), has_name))
                report.add(Severity::error, mover.where,
                           called(mover) + " carries object '" + pattern.substr(0, 60) +
                               "', which the stage does not have" + suggestions.did_you_mean(pattern, known));
        }
}

} // namespace ghost::scene
