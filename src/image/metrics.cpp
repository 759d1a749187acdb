// SPDX-License-Identifier: Apache-2.0
#include "image/metrics.h"

#include "base/check.h"
#include "image/colour.h"
#include "image/finite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ghost::image {
namespace {

constexpr double kFloor = 1e-2; // of mean(r)^2: dark pixels count by what they are to the whole picture
constexpr double kTrimmedShare = 1e-3; // a few lens pixels would decide the mean
constexpr double kLitShare = 1e-2;     // of the mean luminance

glm::vec3 pixel_of(const ImageF& image, std::size_t pixel) {
    const float* value = image.samples.data() + pixel * 3;
    return {value[0], value[1], value[2]};
}

void put(ImageF& image, std::size_t pixel, const glm::vec3& value) {
    for (std::size_t k = 0; k < 3; ++k) image.samples[pixel * 3 + k] = value[static_cast<int>(k)];
}

bool inside(const Circle& circle, std::size_t pixel, int width) {
    const auto row = static_cast<std::size_t>(width);
    const double dx = static_cast<double>(pixel % row) + 0.5 - static_cast<double>(circle.x);
    const double dy = static_cast<double>(pixel / row) + 0.5 - static_cast<double>(circle.y);
    const auto radius = static_cast<double>(circle.radius);
    return dx * dx + dy * dy <= radius * radius;
}

double ratio(double error, double scale) {
    if (scale > 0) return error / scale;
    return error > 0 ? std::numeric_limits<double>::infinity() : 0.0;
}

// The smallest value that this share of the values does not exceed.
double percentile(std::vector<double>& values, double share) {
    const auto count = static_cast<double>(values.size());
    const auto rank = static_cast<std::ptrdiff_t>(std::max(std::ceil(share * count), 1.0)) - 1;
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

std::optional<double> lit_p75(const ImageF& image, const PicturePair& pair) {
    std::vector<double> luminance;
    double sum = 0;
    for (std::size_t p = 0; p < pair.counts.size(); ++p) {
        if (!pair.takes_part(p)) continue;
        luminance.push_back(static_cast<double>(rec2020_to_xyz(pixel_of(image, p)).y));
        sum += luminance.back();
    }
    const double floor = kLitShare * sum / static_cast<double>(luminance.size());
    std::erase_if(luminance, [&](double value) { return value <= std::max(floor, 0.0); });
    if (luminance.empty()) return std::nullopt;
    return percentile(luminance, 0.75);
}

} // namespace

glm::vec3 PicturePair::test_at(std::size_t pixel) const {
    return pixel_of(test, pixel);
}

glm::vec3 PicturePair::reference_at(std::size_t pixel) const {
    return pixel_of(reference, pixel);
}

Result<PicturePair> pair_up(ImageF test, ImageF reference, const std::vector<Circle>& masked_out) {
    CHECK_EQ(test.channels, 3);
    CHECK_EQ(reference.channels, 3);
    if (test.width != reference.width || test.height != reference.height)
        return Error{"the pictures differ in size: " + std::to_string(test.width) + " x " +
                         std::to_string(test.height) + " and " + std::to_string(reference.width) + " x " +
                         std::to_string(reference.height) + " pixels",
                     ""};
    PicturePair pair;
    pair.counts.assign(test.samples.size() / 3, 1);
    for (std::size_t p = 0; p < pair.counts.size(); ++p) {
        const glm::vec3 r = pixel_of(reference, p);
        const bool whole = is_finite(r) && is_finite(pixel_of(test, p));
        const bool masked = std::any_of(masked_out.begin(), masked_out.end(),
                                        [&](const Circle& circle) { return inside(circle, p, test.width); });
        if (whole && !masked) continue;
        if (!masked) ++pair.non_finite;
        pair.counts[p] = 0;
        put(test, p, is_finite(r) ? r : glm::vec3(0));
        put(reference, p, is_finite(r) ? r : glm::vec3(0));
    }
    pair.counted = static_cast<std::size_t>(std::count(pair.counts.begin(), pair.counts.end(), 1));
    if (pair.counted == 0)
        return Error{"no pixel is left to compare: " + std::to_string(pair.non_finite) +
                         " are not finite numbers, the others are masked out",
                     ""};
    pair.test = std::move(test);
    pair.reference = std::move(reference);
    return pair;
}

RelativeErrors relative_errors(const PicturePair& pair) {
    double test_sum = 0;
    double reference_sum = 0;
    for (std::size_t p = 0; p < pair.counts.size(); ++p) {
        if (!pair.takes_part(p)) continue;
        const glm::dvec3 x(pair.test_at(p));
        const glm::dvec3 r(pair.reference_at(p));
        test_sum += x.x + x.y + x.z;
        reference_sum += r.x + r.y + r.z;
    }
    const double mean = reference_sum / static_cast<double>(3 * pair.counted);
    std::vector<double> terms; // per pixel, mean of its channels
    terms.reserve(pair.counted);
    for (std::size_t p = 0; p < pair.counts.size(); ++p) {
        if (!pair.takes_part(p)) continue;
        const glm::dvec3 r(pair.reference_at(p));
        const glm::dvec3 error = glm::dvec3(pair.test_at(p)) - r;
        double term = 0;
        for (int k = 0; k < 3; ++k)
            term += ratio(error[k] * error[k], r[k] * r[k] + kFloor * mean * mean) / 3.0;
        terms.push_back(term);
    }
    const auto mean_of = [&](std::size_t count) {
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k) sum += terms[k];
        return sum / static_cast<double>(count);
    };
    RelativeErrors errors;
    errors.relmse = mean_of(terms.size());
    errors.max_error = std::sqrt(*std::max_element(terms.begin(), terms.end()));
    errors.p99_error = std::sqrt(percentile(terms, 0.99));
    const auto trimmed = static_cast<std::size_t>(kTrimmedShare * static_cast<double>(terms.size()));
    const std::size_t kept = terms.size() - trimmed;
    std::nth_element(terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(kept - 1), terms.end());
    errors.relmse_trimmed = mean_of(kept);
    const double surplus = test_sum - reference_sum;
    errors.bias = std::copysign(ratio(std::abs(surplus), std::abs(reference_sum)), surplus);
    return errors;
}

double psnr_db(const PicturePair& pair, const ToneCurve& curve) {
    double sum = 0;
    for (std::size_t p = 0; p < pair.counts.size(); ++p) {
        if (!pair.takes_part(p)) continue;
        const glm::dvec3 error = glm::dvec3(curve(pair.test_at(p))) - glm::dvec3(curve(pair.reference_at(p)));
        sum += glm::dot(error, error);
    }
    return -10.0 * std::log10(sum / static_cast<double>(3 * pair.counted));
}

ToneCurve p75_curve(const PicturePair& pair) {
    std::optional<double> p75 = lit_p75(pair.reference, pair);
    if (!p75) p75 = lit_p75(pair.test, pair);
    const auto scale = static_cast<float>(1.0 / (2.0 * p75.value_or(1.0)));
    return [scale](const glm::vec3& value) {
        return glm::vec3(1.0f) - glm::exp(-scale * glm::max(value, glm::vec3(0.0f)));
    };
}

} // namespace ghost::image
