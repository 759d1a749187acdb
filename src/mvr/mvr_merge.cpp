// SPDX-License-Identifier: Apache-2.0
#include "mvr/mvr_merge.h"

#include "base/print.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace ghost::scene {
namespace {

constexpr double kSamePlace_m = 1e-5; // hundredths of a millimetre are noise of rounding
constexpr double kSameTurn = 1e-5;
constexpr std::size_t kListed = 20;

std::string address_text(const fixture::Address& address) {
    if (address.channel <= 0) return "none";
    return std::to_string(address.universe) + "." + std::to_string(address.channel);
}

// What an object is known by in both plots.
std::vector<std::string> keys_of(const Plot& plot) {
    std::vector<std::string> keys;
    std::map<std::string, int> seen;
    for (const PlotObject& object : plot.objects) {
        std::string key = uuid_key(object.uuid);
        if (key.empty() || seen.contains(key)) {
            const std::string layer =
                object.layer >= 0 ? plot.layers[static_cast<std::size_t>(object.layer)].name : "";
            key = std::string(tag_of(object.kind)) + "\n" + layer + "\n" + object.name + "\n";
            key += std::to_string(seen[key]++);
        } else {
            seen[key] = 1;
        }
        keys.push_back(std::move(key));
    }
    return keys;
}

std::string moved_text(const PlotObject& before, const PlotObject& after) {
    const double distance_m = glm::length(glm::dvec3(after.world[3] - before.world[3]));
    double turn = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            turn = std::max(turn, std::abs(after.world[column][row] - before.world[column][row]));
    if (distance_m <= kSamePlace_m && turn <= kSameTurn) return "";
    char text[48];
    std::snprintf(text, sizeof text, "moved %.3f m", distance_m);
    if (turn <= kSameTurn) return text;
    return distance_m > kSamePlace_m ? text + std::string(" and turned") : "turned";
}

std::map<int, fixture::Address> addresses_of(const PlotObject& object) {
    std::map<int, fixture::Address> result;
    for (const PlotAddress& address : object.device.addresses)
        if (address.address.channel > 0) result.emplace(address.dmx_break, address.address);
    return result;
}

std::string patch_text(const PlotObject& before, const PlotObject& after) {
    const auto old_addresses = addresses_of(before);
    const auto new_addresses = addresses_of(after);
    std::map<int, std::pair<fixture::Address, fixture::Address>> both;
    for (const auto& [dmx_break, address] : old_addresses) both[dmx_break].first = address;
    for (const auto& [dmx_break, address] : new_addresses) both[dmx_break].second = address;
    std::string text;
    for (const auto& [dmx_break, pair] : both) {
        if (absolute_address(pair.first) == absolute_address(pair.second)) continue;
        if (!text.empty()) text += ", ";
        if (both.size() > 1) text += "break " + std::to_string(dmx_break) + " ";
        text += "address " + address_text(pair.first) + " is now " + address_text(pair.second);
    }
    return text;
}

class Merger {
public:
    Merger(const Plot& old_plot, const Plot& new_plot)
        : old_(old_plot), new_(new_plot), old_keys_(keys_of(old_plot)), new_keys_(keys_of(new_plot)) {
        for (std::size_t i = 0; i < old_keys_.size(); ++i) old_index_.emplace(old_keys_[i], i);
        for (std::size_t i = 0; i < new_keys_.size(); ++i) new_index_.emplace(new_keys_[i], i);
    }

    MergedPlot merge(std::span<const PlotChange> changes) {
        MergedPlot merged{new_, {}};
        compare(merged.report);
        keep(changes, merged);
        return merged;
    }

private:
    void compare(MergeReport& report) const {
        bool shared = false;
        for (std::size_t i = 0; i < old_keys_.size(); ++i)
            if (!new_index_.contains(old_keys_[i]))
                report.removed.push_back(entry(old_.objects[i], ""));
            else
                shared |= !uuid_key(old_.objects[i].uuid).empty();
        report.unrelated = !shared && !old_.objects.empty() && !new_.objects.empty();
        for (std::size_t i = 0; i < new_keys_.size(); ++i) {
            const PlotObject& after = new_.objects[i];
            const auto found = old_index_.find(new_keys_[i]);
            if (found == old_index_.end()) {
                report.added.push_back(entry(after, ""));
                continue;
            }
            const PlotObject& before = old_.objects[found->second];
            bool same = true;
            const auto note = [&](std::vector<MergeEntry>& list, std::string what) {
                if (what.empty()) return;
                list.push_back(entry(after, std::move(what)));
                same = false;
            };
            note(report.moved, moved_text(before, after));
            note(report.repatched, patch_text(before, after));
            note(report.changed, changed_text(before, after));
            report.unchanged += same;
        }
    }

