// SPDX-License-Identifier: Apache-2.0
#include "render/relight/light_budget.h"

#include "render/relight/light_units.h"

#include <algorithm>
#include <bit>
#include <glm/glm.hpp>
#include <numeric>

namespace ghost::render {
namespace {

struct Branch {
    bool is_changed = false;
    bool is_dark = true; // wanted to be
    int lights = 0;
    float change_cd = 0; // of all its lights
};

Branch change_of(const shared::Light& shown, const shared::Light& wanted) {
    const bool turns = !same_shape(shown, wanted);
    // What turns leaves all of its light here and brings it there.
    const glm::vec3 change_cd =
        turns ? shown.intensity_cd + wanted.intensity_cd : glm::abs(shown.intensity_cd - wanted.intensity_cd);
    return {turns || shown.intensity_cd != wanted.intensity_cd, wanted.intensity_cd == glm::vec3(0), 1,
            change_cd.x + change_cd.y + change_cd.z};
}

} // namespace

const std::vector<shared::Light>& LightBudget::choose(const std::vector<shared::Light>& wanted, int most) {
    int turned = 0;
    if (most > 0 && shown_.size() == wanted.size())
        for (std::size_t i = 0; i < wanted.size(); ++i) turned += same_shape(shown_[i], wanted[i]) ? 0 : 1;
    is_short_ = turned > most;
    if (most <= 0 || !is_short_) {
        is_short_ = false;
        ages_ = {};
        room_ = 0;
        shown_ = wanted;
        return shown_;
    }
    // More branches than parts: the last ones may have no lights.
    static_assert(kBranches == 2 * kOldest);
    const std::size_t leaves = std::max(std::bit_ceil(wanted.size()), kBranches);
    const auto branch_of = [&](std::size_t light) { return light * kBranches / leaves; };
    std::array<Branch, kBranches> branches;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        Branch& branch = branches[branch_of(i)];
        const Branch change = change_of(shown_[i], wanted[i]);
        branch.is_changed |= change.is_changed;
        branch.is_dark &= change.is_dark;
        branch.lights += change.lights;
        branch.change_cd += change.change_cd;
    }
    int to_draw = 0;
    const auto is_free = [](const Branch& branch) { return !branch.is_changed || branch.is_dark; };
    for (const Branch& branch : branches) to_draw += is_free(branch) ? 0 : branch.lights;
    std::array<std::size_t, kBranches> order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return ages_[a] != ages_[b] ? ages_[a] > ages_[b] : branches[a].change_cd > branches[b].change_cd;
    });
    // As many as there is time for, a quarter at least; what a branch has more the next picture has less.
    room_ += std::max(most, (to_draw + kOldest - 1) / kOldest);
    bool draws = false;
    std::array<bool, kBranches> is_fresh{};
    for (const std::size_t k : order) {
        const bool is_due = room_ > 0 || !draws || ages_[k] + 1 >= kOldest;
        is_fresh[k] = is_free(branches[k]) || is_due;
        if (!is_free(branches[k]) && is_due) {
            room_ -= branches[k].lights;
            draws = true;
        }
        ages_[k] = is_fresh[k] ? 0 : ages_[k] + 1;
    }
    room_ = std::min(room_, 0);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (is_fresh[branch_of(i)]) shown_[i] = wanted[i];
    return shown_;
}

} // namespace ghost::render
