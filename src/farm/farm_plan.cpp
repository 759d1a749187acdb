// SPDX-License-Identifier: Apache-2.0
#include "farm/farm_plan.h"

#include "bake/hasher.h"
#include "base/log.h"
#include "disk/files.h"
#include "disk/own_folder.h"
#include "disk/temporary.h"
#include "disk/user_cache.h"
#include "disk/user_file.h"
#include "farm/private/own_plans.h"
#include "json_xml_toml/json.h"
#include "live/session/passes_sources.h"
#include "video/files/film.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kPlanVersion = 1;
constexpr JsonLimits kPlanLimits{.bytes = std::size_t{16} << 20, .values = 20 * kMostFarmTasks};
constexpr JsonLimits kDoneLimits{.bytes = std::size_t{4} << 20};
constexpr long kMostPictures = 24 * 3600 * 240; // that are looked for; a day
constexpr std::uintmax_t kMostProgramBytes = std::uintmax_t{1} << 30;
constexpr std::uintmax_t kMostFailureBytes = 1 << 16;
constexpr std::uintmax_t kMostNameBytes = 64;
constexpr std::size_t kMostForeignFiles = 100'000; // beside passes that another program made
constexpr std::size_t kMostShownOfCommand = 500;
constexpr const char* kPlanFile = "plan.json";
constexpr const char* kNewestFile = "newest";

fs::path farms_of(const scene::Show& show) {
    return show.cache_folder() / "farm";
}

std::vector<std::string> texts_of(const json& list) {
    std::vector<std::string> texts;
    for (const json& text : list) texts.push_back(text.get<std::string>());
    return texts;
}

std::string text_of(const FarmPlan& plan) {
    json tasks = json::array();
    for (const FarmTask& task : plan.tasks)
        tasks.push_back({{"name", task.name},
                         {"stage", task.stage},
                         {"words", task.words},
                         {"first_frame", task.first_frame},
                         {"last_frame", task.last_frame}});
    json also = json::array();
    for (const fs::path& file : plan.also) also.push_back(file.string());
    return json({{"version", kPlanVersion},
                 {"build", plan.build},
                 {"inputs", plan.inputs},
                 {"show", plan.show.string()},
                 {"from", plan.from.string()},
                 {"words", plan.words},
                 {"out", plan.out.string()},
                 {"camera", plan.camera},
                 {"fps", plan.fps},
                 {"also", also},
                 {"tasks", tasks}})
               .dump(1, ' ', false, json::error_handler_t::replace) +
           "\n";
}

std::string text_of(const FarmDone& done) {
    json files = json::object();
    for (const auto& [name, file] : done.files) files[name] = {file.first, file.second};
    return json({{"host", done.host},
                 {"seconds", done.seconds},
                 {"passes", done.passes},
                 {"folder", done.folder},
                 {"lacks_something", done.lacks_something},
                 {"pictures", done.pictures},
                 {"files", files}})
               .dump(-1, ' ', false, json::error_handler_t::replace) +
           "\n";
}

// Throws json::exception where something has another type.
FarmPlan plan_of(const json& all) {
    FarmPlan plan;
    plan.build = all.at("build").get<std::string>();
    plan.inputs = all.at("inputs").get<std::string>();
    plan.show = all.at("show").get<std::string>();
    plan.from = all.at("from").get<std::string>();
    plan.words = texts_of(all.at("words"));
    plan.out = all.at("out").get<std::string>();
    plan.camera = all.at("camera").get<std::string>();
    plan.fps = all.at("fps").get<int>();
    for (const std::string& file : texts_of(all.at("also"))) plan.also.emplace_back(file);
    for (const json& entry : all.at("tasks")) {
        FarmTask& task = plan.tasks.emplace_back();
        task.name = entry.at("name").get<std::string>();
        task.stage = entry.at("stage").get<int>();
        task.words = texts_of(entry.at("words"));
        task.first_frame = entry.at("first_frame").get<long>();
        task.last_frame = entry.at("last_frame").get<long>();
    }
    return plan;
}

// As done_file, failed_file and result_file name them.
bool is_of_a_task(const fs::path& name) {
    const std::string stem = name.stem().string();
    const bool is_number = !stem.empty() && stem.find_first_not_of("0123456789") == std::string::npos;
    return (is_number || stem == "result") && (name.extension() == ".json" || name.extension() == ".txt");
}

