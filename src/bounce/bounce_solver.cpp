// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_solver.h"

#include "base/check.h"
#include "shared/develop.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace ghost::scene {
namespace {

using glm::vec4;

using Four = float __attribute__((vector_size(16)));
static_assert(sizeof(Four) == sizeof(vec4) && kBounceBins % 2 == 0);

constexpr float kPi = 3.14159265f;
constexpr double kMostRest = 0.95; // of an order that comes back in the next one

double luminance(const glm::dvec3& rgb) {
    return static_cast<double>(shared::luminance_of(glm::vec3(rgb)));
}

} // namespace

glm::dvec3 absorbed_power(const Bounce& bounce, const BounceAir& air, const vec4* flux, const vec4* lux) {
    glm::dvec3 sum(0);
    const float kept_per_m = air.extinction_per_m - air.scattering_per_m;
    for (std::size_t c = 0; c < bounce.fine.cells.size(); ++c)
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            sum += glm::dvec3(glm::vec3(flux[c * kBounceBins + bin]) *
                              (bounce.fine.cells[c].volume_m3 * kept_per_m));
    for (std::size_t s = 0; s < bounce.fine.surfels.size(); ++s) {
        const BounceSurfel& surfel = bounce.fine.surfels[s];
        sum += glm::dvec3(glm::vec3(lux[s]) * (1.0f - surfel.albedo) * surfel.area_m2);
    }
    return sum;
}

BounceSolver::BounceSolver(const Bounce& bounce) : bounce_(bounce) {
    sent_.assign(bounce.fine.slots(), vec4(0));
    arriving_ = sent_;
    coarse_sent_.assign(bounce.coarse.slots(), vec4(0));
    coarse_arriving_ = coarse_sent_;
    share_far();
}

// A block has lit places in the open beside dark ones in niches: what is far gets light of the former, so
// each sends and gets by how much it sees of what is far, against the mean of its block.
void BounceSolver::share_far() {
    constexpr float kLeastShare = 0.02f; // of a block that is shut in: nothing is known from it
    const BounceLevel& fine = bounce_.fine;
    const BounceLevel& coarse = bounce_.coarse;
    const std::vector<float>& share = bounce_.far_share;
    std::vector<float> mean(coarse.slots(), 0);
    for (std::size_t c = 0; c < fine.cells.size(); ++c) {
        const float fraction = fine.cells[c].volume_m3 / coarse.cells[fine.cells[c].block].volume_m3;
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            mean[fine.cells[c].block * kBounceBins + bin] += share[c * kBounceBins + bin] * fraction;
    }
    for (std::size_t s = 0; s < fine.surfels.size(); ++s) {
        const BounceSurfel& surfel = fine.surfels[s];
        mean[coarse.surfel_slot(surfel.cluster)] +=
            share[fine.surfel_slot(s)] * (surfel.area_m2 / coarse.surfels[surfel.cluster].area_m2);
    }
    const auto against = [](float own, float of_all) { return of_all > kLeastShare ? own / of_all : 1.0f; };
    const auto of_parents = [&](const BounceParents& parents, const auto& slot_of) {
        float sum = 0;
        for (std::size_t p = 0; p < parents.node.size() && parents.node[p] != kNoNode; ++p)
            sum += parents.fraction[p] * mean[slot_of(parents.node[p])];
        return sum;
    };
    gets_far_.resize(fine.slots());
    sends_far_.resize(fine.slots());
    for (std::size_t c = 0; c < fine.cells.size(); ++c)
        for (std::size_t bin = 0; bin < kBounceBins; ++bin) {
            const std::size_t slot = c * kBounceBins + bin, back = c * kBounceBins + bounce_reversed(bin),
                              block = fine.cells[c].block * kBounceBins + bounce_reversed(bin);
            gets_far_[slot] =
                against(share[slot], of_parents(bounce_.cell_parents[c], [&](std::uint32_t node) {
                            return node * kBounceBins + bin;
                        }));
            sends_far_[slot] = against(share[back], mean[block]);
        }
    for (std::size_t s = 0; s < fine.surfels.size(); ++s) {
        const std::size_t slot = fine.surfel_slot(s);
        gets_far_[slot] = against(share[slot], of_parents(bounce_.surfel_parents[s], [&](std::uint32_t node) {
                                      return coarse.surfel_slot(node);
                                  }));
        sends_far_[slot] = against(share[slot], mean[coarse.surfel_slot(fine.surfels[s].cluster)]);
    }
}

