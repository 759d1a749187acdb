#pragma once
// SPDX-License-Identifier: Apache-2.0
// LoopWatch: how late the event loop of its thread comes to a timer: as long as it was busy at a stretch, to
// within kBeat_ms. Nothing that a person does is seen meanwhile. (The dispatcher's own signals say nothing of
// that: with GLib it emits both before it does what it woke up for.) Window thread.

#include "dmx/merge/latency.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ghost::ui {

class LoopWatch : public QObject {
    Q_OBJECT
public:
    static constexpr int kBeat_ms = 20;

    explicit LoopWatch(QObject* parent);

    const dmx::Latency& busy() const { return busy_; }
    void reset() { busy_ = {}; }

private:
    void count();

    dmx::Latency busy_;
    QTimer beat_;
    QElapsedTimer since_; // the last beat; not valid before the first
};

} // namespace ghost::ui
