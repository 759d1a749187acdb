#pragma once
// SPDX-License-Identifier: Apache-2.0
// Steps of a picture: surfaces, sums of kept images, from points to pixels, silhouettes, glare, tone curve. As
// shaders they cost a processor 60 to 80 cycles a pixel each (surfaces of a light 24), mostly loads and stores
// one by one; here they are loops over eight floats (docs/measurements/performance.md). The shaders of the
// same names say what is right; tests hold both together.

#include <functional>

namespace ghost::render {

// This processor has the vectors (AVX2, FMA, F16C) that the steps of this room are written for. Nothing else
// here may be called without.
bool has_vectors();

// On all cores, some rows at a time. Waits.
void each_rows(int height, const std::function<void(int from, int to)>& rows);

} // namespace ghost::render
