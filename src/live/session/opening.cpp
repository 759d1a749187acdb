// SPDX-License-Identifier: Apache-2.0
// GCC 12 takes the result inside of std::async, which is placed in memory of the future, for one on the
// stack.
#pragma GCC diagnostic ignored "-Wfree-nonheap-object"
#include "live/session/opening.h"

#include "base/check.h"

#include <chrono>
#include <utility>

namespace ghost::app {

Opening::~Opening() {
    if (opened_.valid()) opened_.wait();
}

void Opening::begin(Kind kind, std::function<Opened()> open) {
    CHECK(!is_running());
    kind_ = kind;
    opened_ = std::async(std::launch::async, std::move(open));
}

std::optional<Opening::Opened> Opening::take() {
    if (!is_running() || opened_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    Opened opened = opened_.get();
    if (std::exchange(is_dropped_, false)) return {};
    return opened;
}

} // namespace ghost::app
