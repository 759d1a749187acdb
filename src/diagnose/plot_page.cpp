// SPDX-License-Identifier: Apache-2.0
#include "diagnose/plot_page.h"

#include "base/text.h"
#include "diagnose/private/doctor_patch.h"
#include "diagnose/private/doctor_substitute.h"
#include "mvr/mvr_load.h"
#include "plots/plot_types.h"
#include "show/show.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostNameBytes = 100;  // of a type, in a line
constexpr std::size_t kMostSuggestions = 50; // files of one show that are looked for

struct KindTitle {
    std::string_view kind;
    const char* title;
};
constexpr KindTitle kTitles[] = {
    {"missing_fixture_file", "Fixture files that are missing"},
    {"unreadable_fixture_file", "Fixture files that cannot be read"},
    {"no_mode", "Fixture files without a DMX mode"},
    {"unknown_mode", "Modes that the fixture file does not have"},
    {"no_beam", "Fixture files that say nothing of their light"},
    {"guessed_fixture_file", "Fixture files taken by a name that is nearly the same"},
    {"missing_file", "Files that are missing"},
    {"missing_media", "Pictures and models that are missing"},
    {"unreadable_media", "Films and pictures that cannot be read"},
    {"missing_link", "Names that lead nowhere"},
    {"overlap", "Fixtures that share channels"},
    {"unpatched", "Fixtures without an address"},
    {"past_512", "Fixtures that run past channel 512"},
    {"break_without_address", "Parts of fixtures without an address"},
    {"bad_address", "Addresses that cannot be"},
    {"wrong_mode_length", "Addresses that fit another mode"},
    {"multipatch", "Fixtures with the very same address"},
    {"duplicate_name", "Names that are given twice"},
    {"duplicate_id", "Fixture numbers that are given twice"},
    {"duplicate_uuid", "Identities that are given twice"},
    {"unsafe_name", "Names that lead out of the file"},
    {"guessed_value", "Values that a file leaves out"},
    {"unknown_element", "Things in the file that mean nothing to us"},
    {"not_used", "Things in the file that no picture needs"},
};

std::string title_of(const std::string& kind) {
    for (const KindTitle& known : kTitles)
        if (known.kind == kind) return known.title;
    return "Other";
}

// Lamps of no make, by what their names have in common with what they stand in for.
struct GeneralLamp {
    const char* file;
    const char* label;
    std::array<std::string_view, 8> words;
};
constexpr std::array<std::string_view, 4> kKinds{"spot", "profile", "wash", "fresnel"};
constexpr GeneralLamp kGeneral[] = {
    {"Vari-Lite@VL2500_Spot.gdtf",
     "VL2500 Spot",
     {"spot", "profile", "viper", "esprite", "pointe", "beam", "airfx", "fortimo"}},
    {"Vari-Lite@VL2500_Wash.gdtf",
     "VL2500 Wash",
     {"wash", "spiider", "aura", "quantum", "eye", "k20", "tarrantula", "rush"}},
    {"Ghostlight@LED_Par.gdtf", "LED par", {"led", "par", "strip", "bar", "pixel", "cluster", "tube", "cyc"}},
    {"Ghostlight@Dimmer_Lamp.gdtf",
     "Dimmer lamp",
     {"fresnel", "dimmer", "blinder", "mole", "source", "four", "alc4", "par64"}},
};

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

