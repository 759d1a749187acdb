// SPDX-License-Identifier: Apache-2.0
#include "image/flip.h"

#include "base/check.h"
#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace ghost::image {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kColourPower = 0.7f;   // q_c
constexpr float kColourKnee = 0.4f;    // p_c: share of the greatest difference
constexpr float kColourKneeTo = 0.95f; // p_t: what the knee is mapped to
constexpr float kFeatureDeg = 0.082f;  // w: width of the detectors of edges and points
constexpr float kFeaturePower = 0.5f;  // q_f
constexpr float kExposureTarget = 0.85f;
constexpr float kMaxStops = 24.0f;

// Narkowicz' fit of the ACES curve, (a x^2 + b x) / (c x^2 + d x + e), without its exposure factor of 0.6.
constexpr float kAcesA = 0.6f * 0.6f * 2.51f;
constexpr float kAcesB = 0.6f * 0.03f;
constexpr float kAcesC = 0.6f * 0.6f * 2.43f;
constexpr float kAcesD = 0.6f * 0.59f;
constexpr float kAcesE = 0.14f;

// Contrast sensitivity in space: a1 sqrt(pi/b1) exp(-pi^2 r^2/b1) + the same of a2, b2; r in degrees.
struct Sensitivity {
    float a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic{1.0f, 0.0047f, 0.0f, 1e-5f};
constexpr Sensitivity kRedGreen{1.0f, 0.0053f, 0.0f, 1e-5f};
constexpr Sensitivity kBlueYellow{34.1f, 0.04f, 13.5f, 0.025f};
constexpr float kWidestB = 0.04f; // all filters are cut off where this one is 3 standard deviations wide

struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;

    Plane(int width_px, int height_px)
        : width(width_px), height(height_px),
          values(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)) {}
    float* row(int y) { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
    const float* row(int y) const { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
};

using Kernel = std::vector<float>; // odd length, the middle is 0

int radius_of(const Kernel& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

void add_scaled(float* sum, const float* values, float weight, int count) {
    for (int x = 0; x < count; ++x) sum[x] += weight * values[x];
}

// Pixels beyond the border are as the border.
Plane filter_rows(const Plane& in, const Kernel& kernel) {
    const int radius = radius_of(kernel);
    Plane out(in.width, in.height);
    std::vector<float> padded(static_cast<std::size_t>(in.width + 2 * radius));
    for (int y = 0; y < in.height; ++y) {
        const float* row = in.row(y);
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, in.width, padded.begin() + radius);
        std::fill_n(padded.begin() + radius + in.width, radius, row[in.width - 1]);
        for (int k = 0; k <= 2 * radius; ++k)
            add_scaled(out.row(y), padded.data() + k, kernel[static_cast<std::size_t>(k)], in.width);
    }
    return out;
}

Plane filter_columns(const Plane& in, const Kernel& kernel) {
    const int radius = radius_of(kernel);
    Plane out(in.width, in.height);
    for (int y = 0; y < in.height; ++y)
        for (int k = -radius; k <= radius; ++k)
            add_scaled(out.row(y), in.row(std::clamp(y + k, 0, in.height - 1)),
                       kernel[static_cast<std::size_t>(k + radius)], in.width);
    return out;
}

Kernel gauss(int radius, float exponent) {
    Kernel kernel;
    for (int k = -radius; k <= radius; ++k)
        kernel.push_back(std::exp(-exponent * static_cast<float>(k) * static_cast<float>(k)));
    return kernel;
}

float sum_of(const Kernel& kernel) {
    float sum = 0;
    for (const float weight : kernel) sum += weight;
    return sum;
}

void scale(Kernel& kernel, float factor) {
    for (float& weight : kernel) weight *= factor;
}

// A sum of two Gaussians is not separable, each of them is.
Plane filter_by_sensitivity(const Plane& in, const Sensitivity& s, float pixels_per_degree) {
    const int radius =
        static_cast<int>(std::ceil(3.0f * std::sqrt(kWidestB / (2.0f * kPi * kPi)) * pixels_per_degree));
    const float per_pixel = 1.0f / (pixels_per_degree * pixels_per_degree);
    Kernel first = gauss(radius, kPi * kPi * per_pixel / s.b1);
    Kernel second = gauss(radius, kPi * kPi * per_pixel / s.b2);
    const float first_sum = sum_of(first);
    const float second_sum = sum_of(second);
    float first_share = s.a1 * std::sqrt(kPi / s.b1) * first_sum * first_sum;
    const float second_share = s.a2 * std::sqrt(kPi / s.b2) * second_sum * second_sum;
    first_share /= first_share + second_share;
    scale(first, 1.0f / first_sum);
    Plane out = filter_columns(filter_rows(in, first), first);
    if (second_share <= 0) return out;
    scale(second, 1.0f / second_sum);
    const Plane other = filter_columns(filter_rows(in, second), second);
    for (std::size_t p = 0; p < out.values.size(); ++p)
        out.values[p] = first_share * out.values[p] + (1.0f - first_share) * other.values[p];
    return out;
}

// Positive weights add up to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
    float positive = 0;
    float negative = 0;
    for (const float weight : kernel) (weight > 0 ? positive : negative) += weight;
    for (float& weight : kernel) weight /= weight > 0 ? positive : -negative;
    return kernel;
}

