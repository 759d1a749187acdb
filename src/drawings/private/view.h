#pragma once
// SPDX-License-Identifier: Apache-2.0
// View: which way a drawing to scale looks. World metres to metres of the drawing, x to the right, y up. From
// above up-stage is up; from the side the house is at the left. Pure, any thread.

#include <glm/glm.hpp>
#include <optional>

namespace ghost::scene {

struct View {
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 1, 0};
    std::optional<double> cut_m; // what is nearer to the eye than this is left out

    glm::dvec3 to_eye() const { return glm::cross(right, up); }
    glm::dvec2 flat(const glm::vec3& point_m) const {
        const glm::dvec3 point(point_m);
        return {glm::dot(point, right), glm::dot(point, up)};
    }
    double depth(const glm::vec3& point_m) const { return glm::dot(glm::dvec3(point_m), to_eye()); }
    bool is_cut_away(const glm::vec3& point_m) const { return cut_m && depth(point_m) > *cut_m; }
};

inline View from_above() {
    return {};
}

// Seen from stage left; only what is to the left of x, as the house sees it, where that is given.
inline View from_the_side(std::optional<double> x_m) {
    return {{0, 1, 0}, {0, 0, 1}, x_m};
}

struct Extent2 {
    glm::dvec2 low{1e300}, high{-1e300};

    bool is_empty() const { return low.x > high.x; }
    void include(const glm::dvec2& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void include(const Extent2& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    void grow(double by) {
        low -= by;
        high += by;
    }
    bool touches(const Extent2& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
               other.low.y <= high.y;
    }
    bool holds(const Extent2& other) const {
        return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x &&
               high.y >= other.high.y;
    }
    glm::dvec2 size() const { return high - low; }
    glm::dvec2 middle() const { return 0.5 * (low + high); }
};

} // namespace ghost::scene
