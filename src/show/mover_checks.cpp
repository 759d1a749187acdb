// SPDX-License-Identifier: Apache-2.0
// What a show has for its movers: parents, channels of fixtures, and what is carried.
#include "show/movers.h"

#include "base/name_index.h"
#include "base/suggest.h"
#include "dmx/wire/universes.h"
#include "show/show.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostSaidOfNames = 200;
constexpr int kChannels = static_cast<int>(dmx::kSlots); // of a universe

std::string short_name(const std::string& name) {
    return "'" + name.substr(0, 60) + "'";
}

std::string called(const Mover& mover) {
    return "[[mover]] " + short_name(mover.name);
}

// What is wrong with the names of one check; beyond kMostSaidOfNames it is counted.
class Sentences {
public:
    explicit Sentences(Report& report) : report_(report) {}

    void add(const std::string& where, const std::string& what) {
        where_ = where;
        if (++count_ <= kMostSaidOfNames) report_.add(Severity::error, where, what);
    }
    // then: after what is suggested.
    void add_unknown(const std::string& where, const std::string& what, const std::string& name,
                     std::span<const std::string> known, const std::string& then = "") {
        const bool is_said = count_ < kMostSaidOfNames;
        add(where, is_said ? what + suggestions_.did_you_mean(name, known) + then : "");
    }
    void add_taken(const Mover& mover, const char* kind, const std::string& name, const Mover& first) {
        add(mover.where, called(mover) + " carries " + kind + " " + short_name(name) + ", which " +
                             short_name(first.name) + " carries already; it goes with that one");
    }
    void end() {
        if (count_ > kMostSaidOfNames)
            report_.add(Severity::error, where_,
                        std::to_string(count_ - kMostSaidOfNames) +
                            " more names of [[mover]] entries are wrong; they are not listed");
    }

private:
    Report& report_;
    Suggestions suggestions_;
    std::size_t count_ = 0;
    std::string where_; // of the last
};

