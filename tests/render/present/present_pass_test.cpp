// SPDX-License-Identifier: Apache-2.0
// What is put together for a surface, on images as surfaces have them.
#include "render/present/screen.h"
#include "support/one_device.h"

#include "gpu/buffer.h"

#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>
#include <vector>

namespace ghost::render {
namespace {

constexpr std::uint32_t kWidth = 8, kHeight = 4; // of the surface

struct Pixel8 {
    std::uint8_t r, g, b, a;
    bool operator==(const Pixel8&) const = default;
};

class PresentPassTest : public testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(device().validation_errors(), 0u); }

    static gpu::Texture picture_of(std::uint32_t width, std::uint32_t height, const auto& pixel_at) {
        gpu::Texture made(device(), {width, height, 1, 1, VK_FORMAT_R8G8B8A8_UNORM, true, true});
        std::vector<Pixel8> pixels;
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x) pixels.push_back(pixel_at(x, y));
        made.write(0, pixels.data(), pixels.size() * sizeof(Pixel8));
        return made;
    }

    // In the bytes that are copied to the surface.
    template <class Texel>
    std::vector<Texel> shown(const ScreenPicture& picture, const PicturePlace& place,
                             const gpu::Texture* covers, const SurfaceFormat& format) {
        const gpu::Texture to(device(), {kWidth, kHeight, 1, 1, format.drawn, true, false});
        const gpu::Buffer back(device(), sizeof(Texel) * kWidth * kHeight, gpu::Access::readback);
        gpu::Commands commands(device());
        commands.begin();
        pass_.record(commands, picture, place, covers, format, to);
        commands.copy(to, back);
        commands.submit_and_wait();
        std::vector<Texel> texels(std::size_t{kWidth} * kHeight);
        std::memcpy(texels.data(), back.mapped(), texels.size() * sizeof(Texel));
        return texels;
    }

    PresentPass pass_{device()};
    const SurfaceFormat plain_{{VK_FORMAT_R8G8B8A8_UNORM, VK_COLOR_SPACE_SRGB_NONLINEAR_KHR},
                               VK_FORMAT_R8G8B8A8_UNORM};
};

Pixel8 gradient(std::uint32_t x, std::uint32_t y) {
    return {static_cast<std::uint8_t>(30 * x), static_cast<std::uint8_t>(60 * y), 200, 255};
}

TEST_F(PresentPassTest, a_picture_that_fits_is_shown_byte_for_byte) {
    const gpu::Texture picture = picture_of(kWidth, kHeight, gradient);
    const auto texels = shown<Pixel8>({&picture}, {0, 0, kWidth, kHeight}, nullptr, plain_);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x)
            EXPECT_EQ(texels[y * kWidth + x], gradient(x, y)) << x << ", " << y;
    SurfaceFormat swapped = plain_;
    swapped.swaps = true;
    EXPECT_EQ(shown<Pixel8>({&picture}, {0, 0, kWidth, kHeight}, nullptr, swapped)[1],
              (Pixel8{200, 0, 30, 255}));
}

TEST_F(PresentPassTest, beside_it_all_is_black) {
    const gpu::Texture picture = picture_of(4, 2, [](auto, auto) { return Pixel8{255, 255, 255, 255}; });
    const auto texels = shown<Pixel8>({&picture}, {2, 1, 4, 2}, nullptr, plain_);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const bool inside = x >= 2 && x < 6 && y >= 1 && y < 3;
            EXPECT_EQ(texels[y * kWidth + x].r, inside ? 255 : 0) << x << ", " << y;
        }
    const auto without = shown<Pixel8>({}, {}, nullptr, plain_);
    EXPECT_EQ(without[0], (Pixel8{0, 0, 0, 255}));
}

