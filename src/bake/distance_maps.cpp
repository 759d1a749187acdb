// SPDX-License-Identifier: Apache-2.0
#include "bake/distance_maps.h"

#include "bake/distance_sight.h"
#include "bake/hasher.h"
#include "bake/private/distance_stage.h"
#include "bake/private/distance_trace.h"
#include "disk/files.h"
#include "disk/own_folder.h"
#include "passes/distance_maps_file.h"
#include "passes/passes_file.h"
#include "rays/tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <utility>

namespace ghost::bake {
namespace fs = std::filesystem;
namespace {

constexpr int kRows = 16; // of a task
// A light that has nearly everything nearer than this hangs inside something.
constexpr float kInside_m = 0.05f;
constexpr double kInsideShare = 0.95;
// Embree traces from no place that is farther away.
constexpr float kWorld_m = 1e6f;

bool in_the_world(const glm::vec3& v) {
    return std::abs(v.x) < kWorld_m && std::abs(v.y) < kWorld_m && std::abs(v.z) < kWorld_m;
}

class Update {
public:
    Update(const scene::Show& show, const scene::Stage& stage, const DistanceMapOptions& options,
           Report& report)
        : show_(show), stage_(stage), options_(options), report_(report), sight_(options.size),
          places_(scene::distance_places(show, options.size)), right_(places_.size(), 0),
          complaints_(places_.size()) {
        for (const scene::DistancePlace& place : places_)
            maps_.push_back({place.fixture, place.stop, place.place, place.position_m, {}});
    }

    DistanceMapStats run(scene::DistanceMaps& maps) {
        const double begin_s = now_s();
        wanted_ = stage_for_distances(stage_, report_);
        find_kept();
        const double kept_s = now_s();
        make_missing();
        stats_.trace_seconds = now_s() - kept_s;
        finish(maps);
        stats_.seconds = now_s() - begin_s;
        return stats_;
    }

private:
    bool stopped() const { return options_.stop && options_.stop(); }
    double now_s() const { return options_.now_s ? options_.now_s() : 0.0; }

    void find_kept();
    bool unchanged(const scene::StoredDistanceMap& map, const glm::vec3& position_m,
                   const std::set<std::string>& removed,
                   const std::vector<scene::StageInstance>& added) const;
    void make_missing();
    bool trace(std::size_t index, const Tracer& tracer, scene::StoredDistanceMap& stored);
    void finish(scene::DistanceMaps& maps);
    void failed_to_write(const Error& error);

