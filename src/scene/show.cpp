// SPDX-License-Identifier: Apache-2.0
#include "scene/show.h"

#include "base/files.h"
#include "base/suggest.h"
#include "fixture/load_type.h"
#include "fixture/patch.h"
#include "scene/show_toml.h"
#include "scene/toml_reader.h"

#include <map>
#include <utility>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxShowBytes = std::uintmax_t{16} << 20;

Severity severity_of(fixture::Severity severity) {
    switch (severity) {
    case fixture::Severity::note:
        return Severity::note;
    case fixture::Severity::warning:
        return Severity::warning;
    case fixture::Severity::lost:
        return Severity::error;
    }
    return Severity::error;
}

bool is_file(const fs::path& path) {
    std::error_code code;
    return fs::is_regular_file(path, code);
}

// "no such file x.glb, did you mean 'y.glb'?"
std::string missing_file(const fs::path& path) {
    constexpr std::size_t kLooked = 1000;
    std::vector<std::string> names;
    std::error_code code;
    if (fs::exists(path, code)) return path.string() + " is not a plain file.";
    if (code && code != std::errc::no_such_file_or_directory)
        return "cannot look for " + path.string() + ": " + code.message() + ".";
    for (fs::directory_iterator entry(path.parent_path(), code), end;
         !code && entry != end && names.size() < kLooked; entry.increment(code))
        names.push_back(entry->path().filename().string());
    const std::string what = "no such file " + path.string() + did_you_mean(path.filename().string(), names);
    return what + (what.back() == '?' ? "" : ".");
}

// Each fixture file once, however many fixtures use it.
class TypeLibrary {
public:
    std::shared_ptr<const fixture::Type> find(const fs::path& path, const std::string& where,
                                              Report& report) {
        const auto [entry, is_new] = types_.try_emplace(path.lexically_normal());
        if (!is_new) return entry->second;
        if (!is_file(path)) {
            report.add(Severity::error, where, missing_file(path) + " Its fixtures stay dark.");
            return nullptr;
        }
        auto loaded = fixture::load_type(path);
        if (!loaded.ok()) {
            report.add(Severity::error, where, loaded.error().text() + "; its fixtures stay dark");
            return nullptr;
        }
        for (const fixture::Message& message : loaded->messages)
            report.add(severity_of(message.severity), message.where, message.what);
        if (loaded->type.modes.empty()) {
            report.add(Severity::error, where, path.string() + ": has no DMX mode; its fixtures stay dark");
            return nullptr;
        }
        return entry->second = std::make_shared<const fixture::Type>(std::move(loaded->type));
    }

private:
    std::map<fs::path, std::shared_ptr<const fixture::Type>> types_;
};

void load_types(ParsedShow& parsed, const std::string& file, Report& report) {
    TypeLibrary library;
    for (std::size_t k = 0; k < parsed.show.fixtures.size(); ++k) {
        PatchedFixture& fixture = parsed.show.fixtures[k];
        const FixtureSource& source = parsed.sources[k];
        if (fixture.gdtf.empty()) continue;
        fixture.type =
            library.find(parsed.show.folder / fixture.gdtf, file_line(file, source.gdtf_line), report);
        if (!fixture.type) continue;
        const auto mode = fixture::find_mode(*fixture.type, source.mode);
        if (mode.ok())
            fixture.mode = *mode;
        else
            report.add(Severity::error, file_line(file, source.mode_line),
                       "[[fixture]] '" + fixture.name + "' " + mode.error().what + "; it gets '" +
                           fixture.type->modes.front().name + "'");
    }
}

// The two channels of a track, seen as a fixture.
const fixture::Type& track_type() {
    static const fixture::Type type = [] {
        fixture::Type made;
        made.modes.emplace_back();
        made.modes.back().footprint = {2};
        return made;
    }();
    return type;
}