TEST_F(PresentPassTest, a_coarse_picture_is_smoothed_and_a_fine_one_averaged) {
    const auto halves = [](std::uint32_t x, std::uint32_t) {
        return x % 2 == 0 ? Pixel8{0, 0, 0, 255} : Pixel8{200, 200, 200, 255};
    };
    const gpu::Texture coarse = picture_of(2, 1, halves), fine = picture_of(4 * kWidth, 4 * kHeight, halves);
    const PicturePlace whole{0, 0, kWidth, kHeight};
    const auto smooth = shown<Pixel8>({&coarse}, whole, nullptr, plain_);
    EXPECT_EQ(smooth[0].r, 0);
    EXPECT_EQ(smooth[7].r, 200);
    EXPECT_NEAR(smooth[3].r, 75, 2);
    EXPECT_NEAR(smooth[4].r, 125, 2);
    for (const Pixel8& pixel : shown<Pixel8>({&fine}, whole, nullptr, plain_)) EXPECT_NEAR(pixel.r, 100, 2);
}

TEST_F(PresentPassTest, what_covers_it_lies_over_it_as_a_window_has_it) {
    const gpu::Texture picture = picture_of(kWidth, kHeight, [](auto, auto) {
        return Pixel8{100, 50, 200, 255};
    });
    gpu::Texture covers(device(), {kWidth, kHeight, 1, 1, VK_FORMAT_B8G8R8A8_UNORM, false, false});
    std::vector<Pixel8> over(kWidth * kHeight, Pixel8{0, 0, 0, 0});
    over[1] = {0, 0, 255, 255}; // red, for blue stands first
    over[2] = {0, 64, 0, 128};  // half of dark green
    covers.write(0, over.data(), over.size() * sizeof(Pixel8));
    const auto texels = shown<Pixel8>({&picture}, {0, 0, kWidth, kHeight}, &covers, plain_);
    EXPECT_EQ(texels[0], (Pixel8{100, 50, 200, 255}));
    EXPECT_EQ(texels[1], (Pixel8{255, 0, 0, 255}));
    EXPECT_NEAR(texels[2].r, 50, 1);
    EXPECT_NEAR(texels[2].g, 25 + 64, 1);
    EXPECT_NEAR(texels[2].b, 100, 1);
}

// Numbers of ITU-R BT.2100: PQ of 0, 100 and 10000 cd/m^2; white of the picture has 203.
TEST_F(PresentPassTest, hdr10_shows_white_as_bright_as_paper) {
    EXPECT_NEAR(shared::pq_encode_one(0), 0.0f, 1e-4f);
    EXPECT_NEAR(shared::pq_encode_one(100), 0.5081f, 1e-4f);
    EXPECT_NEAR(shared::pq_encode_one(203), 0.5807f, 1e-4f);
    EXPECT_NEAR(shared::pq_encode_one(10000), 1.0f, 1e-4f);
    const gpu::Texture picture = picture_of(kWidth, kHeight, [](std::uint32_t x, auto) {
        return x == 0   ? Pixel8{255, 255, 255, 255}
               : x == 1 ? Pixel8{255, 0, 0, 255}
                        : Pixel8{static_cast<std::uint8_t>(30 * x), 60, 90, 255};
    });
    SurfaceFormat pq{{VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_COLOR_SPACE_HDR10_ST2084_EXT},
                     VK_FORMAT_A2B10G10R10_UNORM_PACK32,
                     false,
                     Encoding::pq};
    if (device().first_format(std::array{pq.drawn, VK_FORMAT_UNDEFINED},
                              VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT) != pq.drawn)
        GTEST_SKIP() << "no shader stores to ten bits on this device";
    const auto texels = shown<std::uint32_t>({&picture}, {0, 0, kWidth, kHeight}, nullptr, pq);
    for (std::uint32_t x = 0; x < kWidth; ++x) {
        const glm::vec3 srgb = x == 0   ? glm::vec3(1)
                               : x == 1 ? glm::vec3(1, 0, 0)
                                        : glm::vec3(30.0f * static_cast<float>(x), 60, 90) / 255.0f;
        const glm::vec3 wanted =
            shared::encode_light(shared::rec2020_of_rec709() * shared::srgb_decode(srgb), shared::kEncodePq);
        for (int c = 0; c < 3; ++c) {
            const std::uint32_t ten = (texels[x] >> (10 * c)) & 1023u;
            EXPECT_NEAR(static_cast<float>(ten), 1023.0f * wanted[c], 1.5f) << x << ", " << c;
        }
    }
    EXPECT_NEAR(static_cast<float>(texels[0] & 1023u), 0.5807f * 1023, 1.5f);
    // Red of Rec.709 lies within Rec.2020: it has some green there.
    EXPECT_GT((texels[1] >> 10) & 1023u, 200u);
    pq.swaps = true;
    EXPECT_EQ(shown<std::uint32_t>({&picture}, {0, 0, kWidth, kHeight}, nullptr, pq)[1] >> 20 & 1023u,
              texels[1] & 1023u);
}

