#pragma once
// SPDX-License-Identifier: Apache-2.0
// MoverWatch: what goes wrong on the way of a show's movers: bodies that meet, bodies below the floor (Z =
// 0), axes that are asked to go past their end stops. A body is the box of an instance of the stage, turned
// as it is; what touches where the model has it may touch. One sentence for each trouble, at its first
// moment, with time and place. Metres, seconds. Main thread.

#include "base/report.h"
#include "light/bodies.h"
#include "light/rig.h"
#include "stage/box.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace ghost::scene {

inline constexpr std::uint64_t kMostComparedBodies = 20'000'000'000; // pairs, of all moments: a minute

class MoverWatch {
public:
    // stage: that of stage_with_bodies, as the show has it. All must outlive it. most_pairs: then, which is
    // said, nobody looks any more whether bodies meet.
    MoverWatch(const Show& show, const Stage& stage, std::uint64_t most_pairs = kMostComparedBodies);

    // After the rig's step.
    void look(const Rig& rig, double at_s, Report& report);

private:
    struct Body {
        std::size_t instance = 0;
        int mover = kNoMover;
        Box own; // of its mesh
    };
    struct Placed {
        glm::mat4 world{1.0f};
        Box round; // of the world's axes
    };
    Placed placed(const Body& body, const Rig* rig) const;
    // No report: they stand where the model has them, and may meet.
    void look_for_meetings(const std::vector<Placed>& now, double at_s, Report* report);

    const Show& show_;
    const Stage& stage_;
    std::vector<Body> bodies_;                           // those that move first
    std::size_t moving_ = 0;                             // how many of them do
    std::set<std::pair<std::size_t, std::size_t>> said_; // bodies that meet, or met at home
    std::size_t meetings_ = 0;                           // of them after that
    std::uint64_t left_pairs_;
    bool gave_up_ = false, said_so_ = false;
    std::set<std::size_t> low_;                          // bodies below the floor
    std::set<std::pair<std::size_t, std::size_t>> past_; // mover and axis
};

} // namespace ghost::scene
