// SPDX-License-Identifier: Apache-2.0
#include "show/cues.h"

#include "base/suggest.h"
#include "json_xml_toml/toml_reader.h"
#include "show/looks.h"
#include "show/show.h"

#include <algorithm>
#include <set>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostCues = 10'000;
constexpr double kLatest_s = 366.0 * 86400.0;
constexpr double kLongestFlight_s = 60;
constexpr double kLongestFollow_s = 86400;

std::optional<float> seconds_of(TableReader& reader, const std::string& key, double most_s) {
    const auto seconds = reader.number(key, 0, most_s);
    return seconds ? std::optional(static_cast<float>(*seconds)) : std::nullopt;
}

void check_name(const Cue& cue, const std::string& what, const std::string& name,
                const std::vector<std::string>& names, Suggestions& suggestions, Report& report) {
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    report.add(Severity::error, cue.where,
               "[[cue]] names " + what + " '" + name.substr(0, 60) + "', which the show does not have" +
                   suggestions.did_you_mean(name, names));
}

} // namespace

std::vector<Cue> read_cues(TableReader& top, const std::string& file, Report& report) {
    std::vector<Cue> cues;
    std::set<std::string> names;
    for (const toml::table* table : top.tables("cue", kMostCues)) {
        TableReader reader(*table, "[[cue]]", file, report);
        Cue cue;
        cue.where = file_line(file, reader.line());
        cue.name = reader.text("name").value_or("");
        cue.number = reader.text("number").value_or("");
        cue.page = reader.text("page").value_or("");
        cue.at_s = reader.number("at_s", 0, kLatest_s);
        cue.camera = reader.text("camera").value_or("");
        cue.flight_s = seconds_of(reader, "flight_s", kLongestFlight_s).value_or(0);
        cue.look = reader.text("look").value_or("");
        cue.fade_s = seconds_of(reader, "fade_s", kLongestFade_s);
        cue.follow_s = seconds_of(reader, "follow_s", kLongestFollow_s);
        cue.notes = reader.text("notes").value_or("");
        if (cue.name.empty()) reader.missing("name", "what it is called by");
        if (!cue.at_s && cue.camera.empty() && cue.look.empty())
            reader.missing("at_s", "where it goes: at_s = a second of the recording, camera = a name, or "
                                   "look = a name");
        const bool known = !cue.name.empty() && !names.insert(cue.name).second;
        if (known)
            reader.problem(Severity::error, "name", "is that of another cue; the first one is called by it");
        reader.finish();
        if (!cue.name.empty() && !known) cues.push_back(std::move(cue));
    }
    return cues;
}

void check_cues(const Show& show, Report& report) {
    std::vector<std::string> cameras, looks;
    for (const Camera& camera : show.cameras) cameras.push_back(camera.name);
    const bool asks_for_looks =
        std::any_of(show.cues.begin(), show.cues.end(), [](const Cue& cue) { return !cue.look.empty(); });
    if (asks_for_looks) {
        Report unsaid; // whoever takes the looks says what is wrong with them
        if (const auto stored = load_looks(looks_file(show), unsaid); stored.ok())
            for (const StoredLook& look : *stored) looks.push_back(look.name);
    }
    Suggestions suggestions;
    for (const Cue& cue : show.cues) {
        check_name(cue, "camera", cue.camera, cameras, suggestions, report);
        check_name(cue, "look", cue.look, looks, suggestions, report);
    }
}

} // namespace ghost::scene