    static MergeEntry entry(const PlotObject& object, std::string what) {
        return {object.uuid, object.kind, object.name, object.device.fixture_id, std::move(what)};
    }

    std::string changed_text(const PlotObject& before, const PlotObject& after) const {
        std::string text;
        const auto note = [&](const char* what, const std::string& was, const std::string& is) {
            if (was == is) return;
            text += (text.empty() ? "" : ", ") + std::string(what) + " '" + was + "' is now '" + is + "'";
        };
        note("name", before.name, after.name);
        note("fixture file", before.device.gdtf_spec, after.device.gdtf_spec);
        note("mode", before.device.gdtf_mode, after.device.gdtf_mode);
        note("fixture ID", before.device.fixture_id, after.device.fixture_id);
        note("class", class_of(old_, before), class_of(new_, after));
        note("layer", layer_of(old_, before), layer_of(new_, after));
        if (parent_key(old_keys_, before) != parent_key(new_keys_, after))
            text += (text.empty() ? "" : ", ") + std::string("hangs on ") + parent_name(new_, after) +
                    " instead of " + parent_name(old_, before);
        if (before.kind != after.kind) note("kind", name_of(before.kind), name_of(after.kind));
        return text;
    }

    static std::string class_of(const Plot& plot, const PlotObject& object) {
        return object.plot_class >= 0 ? plot.classes[static_cast<std::size_t>(object.plot_class)].name : "";
    }
    static std::string layer_of(const Plot& plot, const PlotObject& object) {
        return object.layer >= 0 ? plot.layers[static_cast<std::size_t>(object.layer)].name : "";
    }
    static std::string parent_key(const std::vector<std::string>& keys, const PlotObject& object) {
        return object.parent >= 0 ? keys[static_cast<std::size_t>(object.parent)] : "";
    }
    static std::string parent_name(const Plot& plot, const PlotObject& object) {
        if (object.parent < 0) return "nothing";
        const PlotObject& parent = plot.objects[static_cast<std::size_t>(object.parent)];
        return std::string(scene::name_of(parent.kind)) + " '" + parent.name + "'";
    }

    // What a plot says of the thing that a change is about.
    static std::string said(const PlotObject& object, const PlotChange& change) {
        switch (change.what) {
        case PlotChange::What::address: {
            const auto addresses = addresses_of(object);
            const auto found = addresses.find(change.dmx_break);
            return address_text(found == addresses.end() ? fixture::Address{} : found->second);
        }
        case PlotChange::What::mode:
            return object.device.gdtf_mode;
        case PlotChange::What::name:
            return object.name;
        case PlotChange::What::position: {
            char text[96];
            std::snprintf(text, sizeof text, "%.3f, %.3f, %.3f m", object.local[3].x, object.local[3].y,
                          object.local[3].z);
            return text;
        }
        case PlotChange::What::hidden:
            return "";
        }
        return "";
    }

    static bool plot_changed_it(const PlotObject& before, const PlotObject& after, const PlotChange& change) {
        if (change.what != PlotChange::What::position) return said(before, change) != said(after, change);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row)
                if (std::abs(before.local[column][row] - after.local[column][row]) > kSamePlace_m)
                    return true;
        return false;
    }

