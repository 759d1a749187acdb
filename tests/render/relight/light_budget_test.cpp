// SPDX-License-Identifier: Apache-2.0
#include "render/relight/light_budget.h"

#include "render/relight/light_tree.h"

#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace ghost::render {
namespace {

std::vector<shared::Light> turned(std::size_t count, float to) {
    std::vector<shared::Light> lights(count);
    for (shared::Light& light : lights) {
        light.axis_w = glm::vec3(to, 0, 1);
        light.intensity_cd = glm::vec3(100);
    }
    return lights;
}

TEST(LightBudget, AllWhereThereIsTime) {
    LightBudget budget;
    (void)budget.choose(turned(20, 0), 20);
    const std::vector<shared::Light>& shown = budget.choose(turned(20, 1), 20);
    EXPECT_FALSE(budget.is_short());
    for (const shared::Light& light : shown) EXPECT_EQ(light.axis_w.x, 1.0f);
}

TEST(LightBudget, NoLightIsOlderThanFourPictures) {
    for (const std::size_t count : {5u, 16u, 60u, 145u, 400u, 1000u}) {
        LightBudget budget;
        (void)budget.choose(turned(count, 0), 2);
        int most = 0;
        for (int picture = 1; picture <= 12; ++picture) {
            const auto now = static_cast<float>(picture);
            const std::vector<shared::Light>& shown = budget.choose(turned(count, now), 2);
            EXPECT_TRUE(budget.is_short());
            int fresh = 0;
            for (const shared::Light& light : shown) {
                EXPECT_GE(light.axis_w.x, now - LightBudget::kOldest);
                fresh += light.axis_w.x == now ? 1 : 0;
            }
            most = std::max(most, fresh);
        }
        if (count >= 16) {
            EXPECT_LT(most, static_cast<int>(count));
        }
    }
}

TEST(LightBudget, WhatOnlyFadesIsShownAtOnce) {
    LightBudget budget;
    std::vector<shared::Light> lights = turned(60, 0);
    (void)budget.choose(lights, 2);
    for (shared::Light& light : lights) light.intensity_cd = glm::vec3(50);
    EXPECT_EQ(budget.choose(lights, 2).back().intensity_cd.x, 50.0f);
    EXPECT_FALSE(budget.is_short());
}

TEST(LightBudget, WhatChangesMostComesFirstAndWhatRestsTakesNoTurn) {
    LightBudget budget;
    std::vector<shared::Light> lights = turned(64, 0); // eight a branch
    (void)budget.choose(lights, 2);
    // Of three branches that turn the second is bright; the others rest.
    for (std::size_t i = 0; i < 24; ++i) lights[i].axis_w.x = 1;
    for (std::size_t i = 8; i < 16; ++i) lights[i].intensity_cd = glm::vec3(500);
    const std::vector<shared::Light>& shown = budget.choose(lights, 2);
    EXPECT_TRUE(budget.is_short());
    EXPECT_EQ(shown[8].axis_w.x, 1);
    EXPECT_EQ(shown[0].axis_w.x, 0) << "one of three is more than a quarter";
    EXPECT_EQ(shown[16].axis_w.x, 0);
    EXPECT_EQ(budget.choose(lights, 2)[0].axis_w.x, 1);
    EXPECT_EQ(budget.choose(lights, 2)[16].axis_w.x, 1);
    EXPECT_TRUE(budget.is_short());
    (void)budget.choose(lights, 2);
    EXPECT_FALSE(budget.is_short());
}

TEST(LightBudget, WhatGoesDarkDoesNotWait) {
    LightBudget budget;
    std::vector<shared::Light> lights = turned(64, 0);
    (void)budget.choose(lights, 2);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        lights[i].axis_w.x = 1;
        if (i >= 32) lights[i].intensity_cd = glm::vec3(0);
    }
    const std::vector<shared::Light>& shown = budget.choose(lights, 2);
    for (std::size_t i = 32; i < lights.size(); ++i) EXPECT_EQ(shown[i].intensity_cd.x, 0) << i;
}

TEST(LightBudget, HalfOfTheLightsWhereThereIsTimeForThem) {
    LightBudget budget;
    (void)budget.choose(turned(64, 0), 32);
    const std::vector<shared::Light>& shown = budget.choose(turned(64, 1), 32);
    EXPECT_TRUE(budget.is_short());
    int fresh = 0;
    for (const shared::Light& light : shown) fresh += light.axis_w.x == 1 ? 1 : 0;
    EXPECT_EQ(fresh, 32);
}

// Where a part of the lights is brought up to date by turns, each is drawn once a turn and the rest is a few
// images.
TEST(LightBudget, AQuarterOfTheLightsIsDrawnInEachPicture) {
    constexpr int kCount = 400;
    LightTree tree(kCount, 2 * kCount);
    LightBudget budget;
    std::vector<shared::Light> before = budget.choose(turned(kCount, 0), 0);
    std::vector<int> all(kCount);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(tree.plan(all, {}, LightTree::Making::by_branches).drawn, kCount);
    int drawn = 0;
    for (int picture = 1; picture <= 8; ++picture) {
        const std::vector<shared::Light>& shown =
            budget.choose(turned(kCount, static_cast<float>(picture)), 50);
        std::vector<int> changed;
        for (int i = 0; i < kCount; ++i) {
            const auto k = static_cast<std::size_t>(i);
            if (shown[k].axis_w.x != before[k].axis_w.x) changed.push_back(i);
        }
        before = shown;
        const Plan plan = tree.plan(changed, {}, LightTree::Making::by_branches);
        EXPECT_EQ(plan.drawn, static_cast<int>(changed.size()));
        EXPECT_LE(plan.additions, 24);
        drawn += plan.drawn;
    }
    EXPECT_EQ(drawn, 2 * kCount);
}

} // namespace
} // namespace ghost::render
