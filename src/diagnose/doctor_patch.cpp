// SPDX-License-Identifier: Apache-2.0
#include "diagnose/private/doctor_patch.h"

#include "base/text.h"
#include "diagnose/doctor_show.h"
#include "show/show.h"
#include "stage/model_file.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace ghost::scene {
namespace {

using fixture::Address;
using Indices = std::vector<std::size_t>;

std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::vector<Address> addresses_of(const PatchedFixture& fixture) {
    std::vector<Address> addresses{{fixture.universe, fixture.address}};
    addresses.insert(addresses.end(), fixture.more_addresses.begin(), fixture.more_addresses.end());
    return addresses;
}

bool is_patched(const PatchedFixture& fixture) {
    const std::vector<Address> addresses = addresses_of(fixture);
    return std::any_of(addresses.begin(), addresses.end(), [](const Address& a) { return a.channel > 0; });
}

long absolute(const Address& address) {
    return (address.universe - 1L) * 512 + address.channel;
}

// The first that is patched.
Address first_address(const PatchedFixture& fixture) {
    for (const Address& address : addresses_of(fixture))
        if (address.channel > 0) return address;
    return {};
}

std::string text_of(const Address& address) {
    return std::to_string(address.universe) + "." + std::to_string(address.channel);
}

int channels_of(const fixture::Mode& mode) {
    int channels = 0;
    for (const int bytes : mode.footprint) channels += bytes;
    return channels;
}

int first_break(const fixture::Mode& mode) {
    return mode.footprint.empty() ? 0 : mode.footprint.front();
}

class RigCheck {
public:
    explicit RigCheck(std::span<const PatchEntry> entries) : entries_(entries) {
        for (std::size_t k = 0; k < entries.size(); ++k) {
            const PatchedFixture& fixture = *entries[k].fixture;
            const int mode = fixture.type ? fixture.mode : -1;
            auto& equal = equal_[{entries[k].spec, mode, mode < 0 ? entries[k].mode : ""}];
            if (equal.empty()) order_.push_back(&equal);
            equal.push_back(k);
        }
    }

    std::vector<Finding> all() {
        unpatched();
        for (const Indices* equal : order_) single_patches(*equal);
        overlaps(multipatches());
        for (const Indices* equal : order_) lengths(*equal);
        for (const Indices* equal : order_) dark(*equal);
        same_numbers();
        return std::move(findings_);
    }

private:
    const PatchedFixture& fixture(std::size_t k) const { return *entries_[k].fixture; }

    std::string names(const Indices& which) const {
        std::vector<std::string> list;
        for (const std::size_t k : which) list.push_back(fixture(k).name);
        return name_list(list);
    }

    // "'Spot.gdtf' in mode 'Wide' (24 channels)"
    std::string kind_text(std::size_t k) const {
        const fixture::Mode& mode = fixture(k).type->modes[static_cast<std::size_t>(fixture(k).mode)];
        return "'" + entries_[k].spec.substr(0, 80) + "' in mode '" + mode.name + "' (" +
               counted(static_cast<std::size_t>(channels_of(mode)), "channel") + ")";
    }

    void say(Severity severity, const char* kind, std::size_t first, std::string what, std::string advice,
             std::size_t times) {
        findings_.push_back({severity, kind, entries_[first].where, std::move(what), std::move(advice),
                             static_cast<int>(times), !is_each(kind)});
    }

    // Kinds that come once per place; all others sum up what equal fixtures have in common.
    static bool is_each(std::string_view kind) {
        return kind == "multipatch" || kind == "duplicate_id" || kind == "bad_address";
    }

