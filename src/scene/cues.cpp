// SPDX-License-Identifier: Apache-2.0
#include "scene/cues.h"

#include "base/suggest.h"
#include "scene/scene_toml.h"
#include "scene/show.h"
#include "scene/toml_reader.h"

#include <algorithm>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostCues = 10'000;
constexpr double kLatest_s = 366.0 * 86400.0;
constexpr double kLongestFlight_s = 60;

} // namespace

std::vector<Cue> read_cues(TableReader& top, const std::string& file, Report& report) {
    std::vector<Cue> cues;
    for (const toml::table* table : top.tables("cue", kMostCues)) {
        TableReader reader(*table, "[[cue]]", file, report);
        Cue cue;
        cue.where = file_line(file, reader.line());
        cue.name = reader.text("name").value_or("");
        cue.at_s = reader.number("at_s", 0, kLatest_s);
        cue.camera = reader.text("camera").value_or("");
        if (const auto flight_s = reader.number("flight_s", 0, kLongestFlight_s))
            cue.flight_s = static_cast<float>(*flight_s);
        if (cue.name.empty()) reader.missing("name", "what a remote control calls it");
        if (!cue.at_s && cue.camera.empty())
            reader.missing("at_s", "where it goes: at_s = a second of the recording, or camera = a name");
        const bool known =
            std::any_of(cues.begin(), cues.end(), [&](const Cue& other) { return other.name == cue.name; });
        if (known)
            reader.problem(Severity::error, "name", "is that of another cue; the first one is called by it");
        reader.finish();
        if (!cue.name.empty() && !known) cues.push_back(std::move(cue));
    }
    return cues;
}

void check_cues(const Show& show, Report& report) {
    std::vector<std::string> cameras;
    for (const Camera& camera : show.cameras) cameras.push_back(camera.name);
    Suggestions suggestions;
    for (const Cue& cue : show.cues)
        if (!cue.camera.empty() && std::find(cameras.begin(), cameras.end(), cue.camera) == cameras.end())
            report.add(Severity::error, cue.where,
                       "[[cue]] names camera '" + cue.camera.substr(0, 60) +
                           "', which the show does not have" + suggestions.did_you_mean(cue.camera, cameras));
}

} // namespace ghost::scene
