// SPDX-License-Identifier: Apache-2.0
#include "ui/loop_watch.h"

#include <QAbstractEventDispatcher>

#include <chrono>

namespace ghost::ui {

LoopWatch::LoopWatch(QObject* parent) : QObject(parent) {
    const auto* dispatcher = QAbstractEventDispatcher::instance();
    connect(dispatcher, &QAbstractEventDispatcher::awake, this, [this] {
        count(); // there was more to do, and it did not wait
        since_.start();
    });
    connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, [this] {
        count();
        since_.invalidate();
    });
}

void LoopWatch::count() {
    if (since_.isValid()) busy_.add(std::chrono::nanoseconds(since_.nsecsElapsed()));
}

} // namespace ghost::ui
