// SPDX-License-Identifier: Apache-2.0
#include "diagnose/doctor_show.h"

#include "base/text.h"
#include "diagnose/private/doctor_patch.h"
#include "diagnose/private/doctor_substitute.h"
#include "disk/files.h"
#include "fixture/values.h"
#include "fixture_files/gdtf/gdtf.h"
#include "json_xml_toml/toml_reader.h"
#include "mvr/mvr_load.h"
#include "plots/plot_show.h"
#include "show_file/show_toml.h"
#include "stage/model_file.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::size_t kMaxSuggestions = 50; // missing files of one show that are looked for

// The lines of a show file's own fixtures.
std::vector<FixtureSource> sources_of(const Show& show) {
    if (show.file == show.plot_file) return {};
    const auto text = read_text_file(show.file, kMaxShowBytes);
    if (!text.ok()) return {};
    Report again; // all of it is in the report already
    auto parsed = parse_show(*text, show.file, again);
    return parsed.ok() ? std::move(parsed->sources) : std::vector<FixtureSource>{};
}

// What check_rig and same_names say better, for many at once. Tracks and channels that choose a medium are
// the loader's.
bool is_said_again(const std::string& what) {
    const auto has = [&](const char* words) { return what.find(words) != std::string::npos; };
    if (has("' track '") || has("' select '")) return false;
    return has("another object has the uuid of this one") || // same_names says which
           (has("' shares universe ") && has(" channels ")) || has("more pairs of fixtures share channels") ||
           (has("' address ") &&
            (has("runs past channel 512") || has("is out of range, expected universe"))) ||
           (has("' no address") && has("(needs "));
}

class Substitutes {
public:
    Substitutes(const Show& show, const FixtureOffers& offers) : show_(show), offers_(offers) {
        if (show.plot)
            for (const std::string& name : show.plot->archive.names())
                if (lower(name).ends_with(".gdtf")) members_.push_back(name);
        names_ = members_;
        names_.insert(names_.end(), offers.names.begin(), offers.names.end());
    }

    // own: the file that is asked for and that gives no light; it does not stand in for itself.
    std::string advice(const WantedFixture& wanted, bool of_plot, const std::string& own = "") {
        const auto found = suggest_substitute(wanted, names_, [&](std::size_t k) {
            const std::filesystem::path path =
                k < members_.size() ? members_[k] : offers_.files[k - members_.size()].string();
            const auto type = own.empty() || path.filename() != own ? load(k) : nullptr;
            const bool is_lit =
                type && std::any_of(type->modes.begin(), type->modes.end(),
                                    [&](const fixture::Mode& mode) { return !is_dark_by_desk(*type, mode); });
            return own.empty() || is_lit ? type : nullptr;
        });
        if (!found) return "";
        const bool inside = found->offer < members_.size();
        const std::string file =
            inside ? members_[found->offer] : offers_.files[found->offer - members_.size()].string();
        std::string text = std::string(found->likeness >= kSameFixture ? "'" : "the nearest is '") + file +
                           "'" + (inside ? " of the archive" : "") +
                           (found->likeness >= kSameFixture ? " seems to be this fixture" : "");
        const std::string needs = own.empty() ? " that the patch leaves for each" : " of the mode asked for";
        const std::string channels =
            std::to_string(found->channels) + (found->channels == 1 ? " channel" : " channels");
        if (found->by_length)
            text += "; its mode '" + found->mode + "' has the " + channels + needs;
        else if (wanted.channels > 0)
            text += "; no mode of it has the " + std::to_string(wanted.channels) + " channels" + needs +
                    ", the nearest by name is '" + found->mode + "' (" + channels + ")";
        else
            text += "; its mode '" + found->mode + "' has " + channels;
        if (!of_plot) return text;
        const std::string name = wanted.name.substr(0, 80);
        if (found->likeness >= kSameFixture && found->mode == wanted.mode && !inside && own.empty())
            return text + ". Copy it beside the plot as '" + name + "'";
        return text + ". Copy it into the show's folder, and in the show file: [[substitute]] for = \"" +
               name + "\", gdtf = \"" + std::filesystem::path(file).filename().string() + "\", mode = \"" +
               found->mode + "\"";
    }

private:
    std::shared_ptr<const fixture::Type> load(std::size_t k) {
        const auto [entry, is_new] = loaded_.try_emplace(k);
        if (!is_new) return entry->second;
        if (k >= members_.size()) return entry->second = offers_.load(k - members_.size());
        const auto bytes = show_.plot->archive.read(members_[k]);
        if (!bytes.ok()) return nullptr;
        auto type = fixture::load_gdtf(*bytes, members_[k]);
        if (type.ok()) entry->second = std::make_shared<const fixture::Type>(std::move(type->type));
        return entry->second;
    }

