// SPDX-License-Identifier: Apache-2.0
// check FILE...: the import doctor. What a fixture file or a show would lose, and where.
#include "app/commands.h"

#include "dmx/recording.h"
#include "fixture/load_type.h"
#include "scene/passes.h"
#include "scene/show.h"
#include "scene/stage_checks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using scene::Severity;

struct Options {
    std::vector<std::string> files;
    bool json = false;
    bool quiet = false;
};

struct Checked {
    scene::Report report;
    std::string summary; // one line
    nlohmann::json facts = nlohmann::json::object();
};

const char* name_of(Severity severity) {
    switch (severity) {
    case Severity::note:
        return "note";
    case Severity::warning:
        return "warning";
    case Severity::error:
        return "error";
    }
    return "error";
}

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

std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

Checked check_type(const fs::path& path) {
    Checked result;
    const auto loaded = fixture::load_type(path);
    if (!loaded.ok()) {
        result.report.add(Severity::error, loaded.error().where, loaded.error().what);
        return result;
    }
    for (const fixture::Message& message : loaded->messages)
        result.report.add(severity_of(message.severity), message.where, message.what);
    const fixture::Type& type = loaded->type;
    result.facts["manufacturer"] = type.manufacturer;
    result.facts["name"] = type.name;
    result.facts["modes"] = nlohmann::json::array();
    result.facts["wheels"] = nlohmann::json::array();
    result.summary = type.manufacturer + " " + type.name + ": " + counted(type.modes.size(), "mode");
    for (const fixture::Mode& mode : type.modes) {
        int channels = 0;
        for (const int bytes : mode.footprint) channels += bytes;
        result.facts["modes"].push_back(
            {{"name", mode.name}, {"channels", channels}, {"beams", mode.beams.size()}});
        result.summary += (mode.name == type.modes.front().name ? " (" : ", ") + std::string("'") +
                          mode.name + "' " + counted(static_cast<std::size_t>(channels), "channel");
    }
    result.summary +=
        (type.modes.empty() ? "" : ")") + std::string(", ") + counted(type.wheels.size(), "wheel");
    for (const fixture::Wheel& wheel : type.wheels) {
        result.facts["wheels"].push_back({{"name", wheel.name}, {"slots", wheel.slots.size()}});
        result.summary += (&wheel == &type.wheels.front() ? " (" : ", ") + std::string("'") + wheel.name +
                          "' " + counted(wheel.slots.size(), "slot");
    }
    if (!type.wheels.empty()) result.summary += ")";
    return result;
}

Checked check_show(const fs::path& path) {
    Checked result;
    const auto show = scene::load_show(path, true, result.report);
    if (!show.ok()) {
        result.report.add(Severity::error, show.error().where, show.error().what);
        return result;
    }
    const scene::Stage with_bodies = scene::stage_with_bodies(*show, result.report);
    scene::check_places(*show, with_bodies, show->cameras, result.report);
    if (std::error_code code; fs::is_regular_file(show->recording, code)) {
        const auto recording = dmx::read_recording(show->recording);
        if (!recording.ok())
            result.report.add(Severity::error, recording.error().where, recording.error().what);
        if (recording.ok())
            for (const Error& problem : recording->problems)
                result.report.add(Severity::error, problem.where, problem.what);
    }
    for (const scene::Camera& camera : show->cameras) {
        if (camera.foreign_passes.empty()) continue;
        const auto passes = scene::load_foreign_passes(camera.foreign_passes, result.report);
        if (!passes.ok()) result.report.add(Severity::error, passes.error().where, passes.error().what);
    }
    const auto dark = std::count_if(show->fixtures.begin(), show->fixtures.end(),
                                    [](const scene::PatchedFixture& fixture) { return !fixture.type; });
    const scene::Stage& stage = show->stage;
    result.summary =
        "show '" + show->name + "': " + counted(show->fixtures.size(), "fixture") +
        (dark ? " (" + std::to_string(dark) + " dark)" : "") + ", " +
        counted(show->cameras.size(), "camera") + ", stage of " + std::to_string(stage.drawn_triangles()) +
        " triangles (" + std::to_string(stage.stored_triangles()) + " stored), " +
        counted(stage.materials.size(), "material") + ", " + counted(stage.textures.size(), "texture");
    result.facts = {{"name", show->name},
                    {"fixtures", show->fixtures.size()},
                    {"dark_fixtures", dark},
                    {"cameras", show->cameras.size()},
                    {"drawn_triangles", stage.drawn_triangles()},
                    {"stored_triangles", stage.stored_triangles()},
                    {"materials", stage.materials.size()},
                    {"textures", stage.textures.size()}};
    return result;
}

Checked check_file(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    std::error_code code;
    if (fixture::has_type_extension(path)) return check_type(path);
    if (extension == ".toml" || extension == ".mvr" || fs::is_directory(path, code)) return check_show(path);
    Checked result;
    result.report.add(Severity::error, path.string(),
                      fs::exists(path, code)
                          ? "is neither a fixture file (.gdtf, .qxf, .json) nor a show (a show.toml, its folder or an .mvr)"
                          : "no such file");
    return result;
}

nlohmann::json json_of(const std::string& file, const Checked& checked) {
    nlohmann::json messages = nlohmann::json::array();
    for (const scene::Message& message : checked.report.messages)
        messages.push_back(
            {{"severity", name_of(message.severity)}, {"where", message.where}, {"what", message.what}});
    return {{"file", file},
            {"lost", checked.report.lost_anything()},
            {"facts", checked.facts},
            {"messages", messages}};
}

void print(const std::string& file, const Checked& checked, bool quiet) {
    for (const scene::Message& message : checked.report.messages)
        if (!quiet || message.severity == Severity::error)
            std::cout << name_of(message.severity) << ": " << message.where << ": " << message.what << "\n";
    if (quiet) return;
    std::cout << file << ": " << (checked.report.lost_anything() ? "LOSSES" : "ok");
    if (!checked.summary.empty()) std::cout << ", " << checked.summary;
    std::cout << "\n";
}

int run(const Options& options) {
    bool lost = false;
    nlohmann::json all = nlohmann::json::array();
    for (const std::string& file : options.files) {
        const Checked checked = check_file(file);
        lost |= checked.report.lost_anything();
        if (options.json)
            all.push_back(json_of(file, checked));
        else
            print(file, checked, options.quiet);
    }
    // A file may say anything in its names; what is no UTF-8 is replaced, not thrown.
    if (options.json) std::cout << all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
    return lost ? 1 : 0;
}

} // namespace

void add_check(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("check", "What a fixture or show file would lose, and where");
    command->add_option("FILE", options->files, ".gdtf, .qxf and .json fixture files, show.toml files, folders of shows or .mvr plots")
        ->required();
    command->add_flag("--json", options->json, "one JSON list on standard output");
    command->add_flag("--quiet", options->quiet, "print losses only");
    command->footer("Example: ghostlight check assets/demo assets/fixtures/*.gdtf\nExit: 0 nothing lost, 1 "
                    "something was.");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace ghost::app
