// SPDX-License-Identifier: Apache-2.0
#include "rays/textures.h"

#include "image/colour.h"

#include <cmath>

namespace ghost::bake {
namespace {

struct Footprint {
    const std::uint8_t* texel[4] = {};
    float weight[4] = {};
};

int wrap(int at, int size) {
    const int rest = at % size;
    return rest < 0 ? rest + size : rest;
}

Footprint footprint(const image::Image8& pixels, const glm::vec2& uv) {
    // The whole part is taken off first: large tilings would lose the texel otherwise, and NaN must not
    // index.
    const float u = std::isfinite(uv.x) ? uv.x - std::floor(uv.x) : 0.0f;
    const float v = std::isfinite(uv.y) ? uv.y - std::floor(uv.y) : 0.0f;
    const float x = u * static_cast<float>(pixels.width) - 0.5f;
    const float y = v * static_cast<float>(pixels.height) - 0.5f;
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(x0);
    const float fy = y - static_cast<float>(y0);
    const int xa = wrap(x0, pixels.width);
    const int xb = wrap(x0 + 1, pixels.width);
    const int ya = wrap(y0, pixels.height);
    const int yb = wrap(y0 + 1, pixels.height);
    Footprint result;
    result.texel[0] = pixels.at(xa, ya);
    result.texel[1] = pixels.at(xb, ya);
    result.texel[2] = pixels.at(xa, yb);
    result.texel[3] = pixels.at(xb, yb);
    result.weight[0] = (1 - fx) * (1 - fy);
    result.weight[1] = fx * (1 - fy);
    result.weight[2] = (1 - fx) * fy;
    result.weight[3] = fx * fy;
    return result;
}

glm::vec4 blend(const Footprint& f, const std::array<float, 256>& rgb, const std::array<float, 256>& alpha) {
    glm::vec4 sum(0.0f);
    for (int k = 0; k < 4; ++k)
        sum += f.weight[k] *
               glm::vec4(rgb[f.texel[k][0]], rgb[f.texel[k][1]], rgb[f.texel[k][2]], alpha[f.texel[k][3]]);
    return sum;
}

} // namespace

Textures::Textures(const scene::Stage& stage) : stage_(stage) {
    for (std::size_t k = 0; k < linear_.size(); ++k) {
        plain_[k] = static_cast<float>(k) / 255.0f;
        linear_[k] = image::srgb_to_linear(plain_[k]);
    }
    for (int k = 0; k < 3; ++k) {
        glm::vec3 unit(0.0f);
        unit[k] = 1.0f;
        to_working_[k] = image::rec709_to_rec2020(unit);
    }
}

glm::vec4 Textures::colour(int texture, const glm::vec2& uv) const {
    const scene::Texture& image = stage_.textures[static_cast<std::size_t>(texture)];
    const glm::vec4 value = blend(footprint(image.pixels, uv), image.is_colour ? linear_ : plain_, plain_);
    return {to_working_ * glm::vec3(value), value.w};
}

glm::vec4 Textures::data(int texture, const glm::vec2& uv) const {
    return blend(footprint(stage_.textures[static_cast<std::size_t>(texture)].pixels, uv), plain_, plain_);
}

float Textures::alpha(int texture, const glm::vec2& uv) const {
    const Footprint f = footprint(stage_.textures[static_cast<std::size_t>(texture)].pixels, uv);
    float sum = 0.0f;
    for (int k = 0; k < 4; ++k) sum += f.weight[k] * plain_[f.texel[k][3]];
    return sum;
}

} // namespace ghost::bake
