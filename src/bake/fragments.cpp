// SPDX-License-Identifier: Apache-2.0
#include "bake/fragments.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ghost::bake {

int split_into_fragments(std::span<const Surface> samples, float pixel_per_m, std::span<int> part) {
    thread_local std::vector<int> order;
    order.clear();
    for (std::size_t k = 0; k < samples.size(); ++k) {
        part[k] = -1;
        if (samples[k].instance >= 0) order.push_back(static_cast<int>(k));
    }
    if (order.empty()) return 0;
    const auto distance = [&](int at) {
        return samples[static_cast<std::size_t>(order[static_cast<std::size_t>(at)])].distance_m;
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const float da = samples[static_cast<std::size_t>(a)].distance_m;
        const float db = samples[static_cast<std::size_t>(b)].distance_m;
        return da != db ? da < db : a < b;
    });

    struct Run {
        int begin, end;
    };
    std::array<Run, kMaxFragments> runs{};
    runs[0] = {0, static_cast<int>(order.size())};
    int count = 1;
    while (count < kMaxFragments) {
        // Cut the deepest run that is still too deep, relative to how far away it is.
        int deepest = -1;
        float worst = kFragmentDepthPixels;
        for (int k = 0; k < count; ++k) {
            const Run& run = runs[static_cast<std::size_t>(k)];
            const float near = distance(run.begin);
            const float depth = (distance(run.end - 1) - near) / std::max(near * pixel_per_m, 1e-9f);
            if (depth > worst) {
                worst = depth;
                deepest = k;
            }
        }
        if (deepest < 0) break;
        Run& run = runs[static_cast<std::size_t>(deepest)];
        int cut = run.begin + 1;
        float widest = -1.0f;
        for (int at = run.begin + 1; at < run.end; ++at) {
            const float gap = distance(at) - distance(at - 1);
            if (gap > widest) {
                widest = gap;
                cut = at;
            }
        }
        runs[static_cast<std::size_t>(count++)] = {cut, run.end};
        run.end = cut;
    }
    std::stable_sort(runs.begin(), runs.begin() + count,
                     [](const Run& a, const Run& b) { return a.end - a.begin > b.end - b.begin; });
    for (int k = 0; k < count; ++k)
        for (int at = runs[static_cast<std::size_t>(k)].begin; at < runs[static_cast<std::size_t>(k)].end;
             ++at)
            part[static_cast<std::size_t>(order[static_cast<std::size_t>(at)])] = k;
    return count;
}

} // namespace ghost::bake
