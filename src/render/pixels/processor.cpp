// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/processor.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace ghost::render {

bool has_vectors() {
#if defined(__x86_64__)
    unsigned int a = 0, b = 0, features = 0, d = 0;
    const bool has_halves = __get_cpuid(1, &a, &b, &features, &d) != 0 && (features & bit_F16C) != 0;
    return has_halves && __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
    return false;
#endif
}

void each_rows(int height, const std::function<void(int from, int to)>& rows) {
    constexpr int kRowsInTurn = 16;
    tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsInTurn),
                      [&](const auto& some) { rows(some.begin(), some.end()); });
}

} // namespace ghost::render
