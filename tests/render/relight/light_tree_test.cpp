// SPDX-License-Identifier: Apache-2.0
// The tree of summed images without pixels: plans are executed with numbers instead of images.
#include "render/relight/light_tree.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace ghost::render {
namespace {

int ceil_log2(int n) {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(n - 1)));
}

std::vector<int> all_of(int n) {
    std::vector<int> lights(static_cast<std::size_t>(n));
    std::iota(lights.begin(), lights.end(), 0);
    return lights;
}

// Does with whole numbers what the relighter does with images. A slot that was never written is poison. A
// light is its unit times its weight.
class Numbers {
public:
    Numbers(int light_count, int slot_count)
        : tree_(light_count, slot_count), light_(static_cast<std::size_t>(light_count)),
          weight_(static_cast<std::size_t>(light_count), 1),
          slot_(static_cast<std::size_t>(slot_count) + 1, kPoison), slot_count_(slot_count) {}

    void change(int light, std::int64_t value) { light_[static_cast<std::size_t>(light)] = value; }
    void dim(int light, std::int64_t weight) { weight_[static_cast<std::size_t>(light)] = weight; }
    void invalidate_all() {
        tree_.invalidate_all();
        std::fill(slot_.begin(), slot_.end(), kPoison);
    }

    Plan draw(const std::vector<int>& changed, const std::vector<int>& dimmed = {}) {
        const Plan plan = tree_.plan(changed, dimmed);
        int drawn = 0;
        int additions = 0;
        for (std::size_t k = 0; k < plan.sums.size(); ++k) {
            const ImageSum& sum = plan.sums[k];
            EXPECT_EQ(sum.target < 0, k + 1 == plan.sums.size()) << "the frame comes last, and once";
            std::int64_t value = sum.base ? kBase : 0;
            EXPECT_TRUE(!sum.at_unit || (sum.lights.size() == 1 && sum.addends.empty() && !sum.base));
            for (const int light : sum.lights)
                value += light_.at(static_cast<std::size_t>(light)) *
                         (sum.at_unit ? 1 : weight_.at(static_cast<std::size_t>(light)));
            for (const Addend& addend : sum.addends) {
                value += slot_.at(static_cast<std::size_t>(addend.slot)) *
                         (addend.light < 0 ? 1 : weight_.at(static_cast<std::size_t>(addend.light)));
                EXPECT_NE(addend.slot, sum.target) << "target is an addend";
            }
            (sum.target < 0 ? frame_ : slot_.at(static_cast<std::size_t>(sum.target))) = value;
            if (sum.target >= 0) {
                EXPECT_LE(sum.target, slot_count_);
            }
            drawn += static_cast<int>(sum.lights.size());
            additions += std::max(static_cast<int>(sum.addends.size()) + (sum.lights.empty() ? 0 : 1) - 1, 0);
        }
        EXPECT_EQ(plan.drawn, drawn);
        EXPECT_EQ(plan.additions, additions);
        return plan;
    }
    std::int64_t frame() const { return frame_; }
    std::int64_t expected() const {
        return std::inner_product(light_.begin(), light_.end(), weight_.begin(), kBase);
    }

private:
    static constexpr std::int64_t kPoison = std::int64_t{1} << 50;
    static constexpr std::int64_t kBase = std::int64_t{1} << 40;
    LightTree tree_;
    std::vector<std::int64_t> light_, weight_;
    std::vector<std::int64_t> slot_;
    std::int64_t frame_ = kPoison;
    int slot_count_;
};

TEST(light_tree, OneOfNChangingCostsLogN) {
    int most = 0;
    for (int n = 1; n <= 512; ++n) {
        for (const int changing : {0, n / 3, n / 2, n - 1}) {
            LightTree tree(n, 2 * n);
            tree.plan(all_of(n));
            for (int frame = 0; frame < 5; ++frame) {
                const Plan plan = tree.plan(std::vector{changing});
                ASSERT_LE(plan.additions, ceil_log2(n)) << n << " lights, frame " << frame;
                if (frame > 0) {
                    ASSERT_EQ(plan.drawn, 1) << n << " lights, frame " << frame;
                }
                most = std::max(most, plan.additions);
            }
            // From the third time on what rests is one image.
            ASSERT_LE(tree.plan(std::vector{changing}).additions, 1);
        }
    }
    EXPECT_EQ(most, 9);
}

// Another light every frame: its resting predecessor gets its images back on the way, and one that changed
// twice within six frames keeps its way to the root open.
TEST(light_tree, AnotherOfNChangingEveryFrameCostsAFewLogN) {
    std::mt19937 random(1);
    for (const int n : {2, 3, 7, 10, 64, 100, 512}) {
        LightTree tree(n, 2 * n);
        tree.plan(all_of(n));
        for (int light = 0; light < n; ++light) tree.plan(std::vector{light}); // every image made once
        constexpr int kFrames = 400;
        int additions = 0, most = 0;
        for (int frame = 0; frame < kFrames; ++frame) {
            const Plan plan = tree.plan(std::vector{static_cast<int>(random() % static_cast<unsigned>(n))});
            ASSERT_LE(plan.drawn, 2) << n; // itself and its predecessor
            additions += plan.additions;
            most = std::max(most, plan.additions);
        }
        std::printf("%d lights, another one every frame: %.2f additions on average, %d at most\n", n,
                    static_cast<double>(additions) / kFrames, most);
        EXPECT_LE(additions, 5 * ceil_log2(n) * kFrames / 2) << n;
        EXPECT_LE(most, std::min(n + 1, 5 * ceil_log2(n))) << n;
    }
}

