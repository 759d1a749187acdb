// SPDX-License-Identifier: Apache-2.0
#include "image/metrics.h"

#include "image/colour.h"
#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace ghost::image {
namespace {

constexpr float kPpd = kFlipPixelsPerDegree;
const ToneCurve kAsItIs = [](const glm::vec3& value) { return value; };

ImageF uniform(int width, int height, const glm::vec3& rgb) {
    ImageF image(width, height, 3);
    for (std::size_t k = 0; k < image.samples.size(); ++k) image.samples[k] = rgb[static_cast<int>(k % 3)];
    return image;
}

ImageF random_picture(int width, int height, unsigned seed) {
    ImageF image(width, height, 3);
    std::mt19937 random(seed);
    for (float& value : image.samples) value = static_cast<float>(random() % 1000) / 1000.0f;
    return image;
}

// amplitude times the same noise for every amplitude.
ImageF with_noise(ImageF image, float amplitude) {
    std::mt19937 random(7);
    for (float& value : image.samples)
        value = std::max(value + amplitude * (static_cast<float>(random() % 2001) / 1000.0f - 1.0f), 0.0f);
    return image;
}

ImageF scaled(ImageF image, float factor) {
    for (float& value : image.samples) value *= factor;
    return image;
}

void set(ImageF& image, int x, int y, const glm::vec3& rgb) {
    for (int k = 0; k < 3; ++k) image.at(x, y)[k] = rgb[k];
}

PicturePair pair_of(const ImageF& test, const ImageF& reference, const std::vector<Circle>& circles = {}) {
    Result<PicturePair> pair = pair_up(test, reference, circles);
    EXPECT_TRUE(pair.ok()) << pair.error().text();
    return *std::move(pair);
}

PicturePair rec709_pair(const glm::vec3& test, const glm::vec3& reference, int width = 6, int height = 5) {
    return pair_of(uniform(width, height, rec709_to_rec2020(test)),
                   uniform(width, height, rec709_to_rec2020(reference)));
}

TEST(Metrics, IdenticalPictures) {
    const ImageF picture = random_picture(40, 30, 1);
    const PicturePair pair = pair_of(picture, picture);
    const RelativeErrors errors = relative_errors(pair);
    EXPECT_EQ(errors.relmse, 0);
    EXPECT_EQ(errors.relmse_trimmed, 0);
    EXPECT_EQ(errors.bias, 0);
    EXPECT_EQ(errors.max_error, 0);
    EXPECT_EQ(errors.p99_error, 0);
    EXPECT_EQ(psnr_db(pair, kAsItIs), std::numeric_limits<double>::infinity());
    EXPECT_EQ(psnr_db(pair, p75_curve(pair)), std::numeric_limits<double>::infinity());
    EXPECT_EQ(ldr_flip(pair, kPpd).max, 0);
    EXPECT_EQ(hdr_flip(pair, kPpd).max, 0);
}

TEST(Metrics, ConstantOffset) {
    const PicturePair pair = pair_of(uniform(20, 10, glm::vec3(2.2f)), uniform(20, 10, glm::vec3(2.0f)));
    const RelativeErrors errors = relative_errors(pair);
    const double term = 0.2 * 0.2 / (4.0 + 0.01 * 4.0);
    EXPECT_NEAR(errors.relmse, term, 1e-7);
    EXPECT_NEAR(errors.relmse_trimmed, term, 1e-7);
    EXPECT_NEAR(errors.bias, 0.1, 1e-6);
    EXPECT_NEAR(errors.max_error, std::sqrt(term), 1e-6);
    EXPECT_NEAR(errors.p99_error, std::sqrt(term), 1e-6);
    EXPECT_NEAR(psnr_db(pair, kAsItIs), -20.0 * std::log10(0.2), 1e-4);
    EXPECT_NEAR(relative_errors(pair_of(pair.reference, pair.test)).bias, -0.2 / 2.2, 1e-6);
}

TEST(Metrics, OneChannelIsAThird) {
    const PicturePair pair = pair_of(uniform(8, 8, {1, 1.5f, 1}), uniform(8, 8, glm::vec3(1)));
    EXPECT_NEAR(relative_errors(pair).relmse, 0.25 / 1.01 / 3.0, 1e-7);
    EXPECT_NEAR(psnr_db(pair, kAsItIs), -10.0 * std::log10(0.25 / 3.0), 1e-5);
}

// One pixel of 10000 is far less than the 0.1 % that are trimmed, and than 1 %.
TEST(Metrics, SinglePixel) {
    const ImageF reference = uniform(100, 100, glm::vec3(1));
    ImageF test = reference;
    set(test, 31, 62, glm::vec3(11));
    const RelativeErrors errors = relative_errors(pair_of(test, reference));
    EXPECT_NEAR(errors.relmse, 100.0 / 1.01 / 1e4, 1e-7);
    EXPECT_EQ(errors.relmse_trimmed, 0);
    EXPECT_NEAR(errors.max_error, 10.0 / std::sqrt(1.01), 1e-5);
    EXPECT_EQ(errors.p99_error, 0);
    EXPECT_NEAR(errors.bias, 10.0 / 1e4, 1e-9);
}

TEST(Metrics, TrimsTenOfTenThousand) {
    const ImageF reference = uniform(100, 100, glm::vec3(1));
    ImageF test = reference;
    for (int x = 0; x < 11; ++x) set(test, x, 0, glm::vec3(2));
    EXPECT_NEAR(relative_errors(pair_of(test, reference)).relmse_trimmed, 1.0 / 1.01 / 9990, 1e-9);
    for (int x = 0; x < 100; ++x) set(test, x, 1, glm::vec3(3));
    EXPECT_NEAR(relative_errors(pair_of(test, reference)).p99_error, 1.0 / std::sqrt(1.01), 1e-6);
}

TEST(Metrics, BlackReference) {
    const ImageF black = uniform(8, 8, glm::vec3(0));
    EXPECT_EQ(relative_errors(pair_of(black, black)).relmse, 0);
    EXPECT_EQ(relative_errors(pair_of(black, black)).bias, 0);
    EXPECT_EQ(hdr_flip(pair_of(black, black), kPpd).max, 0);
    const PicturePair lit = pair_of(uniform(8, 8, glm::vec3(1e-3f)), black);
    EXPECT_EQ(relative_errors(lit).relmse, std::numeric_limits<double>::infinity());
    EXPECT_EQ(relative_errors(lit).bias, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(psnr_db(lit, p75_curve(lit)), -20.0 * std::log10(1.0 - std::exp(-0.5)), 1e-4);
    EXPECT_GT(hdr_flip(lit, kPpd).mean, 0.8);
}

// A quarter of the lit pixels is at 8, the others at 4; more than half of the picture is dark.
TEST(Metrics, P75OfTheLitPixels) {
    ImageF reference = uniform(10, 10, glm::vec3(1e-6f));
    for (int k = 0; k < 40; ++k) set(reference, k % 10, k / 10, glm::vec3(k < 10 ? 8.0f : 4.0f));
    const PicturePair pair = pair_of(scaled(reference, 2), reference);
    const ToneCurve curve = p75_curve(pair);
    EXPECT_NEAR(curve(glm::vec3(4)).x, 1.0 - std::exp(-0.5), 1e-6);
    EXPECT_NEAR(curve({0, 8, -1}).y, 1.0 - std::exp(-1.0), 1e-6);
    EXPECT_EQ(curve({0, 8, -1}).z, 0);
    const double at_4 = std::exp(-0.5) - std::exp(-1.0);
    const double at_8 = std::exp(-1.0) - std::exp(-2.0);
    EXPECT_NEAR(psnr_db(pair, curve), -10.0 * std::log10(0.3 * at_4 * at_4 + 0.1 * at_8 * at_8), 1e-4);
}

TEST(Metrics, MaskedPixelsDoNotCount) {
    const ImageF reference = random_picture(30, 20, 3);
    ImageF test = reference;
    set(test, 12, 7, glm::vec3(50));
    set(test, 14, 7, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    const PicturePair masked = pair_of(test, reference, {{12.5f, 7.5f, 2.1f}});
    EXPECT_EQ(masked.counted, 600u - 13u); // 13 pixel middles within 2.1
    EXPECT_EQ(masked.non_finite, 0u);
    EXPECT_EQ(relative_errors(masked).relmse, 0);
    EXPECT_EQ(hdr_flip(masked, kPpd).max, 0);
    EXPECT_GT(relative_errors(pair_of(test, reference, {{25.5f, 7.5f, 2.1f}})).relmse, 0.1);
}

TEST(Metrics, PixelsThatAreNoNumbersAreCountedAndLeftOut) {
    ImageF reference = random_picture(30, 20, 3);
    ImageF test = reference;
    test.at(3, 4)[1] = std::numeric_limits<float>::quiet_NaN();
    test.at(9, 9)[0] = std::numeric_limits<float>::infinity();
    reference.at(9, 10)[2] = -std::numeric_limits<float>::infinity();
    const PicturePair pair = pair_of(test, reference);
    EXPECT_EQ(pair.non_finite, 3u);
    EXPECT_EQ(pair.counted, 597u);
    EXPECT_EQ(relative_errors(pair).relmse, 0);
    EXPECT_EQ(hdr_flip(pair, kPpd).max, 0);
    EXPECT_EQ(ldr_flip(pair, kPpd).max, 0);
}

TEST(Metrics, WhatCannotBeCompared) {
    const Result<PicturePair> sizes = pair_up(uniform(4, 3, {}), uniform(3, 4, {}), {});
    ASSERT_FALSE(sizes.ok());
    EXPECT_NE(sizes.error().what.find("4 x 3 and 3 x 4"), std::string::npos) << sizes.error().what;
    const ImageF bad = uniform(4, 3, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(pair_up(bad, uniform(4, 3, {}), {}).ok());
    EXPECT_FALSE(pair_up(uniform(4, 3, {}), uniform(4, 3, {}), {{2, 2, 50}}).ok());
}

TEST(Metrics, MoreNoiseIsWorse) {
    const ImageF reference = random_picture(48, 32, 5);
    double flip = 0;
    double relmse = 0;
    double psnr = std::numeric_limits<double>::infinity();
    for (const float amplitude : {0.01f, 0.03f, 0.1f, 0.3f}) {
        const PicturePair pair = pair_of(with_noise(reference, amplitude), reference);
        const double flip_now = hdr_flip(pair, kPpd).mean;
        const double relmse_now = relative_errors(pair).relmse;
        const double psnr_now = psnr_db(pair, p75_curve(pair));
        EXPECT_GT(flip_now, flip * 1.3) << amplitude;
        EXPECT_GT(relmse_now, relmse * 2.0) << amplitude;
        EXPECT_LT(psnr_now, psnr - 5.0) << amplitude;
        flip = flip_now;
        relmse = relmse_now;
        psnr = psnr_now;
    }
    EXPECT_LT(flip, 1);
}

// L*a*b* of sRGB's green and blue (D65): 87.735 -86.183 83.179 and 32.297 79.188 -107.860.
double greatest_difference() {
    const double green = 0.87735;
    const double blue = 0.32297;
    const double da = -86.183 * green - 79.188 * blue;
    const double db = 83.179 * green + 107.860 * blue;
    return 87.735 - 32.297 + std::sqrt(da * da + db * db);
}

// Uniform greys: no features, and HyAB is the difference of L*.
double grey_flip(double lightness) {
    const double greatest = std::pow(greatest_difference(), 0.7);
    const double power = std::pow(lightness, 0.7);
    const double knee = 0.4 * greatest;
    return power < knee ? 0.95 * power / knee : 0.95 + 0.05 * (power - knee) / (greatest - knee);
}

double lightness(double luminance) {
    return 116.0 * std::cbrt(luminance) - 16.0; // above 0.008856
}

TEST(Flip, UniformPicturesByHand) {
    EXPECT_NEAR(grey_flip(100), 0.967, 1e-3);
    EXPECT_NEAR(ldr_flip(rec709_pair({0, 0, 0}, {1, 1, 1}), kPpd).mean, grey_flip(100), 1e-4);
    EXPECT_NEAR(ldr_flip(rec709_pair({1, 1, 1}, {0, 0, 0}), kPpd).max, grey_flip(100), 1e-4);
    const double step = lightness(0.5) - lightness(0.18);
    EXPECT_NEAR(ldr_flip(rec709_pair(glm::vec3(0.5f), glm::vec3(0.18f)), kPpd).mean, grey_flip(step), 1e-4);
    EXPECT_NEAR(ldr_flip(rec709_pair({0, 1, 0}, {0, 0, 1}), kPpd).mean, 1.0, 1e-5);
    EXPECT_NEAR(ldr_flip(rec709_pair(glm::vec3(7), glm::vec3(1)), kPpd).mean, 0.0, 1e-6); // clipped
}

// The reference is put at 0.85; the test, twice as bright, at the curve's value of twice that exposure.
TEST(Flip, HdrOfUniformPicturesByHand) {
    const auto curve = [](double x) {
        return (0.9036 * x * x + 0.018 * x) / (0.8748 * x * x + 0.354 * x + 0.14);
    };
    double target = 1;
    for (int k = 0; k < 5000; ++k) target += 0.5 * (0.85 - curve(target));
    const double expected = grey_flip(lightness(curve(2 * target)) - lightness(0.85));
    for (const float level : {1e-3f, 1.0f, 5e4f}) {
        const PicturePair pair = rec709_pair(glm::vec3(2 * level), glm::vec3(level));
        const FlipExposures exposures = flip_exposures(pair);
        EXPECT_EQ(exposures.count, 1);
        EXPECT_NEAR(exposures.first, std::log2(target / static_cast<double>(level)), 3e-5);
        EXPECT_NEAR(hdr_flip(pair, kPpd).mean, expected, 1e-4);
    }
}

TEST(Flip, ExposuresOfTheReference) {
    ImageF reference = uniform(10, 10, glm::vec3(1));
    for (int x = 0; x < 10; ++x) set(reference, x, 0, glm::vec3(40)); // log2(40) = 5.3
    FlipExposures exposures = flip_exposures(pair_of(uniform(10, 10, glm::vec3(9)), reference));
    EXPECT_EQ(exposures.count, 6);
    EXPECT_NEAR(exposures.last - exposures.first, std::log2(40.0), 1e-4);
    // Dark stage: 70 % black, the median of the rest decides.
    for (int y = 3; y < 10; ++y)
        for (int x = 0; x < 10; ++x) set(reference, x, y, glm::vec3(0));
    exposures = flip_exposures(pair_of(uniform(10, 10, glm::vec3(9)), reference));
    EXPECT_NEAR(exposures.last - exposures.first, std::log2(40.0), 1e-4);
    // A hall that is all but black must not ask for a hundred exposures.
    for (int y = 1; y < 10; ++y)
        for (int x = 0; x < 10; ++x) set(reference, x, y, glm::vec3(1e-20f));
    exposures = flip_exposures(pair_of(uniform(10, 10, glm::vec3(9)), reference));
    EXPECT_EQ(exposures.count, 24);
    EXPECT_LE(hdr_flip(pair_of(uniform(10, 10, glm::vec3(9)), reference), kPpd).max, 1.0);
}

TEST(Flip, DarkDifferencesShowInHdrOnly) {
    ImageF reference = uniform(24, 24, glm::vec3(0.001f));
    set(reference, 3, 3, glm::vec3(1));
    ImageF test = reference;
    for (int y = 10; y < 20; ++y)
        for (int x = 10; x < 20; ++x) set(test, x, y, glm::vec3(0.0015f));
    const PicturePair pair = pair_of(test, reference);
    const double ldr = ldr_flip(pair, kPpd).max;
    EXPECT_LT(ldr, 0.05);
    EXPECT_GT(hdr_flip(pair, kPpd).max, 5 * ldr);
}

TEST(Flip, SymmetricMirroredAndLocal) {
    ImageF a = uniform(64, 40, glm::vec3(0.2f));
    const ImageF b = a;
    set(a, 20, 15, {0.9f, 0.1f, 0.3f});
    const FlipMap map = ldr_flip(pair_of(a, b), kPpd);
    EXPECT_EQ(map.errors.samples, ldr_flip(pair_of(b, a), kPpd).errors.samples);
    EXPECT_GT(*map.errors.at(20, 15), 0.05f);
    EXPECT_EQ(map.max, static_cast<double>(*map.errors.at(20, 15)));
    for (int d = 1; d <= 10; ++d) {
        EXPECT_NEAR(*map.errors.at(20 + d, 15), *map.errors.at(20 - d, 15), 1e-4) << d;
        EXPECT_NEAR(*map.errors.at(20 + d, 15), *map.errors.at(20, 15 + d), 1e-4) << d;
    }
    EXPECT_EQ(*map.errors.at(31, 15), 0.0f); // filters reach 10 pixels at 67 per degree
    EXPECT_EQ(*map.errors.at(20, 26), 0.0f);
}

// The published definition once more: double, with whole two-dimensional kernels.
using Kernel2 = std::function<double(double, double)>;

std::vector<double> filtered(const std::vector<double>& in, int width, int height, int radius, bool balance,
                             const Kernel2& kernel) {
    double positive = 0;
    double negative = 0;
    for (int v = -radius; v <= radius; ++v)
        for (int u = -radius; u <= radius; ++u) (kernel(u, v) > 0 ? positive : negative) += kernel(u, v);
    std::vector<double> out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0;
            for (int v = -radius; v <= radius; ++v)
                for (int u = -radius; u <= radius; ++u) {
                    const int at = std::clamp(y + v, 0, height - 1) * width + std::clamp(x + u, 0, width - 1);
                    const double weight = kernel(u, v);
                    sum += in[static_cast<std::size_t>(at)] * weight /
                           (balance && weight < 0 ? -negative : positive);
                }
            out.push_back(sum);
        }
    return out;
}

struct PlainSeen {
    std::vector<glm::dvec3> lab;
    std::vector<double> edge, point;
};

PlainSeen plain_see(const ImageF& rec2020, double ppd) {
    constexpr double pi = std::numbers::pi;
    const int w = rec2020.width;
    const int h = rec2020.height;
    // IEC 61966-2-1
    const glm::dmat3 matrix(0.4124, 0.2126, 0.0193, 0.3576, 0.7152, 0.1192, 0.1805, 0.0722, 0.9505);
    const glm::dvec3 white = matrix * glm::dvec3(1);
    std::vector<double> channel[3];
    for (std::size_t k = 0; k < rec2020.samples.size(); k += 3) {
        const float* p = rec2020.samples.data() + k;
        const glm::dvec3 rgb = glm::clamp(glm::dvec3(rec2020_to_rec709({p[0], p[1], p[2]})), 0.0, 1.0);
        const glm::dvec3 xyz = matrix * rgb / white;
        channel[0].push_back(116 * xyz.y - 16);
        channel[1].push_back(500 * (xyz.x - xyz.y));
        channel[2].push_back(200 * (xyz.y - xyz.z));
    }
    PlainSeen seen;
    const double deviation = 0.041 * ppd;
    const int feature_radius = static_cast<int>(std::ceil(3 * deviation));
    const auto bell = [&](double x, double y) {
        return std::exp(-(x * x + y * y) / (2 * deviation * deviation));
    };
    const auto edge = [&](double x, double y) { return -x * bell(x, y); };
    const auto point = [&](double x, double y) { return (x * x / (deviation * deviation) - 1) * bell(x, y); };
    for (const bool is_edge : {true, false}) {
        const Kernel2 kernel = is_edge ? Kernel2(edge) : Kernel2(point);
        std::vector<double> y = channel[0];
        for (double& value : y) value = (value + 16) / 116;
        const auto across = filtered(y, w, h, feature_radius, true, kernel);
        const auto along =
            filtered(y, w, h, feature_radius, true, [&](double u, double v) { return kernel(v, u); });
        for (std::size_t k = 0; k < y.size(); ++k)
            (is_edge ? seen.edge : seen.point).push_back(std::hypot(across[k], along[k]));
    }
    const double parameters[3][4] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    for (int c = 0; c < 3; ++c)
        channel[c] = filtered(channel[c], w, h, radius, false, [&](double x, double y) {
            const double r2 = (x * x + y * y) / (ppd * ppd);
            const double* q = parameters[c];
            return q[0] * std::sqrt(pi / q[1]) * std::exp(-pi * pi * r2 / q[1]) +
                   q[2] * std::sqrt(pi / q[3]) * std::exp(-pi * pi * r2 / q[3]);
        });
    for (std::size_t k = 0; k < channel[0].size(); ++k) {
        const double y = (channel[0][k] + 16) / 116;
        const glm::dvec3 back(y + channel[1][k] / 500, y, y - channel[2][k] / 200);
        const glm::dvec3 rgb = glm::clamp(glm::inverse(matrix) * (back * white), 0.0, 1.0);
        const glm::dvec3 xyz = matrix * rgb / white;
        glm::dvec3 f;
        for (int c = 0; c < 3; ++c)
            f[c] = xyz[c] > 216.0 / 24389 ? std::cbrt(xyz[c]) : 841.0 / 108 * xyz[c] + 4.0 / 29;
        const double l = 116 * f.y - 16;
        seen.lab.emplace_back(l, 5 * l * (f.x - f.y), 2 * l * (f.y - f.z));
    }
    return seen;
}

double worst_of_plain(const ImageF& test, const ImageF& reference, double ppd) {
    const FlipMap map = ldr_flip(pair_of(test, reference), static_cast<float>(ppd));
    const PlainSeen a = plain_see(test, ppd);
    const PlainSeen b = plain_see(reference, ppd);
    double worst = 0;
    for (std::size_t k = 0; k < a.lab.size(); ++k) {
        const glm::dvec3 d = a.lab[k] - b.lab[k];
        const double colour = grey_flip(std::abs(d.x) + std::hypot(d.y, d.z));
        const double feature =
            std::max(std::abs(a.edge[k] - b.edge[k]), std::abs(a.point[k] - b.point[k])) / std::sqrt(2.0);
        const double expected = std::pow(colour, 1 - std::sqrt(feature));
        worst = std::max(worst, std::abs(expected - static_cast<double>(map.errors.samples[k])));
    }
    return worst;
}

TEST(Flip, AsTheDefinitionPixelByPixel) {
    const ImageF reference = random_picture(31, 23, 11);
    EXPECT_LT(worst_of_plain(with_noise(reference, 0.2f), reference, 67), 2e-3);
    EXPECT_LT(worst_of_plain(random_picture(31, 23, 12), reference, 25), 2e-3);
    ImageF edge = uniform(31, 23, glm::vec3(0.1f));
    for (int y = 0; y < 23; ++y)
        for (int x = 9; x < 31; ++x) set(edge, x, y, {0.8f, 0.5f, 0.1f});
    EXPECT_LT(worst_of_plain(edge, uniform(31, 23, glm::vec3(0.1f)), 67), 2e-3);
}

TEST(Flip, PictureOfTheMap) {
    ImageF errors(3, 1, 1);
    errors.samples = {0.0f, 0.5f, 1.0f};
    const Image8 picture = flip_picture(errors);
    ASSERT_EQ(picture.channels, 3);
    EXPECT_EQ(picture.samples, (std::vector<std::uint8_t>{0, 0, 4, 183, 55, 121, 252, 253, 191}));
}

} // namespace
} // namespace ghost::image
