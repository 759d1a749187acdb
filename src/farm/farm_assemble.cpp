// SPDX-License-Identifier: Apache-2.0
#include "farm/farm_task.h"

#include "base/child.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "disk/crc32.h"
#include "disk/files.h"
#include "disk/own_program.h"
#include "live/session/film_sound.h"
#include "show/show.h"
#include "show_folder/load_show.h"
#include "video/files/film.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

// Shared folders show for so long what was there before.
constexpr auto kPatience = std::chrono::seconds(60);
constexpr auto kBetweenRecounts = std::chrono::seconds(2);
constexpr std::size_t kMostNamed = 5;

Result<void> check_whole(const FarmPlan& plan) {
    const auto begun = std::chrono::steady_clock::now();
    for (;;) {
        std::vector<std::size_t> missing;
        bool may_come = std::getenv("SLURM_JOB_ID") != nullptr;
        for (std::size_t task = 0; task < plan.tasks.size(); ++task) {
            if (done_of(plan, task)) continue;
            missing.push_back(task);
            may_come = may_come && failure_of(plan, task).empty();
        }
        if (missing.empty()) return {};
        if (may_come && std::chrono::steady_clock::now() - begun < kPatience && !interrupted()) {
            std::this_thread::sleep_for(kBetweenRecounts);
            continue;
        }
        std::string names, why;
        for (std::size_t k = 0; k < missing.size() && k < kMostNamed; ++k)
            names += (k > 0 ? ", " : "") + plan.tasks[missing[k]].name;
        if (missing.size() > kMostNamed) names += " and more";
        for (const std::size_t task : missing)
            if (why.empty()) why = failure_of(plan, task);
        return Error{std::to_string(missing.size()) + " of " + std::to_string(plan.tasks.size()) +
                         " tasks are missing: " + names +
                         (why.empty() ? "" : "; the first that failed said: " + why) +
                         "; ghostlight farm retry makes what is missing",
                     plan.folder.string()};
    }
}

// What a task left is made again.
Error damaged(const FarmPlan& plan, std::size_t task, const std::string& what, const std::string& file) {
    std::error_code code;
    fs::remove(plan.done_file(task), code);
    return Error{what + "; ghostlight farm retry makes it again", file};
}

// As the task wrote it.
Result<std::vector<std::uint8_t>> bytes_of(const FarmPlan& plan, std::size_t task, const FarmDone& done,
                                           const std::string& name) {
    const auto expected = done.files.find(name);
    if (expected == done.files.end()) return damaged(plan, task, "has no " + name, plan.tasks[task].name);
    const fs::path file = plan.folder / "frames" / done.folder / name;
    std::error_code code;
    if (fs::is_symlink(file, code)) return damaged(plan, task, "is a link", file.string());
    auto bytes = read_file(file, kMostPictureBytes);
    if (bytes.ok() && bytes->size() == expected->second.first && crc32(*bytes) == expected->second.second)
        return bytes;
    return damaged(plan, task, "is not what its task wrote", file.string());
}

// Of a film whose first picture has this number. What is drawn in parts has no sound; it comes with the film.
Result<video::FilmSound> sound_of(const FarmPlan& plan, long first_frame) {
    Report report;
    TRY(const scene::Show show, scene::load_show(plan.show, false, report));
    return film_sound(show, static_cast<double>(first_frame) / plan.fps);
}

