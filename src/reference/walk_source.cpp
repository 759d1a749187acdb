// SPDX-License-Identifier: Apache-2.0
#include "reference/private/walk_source.h"

#include "shared/develop.h"

#include <algorithm>
#include <cmath>

namespace ghost::bake {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::size_t kSquares = 24; // of a gate, across and down
constexpr double kTypical_m = 10;    // from the lens, where squares are weighed
constexpr double kLeastShare = 0.02; // of the mean square, for what falls between the points looked at
constexpr int kLooks = 3;            // across and down a square

// Of the gate's plane, at a place in gate radii times tan_field.
double steradians_per_area(const dvec2& slope) {
    return std::pow(1.0 + glm::dot(slope, slope), -1.5);
}

double half_slope(const shared::Light& light) {
    return static_cast<double>(light.cut_radius) * static_cast<double>(light.tan_field);
}

} // namespace

double luminance(const dvec3& rgb) {
    return static_cast<double>(shared::luminance_of(glm::vec3(rgb)));
}

WalkSource::WalkSource(const std::vector<shared::Light>& lights, const shared::Gobos& gobos,
                       const BeamOverride& beam) {
    double sum = 0;
    for (const shared::Light& light : lights) lamps_.push_back({&light, ReferenceBeam(light, gobos, beam)});
    for (const Lamp& lamp : lamps_) {
        const double half = half_slope(*lamp.light), side = 2 * half / kSquares;
        const double z_m = static_cast<double>(lamp.light->lens_m) + kTypical_m;
        std::vector<double> squares;
        double lumens = 0;
        for (std::size_t k = 0; k < kSquares * kSquares; ++k) {
            double flux = 0;
            for (int look = 0; look < kLooks * kLooks; ++look) {
                const int row = look / kLooks;
                const dvec2 slope{
                    (static_cast<double>(k % kSquares) + (look % kLooks + 0.5) / kLooks) * side - half,
                    (static_cast<double>(k / kSquares) + (row + 0.5) / kLooks) * side - half};
                flux += luminance(lamp.beam.candela(dvec3(slope, 1.0) * z_m)) * steradians_per_area(slope);
            }
            squares.push_back(flux * side * side / (kLooks * kLooks));
            lumens += squares.back();
        }
        const double least = lumens * kLeastShare / static_cast<double>(squares.size());
        for (const double flux : squares) fractions_.push_back(sum += std::max(flux, least));
    }
    if (!(sum > 0) || !std::isfinite(sum)) {
        fractions_.clear();
        return;
    }
    for (double& fraction : fractions_) fraction /= sum;
}

WalkStart WalkSource::start(const double (&u)[3]) const {
    const auto found = std::upper_bound(fractions_.begin(), fractions_.end() - 1, u[0]);
    const auto index = static_cast<std::size_t>(found - fractions_.begin());
    const double chance = *found - (index > 0 ? fractions_[index - 1] : 0.0);
    const std::size_t square = index % (kSquares * kSquares);
    WalkStart start;
    start.lamp = index / (kSquares * kSquares);
    const shared::Light& light = *lamps_[start.lamp].light;
    const double half = half_slope(light), side = 2 * half / kSquares;
    const dvec2 slope{(static_cast<double>(square % kSquares) + u[1]) * side - half,
                      (static_cast<double>(square / kSquares) + u[2]) * side - half};
    start.apex_m = dvec3(light.position_m);
    const dvec3 to_lens = dvec3(light.axis_u) * slope.x + dvec3(light.axis_v) * slope.y + dvec3(light.axis_w);
    start.way = glm::normalize(to_lens);
    // A hair beyond the lens: there is no light before it.
    start.from_m = start.apex_m + to_lens * (static_cast<double>(light.lens_m) + 1e-3);
    start.per_candela = steradians_per_area(slope) * side * side / chance;
    return start;
}

dvec3 WalkSource::candela(std::size_t lamp, const dvec3& offset_m) const {
    return lamps_[lamp].beam.candela(lamps_[lamp].beam.to_gate(offset_m));
}

} // namespace ghost::bake
