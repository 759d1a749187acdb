#pragma once
// SPDX-License-Identifier: Apache-2.0
// BoundedQueue<T, kMost>: hands values from one thread to another in their order, and no more of them than
// fit: who puts one too many hears of it and waits for nobody. Any thread.

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace ghost {

template <class T, std::size_t kMost>
class BoundedQueue {
public:
    // False: it is full, and the value is not taken.
    bool put(T value) {
        const std::lock_guard lock(mutex_);
        if (values_.size() >= kMost) return false;
        values_.push_back(std::move(value));
        return true;
    }
    // All since the last call, oldest first.
    std::vector<T> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(values_, {});
    }

private:
    std::mutex mutex_;
    std::vector<T> values_;
};

} // namespace ghost