void BounceSolver::set_haze(const shared::Haze& haze) {
    if (haze_ && std::memcmp(&*haze_, &haze, sizeof haze) == 0) return;
    haze_ = haze;
    air_ = bounce_air(haze);
    weigh(bounce_.near, near_);
    weigh(bounce_.far, far_);
    known_.clear();
}

void BounceSolver::weigh(const BounceRows& rows, std::vector<Term>& terms) const {
    terms.resize(rows.links.size());
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const BounceLink& link = rows.links[k];
        terms[k] = {link.emitter,
                    glm::unpackHalf1x16(link.weight) *
                        std::exp(-air_.extinction_per_m * glm::unpackHalf1x16(link.distance_m))};
    }
}

// Order 0: what leaves after the light of the lamps has landed.
void BounceSolver::begin(const std::vector<shared::Light>& lights, Field& sent) {
    std::fill(sent.begin(), sent.end(), vec4(0));
    solution_.sent_lm = 0;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const glm::vec3 intensity = lights[k].intensity_cd;
        const BounceEntries& entries = known_[k].entries;
        if (intensity == glm::vec3(0)) continue;
        solution_.sent_lm += luminance(glm::dvec3(entries.sent * intensity));
        for (const BounceEntries::InAir& entry : entries.air) {
            const std::array<float, kBounceBins> fractions = air_.into_bins(entry.way);
            const glm::vec3 scattered = entry.lumen_m * intensity *
                                        (air_.scattering_per_m / bounce_.fine.cells[entry.cell].volume_m3);
            vec4* const to = &sent[entry.cell * kBounceBins];
            for (std::size_t bin = 0; bin < kBounceBins; ++bin)
                to[bin] += vec4(scattered * fractions[bin], 0);
        }
        for (const BounceEntries::OnSurface& entry : entries.surfaces) {
            const BounceSurfel& surfel = bounce_.fine.surfels[entry.surfel];
            sent[bounce_.fine.surfel_slot(entry.surfel)] +=
                vec4(entry.reflected * intensity / (kPi * surfel.area_m2), 0);
        }
    }
}