    void unpatched() {
        Indices none;
        std::size_t patched = 0;
        for (std::size_t k = 0; k < entries_.size(); ++k) {
            const PatchedFixture& of = fixture(k);
            if (is_patched(of)) {
                ++patched;
                continue;
            }
            // What has no channels needs no address.
            if (of.type && channels_of(of.type->modes[static_cast<std::size_t>(of.mode)]) == 0) continue;
            // Our own walls, projectors and lasers shine without a desk.
            const bool is_on = of.gdtf.empty() && (of.wall || of.projector || of.laser);
            if (!of.track && !is_on) none.push_back(k);
        }
        if (none.empty()) return;
        say(Severity::warning, "unpatched", none.front(),
            counted(none.size(), "fixture") + (none.size() == 1 ? " has" : " have") +
                " no address, all channels keep their defaults" +
                (patched == 0 ? ": nothing of this rig is patched" : "") + ": " + names(none),
            "patch them in the plot, or with address in [[fixture]] or [[change]] of the show file",
            none.size());
    }

    // check_patch, once for all equal fixtures.
    void single_patches(const Indices& equal) {
        Indices past;
        std::map<std::string, Indices> without;
        for (const std::size_t k : equal) {
            if (!fixture(k).type || !is_patched(fixture(k))) continue;
            const fixture::Mode& mode = fixture(k).type->modes[static_cast<std::size_t>(fixture(k).mode)];
            const std::vector<Address> addresses = addresses_of(fixture(k));
            bool is_past = false;
            for (std::size_t b = 0; b < mode.footprint.size(); ++b) {
                if (mode.footprint[b] == 0) continue;
                if (b >= addresses.size() || addresses[b].channel == 0)
                    without["break " + std::to_string(b + 1)].push_back(k);
                else if (addresses[b].channel <= 512 && addresses[b].channel + mode.footprint[b] - 1 > 512)
                    is_past = true;
            }
            if (is_past) past.push_back(k);
            for (const std::string& problem : fixture::check_patch(fixture(k).patch()))
                if (problem.find("is out of range") != std::string::npos)
                    say(Severity::error, "bad_address", k, "'" + fixture(k).name + "': " + problem,
                        "give it an address in that range", 1);
        }
        if (!past.empty())
            say(Severity::warning, "past_512", past.front(),
                counted(past.size(), "fixture") + " of " + kind_text(past.front()) +
                    (past.size() == 1 ? " runs" : " run") +
                    " past channel 512; taken to go on at channel 1 of the next universe: " + names(past),
                "move them to addresses where they fit", past.size());
        for (const auto& [which, fixtures] : without)
            say(entries_[fixtures.front()].of_plot ? Severity::note : Severity::warning,
                "break_without_address", fixtures.front(),
                counted(fixtures.size(), "fixture") + " of " + kind_text(fixtures.front()) + ": " + which +
                    " has no address, its channels keep their defaults: " + names(fixtures),
                "give each break an address, if the desk drives it", fixtures.size());
    }

    // One of each set that has type, mode and all addresses in common: these do the same by intent.
    Indices multipatches() {
        std::map<std::tuple<const fixture::Type*, int, std::vector<long>>, Indices> sets;
        std::vector<const Indices*> in_order;
        for (std::size_t k = 0; k < entries_.size(); ++k) {
            if (!fixture(k).type || !is_patched(fixture(k))) continue;
            std::vector<long> places;
            for (const Address& address : addresses_of(fixture(k))) places.push_back(absolute(address));
            Indices& set = sets[{fixture(k).type.get(), fixture(k).mode, places}];
            if (set.empty()) in_order.push_back(&set);
            set.push_back(k);
        }
        Indices first;
        for (const Indices* set : in_order) {
            first.push_back(set->front());
            Indices said;
            for (const std::size_t k : *set)
                if (!entries_[k].is_multipatch) said.push_back(k);
            if (said.size() < 2) continue;
            say(Severity::note, "multipatch", said[1],
                counted(said.size(), "fixture") + " of one type share address " +
                    text_of(first_address(fixture(said.front()))) + " and will do the same: " + names(said),
                "fine where a multipatch is meant", said.size());
        }
        std::sort(first.begin(), first.end());
        return first;
    }

