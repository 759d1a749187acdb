#pragma once
// SPDX-License-Identifier: Apache-2.0
// PictureQueue: between the thread that asks for the picture of a moment and the worker that makes them.
// Asking never waits. Seconds of the show. Thread-safe.

#include "image/pyramid.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>

namespace ghost::video {

inline constexpr double kForever = std::numeric_limits<double>::infinity();

struct Picture {
    image::Pyramid pyramid;
    std::uint32_t number = 0;  // of all pictures of all sources; never 0
    double from_s = -kForever; // shown from here on
    bool stand_in = false;
};

class PictureQueue {
public:
    // The newest picture whose moment has come, as far as they are made; null: none was ever made.
    std::shared_ptr<const Picture> at(double show_s);
    // Waits up to so long until none is missing that would be newer.
    std::shared_ptr<const Picture> wait_for(double show_s, double at_most_s);

    enum class Need { stop, search, next };
    // For the worker. search: the moment lies before what is here, or far beyond; next: more pictures after
    // the last one.
    Need wait_for_need();
    double wanted_s() const;
    void begin_search(double show_s); // of wait_for_need
    // after_gap: pictures between the last one and this one were left out, so no moment there is known.
    void put(std::shared_ptr<const Picture> next, double known_to_s, bool after_gap);
    void know_to(double show_s);                       // no picture before is missing
    void replace(std::shared_ptr<const Picture> only); // whatever the moment
    bool sleep(double seconds);                        // false: it was stopped
    void stop();
    bool stopped() const;

private:
    std::shared_ptr<const Picture> pick(double show_s);

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool stop_ = false;
    double wanted_s_ = 0;
    double low_s_ = kForever;   // before this, pictures were thrown away or never made
    double head_s_ = -kForever; // moment of the last picture
    double known_to_s_ = -kForever;
    std::deque<std::shared_ptr<const Picture>> pictures_; // by from_s
    std::shared_ptr<const Picture> last_;                 // what was shown last
};

} // namespace ghost::video