void BounceSolver::step(const Field& sent, Field& arriving) {
    const BounceLevel& fine = bounce_.fine;
    const BounceLevel& coarse = bounce_.coarse;
    // Coarse nodes send the mean of their fine ones.
    std::fill(coarse_sent_.begin(), coarse_sent_.end(), vec4(0));
    for (std::size_t c = 0; c < fine.cells.size(); ++c) {
        const BounceCell& cell = fine.cells[c];
        const float fraction = cell.volume_m3 / coarse.cells[cell.block].volume_m3;
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            coarse_sent_[cell.block * kBounceBins + bin] +=
                sent[c * kBounceBins + bin] * (fraction * sends_far_[c * kBounceBins + bin]);
    }
    for (std::size_t s = 0; s < fine.surfels.size(); ++s) {
        const BounceSurfel& surfel = fine.surfels[s];
        coarse_sent_[coarse.surfel_slot(surfel.cluster)] +=
            sent[fine.surfel_slot(s)] *
            (sends_far_[fine.surfel_slot(s)] * surfel.area_m2 / coarse.surfels[surfel.cluster].area_m2);
    }
    const auto gather = [](const BounceRows& rows, const std::vector<Term>& terms, const Field& from,
                           std::size_t slot) {
        vec4 sum(0);
        for (std::uint32_t k = rows.start[slot]; k < rows.start[slot + 1]; ++k)
            sum += from[terms[k].emitter] * terms[k].weight;
        return sum;
    };
    for (std::size_t slot = 0; slot < coarse_arriving_.size(); ++slot)
        coarse_arriving_[slot] = gather(bounce_.far, far_, coarse_sent_, slot);
    for (std::size_t c = 0; c < fine.cells.size(); ++c) {
        vec4* const to = &arriving[c * kBounceBins];
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            to[bin] = gather(bounce_.near, near_, sent, c * kBounceBins + bin);
        const BounceParents& parents = bounce_.cell_parents[c];
        for (std::size_t p = 0; p < parents.node.size() && parents.node[p] != kNoNode; ++p)
            for (std::size_t bin = 0; bin < kBounceBins; ++bin)
                to[bin] += coarse_arriving_[parents.node[p] * kBounceBins + bin] *
                           (parents.fraction[p] * gets_far_[c * kBounceBins + bin]);
    }
    for (std::size_t s = 0; s < fine.surfels.size(); ++s) {
        vec4& to = arriving[fine.surfel_slot(s)];
        to = gather(bounce_.near, near_, sent, fine.surfel_slot(s));
        const BounceParents& parents = bounce_.surfel_parents[s];
        for (std::size_t p = 0; p < parents.node.size() && parents.node[p] != kNoNode; ++p)
            to += coarse_arriving_[coarse.surfel_slot(parents.node[p])] *
                  (parents.fraction[p] * gets_far_[fine.surfel_slot(s)]);
    }
    // Light is never made from nothing.
    const glm::dvec3 most = sent_power(sent), got = arriving_power(arriving);
    vec4 factor(1);
    for (int c = 0; c < 3; ++c)
        if (got[c] > most[c]) factor[c] = static_cast<float>(most[c] / got[c]);
    if (factor != vec4(1))
        for (vec4& value : arriving) value *= factor;
}

void BounceSolver::send_on(const Field& arriving, Field& sent) const {
    const BounceLevel& fine = bounce_.fine;
    for (std::size_t c = 0; c < fine.cells.size(); ++c) {
        const vec4* const from = &arriving[c * kBounceBins];
        vec4* const to = &sent[c * kBounceBins];
        std::array<Four, kBounceBins> came;
        std::memcpy(came.data(), from, sizeof came);
        for (std::size_t b = 0; b < kBounceBins; b += 2) { // two sums at once: one waits for each addition
            Four one{}, other{};
            for (std::size_t a = 0; a < kBounceBins; ++a) {
                one += came[a] * air_.scatter[a][b];
                other += came[a] * air_.scatter[a][b + 1];
            }
            one *= air_.scattering_per_m;
            other *= air_.scattering_per_m;
            std::memcpy(&to[b], &one, sizeof one);
            std::memcpy(&to[b + 1], &other, sizeof other);
        }
    }
    for (std::size_t s = 0; s < fine.surfels.size(); ++s)
        sent[fine.surfel_slot(s)] = arriving[fine.surfel_slot(s)] * vec4(fine.surfels[s].albedo / kPi, 0);
}

glm::dvec3 BounceSolver::sent_power(const Field& sent) const {
    glm::dvec3 sum(0);
    for (std::size_t c = 0; c < bounce_.fine.cells.size(); ++c)
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            sum += glm::dvec3(glm::vec3(sent[c * kBounceBins + bin]) *
                              (bounce_.fine.cells[c].volume_m3 * bounce_steradians(bin)));
    for (std::size_t s = 0; s < bounce_.fine.surfels.size(); ++s)
        sum += glm::dvec3(glm::vec3(sent[bounce_.fine.surfel_slot(s)]) *
                          (kPi * bounce_.fine.surfels[s].area_m2));
    return sum;
}

// What surfaces and haze stop.
glm::dvec3 BounceSolver::arriving_power(const Field& arriving) const {
    glm::dvec3 sum(0);
    for (std::size_t c = 0; c < bounce_.fine.cells.size(); ++c)
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            sum += glm::dvec3(glm::vec3(arriving[c * kBounceBins + bin]) *
                              (bounce_.fine.cells[c].volume_m3 * air_.extinction_per_m));
    for (std::size_t s = 0; s < bounce_.fine.surfels.size(); ++s)
        sum += glm::dvec3(glm::vec3(arriving[bounce_.fine.surfel_slot(s)]) * bounce_.fine.surfels[s].area_m2);
    return sum;
}

