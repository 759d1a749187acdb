// SPDX-License-Identifier: Apache-2.0
#include "cli/doctor/doctor.h"

#include "base/text.h"
#include "beam_groups/prism.h"
#include "cli/doctor/doctor_files.h"
#include "diagnose/doctor_show.h"
#include "dmx/record/player.h"
#include "dmx/record/recording.h"
#include "fixture_files/load_type.h"
#include "light/bodies.h"
#include "light/mover_watch.h"
#include "live/session/film_sound.h"
#include "live/session/media_player.h"
#include "passes/passes.h"
#include "plots/plot_types.h"
#include "show/looks.h"
#include "show/show.h"
#include "show_folder/load_show.h"
#include "show_folder/place_checks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr double kWatchEvery_s = 0.05;
constexpr long kMostWatched = 500'000; // steps of movers
constexpr std::size_t kMaxThreads = 64;
constexpr std::size_t kMostNames = 16;     // of modes or wheels in a line
constexpr std::size_t kMaxOffers = 20'000; // files that may stand in for missing ones

std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

scene::Finding lost(const std::string& where, const std::string& what) {
    return scene::finding_of({Severity::error, where, what});
}

// " (a, b and 7 more)"; --json has all.
std::string in_brackets(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t k = 0; k < std::min(names.size(), kMostNames); ++k)
        text += (k == 0 ? " (" : ", ") + names[k];
    if (names.size() > kMostNames) text += " and " + std::to_string(names.size() - kMostNames) + " more";
    return names.empty() ? "" : text + ")";
}

void check_type(const fs::path& path, Checked& result) {
    const auto loaded = fixture::load_type(path);
    if (!loaded.ok()) {
        result.findings.push_back(lost(loaded.error().where, loaded.error().what));
        return;
    }
    for (const Message& message : loaded->messages) result.findings.push_back(scene::finding_of(message));
    const fixture::Type& type = loaded->type;
    Report report;
    scene::check_models(type, path.filename().string(), report);
    scene::check_prisms(type, path.filename().string(), report);
    for (const Message& message : report.messages) result.findings.push_back(scene::finding_of(message));
    result.title = type.manufacturer + " " + type.name;
    result.facts["manufacturer"] = type.manufacturer;
    result.facts["name"] = type.name;
    result.facts["modes"] = nlohmann::json::array();
    result.facts["wheels"] = nlohmann::json::array();
    std::vector<std::string> modes;
    for (const fixture::Mode& mode : type.modes) {
        int channels = 0;
        for (const int bytes : mode.footprint) channels += bytes;
        result.facts["modes"].push_back(
            {{"name", mode.name}, {"channels", channels}, {"beams", mode.beams.size()}});
        modes.push_back("'" + mode.name + "' " + counted(static_cast<std::size_t>(channels), "channel"));
    }
    std::vector<std::string> wheels;
    for (const fixture::Wheel& wheel : type.wheels) {
        result.facts["wheels"].push_back({{"name", wheel.name}, {"slots", wheel.slots.size()}});
        wheels.push_back("'" + wheel.name + "' " + counted(wheel.slots.size(), "slot"));
    }
    result.summary = result.title + ": " + counted(type.modes.size(), "mode") + in_brackets(modes) + ", " +
                     counted(type.wheels.size(), "wheel") + in_brackets(wheels);
}

// What the movers do on their way through a recording, or through their keys.
void watch_movers(const scene::Show& show, const scene::Stage& stage, std::optional<dmx::Player> player,
                  const DoctorOptions& options, Report& report) {
    if (show.movers.empty()) return;
    std::optional<double> first_s, last_s; // keys
    for (const scene::Mover& mover : show.movers) {
        if (mover.keys.empty()) continue;
        first_s = std::min(first_s.value_or(mover.keys.front().at_s), mover.keys.front().at_s);
        last_s = std::max(last_s.value_or(0), mover.keys.back().at_s);
    }
    const double begin_s = player ? 0 : first_s.value_or(0);
    const double end_s = std::max(player ? player->duration_s() : 0, last_s.value_or(0));
    const double steps = std::floor((end_s - begin_s) / kWatchEvery_s) + 1;
    if (steps > static_cast<double>(kMostWatched)) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "the movers are watched for %.0f s, from %.0f s on; what they do up to %.0f s is not "
                      "looked at",
                      static_cast<double>(kMostWatched) * kWatchEvery_s, begin_s, end_s);
        report.add(Severity::warning, show.file.string(), text);
    }
    const long count = std::lround(std::min(steps, static_cast<double>(kMostWatched)));
    scene::Rig rig(show);
    scene::MoverWatch watch(show, stage);
    for (long step = 0; step < count; ++step) {
        if (options.stop && options.stop()) return;
        const double at_s = begin_s + static_cast<double>(step) * kWatchEvery_s;
        rig.set_time(at_s);
        rig.step(player ? player->at(at_s) : dmx::Universes{}, kWatchEvery_s);
        watch.look(rig, at_s, report);
    }
}