void check_addresses(const ParsedShow& parsed, const std::string& file, Report& report) {
    std::vector<fixture::Patch> patches;
    std::vector<int> lines;
    for (std::size_t k = 0; k < parsed.show.fixtures.size(); ++k) {
        const PatchedFixture& fixture = parsed.show.fixtures[k];
        if (fixture.type && fixture.address > 0) {
            patches.push_back(
                {fixture.name, fixture.type.get(), fixture.mode, {{fixture.universe, fixture.address}}});
            lines.push_back(parsed.sources[k].address_line);
            for (const std::string& problem : fixture::check_patch(patches.back()))
                report.add(Severity::warning, file_line(file, lines.back()),
                           "[[fixture]] '" + fixture.name + "' " + problem);
        }
        if (fixture.track) {
            patches.push_back({fixture.name + "' track '",
                               &track_type(),
                               0,
                               {{fixture.track->universe, fixture.track->address}}});
            lines.push_back(parsed.sources[k].track_line);
        }
    }
    for (const fixture::Overlap& overlap : fixture::find_overlaps(patches)) {
        const fixture::Patch& first = patches[overlap.first];
        const fixture::Patch& second = patches[overlap.second];
        const bool same = first.type == second.type && first.mode == second.mode &&
                          first.addresses[0].universe == second.addresses[0].universe &&
                          first.addresses[0].channel == second.addresses[0].channel;
        report.add(same ? Severity::warning : Severity::error, file_line(file, lines[overlap.second]),
                   "'" + second.name + "' shares universe " + std::to_string(overlap.universe) +
                       " channels " + std::to_string(overlap.channel_from) + " to " +
                       std::to_string(overlap.channel_to) + " with '" + first.name + "' (line " +
                       std::to_string(lines[overlap.first]) + ")" +
                       (same ? "; they will do the same" : ", expected channels of its own"));
    }
}

void check_files(const ParsedShow& parsed, const std::string& file, Report& report) {
    const Show& show = parsed.show;
    if (!show.recording.empty() && !is_file(show.recording))
        report.add(Severity::error, file_line(file, parsed.recording_line),
                   "[show] recording: " + missing_file(show.recording));
    if (!show.stage_file.empty() && !is_file(show.stage_file))
        report.add(Severity::error, file_line(file, parsed.stage_line),
                   "[show] stage: " + missing_file(show.stage_file) + " The stage is empty.");
    for (std::size_t k = 0; k < show.cameras.size(); ++k)
        if (const Camera& camera = show.cameras[k];
            !camera.foreign_passes.empty() && !is_file(camera.foreign_passes))
            report.add(Severity::error, file_line(file, parsed.passes_lines[k]),
                       "[[camera]] '" + camera.name +
                           "' foreign_passes: " + missing_file(camera.foreign_passes));
}

} // namespace

Result<std::size_t> Show::find_camera(const std::string& camera_name) const {
    if (cameras.empty()) return Error{"has no camera", file.string()};
    if (camera_name.empty()) return std::size_t{0};
    std::vector<std::string> names;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        if (cameras[k].name == camera_name) return k;
        names.push_back(cameras[k].name);
    }
    std::string what =
        "has no camera '" + camera_name + "'" + did_you_mean(camera_name, names) + " (cameras:";
    for (std::size_t k = 0; k < names.size() && k < 20; ++k) what += (k ? ", '" : " '") + names[k] + "'";
    return Error{what + ")", file.string()};
}

Result<Show> load_show(const fs::path& path, bool load_stage, Report& report) {
    std::error_code code;
    const fs::path file = fs::is_directory(path, code) ? path / "show.toml" : path;
    TRY(const std::string text, read_text_file(file, kMaxShowBytes));
    TRY(ParsedShow parsed, parse_show(text, file, report));
    load_types(parsed, file.string(), report);
    check_addresses(parsed, file.string(), report);
    check_files(parsed, file.string(), report);
    if (load_stage && is_file(parsed.show.stage_file)) {
        auto stage = load_stage_file(parsed.show.stage_file, report);
        if (stage.ok())
            parsed.show.stage = std::move(*stage);
        else
            report.add(Severity::error, file_line(file.string(), parsed.stage_line),
                       stage.error().text() + "; the stage is empty");
    }
    return std::move(parsed.show);
}

} // namespace ghost::scene
