#pragma once
// SPDX-License-Identifier: Apache-2.0
// Viewer: one browser that looks on: what it wants, what it got, and how many messages it may still send, of
// which those that a picture sent to it is painted do not count.
// Seconds of the server's clock. The server's thread.

#include "web/flow.h"
#include "web/protocol.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace ghost::web {

inline constexpr int kMostMessagesPerSecond = 60;

struct Viewer {
    std::uint64_t id = 0; // of none before
    Flow flow;
    Right right = Right::view;
    std::uint64_t keys = 0; // of the tokens, when it was told its right
    Watch watch;
    std::optional<Watch> wants_watch; // instead, when its time has come
    double watched_s = -1e9;          // when it was another one last
    bool wants_pictures = false;      // small ones
    bool wants_levels = false;
    std::optional<std::size_t> asks;                                        // a fixture to be explained
    std::uint64_t show = 0, messages = 0, levels = 0, looks = 0, small = 0; // versions that it has
    std::uint64_t measure = 0;                                              // number of the side view
    double state_s = -1e9;                                                  // when it was told the state last
    double asked_if_there_s = 0;                                            // by a ping of the WebSocket
    std::deque<double> painted_s;                                           // in the last second
    bool is_served = false;                                                 // of the ration, in this round
    double asked_engine_s = -1e9;                                           // for an explanation, last

    // False: too many.
    bool may_say(double now_s) {
        if (!messages_.has_some(now_s)) return false;
        messages_.spend(1);
        return true;
    }
    // Of a message that may_say() was asked about.
    void hear_painted(std::uint32_t number, double now_s) {
        if (!flow.painted(number, now_s)) return;
        messages_.spend(-1);
        painted_s.push_back(now_s);
        forget_painted(now_s);
    }
    void forget_painted(double now_s) {
        while (!painted_s.empty() && now_s - painted_s.front() > 1) painted_s.pop_front();
    }

private:
    Ration messages_{kMostMessagesPerSecond, 1};
};

} // namespace ghost::web
