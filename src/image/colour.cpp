// SPDX-License-Identifier: Apache-2.0
#include "image/colour.h"

#include <algorithm>
#include <cmath>

namespace ghost::image {
namespace {

glm::dvec3 xyz_of(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

// SMPTE RP 177: scale the primaries so that they add up to the white point.
glm::dmat3 rgb_to_xyz(const Chromaticities& c) {
    const glm::dmat3 primaries(xyz_of(c[0], c[1]), xyz_of(c[2], c[3]), xyz_of(c[4], c[5]));
    const glm::dvec3 scale = glm::inverse(primaries) * xyz_of(c[6], c[7]);
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

const glm::dmat3 kRec2020ToXyz = rgb_to_xyz(kRec2020);
const glm::dmat3 kXyzToRec2020 = glm::inverse(kRec2020ToXyz);
const glm::dmat3 kRec709ToRec2020 = kXyzToRec2020 * rgb_to_xyz(kRec709);
const glm::dmat3 kRec2020ToRec709 = glm::inverse(kRec709ToRec2020);

glm::vec3 times(const glm::dmat3& matrix, const glm::vec3& value) {
    return glm::vec3(matrix * glm::dvec3(value));
}

// Kim et al., US patent 7024034: cubic fits of the Planckian locus.
glm::dvec2 planckian_xy(double t) {
    const double u = 1e3 / t;
    const double x = t <= 4000.0 ? ((-0.2661239 * u - 0.2343589) * u + 0.8776956) * u + 0.179910
                                 : ((-3.0258469 * u + 2.1070379) * u + 0.2226347) * u + 0.240390;
    const double y = t <= 2222.0   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                     : t <= 4000.0 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                                   : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
    return {x, y};
}

// CIE 15: daylight locus, 4000..25000 K.
glm::dvec2 daylight_xy(double t) {
    const double u = 1e3 / t;
    const double x = t <= 7000.0 ? ((-4.6070 * u + 2.9678) * u + 0.09911) * u + 0.244063
                                 : ((-2.0064 * u + 1.9018) * u + 0.24748) * u + 0.237040;
    return {x, -3.0 * x * x + 2.870 * x - 0.275};
}

glm::dvec2 white_xy(double t) {
    const double daylight = std::clamp((t - 4000.0) / 1000.0, 0.0, 1.0);
    return glm::mix(planckian_xy(t), daylight_xy(std::max(t, 4000.0)), daylight);
}

// CIE 1960.
glm::dvec2 uv_of(const glm::dvec2& xy) {
    return glm::dvec2(4.0 * xy.x, 6.0 * xy.y) / (12.0 * xy.y - 2.0 * xy.x + 3.0);
}
glm::dvec2 xy_of(const glm::dvec2& uv) {
    return glm::dvec2(3.0 * uv.x, 2.0 * uv.y) / (2.0 * uv.x - 8.0 * uv.y + 4.0);
}

double sane_k(float temperature_k) {
    return std::clamp(static_cast<double>(temperature_k), 1667.0, 25000.0);
}

} // namespace

float srgb_to_linear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float linear_to_srgb(float linear) {
    return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

glm::vec3 rec709_to_rec2020(const glm::vec3& rgb) {
    return times(kRec709ToRec2020, rgb);
}
glm::vec3 rec2020_to_rec709(const glm::vec3& rgb) {
    return times(kRec2020ToRec709, rgb);
}
glm::vec3 xyz_to_rec2020(const glm::vec3& xyz) {
    return times(kXyzToRec2020, xyz);
}
glm::vec3 rec2020_to_xyz(const glm::vec3& rgb) {
    return times(kRec2020ToXyz, rgb);
}

glm::mat3 rgb_to_rec2020(const Chromaticities& from) {
    return glm::mat3(kXyzToRec2020 * rgb_to_xyz(from));
}

glm::vec3 xyy_to_rec2020(const glm::vec3& xyy) {
    if (!(xyy.y > 0.0f)) return glm::vec3(0.0f);
    return times(kXyzToRec2020 * static_cast<double>(xyy.z), glm::vec3(xyz_of(xyy.x, xyy.y)));
}

glm::vec3 cct_to_rec2020(float temperature_k) {
    const glm::dvec2 xy = white_xy(sane_k(temperature_k));
    return times(kXyzToRec2020, glm::vec3(xyz_of(xy.x, xy.y)));
}

glm::vec3 cct_to_rec2020(float temperature_k, float duv) {
    if (duv == 0.0f) return cct_to_rec2020(temperature_k);
    const double t = sane_k(temperature_k);
    constexpr double kStep = 1.01;
    const double near = std::clamp(t, 1667.0 * kStep, 25000.0 / kStep); // both ends of the tangent are sane
    const glm::dvec2 cooler = glm::normalize(uv_of(white_xy(near * kStep)) - uv_of(white_xy(near / kStep)));
    const glm::dvec2 green(cooler.y, -cooler.x); // on the right of one who walks to lower u
    const glm::dvec2 xy = xy_of(uv_of(white_xy(t)) + static_cast<double>(duv) * green);
    return times(kXyzToRec2020, glm::vec3(xyz_of(xy.x, xy.y)));
}

glm::vec3 rec2020_to_xyy(const glm::vec3& rgb) {
    const glm::vec3 xyz = rec2020_to_xyz(rgb);
    const float sum = xyz.x + xyz.y + xyz.z;
    if (!(sum > 1e-12f)) return {kRec2020[6], kRec2020[7], 0.0f};
    return {xyz.x / sum, xyz.y / sum, xyz.y};
}

glm::vec3 into_gamut(const glm::vec3& rgb) {
    if (rgb.x >= 0.0f && rgb.y >= 0.0f && rgb.z >= 0.0f) return rgb;
    const float luminance = rec2020_to_xyz(rgb).y;
    const glm::vec3 clipped = glm::max(rgb, glm::vec3(0.0f));
    const float now = rec2020_to_xyz(clipped).y;
    return luminance > 0.0f && now > 0.0f ? clipped * (luminance / now) : glm::vec3(0.0f);
}

} // namespace ghost::image