    void keep(std::span<const PlotChange> changes, MergedPlot& merged) const {
        std::unordered_map<std::string, int> objects;
        for (std::size_t i = 0; i < new_.objects.size(); ++i)
            objects.emplace(uuid_key(new_.objects[i].uuid), static_cast<int>(i));
        objects.erase("");
        // The last of several changes of one thing counts, in the place of the first.
        std::map<std::tuple<std::string, PlotChange::What, int>, std::size_t> places;
        std::vector<const PlotChange*> last;
        for (const PlotChange& change : changes) {
            const int dmx_break = change.what == PlotChange::What::address ? change.dmx_break : 0;
            const auto [place, fresh] =
                places.emplace(std::tuple(uuid_key(change.uuid), change.what, dmx_break), last.size());
            if (fresh)
                last.push_back(&change);
            else
                last[place->second] = &change;
        }
        bool moved = false;
        for (const PlotChange* change : last) {
            const std::string key = uuid_key(change->uuid);
            const auto found = objects.find(key);
            if (found == objects.end()) {
                merged.report.gone.push_back(*change);
                continue;
            }
            PlotObject& object = merged.plot.objects[static_cast<std::size_t>(found->second)];
            const PlotObject& after = new_.objects[static_cast<std::size_t>(found->second)];
            KeptChange kept{*change, after.name, after.device.fixture_id, false, ""};
            const auto before = old_index_.find(key);
            if (before != old_index_.end() && plot_changed_it(old_.objects[before->second], after, *change)) {
                kept.both = true;
                kept.plot_says = said(after, *change);
            }
            merged.report.kept.push_back(std::move(kept));
            apply_change(object, *change);
            moved |= change->what == PlotChange::What::position;
        }
        if (moved) update_world(merged.plot);
    }

    const Plot& old_;
    const Plot& new_;
    std::vector<std::string> old_keys_;
    std::vector<std::string> new_keys_;
    std::unordered_map<std::string, std::size_t> old_index_;
    std::unordered_map<std::string, std::size_t> new_index_;
};

const char* name_of(PlotChange::What what) {
    switch (what) {
    case PlotChange::What::address:
        return "address";
    case PlotChange::What::mode:
        return "mode";
    case PlotChange::What::position:
        return "position";
    case PlotChange::What::name:
        return "name";
    case PlotChange::What::hidden:
        return "hidden";
    }
    return "";
}

// " (101, 4A1C-..)": names come again and again, numbers and UUIDs do not.
std::string identity(const std::string& fixture_id, const std::string& uuid) {
    const std::string both = fixture_id + (fixture_id.empty() || uuid.empty() ? "" : ", ") + uuid;
    return both.empty() ? "" : " (" + both + ")";
}

void list(std::string& text, const char* title, const std::vector<MergeEntry>& entries) {
    for (std::size_t i = 0; i < entries.size() && i < kListed; ++i) {
        const MergeEntry& entry = entries[i];
        text +=
            one_line(std::string("  ") + title + ": " + scene::name_of(entry.kind) + " '" + entry.name + "'" +
                     identity(entry.fixture_id, entry.uuid) + (entry.what.empty() ? "" : ": " + entry.what)) +
            "\n";
    }
    if (entries.size() > kListed)
        text += std::string("  ") + title + ": " + std::to_string(entries.size() - kListed) + " more\n";
}

} // namespace

MergedPlot merge_plots(const Plot& old_plot, const Plot& new_plot, std::span<const PlotChange> changes) {
    return Merger(old_plot, new_plot).merge(changes);
}

std::string text_of(const MergeReport& report) {
    std::string text =
        std::to_string(report.added.size()) + " added, " + std::to_string(report.removed.size()) +
        " removed, " + std::to_string(report.moved.size()) + " moved, " +
        std::to_string(report.repatched.size()) + " re-patched, " + std::to_string(report.changed.size()) +
        " changed, " + std::to_string(report.unchanged) + " as before; " +
        std::to_string(report.kept.size()) + " of your changes kept, " + std::to_string(report.gone.size()) +
        " without their object\n";
    if (report.unrelated) text += "  not one object has the UUID of an old one: is this another show?\n";
    list(text, "added", report.added);
    list(text, "removed", report.removed);
    list(text, "moved", report.moved);
    list(text, "re-patched", report.repatched);
    list(text, "changed", report.changed);
    for (const KeptChange& kept : report.kept)
        if (kept.both)
            text += one_line(std::string("  your ") + name_of(kept.change.what) + " of '" + kept.name + "'" +
                             identity(kept.fixture_id, kept.change.uuid) + " is kept; the new plot says " +
                             kept.plot_says) +
                    "\n";
    for (const PlotChange& change : report.gone)
        text += one_line(std::string("  your ") + name_of(change.what) + " of " + change.uuid +
                         " is dropped: there is no such object any more") +
                "\n";
    return text;
}

} // namespace ghost::scene