// Whole letters of UTF-8.
std::string beginning(const std::string& name) {
    std::size_t end = std::min(name.size(), kMostNameBytes);
    while (end > 0 && end < name.size() && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
    return name.substr(0, end);
}

// What stands between quotes.
std::vector<std::string> quoted_in(const std::string& text) {
    std::vector<std::string> all;
    for (std::size_t open = text.find('\''); open != std::string::npos;) {
        const std::size_t close = text.find('\'', open + 1);
        if (close == std::string::npos) break;
        all.push_back(text.substr(open + 1, close - open - 1));
        open = text.find('\'', close + 1);
    }
    return all;
}

using Numbers = std::set<std::size_t>;

class Maker {
public:
    Maker(const Show& show, const FixtureOffers& offers)
        : show_(show), offers_(offers), entries_(entries_of(show)) {
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            for (const std::string& name : {show.fixtures[i].name, entries_[i].spec})
                if (!name.empty()) by_name_[name].insert(i);
        }
        if (show.plot)
            for (const PlotObject& object : show.plot->plot.objects)
                objects_.emplace(uuid_key(object.uuid), &object);
    }

    PlotPage page(const std::vector<Finding>& findings) {
        page_.name = (show_.plot_file.empty() ? show_.file : show_.plot_file).filename().string();
        say_found();
        find_lightless();
        for (const Severity severity : {Severity::error, Severity::warning, Severity::note})
            for (const Finding& finding : findings)
                if (finding.severity == severity && finding.kind != "substitute") add(finding);
        return std::move(page_);
    }

private:
    void say_found() {
        std::map<std::string, std::vector<std::size_t>> types;
        std::set<int> universes;
        for (std::size_t i = 0; i < show_.fixtures.size(); ++i) {
            const PatchedFixture& fixture = show_.fixtures[i];
            types[fixture.type ? fixture.type->name : fixture.gdtf.string()].push_back(i);
            if (fixture.address > 0) universes.insert(fixture.universe);
        }
        page_.found.push_back({counted(show_.fixtures.size(), "fixture", "fixtures") + " of " +
                                   counted(types.size(), "type", "types") + ", patched in " +
                                   counted(universes.size(), "universe", "universes"),
                               "",
                               {}});
        for (auto& [name, fixtures] : types)
            page_.found.push_back({std::to_string(fixtures.size()) + " " +
                                       (name.empty() ? std::string("of no type") : beginning(name)),
                                   "", std::move(fixtures)});
        if (show_.plot) {
            const Plot& plot = show_.plot->plot;
            const auto scenery =
                std::count_if(plot.objects.begin(), plot.objects.end(), [](const PlotObject& object) {
                    return object.kind != ObjectKind::fixture && object.kind != ObjectKind::group;
                });
            page_.found.push_back(
                {scenery == 0 ? "no scenery: heads hang in empty space"
                              : counted(static_cast<std::size_t>(scenery), "piece", "pieces") +
                                    " of scenery in " + counted(plot.layers.size(), "layer", "layers"),
                 "",
                 {}});
        }
        page_.found.push_back({counted(show_.cameras.size(), "camera", "cameras"), "", {}});
    }

    // Null: none of the plot's.
    const PlotGdtf* file_of(std::size_t fixture) const {
        const std::string& uuid = show_.fixtures[fixture].uuid;
        const auto found = uuid.empty() ? objects_.end() : objects_.find(uuid_key(uuid));
        if (found == objects_.end() || found->second->device.gdtf < 0) return nullptr;
        return &show_.plot->plot.gdtf_files[static_cast<std::size_t>(found->second->device.gdtf)];
    }

    void find_lightless() {
        std::map<std::string, Numbers> by_file;
        std::map<std::string, std::size_t> index;
        for (std::size_t i = 0; i < show_.fixtures.size(); ++i) {
            const PlotGdtf* const file = file_of(i);
            const PatchedFixture& fixture = show_.fixtures[i];
            if (!file) continue;
            bool is_dark = true, by_hand = false;
            if (fixture.type) {
                const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
                is_dark = mode.beams.empty();
                if (std::any_of(mode.beams.begin(), mode.beams.end(), [&](int node) {
                        const int geometry = mode.nodes[static_cast<std::size_t>(node)].geometry;
                        const auto& beam = fixture.type->geometries[static_cast<std::size_t>(geometry)].beam;
                        by_hand = by_hand || (beam && beam->is_lit_by_hand);
                        return !beam || !beam->is_assumed;
                    }))
                    continue;
            }
            const std::string& wanted = file->spec.empty() ? file->member : file->spec;
            const auto [entry, is_new] = index.emplace(wanted, page_.lightless.size());
            if (is_new)
                page_.lightless.push_back(
                    {.wanted = wanted,
                     .why = !fixture.type ? file->member.empty() ? "is not in the plot" : "cannot be read"
                            : is_dark     ? "gives no light"
                            : by_hand     ? "says nothing of its light: hands alone light a stand-in"
                                          : "says nothing of its light: a beam is assumed",
                     .is_dark = is_dark,
                     .fixtures = {},
                     .stand_ins = {}});
            page_.lightless[entry->second].fixtures.push_back(i);
        }
        std::stable_sort(page_.lightless.begin(), page_.lightless.end(),
                         [](const LightlessType& a, const LightlessType& b) {
                             return a.is_dark != b.is_dark ? a.is_dark
                                                           : a.fixtures.size() > b.fixtures.size();
                         });
        for (std::size_t k = 0; k < std::min(page_.lightless.size(), kMostSuggestions); ++k)
            suggest(page_.lightless[k]);
    }

    void suggest(LightlessType& lightless) {
        const std::size_t first = lightless.fixtures.front();
        const std::string own = std::filesystem::path(lightless.wanted).filename().string();
        const WantedFixture wanted{own, entries_[first].mode, spacing_of(entries_, lightless.fixtures)};
        const auto likest = suggest_substitute(wanted, offers_.names, [&](std::size_t k) {
            const auto type = offers_.files[k].filename() == own ? nullptr : load(k);
            const bool is_lit =
                type && std::any_of(type->modes.begin(), type->modes.end(),
                                    [&](const auto& mode) { return !is_dark_by_desk(*type, mode); });
            return is_lit ? type : nullptr;
        });
        if (likest) {
            const std::filesystem::path& file = offers_.files[likest->offer];
            lightless.stand_ins.push_back({file.filename().string() + length_words(likest->channels), file,
                                           likest->mode, likest->likeness >= kSameFixture});
        }
        std::vector<std::pair<int, const GeneralLamp*>> general;
        for (const GeneralLamp& lamp : kGeneral) {
            int shared = 0;
            for (const std::string_view word : lamp.words) {
                // A WashBeam is a wash.
                const bool is_kind = std::find(kKinds.begin(), kKinds.end(), word) != kKinds.end();
                shared += lower(own).find(word) == std::string::npos ? 0 : is_kind ? 2 : 1;
            }
            general.push_back({shared, &lamp});
        }
        std::stable_sort(general.begin(), general.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        for (const auto& [shared, lamp] : general) add_general(*lamp, wanted, lightless);
    }

    void add_general(const GeneralLamp& lamp, const WantedFixture& wanted, LightlessType& lightless) {
        const auto at = std::find_if(offers_.files.begin(), offers_.files.end(),
                                     [&](const auto& file) { return file.filename() == lamp.file; });
        if (at == offers_.files.end()) return;
        const auto type = load(static_cast<std::size_t>(at - offers_.files.begin()));
        if (!type || type->modes.empty()) return;
        const int fits = wanted.channels > 0 ? mode_of_length(*type, wanted.channels) : -1;
        const fixture::Mode& mode = type->modes[static_cast<std::size_t>(std::max(fits, 0))];
        const int channels = mode.footprint.empty() ? 0 : mode.footprint.front();
        lightless.stand_ins.push_back({lamp.label + length_words(channels), *at, mode.name, false});
    }

    static std::string length_words(int channels) { return " (" + std::to_string(channels) + " ch)"; }

    std::shared_ptr<const fixture::Type> load(std::size_t k) {
        const auto [entry, is_new] = loaded_.try_emplace(k);
        if (is_new) entry->second = offers_.load(k);
        return entry->second;
    }

    Numbers fixtures_of(const Finding& finding) const {
        Numbers numbers;
        for (const std::string* const text : {&finding.where, &finding.what})
            for (const std::string& name : quoted_in(*text))
                if (const auto found = by_name_.find(name); found != by_name_.end())
                    numbers.insert(found->second.begin(), found->second.end());
        // Its sentence names the first few.
        for (std::size_t i = 0; finding.kind == "unpatched" && i < show_.fixtures.size(); ++i)
            if (show_.fixtures[i].address == 0) numbers.insert(i);
        return numbers;
    }

    void add(const Finding& finding) {
        const auto [entry, is_new] = groups_.emplace(
            std::pair{static_cast<int>(finding.severity), title_of(finding.kind)}, page_.groups.size());
        if (is_new)
            page_.groups.push_back({.severity = finding.severity,
                                    .kind = finding.kind,
                                    .title = entry->first.second,
                                    .times = 0,
                                    .lines = {},
                                    .fixtures = {}});
        PageGroup& group = page_.groups[entry->second];
        group.times += finding.is_sum ? 1 : std::max(finding.times, 1);
        if (group.lines.size() >= kMostPageLines) return;
        const Numbers numbers = fixtures_of(finding);
        const Place place = split_where(finding.where);
        std::string words = finding.what;
        if (!place.element.empty()) words = place.element + ": " + words;
        group.lines.push_back({words, finding.advice, {numbers.begin(), numbers.end()}});
        Numbers all(group.fixtures.begin(), group.fixtures.end());
        all.insert(numbers.begin(), numbers.end());
        group.fixtures.assign(all.begin(), all.end());
    }

    const Show& show_;
    const FixtureOffers& offers_;
    std::vector<PatchEntry> entries_;
    std::map<std::string, Numbers> by_name_; // names of fixtures, and of their files
    std::map<std::string, const PlotObject*> objects_;
    std::map<std::size_t, std::shared_ptr<const fixture::Type>> loaded_;
    std::map<std::pair<int, std::string>, std::size_t> groups_;
    PlotPage page_;
};

} // namespace

