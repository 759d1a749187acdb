// SPDX-License-Identifier: Apache-2.0
#include "farm/farm_task.h"

#include "base/child.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "disk/crc32.h"
#include "disk/files.h"
#include "disk/own_program.h"
#include "live/session/passes_sources.h"
#include "show/show.h"
#include "show_folder/load_show.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kKeptOutput = 4096; // of a task that failed
constexpr int kMostRestarts = 3;          // of a task whose node was lost
constexpr auto kBetweenStageLooks = std::chrono::milliseconds(500);

int number_in_environment(const char* name) {
    const char* const text = std::getenv(name);
    return text != nullptr ? std::atoi(text) : 0;
}

// Of a task before which all others come. Whoever starts tasks by hand may start them all at once.
Result<void> wait_for_stage(const FarmPlan& plan, int stage) {
    const bool is_of_engine = std::getenv("SLURM_JOB_ID") != nullptr;
    bool said = false;
    for (std::size_t task = 0; task < plan.tasks.size(); ++task) {
        if (plan.tasks[task].stage >= stage) continue;
        while (!done_of(plan, task)) {
            if (!failure_of(plan, task).empty() || is_of_engine)
                return Error{plan.tasks[task].name + " comes first, and is not done", plan.folder.string()};
            if (!said) log_info("waiting for " + plan.tasks[task].name + ", which comes first");
            said = true;
            if (interrupted()) return Error{"interrupted", plan.folder.string()};
            std::this_thread::sleep_for(kBetweenStageLooks);
        }
    }
    return {};
}

std::string random_name() {
    std::random_device random;
    char digits[20];
    std::snprintf(digits, sizeof digits, "%08x%08x", random(), random());
    return digits;
}

// Of what the show is made of, the first that is not here; "": all is.
fs::path unseen_file(const FarmPlan& plan, const scene::Show& show) {
    std::vector<fs::path> files = plan.also;
    files.insert(files.end(), {show.stage_file, show.plot_file, show.sound.file});
    for (const scene::Camera& camera : show.cameras) files.push_back(camera.foreign_passes);
    for (const scene::Model& model : show.models) files.push_back(model.file);
    for (const scene::Media& media : show.media) files.push_back(media.file);
    for (const scene::PatchedFixture& fixture : show.fixtures) files.push_back(show.folder / fixture.gdtf);
    std::error_code code;
    for (const fs::path& file : files)
        if (!file.empty() && !fs::exists(file, code)) return file;
    return {};
}

// As it was when the plan was made.
Result<scene::Show> same_show(const FarmPlan& plan) {
    Report report;
    TRY(scene::Show show, scene::load_show(plan.show, false, report));
    if (farm_inputs(show, plan.also) == plan.inputs) return show;
    if (const fs::path unseen = unseen_file(plan, show); !unseen.empty())
        return Error{node_name() +
                         " does not see this file; a farm needs all that the show is made of under the same "
                         "path everywhere",
                     unseen.string()};
    return Error{"the show was changed since the plan was made; start the command again", plan.show.string()};
}

std::string passes_of(const FarmPlan& plan, const scene::Show& show) {
    return plan.camera.empty() ? "" : baked_fingerprint(show, plan.camera);
}

// Those of the first frame; where it is not drawn yet, none.
std::optional<std::string> first_passes(const FarmPlan& plan) {
    const auto first = plan.camera.empty() ? std::nullopt : done_of(plan, 0);
    return first ? std::optional(first->passes) : std::nullopt;
}

