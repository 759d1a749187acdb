#pragma once
// SPDX-License-Identifier: Apache-2.0
// Mailbox<T>: hands the newest value from one thread to another. Older unread values are overwritten, so a
// slow reader never works off a backlog.

#include <mutex>
#include <optional>
#include <utility>

namespace ghost {

template <class T>
class Mailbox {
public:
    void put(T value) {
        const std::lock_guard lock(mutex_);
        newest_ = std::move(value);
    }
    // carry(unread, next): what of a value that nobody took goes on in the next one.
    template <class Carry>
    void put(T value, Carry carry) {
        const std::lock_guard lock(mutex_);
        if (newest_) carry(*newest_, value);
        newest_ = std::move(value);
    }
    // The newest value since the last take, if there is one.
    std::optional<T> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(newest_, std::nullopt);
    }

private:
    std::mutex mutex_;
    std::optional<T> newest_;
};

} // namespace ghost
