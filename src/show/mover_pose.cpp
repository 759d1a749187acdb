// SPDX-License-Identifier: Apache-2.0
#include "show/mover_pose.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace ghost::scene {
namespace {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;

constexpr double kLeastSpread = 1e-6; // m2: points nearer than a millimetre tilt nothing
constexpr double kSteepest = 0.985;   // sine of 80 degrees: beyond, the chains of a truss would cross

dmat4 turned(const dvec3& about_m, double rad, const dvec3& axis) {
    dmat4 matrix = glm::translate(dmat4(1.0), about_m);
    matrix = glm::rotate(matrix, rad, axis);
    return glm::translate(matrix, -about_m);
}

// Slope of the plane of least squares through heights over places, of the least steepness where the places
// lie on a line: the eigenvectors of their covariance that have any extent.
dvec2 slope(std::span<const dvec2> places_m, std::span<const double> heights_m) {
    double xx = 0, xy = 0, yy = 0;
    dvec2 xz(0);
    for (std::size_t k = 0; k < places_m.size(); ++k) {
        const dvec2& p = places_m[k];
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
        xz += p * heights_m[k];
    }
    const double middle = 0.5 * (xx + yy);
    const double apart = std::hypot(0.5 * (xx - yy), xy);
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    const dvec2 longer(std::cos(angle), std::sin(angle));
    const dvec2 shorter(-longer.y, longer.x);
    dvec2 result(0);
    if (middle + apart > kLeastSpread) result += longer * (glm::dot(longer, xz) / (middle + apart));
    if (middle - apart > kLeastSpread) result += shorter * (glm::dot(shorter, xz) / (middle - apart));
    return result;
}

dmat4 hung(const Mover& mover, std::span<const double> values) {
    const auto count = static_cast<double>(mover.axes.size());
    dvec3 middle_m(0);
    double lift_m = 0;
    for (std::size_t k = 0; k < mover.axes.size(); ++k) {
        middle_m += dvec3(mover.axes[k].point_m) / count;
        lift_m += values[k] / count;
    }
    std::vector<dvec2> places_m;
    std::vector<double> heights_m;
    for (std::size_t k = 0; k < mover.axes.size(); ++k) {
        places_m.push_back(dvec2(dvec3(mover.axes[k].point_m) - middle_m));
        heights_m.push_back(values[k] - lift_m);
    }
    const dvec2 rise = slope(places_m, heights_m);
    const double steep = glm::length(rise);
    const dmat4 lifted = glm::translate(dmat4(1.0), dvec3(0, 0, lift_m));
    if (steep < 1e-12) return lifted;
    const dvec3 uphill(rise / steep, 0.0);
    const double tilt_rad = std::asin(std::min(steep, kSteepest));
    return lifted * turned(middle_m, tilt_rad, glm::cross(uphill, dvec3(0, 0, 1)));
}

// A point so far along the path, which goes on straight beyond its ends.
dvec3 along(const std::vector<glm::vec3>& path_m, double at_m) {
    for (std::size_t k = 0; k + 1 < path_m.size(); ++k) {
        const dvec3 from(path_m[k]), to(path_m[k + 1]);
        const double length = glm::distance(from, to);
        if (at_m <= length || k + 2 == path_m.size()) return from + (to - from) * (at_m / length);
        at_m -= length;
    }
    return dvec3(0);
}

struct Axles {
    dvec3 middle_m{0};
    double heading_rad = 0;
};

Axles axles_at(const Mover& mover, double at_m) {
    const double half_m = 0.5 * static_cast<double>(mover.wheelbase_m);
    const dvec3 front = along(mover.path_m, at_m + half_m);
    const dvec3 rear = along(mover.path_m, at_m - half_m);
    return {0.5 * (front + rear), std::atan2(front.y - rear.y, front.x - rear.x)};
}

dmat4 driven(const Mover& mover, double at_m) {
    const Axles home = axles_at(mover, 0), now = axles_at(mover, at_m);
    const dmat4 moved = glm::translate(dmat4(1.0), now.middle_m - home.middle_m);
    if (mover.wheelbase_m <= 0) return moved;
    return moved * turned(home.middle_m, now.heading_rad - home.heading_rad, dvec3(0, 0, 1));
}

// About X, then Y, then Z, as rotation_deg of a fixture.
dmat4 flown(const Mover& mover, std::span<const double> values) {
    double of[6] = {};
    for (std::size_t k = 0; k < mover.axes.size(); ++k)
        of[static_cast<std::size_t>(mover.axes[k].degree)] = values[k];
    const dvec3 centre_m(mover.centre_m);
    const dmat4 moved = glm::translate(dmat4(1.0), dvec3(of[0], of[1], of[2]));
    return moved * turned(centre_m, glm::radians(of[5]), dvec3(0, 0, 1)) *
           turned(centre_m, glm::radians(of[4]), dvec3(0, 1, 0)) *
           turned(centre_m, glm::radians(of[3]), dvec3(1, 0, 0));
}

} // namespace

double length_m(const std::vector<glm::vec3>& path_m) {
    double length = 0;
    for (std::size_t k = 0; k + 1 < path_m.size(); ++k)
        length += glm::distance(dvec3(path_m[k]), dvec3(path_m[k + 1]));
    return length;
}

glm::dmat4 pose_of(const Mover& mover, std::span<const double> values) {
    if (mover.axes.empty()) return dmat4(1.0);
    switch (mover.kind) {
    case MoverKind::hoists:
        return hung(mover, values);
    case MoverKind::linear:
        return glm::translate(dmat4(1.0), values[0] * dvec3(mover.direction));
    case MoverKind::revolve:
        return turned(dvec3(mover.centre_m), glm::radians(values[0]), dvec3(mover.direction));
    case MoverKind::path:
        return driven(mover, values[0]);
    case MoverKind::flown:
        break;
    }
    return flown(mover, values);
}

std::vector<double> values_towards(const Mover& mover, const glm::dvec3& by_m) {
    std::vector<double> values(mover.axes.size(), 0.0);
    if (values.empty()) return values;
    if (mover.kind == MoverKind::linear) values[0] = glm::dot(by_m, dvec3(mover.direction));
    if (mover.kind == MoverKind::flown)
        for (std::size_t k = 0; k < values.size(); ++k)
            if (mover.axes[k].degree <= Degree::z) values[k] = by_m[static_cast<int>(mover.axes[k].degree)];
    if (mover.kind != MoverKind::path) return values;
    // The nearest place of the path.
    const dvec3 wanted = dvec3(mover.path_m.front()) + by_m;
    double nearest = -1, before_m = 0;
    for (std::size_t k = 0; k + 1 < mover.path_m.size(); ++k) {
        const dvec3 from(mover.path_m[k]), way = dvec3(mover.path_m[k + 1]) - from;
        const double length = glm::length(way);
        const double share = std::clamp(glm::dot(wanted - from, way) / (length * length), 0.0, 1.0);
        const double away = glm::distance(wanted, from + share * way);
        if (nearest < 0 || away < nearest) {
            nearest = away;
            values[0] = before_m + share * length;
        }
        before_m += length;
    }
    return values;
}

} // namespace ghost::scene
