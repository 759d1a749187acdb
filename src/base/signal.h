#pragma once
// SPDX-License-Identifier: Apache-2.0
// Signal: wakes a thread that waits for something to do. Raising it while nobody waits is remembered, once.
// Any thread.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace ghost {

class Signal {
public:
    void raise() {
        {
            const std::lock_guard lock(mutex_);
            raised_ = true;
        }
        condition_.notify_one();
    }
    bool is_raised() const {
        const std::lock_guard lock(mutex_);
        return raised_;
    }
    // Until it is raised, or was since the last wait, or the time is over. True: it was raised.
    bool wait_for(std::chrono::nanoseconds time) {
        std::unique_lock lock(mutex_);
        condition_.wait_for(lock, time, [this] { return raised_; });
        return std::exchange(raised_, false);
    }

private:
    mutable std::mutex mutex_;
    std::condition_variable condition_;
    bool raised_ = false;
};

} // namespace ghost
