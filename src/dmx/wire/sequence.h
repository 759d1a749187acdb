#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sequence: the running number of one sender on one universe. A packet numbered 0 to 19 behind the newest is
// late (E1.31-2018 6.7.2); any other is newer, and what lies between was missed. Both ends of the count
// differ (255 to 0 or to 1), so a gap of one across the wrap is no loss. A sender that starts anew steps back
// once; where numbers step back again and again two senders share a row, or one counts in a way of its own.
// Pure.

#include <algorithm>
#include <cstdint>
#include <optional>

namespace ghost::dmx {

class Sequence {
public:
    // Number of packets missed before this one; nothing where it is late and must not be used.
    std::optional<unsigned> accept(std::uint8_t number) {
        unsigned missed = 0;
        const int step = ahead(number);
        swapped_ = step < 0 && step > -20;
        if (newest_) {
            if (step <= 0 && step > -20) return std::nullopt;
            const int gap = step - 1 - (number < *newest_ ? 1 : 0);
            if (gap > 0) missed = static_cast<unsigned>(gap) - std::min(static_cast<unsigned>(gap), passed_);
        }
        stepped_back_ = step < 0;
        passed_ = 0;
        newest_ = number;
        return missed;
    }
    bool stepped_back() const { return stepped_back_; } // the newest that was accepted
    bool swapped() const { return swapped_; }           // the last one came after its successor
    // How far a number is ahead of the newest; 0 where there is none.
    int ahead(std::uint8_t number) const {
        return newest_ ? static_cast<std::int8_t>(static_cast<std::uint8_t>(number - *newest_)) : 0;
    }
    // A number of the same row that somebody else takes: it is not missed. No more than that, for there are
    // senders with a row for each.
    void pass(std::uint8_t number, unsigned missed = 0) {
        if (ahead(number) > 0) passed_ += 1 + missed;
    }
    // The next number counts, whatever it is.
    void forget() {
        newest_.reset();
        passed_ = 0;
        stepped_back_ = false;
    }

private:
    std::optional<std::uint8_t> newest_;
    unsigned passed_ = 0; // since then
    bool stepped_back_ = false, swapped_ = false;
};

} // namespace ghost::dmx