struct Features {
    Plane edges;
    Plane points;
};

Plane length_of(Plane x, const Plane& y) {
    for (std::size_t p = 0; p < x.values.size(); ++p)
        x.values[p] = std::sqrt(x.values[p] * x.values[p] + y.values[p] * y.values[p]);
    return x;
}

Features features_of(const Plane& luminance, float pixels_per_degree) {
    const float deviation = 0.5f * kFeatureDeg * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0f * deviation));
    Kernel smooth = gauss(radius, 0.5f / (deviation * deviation));
    Kernel first = smooth; // derivatives
    Kernel second = smooth;
    for (int k = -radius; k <= radius; ++k) {
        const auto i = static_cast<std::size_t>(k + radius);
        const float x = static_cast<float>(k);
        first[i] *= -x;
        second[i] *= x * x / (deviation * deviation) - 1.0f;
    }
    first = balanced(std::move(first));
    second = balanced(std::move(second));
    scale(smooth, 1.0f / sum_of(smooth));
    const Plane smooth_rows = filter_rows(luminance, smooth);
    return {
        length_of(filter_columns(filter_rows(luminance, first), smooth), filter_columns(smooth_rows, first)),
        length_of(filter_columns(filter_rows(luminance, second), smooth),
                  filter_columns(smooth_rows, second))};
}

// Linear Rec.709 to XYZ relative to its white.
const glm::mat3& to_xyz() {
    static const glm::mat3 matrix = [] {
        const auto xyz = [](const glm::vec3& rgb) { return rec2020_to_xyz(rec709_to_rec2020(rgb)); };
        const glm::vec3 white = xyz(glm::vec3(1));
        return glm::mat3(xyz({1, 0, 0}) / white, xyz({0, 1, 0}) / white, xyz({0, 0, 1}) / white);
    }();
    return matrix;
}

