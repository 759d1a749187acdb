// SPDX-License-Identifier: Apache-2.0
#include "render/pixels/processor.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace ghost::render {

bool has_vectors() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
           __builtin_cpu_supports("f16c") != 0;
#else
    return false;
#endif
}

void each_rows(int height, const std::function<void(int from, int to)>& rows) {
    constexpr int kRowsTogether = 16;
    tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsTogether),
                      [&](const auto& some) { rows(some.begin(), some.end()); });
}

} // namespace ghost::render