BouncePower BounceSolver::power_of(const Field& arriving) const {
    glm::dvec3 surfaces(0), reflected(0), air(0);
    for (std::size_t c = 0; c < bounce_.fine.cells.size(); ++c)
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            air += glm::dvec3(glm::vec3(arriving[c * kBounceBins + bin]) *
                              (bounce_.fine.cells[c].volume_m3 * air_.scattering_per_m));
    for (std::size_t s = 0; s < bounce_.fine.surfels.size(); ++s) {
        const BounceSurfel& surfel = bounce_.fine.surfels[s];
        const glm::vec3 lumens = glm::vec3(arriving[bounce_.fine.surfel_slot(s)]) * surfel.area_m2;
        surfaces += glm::dvec3(lumens);
        reflected += glm::dvec3(lumens * surfel.albedo);
    }
    return {luminance(surfaces), luminance(reflected), luminance(air), luminance(reflected + air)};
}

const BounceSolution& BounceSolver::solve(const std::vector<shared::Light>& lights,
                                          const std::vector<const LampSight*>& sights,
                                          const shared::Gobos& gobos, int passes) {
    CHECK(haze_.has_value());
    CHECK_EQ(lights.size(), sights.size());
    known_.resize(lights.size());
    for (std::size_t k = 0; k < lights.size(); ++k) {
        shared::Light unit = lights[k];
        unit.intensity_cd = glm::vec3(1);
        unit.bounce_cd = glm::vec3(0);
        Known& known = known_[k];
        if (lights[k].intensity_cd == glm::vec3(0)) continue;
        if (known.sight == sights[k] && sights[k] && std::memcmp(&known.unit, &unit, sizeof unit) == 0)
            continue;
        std::memcpy(&known.unit, &unit, sizeof unit);
        known.sight = sights[k];
        known.entries = sights[k] ? bounce_entries(bounce_, unit, gobos, *sights[k], air_.extinction_per_m)
                                  : BounceEntries{};
    }
    begin(lights, sent_);
    kept_.clear();
    solution_.orders.clear();
    Field total(sent_.size(), vec4(0));
    solution_.first_lm = sent_power(sent_);
    solution_.orders.push_back({0, 0, 0, luminance(solution_.first_lm)});
    glm::dvec3 before(0), last(0);
    for (int order = 1; order <= passes + 1; ++order) {
        if (order > 1) send_on(arriving_, sent_);
        step(sent_, arriving_);
        before = last;
        last = arriving_power(arriving_);
        solution_.orders.push_back(power_of(arriving_));
        if (keeps_orders_) kept_.push_back(arriving_);
        if (order == passes + 1 && order > 2) { // what follows is a geometric series
            // All that is left may end where more of it is kept than before: of it no more is kept than was
            // sent.
            const vec4* const flux = arriving_.data();
            const glm::dvec3 sent = sent_power(sent_),
                             kept = absorbed_power(bounce_, air_, flux, flux + bounce_.fine.surfel_slot(0));
            vec4 rest(1);
            for (int c = 0; c < 3; ++c)
                if (before[c] > 0) {
                    const double series = 1 / (1 - std::min(kMostRest, last[c] / before[c]));
                    rest[c] = static_cast<float>(kept[c] * series > sent[c] ? sent[c] / kept[c] : series);
                }
            for (vec4& value : arriving_) value *= rest;
        }
        for (std::size_t k = 0; k < total.size(); ++k) total[k] += arriving_[k];
    }
    const std::size_t cells = bounce_.fine.cells.size() * kBounceBins;
    solution_.flux.assign(total.begin(), total.begin() + static_cast<std::ptrdiff_t>(cells));
    solution_.lux.assign(total.begin() + static_cast<std::ptrdiff_t>(cells), total.end());
    return solution_;
}

} // namespace ghost::scene
