// SPDX-License-Identifier: Apache-2.0
#include "light/gobos.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <random>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;

// A picture inside the unit disc, transparent outside; value(x, y) is linear, in gate coordinates, y up.
template <class Value>
std::vector<std::uint8_t> picture(int side, const Value& value) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4, 0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const vec2 gate = (vec2(x, side - 1 - y) + 0.5f) / (0.5f * static_cast<float>(side)) - 1.0f;
            if (glm::length(gate) > 1.0f) continue;
            std::uint8_t* t = rgba.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                                             static_cast<std::size_t>(x)) *
                                                4;
            t[0] = t[1] = t[2] = value(gate) ? 255 : 0;
            t[3] = 255;
        }
    return rgba;
}

template <class Value>
shared::Gobos stack_of(int side, const Value& value) {
    shared::Gobos gobos;
    append_gobo(gobos, picture(side, value).data(), side, side);
    return gobos;
}

// Mean over the gate, sampled as a beam would.
float gate_mean(const shared::Gobos& gobos, float blur) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x) {
            const vec2 gate((static_cast<float>(x) + 0.5f) / 150.0f - 1.0f,
                            (static_cast<float>(y) + 0.5f) / 150.0f - 1.0f);
            if (glm::length(gate) > 1.0f) continue;
            sum += static_cast<double>(shared::gobo_sample(1, gate, blur, gobos).y);
            ++count;
        }
    return static_cast<float>(sum / count);
}

// What a faint picture lets through is as exact as what a bright one does, however much it is blurred.
TEST(gobos, TheDarkIsAsExactAsTheBright) {
    for (const float value : {1.0f, 0.7f, 0.1f, 0.0123f, 1e-3f, 2e-4f})
        EXPECT_NEAR(shared::gobo_light(shared::gobo_code(vec3(value))).y / value, 1.0f, 1.0f / 500) << value;
    EXPECT_EQ(shared::gobo_light(shared::gobo_code(vec3(1.0f))), vec3(1.0f));
    EXPECT_EQ(shared::gobo_light(shared::gobo_code(vec3(0.0f))), vec3(0.0f));
    EXPECT_EQ(shared::gobo_light(shared::gobo_code(vec3(1e-9f))), vec3(0.0f));
    EXPECT_NEAR(shared::gobo_light(shared::gobo_code(vec3(0.9999f))).x, 1.0f, 1e-3f)
        << "the next power of two";
    // Light that falls off from a bright rim: between two of its texels every place has a value of its own.
    const shared::Gobos faint = stack_of(256, [](vec2 at) { return at.x > 0.9f; });
    float before = 0.0f;
    int alike = 0, looked = 0;
    for (float x = -0.3f; x < 0.6f; x += 0.004f, ++looked) {
        const float seen = shared::gobo_sample(1, {x, 0.0f}, 0.4f, faint).y;
        alike += seen == before ? 1 : 0;
        before = seen;
    }
    EXPECT_LT(alike, looked / 10) << "steps";
}

TEST(gobos, LayerZeroIsOpenAndMissingLayersAreToo) {
    const shared::Gobos gobos = stack_of(64, [](vec2) { return false; });
    EXPECT_EQ(gobos.layers, 2);
    EXPECT_EQ(shared::gobo_sample(0, {0.3f, 0.1f}, 0.02f, gobos), vec3(1.0f));
    EXPECT_EQ(shared::gobo_sample(99, {0.3f, 0.1f}, 0.02f, gobos), vec3(1.0f));
    EXPECT_EQ(shared::gobo_sample(1, {0.3f, 0.1f}, 0.02f, gobos), vec3(0.0f));
    for (int level = 0; level < shared::kGoboLevels; ++level) {
        const auto side = static_cast<std::size_t>(shared::kGoboSize >> level);
        EXPECT_EQ(gobos.texels[level].size(), 2 * side * side);
    }
}

