#pragma once
// SPDX-License-Identifier: Apache-2.0
// Solves bounced light: what the lamps send first (bounce_inject.h), and from there order by order along the
// links of scene::Bounce. An order never carries more than the one before it sent out. Everything is summed
// in a fixed order: the same lights and haze give the same bytes, whatever was solved before. One thread at a
// time; the bounce must outlive it.

#include "bounce/bounce.h"
#include "bounce/bounce_air.h"
#include "bounce/bounce_inject.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ghost::scene {

// Lumens (luminance) of one order.
struct BouncePower {
    double on_surfaces = 0; // arrives
    double reflected = 0;
    double in_air = 0;  // is scattered
    double emitted = 0; // leaves towards the next order
};

struct BounceSolution {
    // All orders from 1 on.
    std::vector<glm::vec4> lux;      // of each surfel
    std::vector<glm::vec4> flux;     // of each cell and bin: radiance times steradians
    std::vector<BouncePower> orders; // 0: straight from the lamps; then those that were solved
    double sent_lm = 0;
    glm::dvec3 first_lm{0}; // by channel, what leaves after the light of the lamps has landed
};

// Of light that arrives, what surfaces and haze keep: lumens by channel. Of a whole solution at most its
// first_lm; the rest escaped.
glm::dvec3 absorbed_power(const Bounce& bounce, const BounceAir& air, const glm::vec4* flux,
                          const glm::vec4* lux);

class BounceSolver {
public:
    explicit BounceSolver(const Bounce& bounce);

    // Cheap where the haze is the same; else weights of all links are made again.
    void set_haze(const shared::Haze& haze);
    const BounceAir& air() const { return air_; }
    // passes: orders solved beyond the first; the rest is their geometric series. sights: one a light, null:
    // it is left out. Lights that did not change cost next to nothing.
    const BounceSolution& solve(const std::vector<shared::Light>& lights,
                                const std::vector<const LampSight*>& sights, const shared::Gobos& gobos,
                                int passes = 2);
    const BounceSolution& solution() const { return solution_; }
    // Keeps each order's own light on surfels (lux) and in cells, for measurements.
    void keep_orders(bool keeps) { keeps_orders_ = keeps; }
    const std::vector<std::vector<glm::vec4>>& kept_orders() const { return kept_; }

private:
    using Field = std::vector<glm::vec4>;
    struct Term {
        std::uint32_t emitter;
        float weight;
    };
    struct Known {
        shared::Light unit; // at an intensity of one
        const LampSight* sight = nullptr;
        BounceEntries entries;
    };

    void share_far();
    void weigh(const BounceRows& rows, std::vector<Term>& terms) const;
    void begin(const std::vector<shared::Light>& lights, Field& sent);
    void step(const Field& sent, Field& arriving);
    void send_on(const Field& arriving, Field& sent) const;
    BouncePower power_of(const Field& arriving) const;
    glm::dvec3 sent_power(const Field& sent) const;
    glm::dvec3 arriving_power(const Field& arriving) const;

    const Bounce& bounce_;
    std::optional<shared::Haze> haze_;
    BounceAir air_;
    std::vector<Term> near_, far_;
    std::vector<float> gets_far_, sends_far_; // of fine slots, against the coarse ones that they stand for
    std::vector<Known> known_;
    Field sent_, arriving_, coarse_sent_, coarse_arriving_;
    BounceSolution solution_;
    bool keeps_orders_ = false;
    std::vector<Field> kept_;
};

} // namespace ghost::scene
