#pragma once
// SPDX-License-Identifier: Apache-2.0
// LampDrag: where a fixture goes that a mouse drags in the picture: along the truss or pipe that it hangs
// under, else on the level; upright where that is asked for. World metres. Pure; window thread.

#include "link/link.h"

#include <QString>

namespace ghost::ui {

class LampDrag {
public:
    // place_m: of the light that is dragged; hangs_m: where its fixture hangs, which stays where it is when
    // the head turns.
    LampDrag(const glm::vec3& place_m, const glm::vec3& hangs_m, const std::vector<Object>& objects);

    // That one goes with it: where both hang alike, neither leaves its truss.
    void take_along(const LampDrag& other);
    // How far it goes, in whole centimetres, when the mouse took hold of it on the first line of sight and
    // stands on the second one (unit vectors). Where one of them does not meet what it runs along: not at
    // all.
    glm::vec3 by_m(const glm::vec3& eye_m, const glm::vec3& from_way, const glm::vec3& way,
                   bool upright) const;
    // "0.85 m along truss_mid", "1.20 m".
    QString words(const glm::vec3& by_m) const;

private:
    std::optional<glm::vec3> met_m(const glm::vec3& eye_m, const glm::vec3& way, bool upright) const;

    glm::vec3 place_m_;
    glm::vec3 along_{0}; // unit vector; 0: it hangs under nothing
    float low_m_ = 0, high_m_ = 0;
    std::string bar_; // name of its object
};

} // namespace ghost::ui