    const Show& show_;
    const FixtureOffers& offers_;
    std::vector<std::string> members_;
    std::vector<std::string> names_;
    std::map<std::size_t, std::shared_ptr<const fixture::Type>> loaded_;
};

struct Missing {
    std::vector<std::size_t> entries;
    std::string name; // what is looked for
};

void add_substitutes(const Show& show, const std::vector<PatchEntry>& entries, const FixtureOffers& offers,
                     std::vector<Finding>& findings) {
    std::map<std::string, Missing> missing;
    std::vector<std::string> in_order;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        if (entries[k].fixture->type) continue;
        // Without a file the name of the fixture says what it may be.
        const std::string& name = entries[k].spec.empty() ? entries[k].fixture->name : entries[k].spec;
        Missing& same = missing[name];
        if (same.entries.empty()) in_order.push_back(name);
        same.name = std::filesystem::path(name).filename().string();
        same.entries.push_back(k);
    }
    Substitutes substitutes(show, offers);
    for (std::size_t k = 0; k < in_order.size() && k < kMaxSuggestions; ++k) {
        const Missing& same = missing[in_order[k]];
        const PatchEntry& first = entries[same.entries.front()];
        const WantedFixture wanted{same.name, first.mode, spacing_of(entries, same.entries)};
        const std::string advice = substitutes.advice(wanted, first.of_plot);
        if (advice.empty()) continue;
        bool is_said = false;
        for (Finding& finding : findings)
            if (finding.severity == Severity::error && !first.spec.empty() &&
                (finding.what.find("'" + first.spec + "' is not in the archive") != std::string::npos ||
                 (finding.kind == "missing_file" && finding.what.find(same.name) != std::string::npos))) {
                finding.kind = "missing_fixture_file";
                finding.advice = advice;
                is_said = true;
            }
        if (!is_said)
            findings.push_back({Severity::note, "substitute", first.where,
                                "'" + same.name.substr(0, 80) + "' has no fixture file that can be read",
                                advice, static_cast<int>(same.entries.size())});
    }
}

// Lamps whose file knows no beam, as some programs export all of theirs.
void add_lit_ones(const Show& show, const std::vector<PatchEntry>& entries, const FixtureOffers& offers,
                  std::vector<Finding>& rig) {
    Substitutes substitutes(show, offers);
    std::size_t asked = 0;
    for (Finding& finding : rig) {
        if (finding.kind != "no_beam" || ++asked > kMaxSuggestions) continue;
        const auto first = std::find_if(entries.begin(), entries.end(), [&](const PatchEntry& entry) {
            return entry.where == finding.where && entry.fixture->type;
        });
        if (first == entries.end()) continue;
        const fixture::Mode& mode =
            first->fixture->type->modes[static_cast<std::size_t>(first->fixture->mode)];
        const WantedFixture wanted{std::filesystem::path(first->spec).filename().string(), first->mode,
                                   mode.footprint.empty() ? 0 : mode.footprint.front()};
        const std::string advice = substitutes.advice(wanted, first->of_plot, wanted.name);
        if (!advice.empty()) finding.advice += ": " + advice;
    }
}

