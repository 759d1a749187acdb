// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/outlet.h"

#include "base/log.h"
#include "dmx/record/recording_tasks.h"

#include <algorithm>
#include <thread>

namespace ghost::app {

namespace {

constexpr std::chrono::milliseconds kLookUp{20};

std::chrono::nanoseconds nanoseconds_of(double time_s) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(time_s));
}

} // namespace

Outlet::Outlet(dmx::Sender& sender, dmx::Player& player, double rate_hz, double pace)
    : sender_(sender), player_(player), period_(nanoseconds_of(1.0 / rate_hz)), pace_(pace),
      playout_(player, period_, pace <= 1.0) {}

Result<void> Outlet::send(double at_s) {
    for (;;) {
        const dmx::Universes due = playout_.due(at_s, Clock::now().time_since_epoch());
        if (due.list.empty()) break;
        TRY_VOID(sender_.send(due));
        if (sender_.trouble() && !down_)
            log_warning(sender_.trouble()->text() + "; it goes on, and sends again when the network is back");
        if (!sender_.trouble() && down_)
            log_info("the network is back; " + std::to_string(sender_.refused()) +
                     " packets could not be sent");
        down_ = sender_.trouble().has_value();
    }
    damaged_ |= log_damage(player_);
    return {};
}

void Outlet::wait(Clock::time_point taken, double at_s, double end_s) const {
    const auto until_s = [&](double then_s) {
        return then_s > at_s ? taken + nanoseconds_of((then_s - at_s) / pace_) : Clock::time_point::max();
    };
    Clock::time_point until = std::min(taken + kLookUp, until_s(end_s));
    if (pace_ > 1.0) {
        until = std::min(taken + period_, until);
    } else if (const auto look_s = playout_.next_look_s()) {
        until = std::min(until, until_s(*look_s));
    }
    if (const auto repeat = playout_.next_repeat()) until = std::min(until, Clock::time_point(*repeat));
    std::this_thread::sleep_until(until);
}

Result<void> Outlet::end(const std::string& name) {
    const std::string why = sender_.trouble() ? ": " + sender_.trouble()->text() : "";
    sender_.terminate();
    if (sender_.refused() > 0 && sender_.packets() > 0)
        log_warning(std::to_string(sender_.refused()) + " packets could not be sent" + why);
    if (sender_.packets() > 0) return {};
    if (sender_.refused() > 0) return Error{"nothing could be sent" + why, name};
    if (damaged_) return Error{"nothing of it can be read: it is damaged as a whole", name};
    return {};
}

} // namespace ghost::app
