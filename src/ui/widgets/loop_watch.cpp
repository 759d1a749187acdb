// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/loop_watch.h"

#include <algorithm>
#include <chrono>

namespace ghost::ui {

LoopWatch::LoopWatch(QObject* parent) : QObject(parent) {
    beat_.setInterval(kBeat_ms);
    beat_.setTimerType(Qt::PreciseTimer);
    connect(&beat_, &QTimer::timeout, this, &LoopWatch::count);
    beat_.start();
}

void LoopWatch::count() {
    if (!since_.isValid()) return since_.start();
    constexpr std::chrono::nanoseconds kBeat = std::chrono::milliseconds(kBeat_ms);
    const std::chrono::nanoseconds late = std::chrono::nanoseconds(since_.nsecsElapsed()) - kBeat;
    since_.start();
    busy_.add(std::max(late, std::chrono::nanoseconds(0)));
}

} // namespace ghost::ui
