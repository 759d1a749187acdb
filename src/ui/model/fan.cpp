// SPDX-License-Identifier: Apache-2.0
#include "ui/model/fan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ghost::ui {

float fanned(Fan fan, float a, float b, std::size_t number, std::size_t count) {
    if (count < 2) return a;
    const std::size_t last = count - 1;
    const auto share = static_cast<float>(number) / static_cast<float>(last);
    if (fan == Fan::centre) return a + b * (2 * share - 1);
    if (fan == Fan::line) return std::lerp(a, b, share);
    const std::size_t to_middle = last / 2;
    const auto inside = static_cast<float>(std::min(number, last - number));
    return to_middle == 0 ? a : std::lerp(a, b, inside / static_cast<float>(to_middle));
}

glm::vec3 fanned(Fan fan, const glm::vec3& a, const glm::vec3& b, std::size_t number, std::size_t count) {
    glm::vec3 value;
    for (int k = 0; k < 3; ++k) value[k] = fanned(fan, a[k], b[k], number, count);
    return value;
}

std::vector<std::size_t> heads_in(HeadOrder order, const AppModel& app) {
    if (order == HeadOrder::selection) return app.selected_in_order();
    std::vector<std::size_t> heads(app.selection().begin(), app.selection().end());
    const std::vector<FixtureNow>& now = app.rig().fixtures;
    const auto x_m = [&](std::size_t head) {
        return head < now.size() ? now[head].light_m.x : std::numeric_limits<float>::max();
    };
    if (order == HeadOrder::left_to_right)
        std::stable_sort(heads.begin(), heads.end(),
                         [&](std::size_t a, std::size_t b) { return x_m(a) < x_m(b); });
    return heads;
}

} // namespace ghost::ui