std::optional<FarmDone> read_done(const fs::path& file) {
    const auto text = read_text_file(file, kDoneLimits.bytes);
    if (!text.ok()) return std::nullopt;
    const auto all = read_json(*text, file.string(), kDoneLimits);
    if (!all.ok()) return std::nullopt;
    try {
        FarmDone done;
        done.host = all->at("host").get<std::string>();
        done.seconds = all->at("seconds").get<double>();
        done.passes = all->at("passes").get<std::string>();
        done.folder = all->at("folder").get<std::string>();
        done.lacks_something = all->at("lacks_something").get<bool>();
        done.pictures = all->at("pictures").get<long>();
        for (const auto& [name, entry] : all->at("files").items())
            done.files[name] = {entry.at(0).get<std::uintmax_t>(), entry.at(1).get<std::uint32_t>()};
        if (done.folder.find('/') != std::string::npos || done.folder == "..") return std::nullopt;
        return done;
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

} // namespace

std::string number_text(long number) {
    std::string digits = std::to_string(number);
    return "-" + std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits;
}

fs::path FarmPlan::picture_file(long number) const {
    fs::path file = out;
    file.replace_filename(out.stem().string() + number_text(number) + out.extension().string());
    return file;
}

fs::path FarmPlan::done_file(std::size_t task) const {
    return folder / "done" / (std::to_string(task) + ".json");
}

fs::path FarmPlan::failed_file(std::size_t task) const {
    return folder / "failed" / (std::to_string(task) + ".txt");
}

std::string node_name() {
    // Several nodes of a Slurm may be one machine.
    const char* const node = std::getenv("SLURMD_NODENAME");
    return node != nullptr ? node : host_name();
}

Result<std::string> farm_build() {
    TRY(const std::vector<std::uint8_t> program, read_file("/proc/self/exe", kMostProgramBytes));
    bake::Hasher hasher;
    hasher.list(program);
    hasher.text(video::film_encoder());
    return hasher.hex();
}

std::string farm_inputs(const scene::Show& show, const std::vector<fs::path>& also) {
    bake::Hasher hasher;
    hasher.text(passes_fingerprint(show));
    std::vector<fs::path> files = also;
    for (const scene::Media& media : show.media) files.push_back(media.file);
    for (const scene::Camera& camera : show.cameras) {
        if (camera.foreign_passes.empty()) continue;
        std::error_code code;
        std::vector<fs::path> passes;
        for (fs::directory_iterator entry(camera.foreign_passes.parent_path(), code), end;
             !code && entry != end && passes.size() < kMostForeignFiles; entry.increment(code))
            if (entry->is_regular_file(code)) passes.push_back(entry->path());
        std::sort(passes.begin(), passes.end());
        files.insert(files.end(), passes.begin(), passes.end());
    }
    if (!show.sound.file.empty()) {
        files.push_back(show.sound.file);
        hasher.value(show.sound.offset_s);
    }
    for (const fs::path& file : files) { // may be long
        std::error_code code;
        hasher.text(file.filename().string());
        hasher.value(fs::file_size(file, code));
        hasher.value(fs::last_write_time(file, code).time_since_epoch().count());
    }
    return hasher.hex();
}

fs::path home_of(const FarmPlan& plan) {
    fs::path home = plan.folder;
    while (home.has_relative_path() && home.filename() != ".ghost" && home.filename() != "ghostlight")
        home = home.parent_path();
    return home.parent_path();
}

Result<void> make_plan_folders(const FarmPlan& plan) {
    for (const char* const name : {"done", "failed", "frames", "log"})
        TRY_VOID(make_folders(plan.folder / name, home_of(plan)));
    return {};
}

Result<void> forget_of_tasks(const FarmPlan& plan, const char* folder) {
    TRY(const OwnFolder own, OwnFolder::open(plan.folder / folder, home_of(plan)));
    for (const OwnFolder::File& file : own.entries().files)
        if (is_of_a_task(file.name)) own.remove_file(file.name);
    return {};
}

Result<void> remove_pictures(const FarmPlan& plan) {
    TRY(const OwnFolder frames, OwnFolder::open(plan.folder / "frames", home_of(plan)));
    for (const std::string& name : frames.entries().folders) {
        TRY(const OwnFolder pictures, frames.below(name));
        for (const OwnFolder::File& file : pictures.entries().files) pictures.remove_file(file.name);
        frames.remove_empty_folder(name);
    }
    return {};
}

Result<void> store_plan(FarmPlan& plan, const scene::Show& show) {
    bake::Hasher hasher;
    const std::string text = text_of(plan);
    hasher.text(text);
    std::error_code code;
    plan.folder = fs::absolute(farms_of(show), code) / hasher.hex().substr(0, 12);
    TRY_VOID(make_folders(plan.folder, fs::absolute(show.cache_home(), code)));
    TRY_VOID(make_plan_folders(plan));
    TRY_VOID(write_file_atomic(plan.folder / kPlanFile, text));
    plan.is_ours = true;
    if (const Result<void> noted = note_as_ours(plan.folder / kPlanFile, text); !noted.ok())
        log_warning(noted.error().text() + "; ghostlight farm retry will ask for --trust");
    return write_file_atomic(plan.folder.parent_path() / kNewestFile, plan.folder.filename().string());
}

Result<FarmPlan> read_plan(const fs::path& folder) {
    const fs::path file = folder / kPlanFile;
    std::error_code code;
    if (!fs::exists(file, code))
        return Error{"no plan lies here; every machine of a farm must see the show's folder under this path",
                     file.string()};
    TRY(const std::string text, read_text_file(file, kPlanLimits.bytes));
    TRY(const json all, read_json(text, file.string(), kPlanLimits));
    try {
        if (all.at("version") != kPlanVersion)
            return Error{"is of another version of Ghostlight; start the command again", file.string()};
        FarmPlan plan = plan_of(all);
        plan.folder = folder;
        plan.is_ours = is_noted_as_ours(file, text);
        const bool is_right = !plan.words.empty() && (plan.words[0] == "bake" || plan.words[0] == "render") &&
                              plan.tasks.size() <= kMostFarmTasks &&
                              (!plan.is_film() || (plan.fps > 0 && plan.fps <= 240));
        if (!is_right) return Error{"is no plan; start the command again", file.string()};
        return plan;
    } catch (const json::exception&) {
        return Error{"is no plan; start the command again", file.string()};
    }
}

Result<FarmPlan> find_plan(const std::string& name) {
    std::error_code code;
    const fs::path given = fs::absolute(name, code).lexically_normal();
    if (fs::exists(given / kPlanFile, code)) return read_plan(given);
    scene::Show show; // only where it keeps things
    const bool is_folder = fs::is_directory(given, code);
    if (!is_folder && !fs::exists(given, code)) return Error{"no such show, and no plan of a farm", name};
    show.folder = is_folder ? given : given.parent_path();
    if (show.folder.filename().empty()) show.folder = show.folder.parent_path();
    if (!is_folder && given.extension() == ".mvr") show.cache_name = given.filename().string();
    show.user_cache = user_cache_for(show.folder);
    // By name, for the clocks of those who wrote them may differ.
    const fs::path file = farms_of(show) / kNewestFile;
    if (!fs::exists(file, code))
        return Error{"nothing of it was given to a farm; ghostlight bake or render with --farm does", name};
    TRY(const std::string newest, read_text_file(file, kMostNameBytes));
    if (newest.empty() || newest.find_first_not_of("0123456789abcdef") != std::string::npos)
        return Error{"is not the name of a plan; start the command again", file.string()};
    return read_plan(farms_of(show) / newest);
}

std::optional<FarmDone> done_of(const FarmPlan& plan, std::size_t task) {
    auto done = read_done(plan.done_file(task));
    if (!done || (!done->folder.empty() && !done->folder.starts_with(std::to_string(task) + ".")))
        return std::nullopt;
    std::error_code code;
    for (const auto& [name, file] : done->files)
        if (fs::file_size(plan.folder / "frames" / done->folder / name, code) != file.first || code)
            return std::nullopt;
    return done;
}

std::vector<std::size_t> missing_tasks(const FarmPlan& plan) {
    std::vector<std::size_t> missing;
    if (has_result(plan)) return missing;
    for (std::size_t task = 0; task < plan.tasks.size(); ++task)
        if (!done_of(plan, task)) missing.push_back(task);
    return missing;
}

Result<bool> store_done(const FarmPlan& plan, std::size_t task, const FarmDone& done) {
    const fs::path file = plan.done_file(task);
    std::error_code code;
    // What it speaks of is gone.
    if (fs::exists(file, code) && !done_of(plan, task)) fs::remove(file, code);
    const fs::path temporary = temporary_beside(file);
    TRY_VOID(write_file_atomic(temporary, text_of(done)));
    const Result<bool> is_first = commit_new(temporary, file);
    if (!is_first.ok() || !*is_first) fs::remove(temporary, code);
    return is_first;
}

Result<void> store_result(const FarmPlan& plan, const FarmDone& result) {
    return write_file_atomic(plan.result_file(), text_of(result));
}

bool result_lacks_something(const FarmPlan& plan) {
    const auto result = read_done(plan.result_file());
    return result && result->lacks_something;
}

bool has_result(const FarmPlan& plan) {
    const auto result = read_done(plan.result_file());
    if (!result) return false;
    std::error_code code;
    for (const auto& [name, file] : result->files)
        if (fs::file_size(plan.out.parent_path() / name, code) != file.first || code) return false;
    for (long number = 0; number < std::min(result->pictures, kMostPictures); ++number)
        if (fs::file_size(plan.picture_file(number), code) == 0 || code) return false;
    return true;
}

Result<void> check_ours(const FarmPlan& plan) {
    if (plan.is_ours || plan.is_trusted) return {};
    std::string command = "ghostlight";
    for (const std::string& word : plan.words) command += " " + word;
    if (command.size() > kMostShownOfCommand) command.replace(kMostShownOfCommand, std::string::npos, "..");
    return Error{"you did not make this plan here, and it may have come with the show: it runs '" + command +
                     "'" + (plan.is_film() ? " and writes " + plan.out.string() : "") +
                     "; start the command again, or say --trust if it is yours",
                 plan.folder.string()};
}

std::string failure_of(const FarmPlan& plan, std::size_t task) {
    const auto text = read_text_file(plan.failed_file(task), kMostFailureBytes);
    if (!text.ok()) return {};
    std::string all = *text;
    for (;;) {
        while (!all.empty() && all.back() == '\n') all.pop_back();
        const std::size_t line = all.rfind('\n') + 1; // 0 where there is one line
        const std::string last = all.substr(line);
        if (last.empty()) return "failed without a word";
        if (line == 0 || !last.starts_with("Run with --help")) return last; // says nothing of what is wrong
        all.resize(line);
    }
}

} // namespace ghost::app
