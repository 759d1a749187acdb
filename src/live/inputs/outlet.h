#pragma once
// SPDX-License-Identifier: Apache-2.0
// Outlet: a recording's looks on their way to the network, each at its time: what the playout says is due is
// sent, and the thread sleeps until the next. Says once that the network takes nothing, and once that it does
// again. One thread.

#include "base/result.h"
#include "dmx/record/playout.h"
#include "dmx/send/sender.h"

namespace ghost::app {

class Outlet {
public:
    using Clock = std::chrono::steady_clock;

    // pace: seconds of the recording in a second. rate_hz: of repeats; at a pace above 1 looks are left out
    // that come faster. All must outlive this.
    Outlet(dmx::Sender& sender, dmx::Player& player, double rate_hz, double pace = 1.0);

    // What is due where the recording stands at at_s.
    Result<void> send(double at_s);
    // Until a look or a repeat is due or the recording stands at end_s, but not for long: Ctrl-C and time
    // code are looked at. It stood at at_s when it was `taken`.
    void wait(Clock::time_point taken, double at_s, double end_s) const;
    // The recording begins anew.
    void rewind() { playout_.rewind(); }

    // Goodbye. Error: nothing went out at all. name: of the recording.
    Result<void> end(const std::string& name);

private:
    dmx::Sender& sender_;
    dmx::Player& player_;
    std::chrono::nanoseconds period_;
    double pace_;
    dmx::Playout playout_;
    bool down_ = false;
    bool damaged_ = false;
};

} // namespace ghost::app