    const scene::Show& show_;
    const scene::Stage& stage_;
    const DistanceMapOptions& options_;
    Report& report_;
    const DistanceSight sight_;
    const std::vector<scene::DistancePlace> places_;
    StageForDistances wanted_;
    std::vector<scene::DistanceMap> maps_; // as places_
    std::vector<char> right_;              // those of maps_ that are finished; no bits: several threads write
    std::vector<std::optional<Error>> complaints_; // per map: what was wrong with its file
    std::mutex mutex_;                             // of write_error_ and the callbacks
    std::optional<Error> write_error_;
    bool writes_ = true; // the folder is there, and is ours
    std::size_t done_ = 0;
    std::atomic<std::uint64_t> rays_{0};
    DistanceMapStats stats_;
};

void Update::find_kept() {
    const fs::path folder = scene::distance_folder(show_, options_.size);
    if (auto made = make_folders(folder, show_.cache_home()); !made.ok()) {
        writes_ = false;
        failed_to_write(made.error());
    }
    std::optional<scene::DistanceStage> old;
    if (auto read = scene::read_distance_stage(folder); read.ok())
        old = std::move(*read);
    else
        report_.add(Severity::warning, read.error().where, read.error().what);

    const auto by_key = [](const scene::StageInstance& a, const scene::StageInstance& b) {
        return a.key < b.key;
    };
    std::set<std::string> removed;
    std::vector<scene::StageInstance> added;
    if (old) {
        const auto& before = old->instances;
        const auto& after = wanted_.stage.instances;
        for (const scene::StageInstance& instance : before)
            if (!std::binary_search(after.begin(), after.end(), instance, by_key))
                removed.insert(instance.key);
        for (const scene::StageInstance& instance : after)
            if (!std::binary_search(before.begin(), before.end(), instance, by_key))
                added.push_back(instance);
    }

    std::vector<std::string> also_right(places_.size());
    tbb::parallel_for(std::size_t{0}, places_.size(), [&](std::size_t k) {
        if (stopped()) return;
        auto stored = scene::read_distance_map(places_[k].file, options_.size);
        if (!stored.ok()) complaints_[k] = stored.error();
        if (!stored.ok() || !stored->has_value()) return;
        scene::StoredDistanceMap& map = **stored;
        if (map.place != scene::place_key(places_[k], options_.size)) return;
        if (map.stage != wanted_.stage.key) {
            if (!old || !old->holds_for(map) || !unchanged(map, places_[k].position_m, removed, added))
                return;
            also_right[k] = map.key;
        }
        maps_[k].distance = std::move(map.distance);
        right_[k] = 1;
    });
    if (stopped()) return; // what was not read may be right, and the stage on disk says so
    std::set<std::string> keys(also_right.begin(), also_right.end());
    keys.erase("");
    wanted_.stage.also_right.assign(keys.begin(), keys.end());
    stats_.kept = static_cast<int>(std::count(right_.begin(), right_.end(), 1));
    if (writes_ && (!old || *old != wanted_.stage))
        if (auto written = scene::write_distance_stage(show_, options_.size, wanted_.stage); !written.ok())
            failed_to_write(written.error());
}

bool Update::unchanged(const scene::StoredDistanceMap& map, const glm::vec3& position_m,
                       const std::set<std::string>& removed,
                       const std::vector<scene::StageInstance>& added) const {
    for (const std::string& key : map.sees)
        if (removed.contains(key)) return false;
    if (added.empty()) return true;
    const std::vector<float> farthest_m = sight_.farthest_m(map.distance);
    return std::none_of(added.begin(), added.end(), [&](const scene::StageInstance& instance) {
        return sight_.may_change(map.distance, farthest_m, position_m, instance.low, instance.high);
    });
}

void Update::make_missing() {
    std::vector<std::size_t> missing;
    for (std::size_t k = 0; k < maps_.size(); ++k)
        if (right_[k] == 0) missing.push_back(k);
    if (missing.empty() || stopped()) return;
    if (options_.progress) options_.progress(0.0, "preparing the stage");
    const Tracer tracer(stage_);
    tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t m) {
        const std::size_t k = missing[m];
        scene::StoredDistanceMap stored;
        bool whole = false;
        // Isolated: a thread that waits for the rows of one map must not begin another.
        tbb::this_task_arena::isolate([&] { whole = trace(k, tracer, stored); });
        if (!whole) return;
        const auto written =
            writes_ ? scene::write_distance_map(places_[k].file, options_.size, stored) : Result<void>();
        maps_[k].distance = std::move(stored.distance);
        scene::measure(maps_[k]);
        right_[k] = 1;
        const std::lock_guard lock(mutex_);
        if (!written.ok()) failed_to_write(written.error());
        ++done_;
        if (options_.on_map) options_.on_map(k, maps_[k]);
        if (options_.progress)
            options_.progress(static_cast<double>(done_) / static_cast<double>(missing.size()),
                              "distance map " + std::to_string(done_) + " of " +
                                  std::to_string(missing.size()));
    });
    stats_.made = static_cast<int>(done_);
}

