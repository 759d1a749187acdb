#pragma once
// SPDX-License-Identifier: Apache-2.0
// LampDrag: where a fixture goes that a mouse drags in the picture: along the truss or pipe that it hangs
// under, else on the level; upright where that is asked for. World metres. Pure; window thread.

#include "link/link.h"

#include <QString>

namespace ghost::ui {

class LampDrag {
public:
    // place_m: of the fixture that is dragged.
    LampDrag(const glm::vec3& place_m, const std::vector<Object>& objects);

    // That one goes with it: where both hang alike, neither leaves its truss.
    void take_along(const LampDrag& other);
    // How far it goes, in whole centimetres, when the mouse stands on that line of sight (way: unit vector).
    // Nothing that the line does not meet: not at all.
    glm::vec3 by_m(const glm::vec3& eye_m, const glm::vec3& way, bool upright) const;
    // "0.85 m along truss_mid", "1.20 m".
    QString words(const glm::vec3& by_m) const;

private:
    glm::vec3 place_m_;
    glm::vec3 along_{0}; // unit vector; 0: it hangs under nothing
    float low_m_ = 0, high_m_ = 0;
    std::string bar_; // name of its object
};

} // namespace ghost::ui
