#pragma once
// SPDX-License-Identifier: Apache-2.0
// A stage in which light bounces at level room, and what must hold of every solution: no more is kept than
// was sent, order by order and in the end, and nothing is negative or no number.

#include "bake/bounce.h"
#include "bounce/bounce_solver.h"
#include "bounce/bounce_volumes.h"

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace ghost::bake {

inline bool is_light(const glm::vec3& value) {
    return glm::all(glm::greaterThanEqual(value, glm::vec3(0))) && std::isfinite(value.x + value.y + value.z);
}

class BounceTrial {
public:
    // Where no light can bounce that is said, and is_made() is false.
    BounceTrial(const scene::Stage& stage, const std::vector<shared::Light>& lights) : tracer_(stage) {
        BounceOptions options;
        options.most_surfels /= 4;
        options.most_cells /= 4;
        options.rays_of_surfel /= 2;
        options.rays_of_cell /= 2;
        options.rays_of_block /= 2;
        options.box = scene::bounce_box(stage, lights);
        for (const shared::Light& light : lights) options.seeds_m.push_back(place_of(light));
        Result<scene::Bounce> made = make_bounce(tracer_, options);
        EXPECT_TRUE(made.ok() || !made.error().what.empty());
        if (!made.ok()) return;
        bounce_ = std::move(*made);
        index_.emplace(bounce_);
        solver_.emplace(bounce_);
    }

    bool is_made() const { return solver_.has_value(); }
    const scene::Bounce& bounce() const { return bounce_; }

    // The most of what left after the lamps' light had landed, by channel, that was kept in the end.
    double solve(const std::vector<shared::Light>& lights, const shared::Gobos& gobos,
                 const shared::Haze& haze, int passes) {
        std::vector<const scene::LampSight*> of_lights;
        for (const shared::Light& light : lights) {
            const glm::vec3 place_m = place_of(light);
            auto& sight = sights_[{place_m.x, place_m.y, place_m.z}];
            if (sight.surfel.empty()) sight = lamp_sight(tracer_, bounce_, *index_, place_m);
            of_lights.push_back(&sight);
        }
        solver_->set_haze(haze);
        const scene::BounceSolution& solution = solver_->solve(lights, of_lights, gobos, passes);
        constexpr double kRounding = 1.001;
        double before = solution.sent_lm;
        for (const scene::BouncePower& order : solution.orders) {
            EXPECT_LE(order.emitted, before * kRounding);
            before = order.emitted;
        }
        for (const auto* field : {&solution.lux, &solution.flux})
            EXPECT_TRUE(std::all_of(field->begin(), field->end(),
                                    [](const glm::vec4& light) { return is_light(light); }));
        scene::BounceVolumes volumes;
        fill_lux(bounce_, solution, volumes);
        fill_glow(bounce_, solver_->air(), solution, lights.empty() ? glm::vec3(0) : lights[0].position_m,
                  volumes);
        for (const auto* volume : {&volumes.surfaces, &volumes.air, &volumes.glow})
            EXPECT_TRUE(std::all_of(volume->texels.begin(), volume->texels.end(), [](std::uint64_t texel) {
                return is_light(glm::unpackHalf4x16(texel));
            }));
        const glm::dvec3 kept =
            absorbed_power(bounce_, solver_->air(), solution.flux.data(), solution.lux.data());
        double most = 0;
        for (int c = 0; c < 3; ++c)
            if (kept[c] > 0) most = std::max(most, kept[c] / solution.first_lm[c]);
        EXPECT_LE(most, kRounding);
        return most;
    }

private:
    static glm::vec3 place_of(const shared::Light& light) { return light.position_m - light.off_map_m; }

    const Tracer tracer_;
    scene::Bounce bounce_;
    std::optional<SurfelIndex> index_;
    std::map<std::tuple<float, float, float>, scene::LampSight> sights_;
    std::optional<scene::BounceSolver> solver_;
};

} // namespace ghost::bake
