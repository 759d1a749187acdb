#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whether all numbers of a vector or a matrix are numbers: no infinity, no NaN. Pure, any thread.

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

} // namespace ghost::image