float lab_root(float value) {
    constexpr float kDelta = 6.0f / 29.0f;
    return value > kDelta * kDelta * kDelta ? std::cbrt(value)
                                            : value / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

// L*a*b* with a and b weakened where it is dark (Hunt).
glm::vec3 hunt_lab(const glm::vec3& rec709) {
    const glm::vec3 xyz = to_xyz() * rec709;
    const glm::vec3 root(lab_root(xyz.x), lab_root(xyz.y), lab_root(xyz.z));
    const float lightness = 116.0f * root.y - 16.0f;
    const float hunt = 0.01f * lightness;
    return {lightness, hunt * 500.0f * (root.x - root.y), hunt * 200.0f * (root.y - root.z)};
}

float hyab(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// 0..1; the greatest difference is that of green and blue.
float redistributed(float distance) {
    static const float greatest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kColourPower);
    const float power = std::pow(distance, kColourPower);
    const float knee = kColourKnee * greatest;
    if (power < knee) return power * kColourKneeTo / knee;
    return kColourKneeTo + (power - knee) / (greatest - knee) * (1.0f - kColourKneeTo);
}

struct Seen {
    std::vector<glm::vec3> lab;
    Features features;
};

// What the eye gets of a display picture (linear Rec.709, 0..1).
Seen see(const std::vector<glm::vec3>& rec709, int width, int height, float pixels_per_degree) {
    Plane xs(width, height);
    Plane ys(width, height);
    Plane zs(width, height);
    for (std::size_t p = 0; p < rec709.size(); ++p) {
        const glm::vec3 xyz = to_xyz() * rec709[p];
        ys.values[p] = xyz.y; // Y of YCxCz is 116 y - 16, a filter that adds up to 1 commutes with that
        xs.values[p] = xyz.x - xyz.y;
        zs.values[p] = xyz.y - xyz.z;
    }
    Seen seen{{}, features_of(ys, pixels_per_degree)};
    const Plane y = filter_by_sensitivity(ys, kAchromatic, pixels_per_degree);
    const Plane cx = filter_by_sensitivity(xs, kRedGreen, pixels_per_degree);
    const Plane cz = filter_by_sensitivity(zs, kBlueYellow, pixels_per_degree);
    const glm::mat3 to_rec709 = glm::inverse(to_xyz());
    seen.lab.resize(rec709.size());
    for (std::size_t p = 0; p < rec709.size(); ++p) {
        const float middle = y.values[p];
        const glm::vec3 xyz(middle + cx.values[p], middle, middle - cz.values[p]);
        seen.lab[p] = hunt_lab(glm::clamp(to_rec709 * xyz, 0.0f, 1.0f));
    }
    return seen;
}

// Raises errors to what these two display pictures give.
void raise(ImageF& errors, const std::vector<glm::vec3>& test, const std::vector<glm::vec3>& reference,
           float pixels_per_degree) {
    const Seen a = see(test, errors.width, errors.height, pixels_per_degree);
    const Seen b = see(reference, errors.width, errors.height, pixels_per_degree);
    for (std::size_t p = 0; p < errors.samples.size(); ++p) {
        const float distance = hyab(a.lab[p], b.lab[p]);
        if (distance <= 0) continue;
        const float feature = std::max(std::abs(a.features.edges.values[p] - b.features.edges.values[p]),
                                       std::abs(a.features.points.values[p] - b.features.points.values[p]));
        const float amplified = std::pow(feature / std::numbers::sqrt2_v<float>, kFeaturePower);
        errors.samples[p] = std::max(errors.samples[p], std::pow(redistributed(distance), 1.0f - amplified));
    }
}

FlipMap pooled(ImageF errors, const PicturePair& pair) {
    FlipMap map;
    std::vector<float> values;
    for (std::size_t p = 0; p < errors.samples.size(); ++p) {
        float& error = errors.samples[p];
        error = pair.takes_part(p) ? std::clamp(error, 0.0f, 1.0f) : 0.0f;
        if (pair.takes_part(p)) values.push_back(error);
    }
    std::sort(values.begin(), values.end());
    double sum = 0;
    for (const float value : values) sum += static_cast<double>(value);
    const auto count = static_cast<double>(values.size());
    map.mean = sum / count;
    map.p99 = static_cast<double>(values[static_cast<std::size_t>(std::ceil(0.99 * count)) - 1]);
    map.max = static_cast<double>(values.back());
    map.errors = std::move(errors);
    return map;
}

std::vector<glm::vec3> rec709_of(const ImageF& image) {
    std::vector<glm::vec3> values(image.samples.size() / 3);
    for (std::size_t p = 0; p < values.size(); ++p) {
        const float* pixel = image.samples.data() + p * 3;
        values[p] = glm::max(rec2020_to_rec709({pixel[0], pixel[1], pixel[2]}), glm::vec3(0));
    }
    return values;
}

glm::vec3 aces(const glm::vec3& value) {
    const glm::vec3 x = glm::min(value, glm::vec3(1e6f)); // its square is finite
    return glm::clamp(x * (kAcesA * x + kAcesB) / (x * (kAcesC * x + kAcesD) + kAcesE), 0.0f, 1.0f);
}

// Where the curve is kExposureTarget.
float aces_target() {
    constexpr float a = kAcesA - kExposureTarget * kAcesC;
    constexpr float b = kAcesB - kExposureTarget * kAcesD;
    constexpr float c = -kExposureTarget * kAcesE;
    return (-b + std::sqrt(b * b - 4.0f * a * c)) / (2.0f * a);
}

// Of the pixels that count and are not black, sorted.
std::vector<float> lit_luminances(const std::vector<glm::vec3>& rec709, const PicturePair& pair) {
    std::vector<float> values;
    for (std::size_t p = 0; p < rec709.size(); ++p) {
        const float luminance = glm::dot(rec709[p], glm::vec3(0.2126f, 0.7152f, 0.0722f));
        if (pair.takes_part(p) && luminance > 0) values.push_back(luminance);
    }
    std::sort(values.begin(), values.end());
    return values;
}

float median(const std::vector<float>& sorted, std::size_t zeros) {
    const auto at = [&](std::size_t k) { return k < zeros ? 0.0f : sorted[k - zeros]; };
    const std::size_t count = sorted.size() + zeros;
    return 0.5f * at((count - 1) / 2) + 0.5f * at(count / 2);
}

std::vector<glm::vec3> exposed(std::vector<glm::vec3> values, float factor) {
    for (glm::vec3& value : values) value = aces(value * factor);
    return values;
}

} // namespace

