// SPDX-License-Identifier: Apache-2.0
#include "light/beam_shape.h"

#include "json_xml_toml/toml_reader.h"
#include "shared/gobos.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ghost::scene {
namespace {

constexpr float kDark = 0.002f; // of the peak: there the picture may end
constexpr std::size_t kRings = 512;
constexpr int kShapeSide = shared::kGoboSize;
constexpr float kDeg = 180.0f / std::numbers::pi_v<float>;

float peak_of(const fixture::Photometric& light) {
    float peak = 0;
    for (const std::vector<float>& plane : light.candela)
        for (std::size_t k = 0; k < plane.size(); ++k)
            if (light.gamma_deg[k] <= 0.5f * kWidestShape_deg) peak = std::max(peak, plane[k]);
    return peak;
}

// Half the angle beyond which it is dark.
float half_field_deg(const fixture::Photometric& light, float peak) {
    float end = 0.5f;
    for (const std::vector<float>& plane : light.candela)
        for (std::size_t k = 0; k < plane.size(); ++k)
            if (plane[k] > kDark * peak)
                end = std::max(end, light.gamma_deg[std::min(k + 1, plane.size() - 1)]);
    return std::min(end, 0.5f * kWidestShape_deg);
}

} // namespace

float BeamShape::solid_angle(float tan_of_field) const {
    const double tan2 = static_cast<double>(tan_of_field) * static_cast<double>(tan_of_field);
    double sum = 0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        const double r2 = (static_cast<double>(k) + 0.5) / static_cast<double>(rings.size());
        sum += rings[k] / std::pow(1.0 + r2 * tan2, 1.5);
    }
    return static_cast<float>(sum * tan2 * 4.0 / (static_cast<double>(kShapeSide) * kShapeSide));
}

BeamShape shape_of(const fixture::Photometric& light, const std::string& file) {
    BeamShape shape;
    shape.file = file;
    const float peak = std::max(peak_of(light), 1e-6f);
    const float half_deg = half_field_deg(light, peak);
    shape.tan_field = std::tan(half_deg / kDeg);
    shape.flux_lm = light.flux_lm(static_cast<double>(half_deg));
    shape.lost_lm = std::max(light.flux_lm() - shape.flux_lm, 0.0);
    shape.texels.reserve(static_cast<std::size_t>(kShapeSide) * kShapeSide);
    shape.rings.assign(kRings, 0.0);
    for (int y = 0; y < kShapeSide; ++y)
        for (int x = 0; x < kShapeSide; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) * 2.0f / kShapeSide - 1.0f;
            const float v = 1.0f - (static_cast<float>(y) + 0.5f) * 2.0f / kShapeSide;
            const float radius = std::hypot(u, v);
            // Beyond the rim it goes on as there: the aperture ends it, and a blur finds no darkness.
            const float gamma = std::atan(std::min(radius, 1.0f) * shape.tan_field) * kDeg;
            const float fraction = std::clamp(light.at(std::atan2(v, u) * kDeg, gamma) / peak, 0.0f, 1.0f);
            const auto texel = static_cast<std::uint8_t>(std::lround(255.0f * fraction));
            shape.texels.push_back(texel);
            if (radius >= 1.0f) continue;
            shape.rings[std::min(static_cast<std::size_t>(radius * radius * kRings), kRings - 1)] +=
                texel / 255.0;
        }
    return shape;
}

} // namespace ghost::scene