    struct Shared {
        fixture::Overlap first;
        std::set<std::size_t> a, b;
        std::size_t pairs = 0;
    };

    void overlaps(const Indices& which) {
        std::vector<fixture::Patch> patches;
        for (const std::size_t k : which) patches.push_back(fixture(k).patch());
        // A run: equal fixtures of one universe.
        using Run = std::tuple<std::string, int, int>;
        const auto run_of = [&](std::size_t k, int universe) {
            return Run{entries_[k].spec, fixture(k).mode, universe};
        };
        std::map<std::pair<Run, Run>, Shared> runs;
        std::vector<std::pair<Run, Run>> in_order;
        for (const fixture::Overlap& overlap : fixture::find_overlaps(patches)) {
            const std::size_t a = which[overlap.first];
            const std::size_t b = which[overlap.second];
            std::pair<Run, Run> key{run_of(a, overlap.universe), run_of(b, overlap.universe)};
            const bool turned = key.second < key.first;
            if (turned) std::swap(key.first, key.second);
            const auto [entry, is_new] = runs.try_emplace(key);
            Shared& shared = entry->second;
            if (is_new) {
                shared.first = overlap;
                in_order.push_back(key);
            }
            ++shared.pairs;
            (turned ? shared.b : shared.a).insert(a);
            (turned ? shared.a : shared.b).insert(b);
        }
        for (const auto& key : in_order) overlap(runs.at(key), which);
    }

    void overlap(const Shared& shared, const Indices& which) {
        const std::size_t a = which[shared.first.first];
        const std::size_t b = which[shared.first.second];
        std::string what = "'" + fixture(b).name + "' and '" + fixture(a).name + "' share channels " +
                           std::to_string(shared.first.channel_from) + " to " +
                           std::to_string(shared.first.channel_to) + " of universe " +
                           std::to_string(shared.first.universe) + ", expected channels of their own";
        if (shared.pairs > 1) {
            Indices all(shared.a.begin(), shared.a.end());
            all.insert(all.end(), shared.b.begin(), shared.b.end());
            std::sort(all.begin(), all.end());
            all.erase(std::unique(all.begin(), all.end()), all.end());
            what += "; so do " + std::to_string(shared.pairs - 1) + " more pairs of the same two kinds, of " +
                    names(all);
        }
        what += " (" + entries_[a].where + ")";
        // In a show file each address was written by hand; designers patch plots in parts.
        const bool of_plot = entries_[a].of_plot && entries_[b].of_plot;
        say(of_plot ? Severity::warning : Severity::error, "overlap", b, std::move(what),
            "give one of them other addresses, or the mode with fewer channels", shared.pairs);
    }

    void lengths(const Indices& equal) {
        const PatchedFixture& first = fixture(equal.front());
        if (!first.type) return;
        const fixture::Mode& mode = first.type->modes[static_cast<std::size_t>(first.mode)];
        const int length = first_break(mode);
        const int apart = spacing_of(entries_, equal);
        if (length == 0 || apart == 0 || apart == length) return;
        const int fits = mode_of_length(*first.type, apart);
        // Room between fixtures is usual; only a mode of just that length says that it was meant.
        if (apart > length && fits < 0) return;
        Indices patched;
        for (const std::size_t k : equal)
            if (is_patched(fixture(k))) patched.push_back(k);
        std::string advice;
        if (fits >= 0)
            advice = "take mode '" + first.type->modes[static_cast<std::size_t>(fits)].name +
                     "', which has " + counted(static_cast<std::size_t>(apart), "channel");
        else
            advice = "no mode of this type has " + counted(static_cast<std::size_t>(apart), "channel") +
                     ": the plot was patched for another fixture or another version of its file";
        say(Severity::warning, "wrong_mode_length", patched.front(),
            counted(patched.size(), "fixture") + " of " + kind_text(patched.front()) + " stand " +
                counted(static_cast<std::size_t>(apart), "channel") + " apart, expected " +
                std::to_string(length) + ": " + names(patched),
            std::move(advice), patched.size());
    }