TEST(light_tree, NothingChangedNothingToDo) {
    for (const int n : {0, 1, 2, 9, 10}) {
        LightTree tree(n, 100);
        EXPECT_EQ(tree.plan(all_of(n)).drawn, n);
        for (int frame = 0; frame < 3; ++frame) {
            const Plan plan = tree.plan({});
            EXPECT_TRUE(plan.sums.empty());
            EXPECT_EQ(plan.drawn + plan.additions, 0);
        }
        tree.invalidate_all();
        EXPECT_EQ(tree.plan({}).drawn, n) << "forgotten images are drawn again, though no light changed";
    }
}

TEST(light_tree, AllChangingIsDrawnStraightIntoTheFrame) {
    LightTree tree(10, 19);
    for (int frame = 0; frame < 4; ++frame) {
        const Plan plan = tree.plan(all_of(10));
        ASSERT_EQ(plan.sums.size(), 1u);
        EXPECT_EQ(plan.drawn, 10);
        EXPECT_EQ(plan.additions, 0);
    }
}

// Any history and any budget of images: the frame is always the sum of all lights.
TEST(light_tree, EveryHistoryGivesTheSumOfAllLights) {
    std::mt19937 random(42);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int run = 0; run < 1500; ++run) {
        const int n = run % 50 == 0 ? 100 + below(300) : below(24);
        const int slots = run % 5 == 0 ? below(3) : below(2 * n + 2);
        Numbers numbers(n, slots);
        for (const int light : all_of(n)) numbers.change(light, below(1000));
        numbers.draw(all_of(n));
        ASSERT_EQ(numbers.frame(), numbers.expected()) << "run " << run;
        std::vector<int> changed = all_of(n);
        for (int frame = 0; frame < 40; ++frame) {
            const int what = below(10);
            if (what == 0) numbers.invalidate_all();
            if (what < 3)
                changed.clear();
            else if (what < 6 && n > 0) { // another group, often a small one, in any order
                changed = all_of(n);
                std::shuffle(changed.begin(), changed.end(), random);
                changed.resize(static_cast<std::size_t>(what == 3 ? below(n + 1) : std::min(below(3), n)));
            } // else the same group again
            for (const int light : changed) numbers.change(light, below(1000));
            std::vector<int> dimmed;
            for (int light = 0; light < n; ++light)
                if (what % 2 == 0 && below(3) == 0 &&
                    std::find(changed.begin(), changed.end(), light) == changed.end())
                    dimmed.push_back(light);
            for (const int light : dimmed) numbers.dim(light, below(9));
            const Plan plan = numbers.draw(changed, dimmed);
            ASSERT_EQ(numbers.frame(), numbers.expected())
                << "run " << run << ", " << n << " lights, " << slots << " slots, frame " << frame;
            ASSERT_LE(plan.drawn, 2 * n) << "what the relighter has room for";
        }
    }
}

// A fade draws every light once, into an image of its own, and from then on nothing.
TEST(light_tree, AFadeRedrawsNothing) {
    Numbers numbers(10, 19);
    for (const int light : all_of(10)) numbers.change(light, light + 1);
    numbers.draw(all_of(10));
    numbers.draw({}, all_of(10));
    for (int frame = 0; frame < 20; ++frame) {
        for (const int light : all_of(10)) numbers.dim(light, frame + light);
        const Plan plan = numbers.draw({}, all_of(10));
        EXPECT_EQ(plan.drawn, 0) << frame;
        EXPECT_EQ(numbers.frame(), numbers.expected()) << frame;
    }
    // Three that turn beside it are drawn, and nothing else.
    for (int frame = 0; frame < 20; ++frame) {
        const Plan plan = numbers.draw({1, 4, 7}, {0, 2, 3, 5, 6, 8, 9});
        EXPECT_EQ(plan.drawn, 3) << frame;
    }
}

// Past the budget the cost grows with the lights that have no image, it never fails.
TEST(light_tree, WithoutRoomEveryLightIsDrawn) {
    LightTree tree(16, 0);
    tree.plan(all_of(16));
    for (int frame = 0; frame < 3; ++frame) {
        const Plan plan = tree.plan(std::vector{5});
        EXPECT_EQ(plan.drawn, 16);
        EXPECT_EQ(plan.additions, 0);
    }
    // Room for the four subtrees beside one light is all that one changing light needs.
    LightTree small(16, 4);
    small.plan(all_of(16));
    small.plan(std::vector{5});
    EXPECT_EQ(small.plan(std::vector{5}).drawn, 1);
}

} // namespace
} // namespace ghost::render
