#pragma once
// SPDX-License-Identifier: Apache-2.0
// MapMaker: makes the distance maps of a show on a thread of its own (bake/distance_maps.h), so that a
// picture can start without them. Finished ones wait in a queue until they are taken. What is finished is on
// disk and stays there whenever the maker is destroyed, which stops the thread and waits for it. take() and
// outcome() from one thread; shows and stage must outlive it and must not change.

#include "base/report.h"
#include "base/result.h"
#include "passes/distance_maps.h"
#include "stage/stage.h"

#include <atomic>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <vector>

namespace ghost::scene {
struct Show;
} // namespace ghost::scene

namespace ghost::app {

class MapMaker {
public:
    struct Made {
        std::size_t index = 0; // among all maps of the show, scene::distance_places
        scene::DistanceMap map;
    };
    struct Outcome {
        Report report;
        bool interrupted = false;
        std::optional<Error> error;
    };

    // known: maps that need no delivery unless they turn out to be of another stage. begin_with: a show whose
    // maps are copied first, for most of them are right; null: none.
    MapMaker(const scene::Show& show, const scene::Stage& stage, int size, std::set<std::size_t> known,
             const scene::Show* begin_with = nullptr);
    ~MapMaker();
    MapMaker(const MapMaker&) = delete;
    MapMaker& operator=(const MapMaker&) = delete;

    // The next one that is finished; never waits for it.
    std::optional<Made> take();
    // Once, after everything is finished and taken.
    std::optional<Outcome> outcome();

private:
    void run();

    const scene::Show& show_;
    const scene::Stage& stage_;
    const int size_;
    const scene::Show* const begin_with_;
    std::set<std::size_t> delivered_; // of the thread
    std::atomic<bool> stop_{false};
    std::mutex mutex_; // of the two below
    std::deque<Made> queue_;
    std::optional<Outcome> outcome_;
    std::thread thread_; // the last member: it uses all others
};

} // namespace ghost::app
