// SPDX-License-Identifier: Apache-2.0
#include "live/session/settle.h"

namespace ghost::app {
namespace {

constexpr double kSettle_s = 5;
constexpr int kSettleSteps = 50;

} // namespace

void settle(scene::Rig& rig, const dmx::Universes& levels,
            const std::map<std::size_t, fixture::Programmer>& programmer) {
    for (int step = 0; step < kSettleSteps; ++step) rig.step(levels, kSettle_s / kSettleSteps, programmer);
}

} // namespace ghost::app
