// SPDX-License-Identifier: Apache-2.0
#include "video/picture_queue.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

namespace ghost::video {
namespace {

constexpr std::size_t kAhead = 4; // pictures that are made before they are needed
constexpr double kJump_s = 1.0;   // further beyond the last picture than this, a film is searched

} // namespace

std::shared_ptr<const Picture> PictureQueue::pick(double show_s) {
    if (wanted_s_ != show_s) {
        wanted_s_ = show_s;
        changed_.notify_all();
    }
    while (pictures_.size() > 1 && pictures_[1]->from_s <= show_s) pictures_.pop_front();
    if (pictures_.empty()) return last_;
    const bool due = pictures_.front()->from_s <= show_s;
    // A film whose first picture comes later than its beginning shows it at once.
    const bool first = show_s >= low_s_ && known_to_s_ > show_s;
    if (due || first || !last_) last_ = pictures_.front();
    if (due) low_s_ = last_->from_s;
    return last_;
}

std::shared_ptr<const Picture> PictureQueue::at(double show_s) {
    const std::scoped_lock lock(mutex_);
    return pick(show_s);
}

std::shared_ptr<const Picture> PictureQueue::wait_for(double show_s, double at_most_s) {
    std::unique_lock lock(mutex_);
    wanted_s_ = show_s;
    changed_.notify_all();
    changed_.wait_for(lock, std::chrono::duration<double>(at_most_s), [&] {
        return stop_ || (known_to_s_ > show_s && !pictures_.empty() && show_s >= low_s_);
    });
    return pick(show_s);
}

PictureQueue::Need PictureQueue::wait_for_need() {
    std::unique_lock lock(mutex_);
    for (;;) {
        if (stop_) return Need::stop;
        if (wanted_s_ < low_s_ || wanted_s_ > std::max(head_s_, known_to_s_) + kJump_s) return Need::search;
        const auto ahead = std::count_if(pictures_.begin(), pictures_.end(),
                                         [&](const auto& picture) { return picture->from_s > wanted_s_; });
        if (static_cast<std::size_t>(ahead) < kAhead && known_to_s_ < kForever) return Need::next;
        changed_.wait(lock);
    }
}

double PictureQueue::wanted_s() const {
    const std::scoped_lock lock(mutex_);
    return wanted_s_;
}

void PictureQueue::begin_search(double show_s) {
    const std::scoped_lock lock(mutex_);
    pictures_.clear();
    low_s_ = head_s_ = show_s;
    known_to_s_ = -kForever;
}

void PictureQueue::put(std::shared_ptr<const Picture> next, double known_to_s, bool after_gap) {
    const std::scoped_lock lock(mutex_);
    if (after_gap) {
        pictures_.clear();
        low_s_ = next->from_s;
    }
    head_s_ = next->from_s;
    known_to_s_ = known_to_s;
    pictures_.push_back(std::move(next));
    changed_.notify_all();
}

void PictureQueue::know_to(double show_s) {
    const std::scoped_lock lock(mutex_);
    known_to_s_ = show_s;
    changed_.notify_all();
}

void PictureQueue::replace(std::shared_ptr<const Picture> only) {
    const std::scoped_lock lock(mutex_);
    pictures_.assign(1, std::move(only));
    low_s_ = -kForever;
    head_s_ = known_to_s_ = kForever;
    changed_.notify_all();
}

bool PictureQueue::sleep(double seconds) {
    std::unique_lock lock(mutex_);
    const auto until = std::chrono::steady_clock::now() +
                       std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                           std::chrono::duration<double>(std::clamp(seconds, 0.0, 3600.0)));
    changed_.wait_until(lock, until, [&] { return stop_; });
    return !stop_;
}

void PictureQueue::stop() {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
    changed_.notify_all();
}

bool PictureQueue::stopped() const {
    const std::scoped_lock lock(mutex_);
    return stop_;
}

} // namespace ghost::video