void same_names(const Show& show, std::vector<Finding>& findings) {
    if (!show.plot) return;
    std::map<std::string, std::vector<const PlotObject*>> by_name;
    std::map<std::string, std::vector<const PlotObject*>> by_uuid;
    for (const PlotObject& object : show.plot->plot.objects) {
        if (object.kind == ObjectKind::fixture && !object.name.empty())
            by_name[object.name].push_back(&object);
        if (const std::string key = uuid_key(object.uuid); !key.empty()) by_uuid[key].push_back(&object);
    }
    std::vector<std::string> names;
    const PlotObject* second = nullptr;
    int times = 0;
    for (const auto& [name, objects] : by_name) {
        if (objects.size() < 2) continue;
        names.push_back(name);
        times += static_cast<int>(objects.size());
        if (!second || objects[1]->line < second->line) second = objects[1];
    }
    if (second)
        findings.push_back({Severity::note, "duplicate_name", place_of(*show.plot, *second),
                            std::to_string(times) +
                                " fixtures share their name with others and are called '" +
                                second->name.substr(0, 60) + " #2' and so on: " + name_list(names),
                            "", times, true});
    for (const auto& [uuid, objects] : by_uuid) {
        if (objects.size() < 2) continue;
        findings.push_back({Severity::warning, "duplicate_uuid", place_of(*show.plot, *objects[1]),
                            "UUID '" + objects[1]->uuid.substr(0, 60) + "' is given to " +
                                std::to_string(objects.size()) + " objects, the first in line " +
                                std::to_string(objects[0]->line) + "; links and changes mean the first one",
                            "export the plot again; each object needs a UUID of its own",
                            static_cast<int>(objects.size())});
    }
}

} // namespace

std::vector<PatchEntry> entries_of(const Show& show) {
    const std::vector<FixtureSource> sources = sources_of(show);
    std::unordered_map<std::string, const PlotObject*> objects;
    if (show.plot)
        for (const PlotObject& object : show.plot->plot.objects)
            objects.emplace(uuid_key(object.uuid), &object);
    std::vector<PatchEntry> entries;
    for (std::size_t k = 0; k < show.fixtures.size(); ++k) {
        const PatchedFixture& fixture = show.fixtures[k];
        PatchEntry entry{
            .fixture = &fixture, .where = show.file.string(), .spec = fixture.gdtf.string(), .mode = ""};
        if (k < sources.size()) {
            const int line = sources[k].address_line > 0 ? sources[k].address_line : sources[k].line;
            entry.where = file_line(show.file.string(), line) + ": [[fixture]] '" + fixture.name + "'";
            entry.mode = sources[k].mode;
        } else if (show.plot) {
            entry.of_plot = true;
            entry.where = show.plot->name;
            if (const auto found = objects.find(uuid_key(fixture.uuid)); found != objects.end()) {
                const PlotObject& object = *found->second;
                entry.where = place_of(*show.plot, object) + ": " + tag_of(object.kind) + " '" +
                              object.name.substr(0, 60) + "'";
                entry.mode = object.device.gdtf_mode;
                entry.is_multipatch = object.device.multipatch >= 0;
                if (!object.device.gdtf_spec.empty() && !fixture.type) entry.spec = object.device.gdtf_spec;
            }
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

bool is_dark_by_desk(const fixture::Type& type, const fixture::Mode& mode) {
    return std::all_of(mode.beams.begin(), mode.beams.end(), [&](int node) {
        const int geometry = mode.nodes[static_cast<std::size_t>(node)].geometry;
        return type.geometries[static_cast<std::size_t>(geometry)].beam->is_lit_by_hand;
    });
}

std::vector<Finding> findings_of(const Show& show, const Report& report, const FixtureOffers& offers) {
    std::vector<Finding> findings;
    for (const Message& message : report.messages)
        if (!is_said_again(message.what)) findings.push_back(finding_of(message));
    const std::vector<PatchEntry> entries = entries_of(show);
    add_substitutes(show, entries, offers, findings);
    same_names(show, findings);
    std::vector<Finding> rig = check_rig(entries);
    add_lit_ones(show, entries, offers, rig);
    findings.insert(findings.end(), std::make_move_iterator(rig.begin()), std::make_move_iterator(rig.end()));
    return findings;
}

} // namespace ghost::scene