    void dark(const Indices& equal) {
        const PatchedFixture& first = fixture(equal.front());
        if (!first.type) return;
        const fixture::Mode& mode = first.type->modes[static_cast<std::size_t>(first.mode)];
        if (!is_dark_by_desk(*first.type, mode)) return;
        const bool by_hand = !mode.beams.empty();
        const bool is_lamp =
            std::any_of(mode.channels.begin(), mode.channels.end(), [](const fixture::Channel& of) {
                return std::any_of(of.functions.begin(), of.functions.end(),
                                   [](const fixture::ChannelFunction& function) {
                                       return function.meaning.role == fixture::Role::dimmer ||
                                              function.meaning.role == fixture::Role::shutter ||
                                              function.meaning.role == fixture::Role::color_add;
                                   });
            });
        say(Severity::warning, "no_beam", equal.front(),
            counted(equal.size(), "fixture") + " of " + kind_text(equal.front()) +
                (by_hand             ? equal.size() == 1 ? " has" : " have"
                 : equal.size() == 1 ? " gives"
                                     : " give") +
                (by_hand ? " stand-in optics, which hands alone light, as the mode has no beam: "
                         : " no light, as the mode has no beam: ") +
                names(equal),
            is_lamp
                ? "name another file of this fixture in [[substitute]] of the show file, or get a newer one"
                : "fine where it is no lamp; else name another file of it in [[substitute]] of the show file",
            equal.size());
    }

    void same_numbers() {
        std::map<std::string, Indices> by_number;
        for (std::size_t k = 0; k < entries_.size(); ++k)
            if (const std::string& id = fixture(k).fixture_id;
                !id.empty() && id != "0" && !entries_[k].is_multipatch)
                by_number[id].push_back(k);
        for (const auto& [id, which] : by_number)
            if (which.size() > 1)
                say(Severity::note, "duplicate_id", which[1],
                    "fixture number '" + id.substr(0, 40) + "' is given to " +
                        counted(which.size(), "fixture") + ": " + names(which) + "; the first is at " +
                        entries_[which.front()].where,
                    "give each fixture a number of its own, or mark them as multipatch", which.size());
    }

    std::span<const PatchEntry> entries_;
    std::map<std::tuple<std::string, int, std::string>, Indices> equal_; // by file and mode
    std::vector<const Indices*> order_;
    std::vector<Finding> findings_;
};

} // namespace

int mode_of_length(const fixture::Type& type, int channels) {
    for (std::size_t k = 0; k < type.modes.size(); ++k)
        if (first_break(type.modes[k]) == channels) return static_cast<int>(k);
    return -1;
}

int spacing_of(std::span<const PatchEntry> entries, std::span<const std::size_t> equal) {
    const std::set<std::size_t> ours(equal.begin(), equal.end());
    std::map<long, bool> starts; // absolute address: is it one of ours
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const Address address = addresses_of(*entries[k].fixture).front();
        if (address.channel == 0) continue;
        const auto entry = starts.try_emplace(absolute(address), true).first;
        entry->second = entry->second && ours.contains(k);
    }
    std::map<long, int> counts;
    int neighbours = 0;
    for (auto entry = starts.begin(); entry != starts.end(); ++entry) {
        const auto next = std::next(entry);
        if (next == starts.end()) break;
        const bool one_universe = (entry->first - 1) / 512 == (next->first - 1) / 512;
        if (!entry->second || !next->second || !one_universe) continue;
        ++counts[next->first - entry->first];
        ++neighbours;
    }
    for (const auto& [apart, count] : counts)
        if (count >= 2 && 2 * count >= neighbours) return static_cast<int>(apart);
    return 0;
}

std::vector<Finding> check_rig(std::span<const PatchEntry> entries) {
    return RigCheck(entries).all();
}

} // namespace ghost::scene
