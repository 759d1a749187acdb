#pragma once
// SPDX-License-Identifier: Apache-2.0
// Light is linear: what a light changes in from frame to frame, and whether that is more than its weight
// (dimmer, strobe, mixed colour, gel, master). A light's image is drawn at its unit, white and as bright as
// the light was when its shape last changed; its weight is what it is now of that. Pure.

#include "shared/types.h"

#include <glm/glm.hpp>
#include <vector>

namespace ghost::render {

// They differ in nothing but their weight.
bool same_shape(const shared::Light& a, const shared::Light& b);

class LightUnits {
public:
    // bounces: the lights' bounced light is drawn, too, which must then keep its proportion.
    explicit LightUnits(bool bounces) : bounces_(bounces) {}

    struct Changes {
        std::vector<int> changed; // in shape: their images are wrong
        std::vector<int> dimmed;  // in weight alone
    };
    // The lights of the next frame, as many as in the last one.
    Changes look(const std::vector<shared::Light>& lights);
    // Nothing is known: all lights count as changed.
    void forget() { lights_.clear(); }

    const std::vector<shared::Light>& lights() const { return lights_; }
    shared::Light at_unit(int light) const;
    glm::vec3 weight(int light) const;

private:
    // Of the light's intensity; 0: it was dark, and its image is worth nothing.
    struct Unit {
        float intensity_cd = 0;
        glm::vec3 bounce{0}; // bounce_cd of a candela
    };
    bool holds(const shared::Light& light, const Unit& unit) const;

    bool bounces_;
    std::vector<shared::Light> lights_;
    std::vector<Unit> units_;
};

} // namespace ghost::render
