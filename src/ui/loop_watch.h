#pragma once
// SPDX-License-Identifier: Apache-2.0
// LoopWatch: how long the event loop of its thread is busy at a stretch: from waking up until it waits again.
// Nothing that a person does is seen meanwhile. Window thread.

#include "dmx/latency.h"

#include <QElapsedTimer>
#include <QObject>

namespace ghost::ui {

class LoopWatch : public QObject {
    Q_OBJECT
public:
    // From when the application's loop is there.
    explicit LoopWatch(QObject* parent);

    const dmx::Latency& busy() const { return busy_; }
    void reset() { busy_ = {}; }

private:
    void count();

    dmx::Latency busy_;
    QElapsedTimer since_; // it woke up; not valid: it waits
};

} // namespace ghost::ui