TEST(gobos, BlurKeepsTheMean) {
    const auto checks = stack_of(512, [](vec2 g) {
        return (static_cast<int>(std::floor(g.x * 6)) + static_cast<int>(std::floor(g.y * 6))) % 2 == 0;
    });
    const auto bars = stack_of(512, [](vec2 g) { return std::fmod(g.x + 8.0f, 0.25f) < 0.125f; });
    const auto dots = stack_of(512, [](vec2 g) {
        const vec2 cell = glm::fract(g * 4.0f) - 0.5f;
        return glm::length(cell) < 0.3f;
    });
    float worst = 0;
    for (const shared::Gobos* gobos : {&checks, &bars, &dots}) {
        const float sharp = gate_mean(*gobos, 0.0f);
        EXPECT_GT(sharp, 0.2f);
        EXPECT_LT(sharp, 0.6f);
        for (int level = 1; level < shared::kGoboLevels; ++level) {
            const float mean = gate_mean(*gobos, shared::kGoboBlurUnit * static_cast<float>(1 << level));
            EXPECT_NEAR(mean, sharp, 0.02f) << level;
            worst = std::max(worst, std::abs(mean - sharp));
        }
    }
    std::printf("mean of blurred gobos: worst difference %.4f\n", static_cast<double>(worst));
}

TEST(gobos, BlurIsADiscOfTheAskedRadius) {
    // A half plane blurred over a disc of radius r: zero below -r, a half on the edge, one above r.
    const auto half = stack_of(512, [](vec2 g) { return g.x > 0.0f; });
    for (const float blur : {0.0625f, 0.125f, 0.25f}) {
        EXPECT_NEAR(shared::gobo_sample(1, {0, 0}, blur, half).y, 0.5f, 0.03f) << blur;
        EXPECT_NEAR(shared::gobo_sample(1, {-1.4f * blur, 0}, blur, half).y, 0.0f, 0.03f) << blur;
        EXPECT_NEAR(shared::gobo_sample(1, {1.4f * blur, 0}, blur, half).y, 1.0f, 0.03f) << blur;
        // Half way in: 1/2 + (asin(1/2) + 1/2 sqrt(3)/2) / pi = 0.8045.
        EXPECT_NEAR(shared::gobo_sample(1, {0.5f * blur, 0}, blur, half).y, 0.8045f, 0.06f) << blur;
    }
}

TEST(gobos, PictureStandsUprightAsInTheFile) {
    const auto quarter = stack_of(256, [](vec2 g) { return g.x > 0.0f && g.y > 0.0f; }); // top right
    EXPECT_NEAR(shared::gobo_sample(1, {0.5f, 0.5f}, 0, quarter).y, 1.0f, 1e-3f);
    EXPECT_NEAR(shared::gobo_sample(1, {-0.5f, 0.5f}, 0, quarter).y, 0.0f, 1e-3f);
    EXPECT_NEAR(shared::gobo_sample(1, {0.5f, -0.5f}, 0, quarter).y, 0.0f, 1e-3f);
}

TEST(gobos, TheRimGoesOnOutside) {
    const auto full = stack_of(512, [](vec2) { return true; });
    for (const float blur : {0.0f, 0.02f, 0.1f, 0.3f})
        for (const float radius : {0.97f, 0.995f, 1.0f, 1.05f, 1.3f})
            for (const float angle : {0.1f, 1.3f, 2.2f, 4.0f})
                EXPECT_NEAR(
                    shared::gobo_sample(1, radius * vec2(std::cos(angle), std::sin(angle)), blur, full).y,
                    1.0f, 0.01f)
                    << radius << " " << angle << " " << blur;
}

TEST(gobos, AnySizeOfPicture) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 700}, {255, 257}, {1000, 10}}) {
        shared::Gobos gobos;
        const std::vector<std::uint8_t> white(static_cast<std::size_t>(width * height) * 4, 255);
        append_gobo(gobos, white.data(), width, height);
        EXPECT_NEAR(gate_mean(gobos, 0.05f), 1.0f, 0.01f) << width << "x" << height;
    }
}

TEST(gobos, AlphaStopsLight) {
    std::vector<std::uint8_t> half_clear(256 * 256 * 4, 255);
    for (std::size_t k = 3; k < half_clear.size(); k += 4) half_clear[k] = 51;
    shared::Gobos gobos;
    append_gobo(gobos, half_clear.data(), 256, 256);
    EXPECT_NEAR(gate_mean(gobos, 0.0f), 0.2f, 0.003f);
}

} // namespace
} // namespace ghost::scene
