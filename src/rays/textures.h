#pragma once
// SPDX-License-Identifier: Apache-2.0
// Bilinear, repeating texture reads; colour comes out linear Rec.2020. Alpha is linear in both. Const, any
// thread.

#include "stage/stage.h"

#include <array>
#include <glm/glm.hpp>

namespace ghost::bake {

class Textures {
public:
    explicit Textures(const scene::Stage& stage);

    glm::vec4 colour(int texture, const glm::vec2& uv) const; // linear Rec.2020, alpha
    glm::vec4 data(int texture, const glm::vec2& uv) const;   // 0..1 as stored
    float alpha(int texture, const glm::vec2& uv) const;

private:
    const scene::Stage& stage_;
    std::array<float, 256> linear_{}; // sRGB decoding
    std::array<float, 256> plain_{};
    glm::mat3 to_working_{1.0f}; // Rec.709 to Rec.2020
};

} // namespace ghost::bake