void find_parents(std::vector<Mover>& movers, Report& report, Sentences& sentences) {
    std::vector<std::string> names;
    for (const Mover& mover : movers) names.push_back(mover.name);
    for (Mover& mover : movers) {
        mover.parent = kNoMover;
        if (mover.parent_name.empty()) continue;
        const auto found = std::find(names.begin(), names.end(), mover.parent_name);
        if (found == names.end())
            sentences.add_unknown(mover.where,
                                  called(mover) + " hangs on " + short_name(mover.parent_name) +
                                      ", which is no mover of the show",
                                  mover.parent_name, names);
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

// Names of things, and which is the first of a name.
struct Names {
    std::vector<std::string> all;
    std::unordered_map<std::string, std::size_t> first;
};

template <class Thing>
Names names_of(const std::vector<Thing>& things) {
    Names names;
    for (const Thing& thing : things) {
        names.first.try_emplace(thing.name, names.all.size());
        names.all.push_back(thing.name);
    }
    return names;
}

// The channel of a fixture, as its file has it.
void find_channel(const Show& show, const Names& names, const Mover& mover, MoverAxis& axis,
                  Sentences& sentences) {
    if (axis.fixture.empty() || axis.attribute.empty()) return;
    const std::string begin = called(mover) + " axis " + short_name(axis.name) + " ";
    const std::string end = "; no channel drives it";
    const std::string whose = short_name(axis.fixture), attribute = short_name(axis.attribute);
    const auto found = names.first.find(axis.fixture);
    if (found == names.first.end())
        return sentences.add_unknown(axis.where,
                                     begin + "names fixture " + whose + ", which the show does not have",
                                     axis.fixture, names.all, end);
    const PatchedFixture& fixture = show.fixtures[found->second];
    if (!fixture.type)
        return sentences.add(axis.where,
                             begin + "is driven by " + whose + ", whose file cannot be read" + end);
    const fixture::Patch patch = fixture.patch();
    std::vector<std::string> known;
    for (const fixture::Channel& channel : patch.mode_of().channels) {
        for (const fixture::ChannelFunction& function : channel.functions) {
            known.push_back(function.attribute);
            if (function.attribute != axis.attribute) continue;
            const auto at = static_cast<std::size_t>(std::max(channel.dmx_break, 1) - 1);
            if (channel.offsets.empty() || at >= patch.addresses.size() || patch.addresses[at].channel == 0)
                return sentences.add(axis.where, begin + "is driven by " + attribute + " of " + whose +
                                                     ", which is not patched" + end);
            const fixture::Address& first = patch.addresses[at];
            for (const int offset : channel.offsets) {
                const int place = first.channel - 1 + offset;
                axis.levels.push_back({first.universe + place / kChannels, place % kChannels + 1});
            }
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
    sentences.add_unknown(axis.where,
                          begin + "names attribute " + attribute + ", which " + whose + " does not have",
                          axis.attribute, known, end);
}

// Loads of one kind, each carried by the first that names it.
template <class Thing>
void load(std::vector<Thing>& things, const Names& names, const std::vector<Mover>& movers, const char* kind,
          const std::vector<std::string> Mover::*patterns, std::uint64_t& steps, Sentences& sentences) {
    for (Thing& thing : things) thing.mover = kNoMover;
    NameIndex index;
    for (std::size_t k = 0; k < things.size(); ++k) index.add(things[k].name, k);
    std::vector<int> said(things.size(), kNoMover); // of which mover last
    for (std::size_t m = 0; m < movers.size(); ++m) {
        const int mover = static_cast<int>(m);
        for (const std::string& pattern : movers[m].*patterns) {
            if (steps == 0) return;
            const std::vector<std::size_t> found = index.find(pattern, steps);
            for (const std::size_t k : found) {
                int& by = things[k].mover;
                if (by == kNoMover) by = mover;
                if (by != mover && std::exchange(said[k], mover) != mover)
                    sentences.add_taken(movers[m], kind, things[k].name,
                                        movers[static_cast<std::size_t>(by)]);
            }
            if (steps == 0)
                sentences.add(movers[m].where, called(movers[m]) + " " + kMatchStepsSpent);
            else if (found.empty())
                sentences.add_unknown(movers[m].where,
                                      called(movers[m]) + " carries " + kind + " " + short_name(pattern) +
                                          ", which the show does not have",
                                      pattern, names.all);
        }
    }
}

// Or null.
const std::string* mesh_name(const Stage& stage, const Instance& instance) {
    if (instance.mesh < 0 || instance.mesh >= static_cast<int>(stage.meshes.size())) return nullptr;
    return &stage.meshes[static_cast<std::size_t>(instance.mesh)].name;
}

// Objects of a stage, by their names and by those of their meshes.
struct StageNames {
    NameIndex by_name, by_mesh;
    std::uint64_t steps = kMostMatchSteps;

    StageNames(const Stage& stage, bool with_fixtures) {
        for (std::size_t k = 0; k < stage.instances.size(); ++k) {
            const Instance& instance = stage.instances[k];
            if (!with_fixtures && instance.fixture != kNone) continue;
            by_name.add(instance.name, k);
            if (const std::string* const mesh = mesh_name(stage, instance)) by_mesh.add(*mesh, k);
        }
    }
};

// For each instance its mover. taken(m, instance): m names one that another carries. missing(m, pattern): no
// instance has such a name; is_spent: nobody knows, nor of those after it.
template <class Taken, class Missing>
std::vector<int> carriers(const Show& show, const Stage& stage, const Taken& taken, const Missing& missing) {
    StageNames named(stage, false);
    std::vector<int> result(stage.instances.size(), kNoMover);
    std::unordered_map<std::string_view, int> walls; // their panels are objects of the stage
    for (const PatchedFixture& fixture : show.fixtures)
        if (fixture.wall && fixture.mover != kNoMover) walls[fixture.name] = fixture.mover;
    for (std::size_t k = 0; k < result.size(); ++k) {
        const Instance& instance = stage.instances[k];
        if (instance.fixture != kNone)
            result[k] = show.fixtures[static_cast<std::size_t>(instance.fixture)].mover;
        else if (const auto wall = walls.find(instance.name); wall != walls.end())
            result[k] = wall->second;
    }
    // As [[object]] does: the name of the object, else that of its mesh.
    const auto carry = [&](std::size_t m, const std::string& pattern, const NameIndex& names) {
        const std::vector<std::size_t> found = names.find(pattern, named.steps);
        for (const std::size_t k : found) {
            if (result[k] == kNoMover) result[k] = static_cast<int>(m);
            if (result[k] != static_cast<int>(m)) taken(m, k);
        }
        return !found.empty();
    };
    for (std::size_t m = 0; m < show.movers.size(); ++m)
        for (const std::string& pattern : show.movers[m].objects) {
            if (!carry(m, pattern, named.by_name) && !carry(m, pattern, named.by_mesh))
                missing(m, pattern, named.steps == 0);
            if (named.steps == 0) return result;
        }
    return result;
}

// Objects that go with a mover and not with their tracker.
void check_tracked(const Show& show, const Stage& stage, const std::vector<int>& movers,
                   Sentences& sentences) {
    std::set<std::string_view> said;
    StageNames named(stage, true);
    for (const TrackerUse& use : show.tracking.uses) {
        std::vector<bool> is_named(movers.size(), false);
        for (const std::string& pattern : use.objects)
            for (const NameIndex* const names : {&named.by_name, &named.by_mesh})
                for (const std::size_t k : names->find(pattern, named.steps)) is_named[k] = true;
        for (std::size_t k = 0; k < movers.size(); ++k) {
            if (!is_named[k] || movers[k] == kNoMover) continue;
            const Instance& instance = stage.instances[k];
            if (said.insert(instance.name).second)
                sentences.add(use.where,
                              "[[tracker]] object " + short_name(instance.name) + " goes with mover " +
                                  short_name(show.movers[static_cast<std::size_t>(movers[k])].name) +
                                  "; the tracker does not move it");
        }
    }
}

} // namespace

void check_movers(Show& show, Report& report) {
    if (show.movers.empty()) return;
    Sentences sentences(report);
    find_parents(show.movers, report, sentences);
    const Names fixtures = names_of(show.fixtures);
    for (Mover& mover : show.movers) {
        for (MoverAxis& axis : mover.axes) find_channel(show, fixtures, mover, axis, sentences);
        const bool carries_mover =
            std::any_of(show.movers.begin(), show.movers.end(),
                        [&](const Mover& other) { return other.parent_name == mover.name; });
        if (mover.carries_nothing() && !carries_mover)
            report.add(Severity::error, mover.where,
                       called(mover) + (mover.kind == MoverKind::hoists ? " has no truss" : " has no load") +
                           ", expected fixtures, objects or cameras = a list of names");
    }
    std::uint64_t steps = kMostMatchSteps;
    load(show.fixtures, fixtures, show.movers, "fixture", &Mover::fixtures, steps, sentences);
    load(show.cameras, names_of(show.cameras), show.movers, "camera", &Mover::cameras, steps, sentences);
    sentences.end();
}

std::vector<int> movers_of_instances(const Show& show, const Stage& stage) {
    return carriers(
        show, stage, [](std::size_t, std::size_t) {}, [](std::size_t, const std::string&, bool) {});
}

void check_moved_objects(const Show& show, const Stage& stage, Report& report) {
    if (show.movers.empty() || stage.instances.empty()) return; // an empty stage was said already
    Sentences sentences(report);
    std::vector<std::string> known;
    for (const Instance& instance : stage.instances) known.push_back(instance.name);
    std::vector<std::set<std::string_view>> said(show.movers.size());
    std::vector<std::pair<std::size_t, std::size_t>> taken; // who is first is known at the end
    const std::vector<int> movers = carriers(
        show, stage,
        [&](std::size_t m, std::size_t instance) {
            if (said[m].insert(stage.instances[instance].name).second) taken.emplace_back(m, instance);
        },
        [&](std::size_t m, const std::string& pattern, bool is_spent) {
            const Mover& mover = show.movers[m];
            if (is_spent) return sentences.add(mover.where, called(mover) + " " + kMatchStepsSpent);
            sentences.add_unknown(mover.where,
                                  called(mover) + " carries object " + short_name(pattern) +
                                      ", which the stage does not have",
                                  pattern, known);
        });
    for (const auto& [m, instance] : taken)
        sentences.add_taken(show.movers[m], "object", stage.instances[instance].name,
                            show.movers[static_cast<std::size_t>(movers[instance])]);
    check_tracked(show, stage, movers, sentences);
    sentences.end();
}

} // namespace ghost::scene
