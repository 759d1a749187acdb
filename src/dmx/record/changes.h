#pragma once
// SPDX-License-Identifier: Apache-2.0
// Changes: from merged levels, as often as they are looked at, to frames of a recording: one for each change
// of a universe's levels, at the time its newest packet arrived, or, where none did (a source was lost), at
// that of looking; and one when its last source is lost or comes back. Times are those of the merge. One
// thread at a time.

#include "dmx/record/recorded_frame.h"

#include <map>
#include <vector>

namespace ghost::dmx {

class Changes {
public:
    // Appends to out what changed since the last call, by time. now: what is said of a lost source.
    void find(const Universes& universes, std::chrono::nanoseconds now, std::vector<RecordedFrame>& out);
    // The same where only this universe can have changed.
    void find(const Universe& universe, std::chrono::nanoseconds now, std::vector<RecordedFrame>& out);

private:
    void look_at(const Universe& universe, std::chrono::nanoseconds now, std::vector<RecordedFrame>& out);
    void order(std::vector<RecordedFrame>& out, std::size_t first);

    struct Known {
        bool any = false;
        bool lost = false;
        std::uint64_t revision = 0;
        std::chrono::nanoseconds arrival{0};
        std::uint16_t slots = 1; // never shrinks, so that a level that returns to 0 is written
    };
    std::map<std::uint16_t, Known> known_;
    std::chrono::microseconds last_ = std::chrono::microseconds::min();
};

} // namespace ghost::dmx
