#pragma once
// SPDX-License-Identifier: Apache-2.0
// Latency: a histogram of durations with eight steps an octave from 1 us to 17 minutes, so that percentiles
// of millions of packets cost 240 counters, and their maximum. Values only.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace ghost::dmx {

class Latency {
public:
    void add(std::chrono::nanoseconds duration) {
        ++counts_[step_of(duration)];
        ++count_;
        max_ = std::max(max_, duration);
    }
    std::uint64_t count() const { return count_; }
    double max_ms() const { return std::chrono::duration<double, std::milli>(max_).count(); }
    // The duration that a share of them did not exceed, to a twelfth; 0 where there are none.
    double percentile_ms(double share) const {
        const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
        std::uint64_t sum = 0;
        for (std::size_t i = 0; count_ > 0 && i < kSteps; ++i) {
            sum += counts_[i];
            if (sum >= wanted && sum > 0)
                return std::min(1e-3 * std::exp2(static_cast<double>(i) / kPerOctave), max_ms());
        }
        return 0.0;
    }

private:
    static constexpr std::size_t kSteps = 240;
    static constexpr double kPerOctave = 8.0;
    static std::size_t step_of(std::chrono::nanoseconds duration) {
        const double us = std::chrono::duration<double, std::micro>(duration).count();
        if (us <= 1.0) return 0;
        const auto step = static_cast<std::size_t>(std::ceil(kPerOctave * std::log2(us)));
        return step < kSteps ? step : kSteps - 1;
    }

    std::array<std::uint64_t, kSteps> counts_{};
    std::uint64_t count_ = 0;
    std::chrono::nanoseconds max_{0};
};

} // namespace ghost::dmx