Result<void> run_task(const FarmPlan& plan, std::size_t task) {
    const FarmTask& wanted = plan.tasks[task];
    if (number_in_environment("SLURM_RESTART_COUNT") >= kMostRestarts)
        return Error{"its node was lost " + std::to_string(kMostRestarts) +
                         " times; it may be what ends them",
                     wanted.name};
    TRY_VOID(check_same(plan));
    TRY_VOID(wait_for_stage(plan, wanted.stage));
    FarmDone done;
    done.host = node_name();
    std::vector<std::string> words{own_program().string()};
    std::error_code code;
    words.insert(words.end(), plan.words.begin(), plan.words.end());
    words.insert(words.end(), wanted.words.begin(), wanted.words.end());
    fs::path pictures;
    if (plan.is_film()) {
        done.folder = std::to_string(task) + "." + random_name();
        pictures = plan.folder / "frames" / done.folder;
        if (!fs::create_directory(pictures, code))
            return Error{"cannot make the folder: " + code.message(), pictures.string()};
        words.insert(
            words.end(),
            {"-o", (pictures / (plan.is_one_file() ? plan.part_name() : "f" + plan.out.extension().string()))
                       .string()});
    }
    take_farm_threads(words);
    const auto begun = std::chrono::steady_clock::now();
    const Result<ChildResult> child = run_child(words, plan.from, true);
    const auto give_up = [&](Error error) {
        if (!pictures.empty()) fs::remove_all(pictures, code);
        return error;
    };
    if (!child.ok()) return give_up(child.error());
    done.lacks_something = said_made_but_missing(*child);
    if (child->exit_code != 0 && !done.lacks_something) {
        std::string said = child->output;
        while (!said.empty() && said.back() == '\n') said.pop_back();
        if (said.size() > kKeptOutput) said.erase(0, said.size() - kKeptOutput);
        if (said.empty()) said = "exit code " + std::to_string(child->exit_code) + " without a word";
        return give_up(Error{said, ""});
    }
    // It read show and passes by itself, perhaps after an edit or a bake.
    const Result<scene::Show> show = same_show(plan);
    if (!show.ok()) return give_up(show.error());
    done.passes = passes_of(plan, *show);
    if (wanted.stage > 0 && first_passes(plan).value_or(done.passes) != done.passes)
        return give_up(Error{"camera '" + plan.camera +
                                 "' was baked anew since the film was begun; the same command begins it anew",
                             plan.show.string()});
    done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (wanted.first_frame >= 0) {
        for (const auto& entry : fs::directory_iterator(pictures, code)) {
            const auto bytes = read_file(entry.path(), kMostPictureBytes);
            if (!bytes.ok()) return give_up(bytes.error());
            done.files[entry.path().filename().string()] = {bytes->size(), crc32(*bytes)};
        }
        // Of a film it is known when it is put together.
        const long files = plan.is_one_file() ? 1 : wanted.last_frame - wanted.first_frame + 1;
        if (static_cast<long>(done.files.size()) != files)
            return give_up(Error{"left " + std::to_string(done.files.size()) + " files, expected " +
                                     std::to_string(files),
                                 wanted.name});
    } else if (!pictures.empty()) {
        fs::remove_all(pictures, code);
        done.folder.clear();
    }
    const Result<bool> stored = store_done(plan, task, done);
    if (!stored.ok()) return give_up(stored.error());
    if (!*stored) {
        log_info(wanted.name + ": somebody was faster");
        if (!pictures.empty()) fs::remove_all(pictures, code);
    }
    return {};
}

} // namespace

bool said_made_but_missing(const ChildResult& child) {
    return child.exit_code == 1 && child.output.find(kMadeButMissing) != std::string::npos;
}

// Pictures of another build, or of a show that was edited meanwhile, must not get into one film.
Result<void> check_same(const FarmPlan& plan) {
    TRY(const std::string build, farm_build());
    if (build != plan.build)
        return Error{"the ghostlight of " + node_name() +
                         " is another build than the one that made the plan, or has another FFmpeg; all "
                         "machines need the same",
                     plan.folder.string()};
    std::error_code code;
    if (!fs::exists(plan.show, code))
        return Error{node_name() + " does not see the show; a farm needs it under the same path everywhere",
                     plan.show.string()};
    if (!fs::is_directory(plan.from, code))
        return Error{node_name() + " does not see this folder, in which the command was given",
                     plan.from.string()};
    TRY_VOID(same_show(plan));
    return {};
}

bool passes_changed(const FarmPlan& plan) {
    const auto first = first_passes(plan);
    if (!first) return false;
    const Result<scene::Show> show = same_show(plan);
    return show.ok() && passes_of(plan, *show) != *first;
}

void take_farm_threads(std::vector<std::string>& words) {
    const int threads = number_in_environment("SLURM_CPUS_PER_TASK");
    if (threads <= 0) return;
    for (std::size_t k = 0; k < words.size();) {
        const bool is_whole = words[k] == "--threads", has_value = words[k].starts_with("--threads=");
        const std::size_t many = is_whole ? std::min<std::size_t>(2, words.size() - k) : has_value ? 1 : 0;
        const auto at = words.begin() + static_cast<std::ptrdiff_t>(k);
        words.erase(at, at + static_cast<std::ptrdiff_t>(many));
        if (many == 0) ++k;
    }
    words.insert(words.end(), {"--threads", std::to_string(threads)});
}

Result<void> run_farm_task(const FarmPlan& plan, std::size_t task) {
    if (task >= plan.tasks.size())
        return Error{"has " + std::to_string(plan.tasks.size()) + " tasks, the first is 0",
                     plan.folder.string()};
    if (has_result(plan) || done_of(plan, task)) {
        log_info(plan.tasks[task].name + ": is done already");
        return {};
    }
    TRY_VOID(check_ours(plan));
    TRY_VOID(make_plan_folders(plan));
    const Result<void> done = run_task(plan, task);
    std::error_code code;
    if (done.ok()) {
        fs::remove(plan.failed_file(task), code);
        return {};
    }
    // Who did it by hand knows.
    if (interrupted() && std::getenv("SLURM_JOB_ID") == nullptr) return done;
    if (const Result<void> kept = write_file_atomic(plan.failed_file(task), done.error().text() + "\n");
        !kept.ok())
        log_warning(kept.error().text());
    return done;
}

} // namespace ghost::app
