// SPDX-License-Identifier: Apache-2.0
#include "show_folder/private/show_types.h"

#include "base/name_index.h"
#include "base/suggest.h"
#include "base/text.h"
#include "fixture_files/common/picture_budget.h"
#include "fixture_files/ies_ldt/photometric.h"
#include "fixture_files/load_type.h"
#include "json_xml_toml/toml_reader.h"
#include "light/beam_shape.h"
#include "show_folder/private/made_types.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace ghost::scene {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
    std::error_code code;
    return fs::is_regular_file(path, code);
}

std::string missing_file(const fs::path& path) {
    Suggestions suggestions;
    return missing_file(path, suggestions);
}

std::string missing_file(const fs::path& path, Suggestions& suggestions) {
    constexpr std::size_t kLooked = 1000;
    std::vector<std::string> names;
    std::error_code code;
    if (fs::exists(path, code)) return path.string() + " is not a plain file.";
    if (code && code != std::errc::no_such_file_or_directory)
        return "cannot look for " + path.string() + ": " + code.message() + ".";
    for (fs::directory_iterator entry(path.parent_path(), code), end;
         !code && entry != end && names.size() < kLooked; entry.increment(code))
        names.push_back(entry->path().filename().string());
    const std::string what =
        "no such file " + path.string() + suggestions.did_you_mean(path.filename().string(), names);
    return what + (what.back() == '?' ? "" : ".");
}

namespace {

// Each fixture file once, however many fixtures use it.
class TypeLibrary {
public:
    explicit TypeLibrary(KnownTypes known) : types_(std::move(known)) {}

    std::shared_ptr<const fixture::Type> find(const fs::path& path, const std::string& where,
                                              Report& report) {
        const auto [entry, is_new] = types_.try_emplace(path.lexically_normal());
        if (!is_new) return entry->second;
        if (!is_file(path)) {
            report.add(Severity::error, where, missing_file(path, suggestions_) + " Its fixtures stay dark.");
            return nullptr;
        }
        auto loaded = fixture::load_type(path);
        if (!loaded.ok()) {
            report.add(Severity::error, where, loaded.error().text() + "; its fixtures stay dark");
            return nullptr;
        }
        for (const Message& message : loaded->messages)
            report.add(message.severity, message.where, message.what);
        if (loaded->type.modes.empty()) {
            report.add(Severity::error, where, path.string() + ": has no DMX mode; its fixtures stay dark");
            return nullptr;
        }
        pictures_.take(loaded->type, path.string(), report);
        return entry->second = std::make_shared<const fixture::Type>(std::move(loaded->type));
    }

private:
    KnownTypes types_;
    fixture::PictureBudget pictures_;
    Suggestions suggestions_;
};

// Photometric files that fixtures, or all fixtures of a type, name: each read once.
class ShapeLibrary {
public:
    std::shared_ptr<const BeamShape> find(const fs::path& path, const std::string& where, Report& report) {
        const auto [entry, is_new] = shapes_.try_emplace(path.lexically_normal());
        if (!is_new) return entry->second;
        if (!is_file(path)) {
            report.add(Severity::error, where,
                       missing_file(path, suggestions_) + " The light is that of the fixture's own file.");
            return nullptr;
        }
        auto loaded = fixture::load_photometric(path);
        if (!loaded.ok()) {
            report.add(Severity::error, where,
                       loaded.error().text() + "; the light is that of the fixture's own file");
            return nullptr;
        }
        for (const Message& message : loaded->messages)
            report.add(message.severity, message.where, message.what);
        entry->second = std::make_shared<const BeamShape>(shape_of(loaded->light, path.filename().string()));
        say_lost(*entry->second, path.string(), report);
        return entry->second;
    }

private:
    static void say_lost(const BeamShape& shape, const std::string& path, Report& report) {
        constexpr double kWorthSaying = 0.005;
        const double all_lm = shape.flux_lm + shape.lost_lm;
        if (shape.lost_lm > kWorthSaying * all_lm)
            report.add(Severity::warning, path,
                       std::to_string(std::lround(100.0 * shape.lost_lm / all_lm)) + " % of its " +
                           std::to_string(std::lround(all_lm)) +
                           " lumens leave more than 80 degrees from the axis and are not drawn");
    }

    std::map<fs::path, std::shared_ptr<const BeamShape>> shapes_;
    Suggestions suggestions_;
};

} // namespace

void load_types(ParsedShow& parsed, KnownTypes known, Report& report) {
    const std::string file = parsed.show.file.string();
    TypeLibrary library(std::move(known));
    Suggestions suggestions;
    for (std::size_t k = 0; k < parsed.show.fixtures.size(); ++k) {
        PatchedFixture& fixture = parsed.show.fixtures[k];
        const FixtureSource& source = parsed.sources[k];
        if (fixture.gdtf.empty()) {
            fixture.type = type_without_file(fixture);
            continue;
        }
        fixture.type =
            library.find(parsed.show.folder / fixture.gdtf, file_line(file, source.gdtf_line), report);
        if (!fixture.type) continue;
        const auto mode = fixture::find_mode(*fixture.type, source.mode, suggestions);
        fixture.is_mode_known = mode.ok() && (!source.mode.empty() || fixture.type->modes.size() == 1);
        if (mode.ok())
            fixture.mode = *mode;
        else
            report.add(Severity::error, file_line(file, source.mode_line),
                       "[[fixture]] '" + fixture.name + "' " + mode.error().what + "; it gets '" +
                           fixture.type->modes.front().name + "'");
    }
}

void load_shapes(ParsedShow& parsed, Report& report) {
    ShapeLibrary library;
    Show& show = parsed.show;
    const std::string file = show.file.string();
    std::vector<bool> was_used(parsed.photometry.size(), false);
    std::vector<std::string> specs;
    for (const PhotometryEntry& entry : parsed.photometry) specs.push_back(lower(entry.spec));
    std::uint64_t steps = kMostMatchSteps;
    for (std::size_t k = 0; k < show.fixtures.size(); ++k) {
        PatchedFixture& fixture = show.fixtures[k];
        fs::path path = k < parsed.sources.size() ? parsed.sources[k].photometry : fs::path{};
        std::string where = path.empty() ? "" : file_line(file, parsed.sources[k].photometry_line);
        const std::string of_fixture = lower(fixture.gdtf.filename().string());
        for (std::size_t e = 0; e < parsed.photometry.size(); ++e) {
            const PhotometryEntry& entry = parsed.photometry[e];
            if (!matches(specs[e], of_fixture, steps)) continue;
            was_used[e] = true;
            if (!path.empty()) continue; // the fixture's own, or the first that fits
            path = entry.file;
            where = entry.where;
        }
        if (path.empty()) continue;
        if (fixture.wall || fixture.projector)
            report.add(Severity::warning, where,
                       "'" + fixture.name + "' shows a picture: its photometry is not used");
        else
            fixture.shape = library.find(show.folder / path, where, report);
    }
    if (steps == 0)
        return report.add(Severity::error, parsed.photometry.front().where,
                          std::string("[[photometry]] ") + kMatchStepsSpent);
    for (std::size_t e = 0; e < parsed.photometry.size(); ++e)
        if (!was_used[e])
            report.add(Severity::warning, parsed.photometry[e].where,
                       "[[photometry]] for: no fixture is of a file '" +
                           parsed.photometry[e].spec.substr(0, 60) + "'");
}

} // namespace ghost::scene