Result<FarmDone> write_film(const FarmPlan& plan) {
    FarmDone result;
    std::vector<video::FilmPart> parts;
    std::vector<std::pair<std::size_t, std::string>> makers; // of each: its task and node
    long first_frame = -1;
    for (std::size_t task = 0; task < plan.tasks.size(); ++task) {
        if (plan.tasks[task].first_frame < 0) continue;
        if (interrupted()) return Error{"interrupted: nothing is written", plan.out.string()};
        const auto done = done_of(plan, task);
        if (!done) return Error{"was done and is gone", plan.tasks[task].name};
        result.lacks_something |= done->lacks_something;
        TRY_VOID(bytes_of(plan, task, *done, plan.part_name()));
        parts.push_back({plan.folder / "frames" / done->folder / plan.part_name(),
                         plan.tasks[task].last_frame - plan.tasks[task].first_frame + 1});
        makers.emplace_back(task, done->host);
        if (first_frame < 0) first_frame = plan.tasks[task].first_frame;
    }
    TRY(video::FilmSound sound, sound_of(plan, first_frame));
    const Result<std::string> problem = video::join_films(plan.out, parts, plan.fps, std::move(sound));
    for (std::size_t k = 0; k < parts.size() && !problem.ok(); ++k)
        if (problem.error().where == parts[k].path.string())
            return damaged(plan, makers[k].first,
                           problem.error().what + " (made on " + makers[k].second + ")",
                           problem.error().where);
    if (!problem.ok()) return problem.error();
    if (!problem->empty()) log_warning(plan.show.string() + ": its sound: " + *problem);
    std::error_code code;
    result.files[plan.out.filename().string()] = {fs::file_size(plan.out, code), 0};
    return result;
}

Result<FarmDone> write_pictures(const FarmPlan& plan) {
    FarmDone result;
    const std::string ending = plan.out.extension().string();
    long number = 0;
    for (std::size_t task = 0; task < plan.tasks.size(); ++task) {
        if (plan.tasks[task].first_frame < 0) continue;
        const auto done = done_of(plan, task);
        if (!done) return Error{"was done and is gone", plan.tasks[task].name};
        result.lacks_something |= done->lacks_something;
        // By number, which has more digits from 100,000 on.
        for (long frame = plan.tasks[task].first_frame; frame <= plan.tasks[task].last_frame;
             ++frame, ++number) {
            if (interrupted()) return Error{"interrupted: nothing more is written", plan.out.string()};
            const std::string name = "f" + number_text(frame) + ending;
            TRY(const std::vector<std::uint8_t> bytes, bytes_of(plan, task, *done, name));
            TRY_VOID(write_file_atomic(plan.picture_file(number), bytes));
        }
    }
    result.pictures = number;
    return result;
}

// The bake finds the pictures of all parts, makes what it does not find, and writes the manifests.
Result<FarmDone> finish_bake(const FarmPlan& plan) {
    std::vector<std::string> words{own_program().string()};
    words.insert(words.end(), plan.words.begin(), plan.words.end());
    // Each begins with its camera.
    for (std::size_t task = 0; task < plan.tasks.size(); ++task)
        if (plan.tasks[task].stage == 0 && plan.tasks[task].words.size() > 1)
            words.insert(words.end(), plan.tasks[task].words.begin(), plan.tasks[task].words.begin() + 2);
    take_farm_threads(words);
    TRY(const ChildResult child, run_child(words, plan.from, true));
    FarmDone result;
    result.lacks_something = said_made_but_missing(child);
    if (child.exit_code != 0 && !result.lacks_something)
        return Error{"the passes could not be put together (see above)", plan.show.string()};
    return result;
}

Result<void> assemble(const FarmPlan& plan) {
    TRY_VOID(check_same(plan));
    TRY_VOID(check_whole(plan));
    TRY(FarmDone result, plan.is_one_file() ? write_film(plan)
                         : plan.is_film()   ? write_pictures(plan)
                                            : finish_bake(plan));
    result.host = node_name();
    return store_result(plan, result);
}

} // namespace

Result<void> assemble_farm(const FarmPlan& plan) {
    if (has_result(plan)) {
        log_info(plan.result_name() + ": is done already");
        if (check_ours(plan).ok()) (void)remove_pictures(plan); // left where who made it was killed
        return {};
    }
    TRY_VOID(check_ours(plan));
    TRY_VOID(make_plan_folders(plan));
    const std::size_t as_task = plan.tasks.size();
    std::error_code code;
    const Result<void> done = assemble(plan);
    if (!done.ok()) {
        if (const auto kept = write_file_atomic(plan.failed_file(as_task), done.error().text() + "\n");
            !kept.ok())
            log_warning(kept.error().text());
        return done;
    }
    fs::remove(plan.failed_file(as_task), code);
    return remove_pictures(plan);
}

} // namespace ghost::app
