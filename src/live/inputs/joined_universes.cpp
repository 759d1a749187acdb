// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/joined_universes.h"

#include "base/log.h"
#include "dmx/merge/merge.h"

#include <algorithm>
#include <string>

namespace ghost::app {

std::vector<std::uint16_t> joined_universes(std::vector<std::uint16_t> asked_for,
                                            const scene::PatchMap& patch) {
    const std::vector<std::uint16_t> patched = patch.universe_numbers();
    asked_for.insert(asked_for.end(), patched.begin(), patched.end());
    std::sort(asked_for.begin(), asked_for.end());
    asked_for.erase(std::unique(asked_for.begin(), asked_for.end()), asked_for.end());
    if (asked_for.size() > dmx::kMaxUniverses) {
        log_warning("the show patches " + std::to_string(asked_for.size()) + " universes; the first " +
                    std::to_string(dmx::kMaxUniverses) + " are listened to");
        asked_for.resize(dmx::kMaxUniverses);
    }
    return asked_for;
}

} // namespace ghost::app
