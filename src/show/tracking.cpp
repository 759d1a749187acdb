// SPDX-License-Identifier: Apache-2.0
#include "show/tracking.h"

#include "base/suggest.h"
#include "json_xml_toml/toml_reader.h"
#include "show/show.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostUses = 256;
constexpr std::size_t kMostTrackedFixtures = 10'000;
constexpr std::size_t kMostObjects = 1000;
constexpr int kLastTracker = 65535;

// "x", "-z"; false: neither.
bool read_axis(const std::string& text, int& axis, float& sign) {
    sign = text.starts_with('-') ? -1.0f : 1.0f;
    const std::string letter = text.substr(text.starts_with('-') ? 1 : 0);
    if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z') return false;
    axis = letter[0] - 'x';
    return true;
}

void read_axes(TableReader& reader, Tracking& tracking) {
    const auto texts = reader.texts("axes", 3);
    if (!texts) return;
    glm::ivec3 axes{0};
    glm::vec3 signs{1};
    bool good = texts->size() == 3;
    std::array<int, 3> used{};
    for (int k = 0; good && k < 3; ++k) {
        good = read_axis((*texts)[static_cast<std::size_t>(k)], axes[k], signs[k]);
        if (good) good = ++used[static_cast<std::size_t>(axes[k])] == 1;
    }
    if (good) {
        tracking.axes = axes;
        tracking.signs = signs;
    } else {
        reader.problem(Severity::error, "axes",
                       "expected the tracking system's axes that are our X, Y and Z, each once, like [\"x\", "
                       "\"-z\", \"y\"]");
    }
}

} // namespace

Tracking read_tracking(TableReader& top, const std::string& file, Report& report) {
    Tracking tracking;
    if (const toml::table* table = top.table("tracking")) {
        TableReader reader(*table, "[tracking]", file, report);
        read_axes(reader, tracking);
        if (const auto origin = reader.vec3("origin_m", kMaxCoordinate_m)) tracking.origin_m = *origin;
        reader.finish();
    }
    for (const toml::table* table : top.tables("tracker", kMostUses)) {
        TableReader reader(*table, "[[tracker]]", file, report);
        TrackerUse use;
        use.where = file_line(file, reader.line());
        use.id = reader.integer("id", 0, kLastTracker).value_or(-1);
        if (!reader.has("id")) {
            use.name = reader.text("name").value_or("");
            if (use.name.empty())
                reader.missing("id", "the tracker's number, or name = as the tracking system calls it");
        }
        if (const auto offset = reader.vec3("offset_m", kMaxCoordinate_m)) use.offset_m = *offset;
        use.camera = reader.text("camera").value_or("");
        use.fixtures = reader.texts("fixtures", kMostTrackedFixtures).value_or(std::vector<std::string>{});
        use.objects = reader.texts("objects", kMostObjects).value_or(std::vector<std::string>{});
        use.home_m = reader.vec3("home_m", kMaxCoordinate_m);
        if (use.home_m && use.objects.empty())
            reader.problem(Severity::warning, "home_m", "does nothing without objects = a list of names");
        if (use.camera.empty() && use.fixtures.empty() && use.objects.empty())
            reader.missing("camera",
                           "what follows it: camera = a name, fixtures or objects = a list of names");
        reader.finish();
        if (use.id >= 0 || !use.name.empty()) tracking.uses.push_back(std::move(use));
    }
    return tracking;
}

void check_tracking(const Show& show, Report& report) {
    std::vector<std::string> cameras, fixtures;
    Suggestions suggestions;
    for (const Camera& camera : show.cameras) cameras.push_back(camera.name);
    for (const PatchedFixture& fixture : show.fixtures) fixtures.push_back(fixture.name);
    const std::set<std::string_view> known_cameras(cameras.begin(), cameras.end()),
        known_fixtures(fixtures.begin(), fixtures.end());
    const auto check = [&](const TrackerUse& use, const std::string& name, const auto& is_known,
                           const std::vector<std::string>& known, const char* kind) {
        if (!is_known.contains(name))
            report.add(Severity::error, use.where,
                       std::string("[[tracker]] names ") + kind + " '" + name.substr(0, 60) +
                           "', which the show does not have" + suggestions.did_you_mean(name, known));
    };
    for (const TrackerUse& use : show.tracking.uses) {
        if (!use.camera.empty()) check(use, use.camera, known_cameras, cameras, "camera");
        for (const std::string& fixture : use.fixtures)
            check(use, fixture, known_fixtures, fixtures, "fixture");
    }
}

} // namespace ghost::scene
