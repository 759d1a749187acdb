// SPDX-License-Identifier: Apache-2.0
#include "live/session/map_maker.h"

#include "bake/distance_maps.h"
#include "base/interrupt.h"
#include "passes/distance_maps_file.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace ghost::app {

MapMaker::MapMaker(const scene::Show& show, const scene::Stage& stage, int size, std::set<std::size_t> known,
                   const scene::Show* begin_with)
    : show_(show), stage_(stage), size_(size), begin_with_(begin_with), delivered_(std::move(known)),
      thread_([this] { run(); }) {}

MapMaker::~MapMaker() {
    stop_ = true;
    thread_.join();
}

std::optional<MapMaker::Made> MapMaker::take() {
    const std::lock_guard lock(mutex_);
    if (queue_.empty()) return std::nullopt;
    Made next = std::move(queue_.front());
    queue_.pop_front();
    return next;
}

std::optional<MapMaker::Outcome> MapMaker::outcome() {
    const std::lock_guard lock(mutex_);
    if (!queue_.empty()) return std::nullopt;
    return std::exchange(outcome_, std::nullopt);
}

void MapMaker::run() {
    bake::DistanceMapOptions options;
    options.size = size_;
    // The picture needs the other cores.
    options.threads = static_cast<int>(std::max(std::thread::hardware_concurrency() / 2, 1u));
    options.stop = [this] { return stop_ || interrupted(); };
    options.on_map = [this](std::size_t index, const scene::DistanceMap& map) {
        const std::lock_guard lock(mutex_);
        delivered_.insert(index);
        queue_.push_back({index, map});
    };
    Outcome outcome;
    scene::DistanceMaps maps;
    try {
        if (begin_with_) scene::copy_distance_maps(*begin_with_, show_, size_, options.stop);
        const auto stats = bake::update_distance_maps(show_, stage_, options, maps, outcome.report);
        if (!stats.ok()) outcome.error = stats.error();
        outcome.interrupted = stats.ok() && stats->interrupted;
    } catch (const std::exception& problem) { // no memory: the picture goes on without the rest
        outcome.error = Error{std::string("making distance maps: ") + problem.what(), show_.file.string()};
    }

    const std::vector<scene::DistancePlace> places = scene::distance_places(show_, size_);
    const std::lock_guard lock(mutex_);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const int kept = maps.find(places[k].fixture, places[k].stop, places[k].place);
        if (kept < 0 || delivered_.contains(k)) continue;
        queue_.push_back({k, std::move(maps.maps[static_cast<std::size_t>(kept)])});
    }
    outcome_ = std::move(outcome);
}

} // namespace ghost::app