bool Update::trace(std::size_t index, const Tracer& tracer, scene::StoredDistanceMap& stored) {
    const auto texels = sight_.directions().size();
    stored.distance.assign(texels, scene::kNoSurface);
    std::vector<std::atomic<bool>> seen(stage_.instances.size());
    const glm::vec3 position_m = places_[index].position_m;
    std::atomic<bool> whole{!stopped()};
    if (in_the_world(position_m))
        tbb::parallel_for(0, (options_.size + kRows - 1) / kRows, [&](int band) {
            if (stopped()) whole = false;
            const int y0 = band * kRows;
            if (whole)
                trace_distances(sight_, {0, y0, options_.size, std::min(y0 + kRows, options_.size)},
                                position_m, tracer, stored.distance, &seen);
        });
    if (!whole) return false;
    stored.place = scene::place_key(places_[index], options_.size);
    stored.stage = wanted_.stage.key;
    Hasher key;
    key.text(stored.place);
    key.text(stored.stage);
    stored.key = key.hex();
    for (std::size_t k = 0; k < seen.size(); ++k)
        if (seen[k] && !wanted_.keys[k].empty()) stored.sees.push_back(wanted_.keys[k]);
    std::sort(stored.sees.begin(), stored.sees.end());
    rays_ += texels;
    return true;
}

void Update::failed_to_write(const Error& error) {
    if (!write_error_) write_error_ = error;
}

void Update::finish(scene::DistanceMaps& maps) {
    stats_.rays = rays_;
    stats_.interrupted = std::count(right_.begin(), right_.end(), 0) > 0;
    for (const std::optional<Error>& complaint : complaints_)
        if (complaint) report_.add(Severity::warning, complaint->where, complaint->what);
    if (write_error_)
        report_.add(Severity::warning, write_error_->where,
                    write_error_->what + "; the distance maps are not kept and are made again next time");
    maps = {options_.size, {}};
    const std::uint16_t inside = scene::to_half(kInside_m);
    for (std::size_t k = 0; k < maps_.size(); ++k) {
        if (right_[k] == 0) continue;
        scene::measure(maps_[k]);
        if (!in_the_world(maps_[k].position_m))
            report_.add(Severity::warning, show_.file.string(),
                        "fixture '" + maps_[k].fixture +
                            "' hangs nowhere, expected a place within 1000 km; its distance map is empty");
        const auto near = std::count_if(maps_[k].distance.begin(), maps_[k].distance.end(),
                                        [&](std::uint16_t distance) { return distance < inside; });
        if (static_cast<double>(near) > kInsideShare * static_cast<double>(maps_[k].distance.size()))
            report_.add(Severity::warning, show_.file.string(),
                        "fixture '" + maps_[k].fixture + "' hangs inside an object: in " +
                            std::to_string(100 * near / static_cast<long>(maps_[k].distance.size())) +
                            " % of all directions something is nearer than 5 cm");
        maps.maps.push_back(std::move(maps_[k]));
    }
    if (stats_.interrupted) return;
    // Maps that no light of the show wants any more.
    std::set<std::string> names;
    for (const scene::DistancePlace& place : places_) names.insert(place.file.filename().string());
    const auto folder = OwnFolder::open(scene::distance_folder(show_, options_.size), show_.cache_home());
    if (!folder.ok()) return;
    for (const OwnFolder::File& file : folder->entries().files)
        if (file.name.ends_with(".exr") && !names.contains(file.name) && !is_temporary_in_use(file.name))
            folder->remove_file(file.name);
}

} // namespace

Result<DistanceMapStats> update_distance_maps(const scene::Show& show, const scene::Stage& stage,
                                              const DistanceMapOptions& options, scene::DistanceMaps& maps,
                                              Report& report) {
    if (options.size < scene::kMinDistanceMapSize || options.size > scene::kMaxDistanceMapSize)
        return Error{"the size of distance maps must be " + std::to_string(scene::kMinDistanceMapSize) +
                         " to " + std::to_string(scene::kMaxDistanceMapSize),
                     ""};
    Update update(show, stage, options, report);
    if (options.threads <= 0) return update.run(maps);
    DistanceMapStats stats;
    tbb::task_arena arena(options.threads);
    arena.execute([&] { stats = update.run(maps); });
    return stats;
}

} // namespace ghost::bake
