#pragma once
// SPDX-License-Identifier: Apache-2.0
// Where particles of light begin: directions of all lamps together, as often as light goes there. Each gate
// is cut into squares, each drawn in proportion to the lumens it sends; what a particle weighs follows from
// its beam where it lands, so that squares need not be exact, only never empty where there is light. Const
// calls from any thread; lights and gobos must outlive it.

#include "reference/reference_beam.h"

#include <cstddef>
#include <vector>

namespace ghost::bake {

// Of linear Rec.2020: lumens of a flux, candela of an intensity.
double luminance(const glm::dvec3& rgb);

struct WalkStart {
    std::size_t lamp = 0;
    glm::dvec3 from_m{0}; // on the lens
    glm::dvec3 apex_m{0};
    glm::dvec3 way{0};      // unit
    double per_candela = 0; // lumens of a particle for each candela towards where it lands
};

class WalkSource {
public:
    WalkSource(const std::vector<shared::Light>& lights, const shared::Gobos& gobos,
               const BeamOverride& beam);

    bool is_dark() const { return fractions_.empty(); }
    // u: even numbers in 0..1, the first chooses lamp and square.
    WalkStart start(const double (&u)[3]) const;
    // Candela towards a point, metres from the apex.
    glm::dvec3 candela(std::size_t lamp, const glm::dvec3& offset_m) const;

private:
    struct Lamp {
        const shared::Light* light;
        ReferenceBeam beam;
    };
    std::vector<Lamp> lamps_;
    std::vector<double> fractions_; // running sums over the squares of all lamps, the last one is 1
};

} // namespace ghost::bake