void check_show(const fs::path& path, const scene::FixtureOffers& offers, const DoctorOptions& options,
                std::atomic<double>& share, Checked& result) {
    Report report;
    const auto show = scene::load_show(
        path, true, report, {[&share](double now, const std::string&) { share = now; }, options.stop});
    if (!show.ok()) {
        for (const Message& message : report.messages) result.findings.push_back(scene::finding_of(message));
        result.findings.push_back(lost(show.error().where, show.error().what));
        return;
    }
    const scene::Stage with_bodies = scene::stage_with_bodies(*show, report);
    scene::check_places(*show, with_bodies, show->cameras, report);
    const std::filesystem::path looks_file = scene::looks_file(*show);
    if (const auto looks = scene::load_looks(looks_file, report); !looks.ok())
        report.add(Severity::error, looks.error().where, looks.error().what);
    else
        for (const scene::StoredLook& look : *looks)
            scene::check_look(look, *show, looks_file.string(), report);
    const fs::path replay = options.replay.empty() ? show->recording : options.replay;
    if (std::error_code code; fs::is_regular_file(replay, code)) {
        auto recording = dmx::read_recording(replay);
        if (!recording.ok()) report.add(Severity::error, recording.error().where, recording.error().what);
        if (recording.ok()) {
            std::vector<Error> problems = recording->problems;
            recording->check_all();
            const std::vector<Error> damage = recording->take_damage();
            problems.insert(problems.end(), damage.begin(), damage.end());
            for (const Error& problem : problems) report.add(Severity::error, problem.where, problem.what);
            watch_movers(*show, with_bodies, dmx::Player(std::move(*recording)), options, report);
        }
    } else if (!options.replay.empty()) {
        report.add(Severity::error, replay.string(), "no such file");
    } else {
        watch_movers(*show, with_bodies, {}, options, report);
    }
    check_media(*show, report);
    check_sound(*show, report);
    scene::check_prisms(*show, report);
    for (const scene::Camera& camera : show->cameras) {
        if (camera.foreign_passes.empty()) continue;
        const auto passes = scene::load_foreign_passes(camera.foreign_passes, report);
        if (!passes.ok()) report.add(Severity::error, passes.error().where, passes.error().what);
    }
    result.findings = scene::findings_of(*show, report, offers);
    const auto dark =
        std::count_if(show->fixtures.begin(), show->fixtures.end(), [](const scene::PatchedFixture& one) {
            return !one.type ||
                   scene::is_dark_by_desk(*one.type, one.type->modes[static_cast<std::size_t>(one.mode)]);
        });
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
}

// What one thread does with one file; a file that eats all memory must not take the others along.
Checked check_file(const std::string& file, const scene::FixtureOffers& offers, const DoctorOptions& options,
                   std::atomic<double>& share) {
    Checked result;
    result.file = file;
    const fs::path path(file);
    std::error_code code;
    const std::string ending = lower(path.extension().string());
    try {
        if (fixture::has_type_extension(path))
            check_type(path, result);
        else if (ending == ".toml" || ending == ".mvr" || fs::is_directory(path, code))
            check_show(path, offers, options, share, result);
        else
            result.findings.push_back(lost(
                file, fs::exists(path, code) ? "is neither a fixture file (.gdtf, .qxf, .json) nor a show (a "
                                               "show.toml, its folder or an .mvr)"
                                             : "no such file"));
    } catch (const std::bad_alloc&) {
        result.findings.push_back(
            lost(file, "needs more memory than there is; the rest of it is not checked"));
    } catch (const std::exception& fault) {
        result.findings.push_back(lost(file, std::string("unexpected: ") + fault.what()));
    }
    return result;
}

bool is_fixture(const std::string& file) {
    return fixture::has_type_extension(file);
}

std::shared_ptr<const fixture::Type> load_offer(const fs::path& path) {
    auto loaded = fixture::load_type(path);
    return loaded.ok() ? std::make_shared<const fixture::Type>(std::move(loaded->type)) : nullptr;
}

