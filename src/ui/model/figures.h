#pragma once
// SPDX-License-Identifier: Apache-2.0
// Figures: what the corner of the picture says of it: how long it took, how many come, how old its packets
// are, what differs from the show. Window thread.

#include "ui/model/app_model.h"

#include <QElapsedTimer>
#include <QStringList>

#include <chrono>

namespace ghost::ui {

class Figures {
public:
    explicit Figures(const AppModel& app) : app_(app) {}

    void count_picture(); // one came
    // Packet to window, of the newest picture that packets changed.
    void take_latency(std::chrono::nanoseconds latency);

    // What pictures took to be drawn, since the last reset().
    const dmx::Latency& draws() const { return draws_; }
    void reset() { draws_ = {}; }

    double latency_ms() const { return latency_ms_; } // below 0: no packet came
    double pictures_per_s() const { return rate_hz_; }
    // How long after a picture none is awaited any more.
    int rest_ms() const;
    QStringList lines() const;

private:
    const AppModel& app_;
    double latency_ms_ = -1;
    dmx::Latency draws_;
    QElapsedTimer since_picture_, since_count_;
    int count_ = 0;
    double rate_hz_ = 0;
};

} // namespace ghost::ui