FlipMap ldr_flip(const PicturePair& pair, float pixels_per_degree) {
    CHECK(pixels_per_degree > 0);
    ImageF errors(pair.test.width, pair.test.height, 1);
    std::vector<glm::vec3> test = rec709_of(pair.test);
    std::vector<glm::vec3> reference = rec709_of(pair.reference);
    for (glm::vec3& value : test) value = glm::min(value, glm::vec3(1));
    for (glm::vec3& value : reference) value = glm::min(value, glm::vec3(1));
    raise(errors, test, reference, pixels_per_degree);
    return pooled(std::move(errors), pair);
}

FlipExposures flip_exposures(const PicturePair& pair) {
    std::vector<float> lit = lit_luminances(rec709_of(pair.reference), pair);
    if (lit.empty()) lit = lit_luminances(rec709_of(pair.test), pair);
    if (lit.empty()) return {};
    float middle = median(lit, pair.counted - lit.size());
    if (middle <= 0) middle = median(lit, 0);
    FlipExposures exposures;
    exposures.first = std::log2(aces_target()) - std::log2(lit.back());
    exposures.last = std::min(std::log2(aces_target()) - std::log2(middle), exposures.first + kMaxStops);
    const float stops = exposures.last - exposures.first;
    if (stops > 0) exposures.count = std::max(2, static_cast<int>(std::ceil(stops)));
    return exposures;
}

FlipMap hdr_flip(const PicturePair& pair, float pixels_per_degree) {
    CHECK(pixels_per_degree > 0);
    const std::vector<glm::vec3> test = rec709_of(pair.test);
    const std::vector<glm::vec3> reference = rec709_of(pair.reference);
    const FlipExposures exposures = flip_exposures(pair);
    ImageF errors(pair.test.width, pair.test.height, 1);
    for (int k = 0; k < exposures.count; ++k) {
        const float share =
            exposures.count > 1 ? static_cast<float>(k) / static_cast<float>(exposures.count - 1) : 0;
        const float factor = std::exp2(exposures.first + share * (exposures.last - exposures.first));
        raise(errors, exposed(test, factor), exposed(reference, factor), pixels_per_degree);
    }
    return pooled(std::move(errors), pair);
}

Image8 flip_picture(const ImageF& errors) {
    CHECK_EQ(errors.channels, 1);
    static constexpr std::array<std::array<float, 3>, 9> kColours{{{0, 0, 4},
                                                                   {28, 16, 68},
                                                                   {81, 18, 124},
                                                                   {131, 38, 129},
                                                                   {183, 55, 121},
                                                                   {231, 82, 99},
                                                                   {252, 137, 97},
                                                                   {254, 195, 137},
                                                                   {252, 253, 191}}};
    Image8 picture(errors.width, errors.height, 3);
    for (std::size_t p = 0; p < errors.samples.size(); ++p) {
        const float place =
            std::clamp(errors.samples[p], 0.0f, 1.0f) * static_cast<float>(kColours.size() - 1);
        const std::size_t below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
        const float share = place - static_cast<float>(below);
        for (std::size_t k = 0; k < 3; ++k)
            picture.samples[p * 3 + k] = static_cast<std::uint8_t>(
                std::lround((1.0f - share) * kColours[below][k] + share * kColours[below + 1][k]));
    }
    return picture;
}

} // namespace ghost::image
