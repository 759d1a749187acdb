#pragma once
// SPDX-License-Identifier: Apache-2.0
// LossNote: says that universes are lost, in the log when it happens and as a line for the picture while it
// lasts: a look that is only held must not pass for one that a desk sends. Main thread.

#include "dmx/wire/universes.h"

#include <chrono>
#include <set>
#include <string>

namespace ghost::app {

class LossNote {
public:
    // now: steady clock, as the universes' arrival.
    void look(const dmx::Universes& universes, std::chrono::nanoseconds now);
    // "no DMX on universes 1, 2 for 5 s: last look held", or nothing.
    const std::string& text() const { return text_; }

private:
    std::set<std::uint16_t> lost_;
    std::string text_;
};

// Two captions on one line; either may be empty.
std::string joined(const std::string& first, const std::string& second);

} // namespace ghost::app
