#pragma once
// SPDX-License-Identifier: Apache-2.0
// News<T>: a mailbox whose newest value two readers get, each once: the window, and who looks on from
// elsewhere, once news are also for him. He may come late: the newest one is kept for him. A value is copied
// for that, so its large parts stand behind shared pointers. Any thread; each reader has one.

#include "base/mailbox.h"

#include <mutex>
#include <optional>
#include <utility>

namespace ghost::ui {

// What comes many times a second is not kept.
enum class Late { gets_newest, waits };

template <class T, Late kLate = Late::gets_newest>
class News {
public:
    void put(T value) {
        put_second(value, [](const T&, T&) {});
        first_.put(std::move(value));
    }
    template <class Carry>
    void put(T value, Carry carry) {
        put_second(value, carry);
        first_.put(std::move(value), carry);
    }
    std::optional<T> take() { return first_.take(); }

    void also_for_second(bool wanted) {
        const std::lock_guard lock(mutex_);
        if (wanted && !for_second_ && kept_) second_.put(*kept_);
        for_second_ = wanted;
    }
    std::optional<T> take_second() { return second_.take(); }
    bool is_for_second() const {
        const std::lock_guard lock(mutex_);
        return for_second_;
    }

private:
    template <class Carry>
    void put_second(const T& value, Carry carry) {
        const std::lock_guard lock(mutex_);
        if constexpr (kLate == Late::gets_newest) kept_ = value;
        if (for_second_) second_.put(value, carry);
    }

    Mailbox<T> first_, second_;
    mutable std::mutex mutex_;
    bool for_second_ = false;
    std::optional<T> kept_;
};

} // namespace ghost::ui