TEST_F(PresentPassTest, scrgb_is_linear_and_goes_on_above_white) {
    gpu::Texture light(device(), {kWidth, kHeight, 1, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, true});
    std::vector<std::uint64_t> texels(kWidth * kHeight);
    for (std::size_t k = 0; k < texels.size(); ++k) {
        const float value = 0.5f * static_cast<float>(k % kWidth); // up to 3.5 times white
        texels[k] = glm::packHalf4x16({value, value, value, 1});
    }
    light.write(0, texels.data(), texels.size() * sizeof texels[0]);
    const SurfaceFormat scrgb{{VK_FORMAT_R16G16B16A16_SFLOAT, VK_COLOR_SPACE_EXTENDED_SRGB_LINEAR_EXT},
                              VK_FORMAT_R16G16B16A16_SFLOAT,
                              false,
                              Encoding::scrgb};
    const auto there = shown<std::uint64_t>({&light, true}, {0, 0, kWidth, kHeight}, nullptr, scrgb);
    for (std::uint32_t x = 0; x < kWidth; ++x) {
        const glm::vec4 texel = glm::unpackHalf4x16(there[x]);
        const float wanted = 0.5f * static_cast<float>(x) * 203.0f / 80.0f;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(texel[c], wanted, 0.002f * wanted + 1e-3f) << x;
    }
}

TEST(ShownLight, is_the_tone_curve_up_to_white_and_goes_on_to_the_peak) {
    const float peak = shared::kPeak_cd_m2 / shared::kWhite_cd_m2;
    for (const shared::uint tone : {shared::kToneAgx, shared::kToneAces}) {
        for (const float exposed : {0.0f, 0.02f, 0.18f, 0.5f, 0.99f}) {
            const glm::vec3 light(exposed);
            const glm::vec3 curve =
                tone == shared::kToneAces ? shared::tone_aces(light) : shared::tone_agx(light);
            EXPECT_NEAR(shared::shown_light(light, 1, tone, peak).x, curve.x, 1e-6f) << exposed;
        }
        float before = 0;
        for (float exposed = 0.01f; exposed < 1e4f; exposed *= 1.1f) {
            const float now = shared::shown_light(glm::vec3(exposed), 1, tone, peak).x;
            EXPECT_GE(now, before - 1e-5f) << exposed;
            EXPECT_LE(now, peak);
            before = now;
        }
        EXPECT_GT(before, 0.8f * peak) << "highlights are as bright as the display may have them";
        EXPECT_LE(shared::shown_light(glm::vec3(100), 1, tone, 1.0f).x, 1.0f);
    }
    EXPECT_FLOAT_EQ(shared::shown_light(glm::vec3(3), 1, shared::kToneLinear, peak).x, 3.0f);
    EXPECT_FLOAT_EQ(shared::shown_light(glm::vec3(300), 1, shared::kToneLinear, peak).x, peak);
}

} // namespace
} // namespace ghost::render
