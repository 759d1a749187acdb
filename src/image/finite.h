#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whether all numbers of a vector or a matrix are numbers: no infinity, no NaN; and a direction of length 1
// where a vector has one. Pure, any thread.

#include <cmath>
#include <glm/glm.hpp>

namespace ghost::image {

template <glm::length_t N, class T, glm::qualifier Q>
bool is_finite(const glm::vec<N, T, Q>& vector) {
    for (glm::length_t k = 0; k < N; ++k)
        if (!std::isfinite(vector[k])) return false;
    return true;
}

template <glm::length_t Columns, glm::length_t Rows, class T, glm::qualifier Q>
bool is_finite(const glm::mat<Columns, Rows, T, Q>& matrix) {
    for (glm::length_t k = 0; k < Columns; ++k)
        if (!is_finite(matrix[k])) return false;
    return true;
}

// Of length 1, or the fallback where it is too short for that or no number.
inline glm::vec3 unit_or(const glm::vec3& vector, const glm::vec3& fallback) {
    const float length2 = glm::dot(vector, vector);
    return length2 > 1e-20f && std::isfinite(length2) ? vector / std::sqrt(length2) : fallback;
}

} // namespace ghost::image
