#pragma once
// SPDX-License-Identifier: Apache-2.0
// Flow: what one viewer gets of the pictures: the newest whenever few enough are on the way to him; what came
// meanwhile is skipped and never waits in line, so a slow viewer sees fewer and smaller pictures, and none
// that are old: a second one follows only while the first is not slower than the one before. Ration: what
// there may be of something in a time, as the bytes that all viewers get together. Pure: times come in, in
// seconds of one clock.

#include <cstdint>
#include <deque>

namespace ghost::web {

// Widths of pictures, the first one for whoever keeps up.
inline constexpr int kWidths[] = {1280, 854, 480};

class Flow {
public:
    // What the browser has room for, and whether it asks for calm: two pictures a second, against strobes.
    void want(int width, bool calm);
    bool may_send(double now_s) const;
    // All that he may have at a time is on the way: what is sent now waits behind it.
    bool is_full(double now_s) const;
    void sent(std::uint32_t number, double now_s);
    // The newest one comes once more.
    void send_again() { newest_ = 0; }
    // What was sent before that picture is done, too. False: it was not on the way, which changes nothing.
    bool painted(std::uint32_t number, double now_s);

    int width() const;                               // that the next picture has at most
    std::uint32_t newest() const { return newest_; } // sent; 0: none
    double ack_ms() const { return ack_ms_; }        // of the picture painted last

private:
    struct OnTheWay {
        std::uint32_t number;
        double sent_s;
    };
    std::deque<OnTheWay> on_the_way_;
    std::uint32_t newest_ = 0;
    int wanted_width_ = kWidths[0];
    bool calm_ = false;
    int step_ = 0;       // down kWidths, because acknowledgements are late
    int late_ = 0;       // of them in a row
    double fast_s_ = -1; // since when all come fast; below 0: they do not
    double sent_s_ = -1e9;
    double ack_ms_ = 0;
};

class Ration {
public:
    // burst_s: the rate of so long may be spent at once after a pause.
    explicit Ration(double per_s, double burst_s = 0.1)
        : per_s_(per_s), most_(per_s * burst_s), left_(most_) {}

    bool has_some(double now_s);
    void spend(double amount) { left_ -= amount; } // may go below zero: then there is a pause

private:
    double per_s_, most_;
    double left_;
    double filled_s_ = 0;
};

} // namespace ghost::web
