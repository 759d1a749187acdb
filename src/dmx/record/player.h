#pragma once
// SPDX-License-Identifier: Apache-2.0
// Plays a recording by show time. Deterministic: the same t gives the same levels in any order of calls.
// Forwards it costs what changed since the last call, any other way a block or two of the recording. One
// thread at a time.

#include "dmx/record/recording.h"

namespace ghost::dmx {

class Player {
public:
    explicit Player(Recording recording) : recording_(std::move(recording)) {}

    // Levels at t_s seconds: of each universe its last frame at or before t (a universe before its first
    // frame is absent). Before 0 like 0, after the end the last look. Where the recording is damaged, the
    // look before the damage.
    Universes at(double t_s);
    // When the first frame after t_s comes; nothing: none does.
    std::optional<double> next_after(double t_s);
    double duration_s() const;
    const Recording& recording() const { return recording_; }
    // Damage that at() came across since the last call.
    std::vector<Error> take_damage() { return recording_.take_damage(); }

private:
    void go_to(double t_s);
    void go_to(std::chrono::microseconds time);
    void load(std::size_t block);

    Recording recording_;
    ghostdmx::BlockCursor cursor_;
    std::optional<std::size_t> block_;  // that cursor_ walks over
    std::chrono::microseconds time_{0}; // that cursor_ has reached
};

} // namespace ghost::dmx