// Fixtures of this run, of the folders of its shows, of the folders that the user names, and our own.
scene::FixtureOffers offers_of(const std::vector<Checked>& results, const DoctorOptions& options) {
    scene::FixtureOffers offers;
    std::set<std::string> known;
    const auto add = [&](const fs::path& path, const std::string& title) {
        if (offers.files.size() >= kMaxOffers || !known.insert(path.lexically_normal().string()).second)
            return;
        offers.files.push_back(path);
        offers.names.push_back(path.filename().string());
        if (title.empty()) return;
        // Files are called what people like; a second entry compares what stands in it.
        offers.files.push_back(path);
        offers.names.push_back(title);
    };
    std::set<fs::path> folders;
    for (const Checked& result : results) {
        if (is_fixture(result.file))
            add(result.file, result.title);
        else {
            std::error_code code;
            const fs::path path(result.file);
            folders.insert(fs::is_directory(path, code) ? path : path.parent_path());
        }
    }
    for (const fs::path& folder : folders)
        for (const fs::path& part : {folder.empty() ? fs::path(".") : folder, folder / "fixtures"})
            for (const fs::path& file : fixture_files(part, kMaxOffers, 0)) add(file, "");
    std::vector<fs::path> more = options.fixture_folders;
    more.push_back(own_folder("fixtures"));
    for (const fs::path& folder : more)
        for (const fs::path& file : fixture_files(folder, kMaxOffers, kMaxSearchDepth)) add(file, "");
    offers.load = [files = offers.files](std::size_t k) { return load_offer(files[k]); };
    return offers;
}

class Run {
public:
    Run(const std::vector<std::string>& files, const DoctorOptions& options)
        : files_(files), options_(options), shares_(files.size()) {
        for (const std::string& file : files) {
            results_.emplace_back();
            results_.back().file = file;
        }
    }

    // Fixtures first: shows may ask for what they are.
    std::vector<Checked> all() {
        for (const bool fixtures : {true, false}) {
            std::vector<std::size_t> work;
            for (std::size_t k = 0; k < files_.size(); ++k)
                if (is_fixture(files_[k]) == fixtures) work.push_back(k);
            if (work.empty()) continue;
            const scene::FixtureOffers offers =
                fixtures ? scene::FixtureOffers{} : offers_of(results_, options_);
            largest_first(work);
            run(work, offers);
        }
        return std::move(results_);
    }

private:
    bool stopped() const { return options_.stop && options_.stop(); }

    // So that no thread is left with the longest one at the end.
    void largest_first(std::vector<std::size_t>& work) const {
        std::vector<std::uintmax_t> bytes(files_.size());
        for (const std::size_t k : work) {
            std::error_code code;
            const std::uintmax_t size = fs::file_size(files_[k], code);
            bytes[k] = code ? 0 : size;
        }
        std::stable_sort(work.begin(), work.end(),
                         [&](std::size_t a, std::size_t b) { return bytes[a] > bytes[b]; });
    }

    void run(const std::vector<std::size_t>& work, const scene::FixtureOffers& offers) {
        const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
        const std::size_t threads =
            std::min({options_.threads > 0 ? options_.threads : cores, work.size(), kMaxThreads});
        std::atomic<std::size_t> next{0};
        std::mutex mutex;
        std::condition_variable changed;
        std::size_t running = threads;
        std::string last;
        const auto take_files = [&] {
            for (;;) {
                const std::size_t at = next.fetch_add(1);
                if (at >= work.size() || stopped()) break;
                Checked result = check_file(files_[work[at]], offers, options_, shares_[work[at]]);
                result.is_done = !stopped() || is_fixture(result.file);
                const std::lock_guard lock(mutex);
                last = result.file;
                results_[work[at]] = std::move(result);
                shares_[work[at]] = 1.0;
                changed.notify_one();
            }
            const std::lock_guard lock(mutex);
            --running;
            changed.notify_one();
        };
        std::vector<std::jthread> workers;
        for (std::size_t k = 0; k < threads; ++k) workers.emplace_back(take_files);
        std::unique_lock lock(mutex);
        while (running > 0) {
            changed.wait_for(lock, std::chrono::milliseconds(200));
            if (!options_.progress) continue;
            const double done = std::accumulate(shares_.begin(), shares_.end(), 0.0);
            options_.progress(done / static_cast<double>(files_.size()), last);
        }
    }

    const std::vector<std::string>& files_;
    const DoctorOptions& options_;
    std::vector<Checked> results_;
    std::vector<std::atomic<double>> shares_; // of each file, how much is done
};

} // namespace

std::size_t Checked::count(Severity severity) const {
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(),
                      [severity](const scene::Finding& finding) { return finding.severity == severity; }));
}

std::vector<Checked> check_files(const std::vector<std::string>& files, const DoctorOptions& options) {
    return Run(files, options).all();
}

} // namespace ghost::app
