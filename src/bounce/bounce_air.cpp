// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_air.h"

#include "shared/haze.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ghost::scene {
namespace {

constexpr float kForwardHaze = 0.1f; // mean cosine from which on haze has a forward fraction
constexpr int kSphere = 6000;        // directions looked at
constexpr int kEvery = 8;            // of them
constexpr float kGolden = 0.61803399f, kFull = 6.28318531f;

std::vector<glm::vec3> directions() {
    std::vector<glm::vec3> all;
    for (int k = 0; k < kSphere; ++k) {
        const float z = 1 - 2 * (static_cast<float>(k) + 0.5f) / kSphere,
                    radius = std::sqrt(std::max(0.0f, 1 - z * z));
        const float angle =
            kFull * (static_cast<float>(k) * kGolden - std::floor(static_cast<float>(k) * kGolden));
        all.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return all;
}

float forward_fraction(const shared::Haze& haze) {
    if (haze.forward_g <= kForwardHaze) return 0;
    constexpr int kSteps = 2000;
    double sum = 0;
    for (int k = 0; k < kSteps; ++k) {
        const float cosine =
            kStraightCosine + (1 - kStraightCosine) * (static_cast<float>(k) + 0.5f) / kSteps;
        sum += static_cast<double>(shared::haze_phase(haze, cosine, 1));
    }
    return static_cast<float>(sum / kSteps) * kFull * (1 - kStraightCosine);
}

} // namespace

BounceAir bounce_air(const shared::Haze& haze) {
    BounceAir air;
    air.forward_fraction = forward_fraction(haze);
    const float kept = 1 - air.forward_fraction;
    air.scattering_per_m = haze.scattering_per_m * kept;
    air.extinction_per_m = haze.extinction_per_m - haze.scattering_per_m * air.forward_fraction;
    const float cut = air.forward_fraction > 0 ? kStraightCosine : 2.0f;
    const auto phase = [&](float cosine) {
        return cosine > cut ? 0.0f : shared::haze_phase(haze, cosine, 1) / kept;
    };

    std::array<std::vector<glm::vec3>, kBounceBins> in_bin;
    std::array<int, kBounceBins> seen{};
    for (const glm::vec3& way : directions()) {
        const std::size_t bin = bounce_bin(way);
        if (seen[bin]++ % kEvery == 0) in_bin[bin].push_back(way);
    }
    for (std::size_t from = 0; from < kBounceBins; ++from) {
        float sum = 0;
        for (std::size_t to = 0; to < kBounceBins; ++to) {
            double mean = 0;
            for (const glm::vec3& a : in_bin[from])
                for (const glm::vec3& b : in_bin[to]) mean += static_cast<double>(phase(glm::dot(a, b)));
            air.scatter[from][to] =
                static_cast<float>(mean / static_cast<double>(in_bin[from].size() * in_bin[to].size()));
            sum += air.scatter[from][to] * bounce_steradians(to);
        }
        for (float& fraction : air.scatter[from]) fraction /= sum;
    }
    constexpr int kTurns = 8;
    for (std::size_t kind = 0; kind < kBounceKinds; ++kind) {
        constexpr std::array<std::size_t, kBounceKinds> kFirst{0, 6, 18};
        const std::size_t bin = kFirst[kind];
        const glm::vec3 middle = bounce_directions()[bin];
        const glm::vec3 aside = glm::normalize(glm::cross(middle, glm::vec3(0.3f, 0.5f, 0.8f)));
        const glm::vec3 other = glm::cross(middle, aside);
        for (std::size_t k = 0; k < BounceAir::kCosines; ++k) {
            const float cosine = -1 + 2 * static_cast<float>(k) / (BounceAir::kCosines - 1);
            const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
            double sum = 0;
            for (int turn = 0; turn < kTurns; ++turn) {
                const float angle = kFull * static_cast<float>(turn) / kTurns;
                const glm::vec3 way =
                    middle * cosine + aside * (sine * std::cos(angle)) + other * (sine * std::sin(angle));
                for (const glm::vec3& b : in_bin[bin]) sum += static_cast<double>(phase(glm::dot(way, b)));
            }
            air.phase[kind][k] = static_cast<float>(sum / static_cast<double>(kTurns * in_bin[bin].size()));
        }
    }
    return air;
}

std::array<float, kBounceBins> BounceAir::into_bins(const glm::vec3& way) const {
    std::array<float, kBounceBins> fractions{};
    float sum = 0;
    for (std::size_t bin = 0; bin < kBounceBins; ++bin) {
        const float at =
            glm::clamp((glm::dot(way, bounce_directions()[bin]) + 1) * 0.5f, 0.0f, 1.0f) * (kCosines - 1);
        const auto below = std::min(static_cast<std::size_t>(at), kCosines - 2);
        const std::array<float, kCosines>& table = phase[bounce_kind(bin)];
        fractions[bin] = glm::mix(table[below], table[below + 1], at - static_cast<float>(below));
        sum += fractions[bin] * bounce_steradians(bin);
    }
    if (sum > 0)
        for (float& fraction : fractions) fraction /= sum;
    return fractions;
}

} // namespace ghost::scene
