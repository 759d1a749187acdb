#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sequence: the running number of one sender on one universe. A packet numbered 0 to 19 behind the newest is
// late (E1.31-2018 6.7.2); any other is newer, and what lies between was missed. Both ends of the count
// differ (255 to 0 or to 1), so a gap of one across the wrap is no loss. Pure.

#include <cstdint>
#include <optional>

namespace ghost::dmx {

class Sequence {
public:
    // Number of packets missed before this one; nothing where it is late and must not be used.
    std::optional<unsigned> accept(std::uint8_t number) {
        unsigned missed = 0;
        if (newest_) {
            const auto step = static_cast<std::int8_t>(static_cast<std::uint8_t>(number - *newest_));
            if (step <= 0 && step > -20) return std::nullopt;
            const int gap = step - 1 - (number < *newest_ ? 1 : 0);
            if (gap > 0) missed = static_cast<unsigned>(gap);
        }
        newest_ = number;
        return missed;
    }
    // The next number counts, whatever it is.
    void forget() { newest_.reset(); }

private:
    std::optional<std::uint8_t> newest_;
};

} // namespace ghost::dmx
