#pragma once
// SPDX-License-Identifier: Apache-2.0
// News<T>: a mailbox whose newest value two readers get, each once: the window, and who looks on from
// elsewhere, once news are also for him. A value is copied for him, so its large parts stand behind shared
// pointers. Any thread; each reader has one.

#include "base/mailbox.h"

#include <atomic>

namespace ghost::ui {

template <class T>
class News {
public:
    void put(T value) {
        if (for_second_) second_.put(value);
        first_.put(std::move(value));
    }
    template <class Carry>
    void put(T value, Carry carry) {
        if (for_second_) second_.put(value, carry);
        first_.put(std::move(value), carry);
    }
    std::optional<T> take() { return first_.take(); }

    void also_for_second(bool wanted) { for_second_ = wanted; }
    std::optional<T> take_second() { return second_.take(); }

private:
    Mailbox<T> first_, second_;
    std::atomic<bool> for_second_{false};
};

} // namespace ghost::ui