int PlotPage::count(Severity severity) const {
    int times = 0;
    for (const PageGroup& group : groups)
        if (group.severity == severity) times += group.times;
    return times;
}

bool PlotPage::matters() const {
    static const std::set<std::string> kOfThePatch{"overlap", "unpatched", "past_512", "wrong_mode_length",
                                                   "guessed_fixture_file"};
    return !lightless.empty() || std::any_of(groups.begin(), groups.end(), [](const PageGroup& group) {
        return group.severity == Severity::error ||
               (group.severity == Severity::warning && kOfThePatch.contains(group.kind));
    });
}

PlotPage plot_page(const Show& show, const std::vector<Finding>& findings, const FixtureOffers& offers) {
    return Maker(show, offers).page(findings);
}

std::string text_of(const PlotPage& page) {
    std::string text = "What '" + page.name + "' has\n\nFound\n";
    for (const PageLine& line : page.found) text += "  " + line.words + "\n";
    if (!page.lightless.empty()) text += "\nNo light of their own\n";
    for (const LightlessType& one : page.lightless) {
        text +=
            "  " + counted(one.fixtures.size(), "head", "heads") + ": '" + one.wanted + "' " + one.why + "\n";
        if (!one.stand_ins.empty())
            text += "    could stand in: " + one.stand_ins.front().label + ", mode '" +
                    one.stand_ins.front().mode + "'\n";
    }
    for (const auto& [severity, title] : {std::pair{Severity::error, "Missing"},
                                          {Severity::warning, "Guessed or repaired"},
                                          {Severity::note, "Odd, but nothing is lost"}}) {
        if (page.count(severity) == 0) continue;
        text += std::string("\n") + title + "\n";
        for (const PageGroup& group : page.groups) {
            if (group.severity != severity) continue;
            text += "  " + group.title + ": " + std::to_string(group.times) + "\n";
            for (const PageLine& line : group.lines) {
                text += "    " + line.words + "\n";
                if (!line.advice.empty()) text += "      do: " + line.advice + "\n";
            }
        }
    }
    return text;
}

} // namespace ghost::scene
