#pragma once
// SPDX-License-Identifier: Apache-2.0
// Makes links reciprocal: what A gets from B and what B gets from A are two estimates of one number, by rays
// of either. Their mean keeps what each node sees in sum, by factors that are the same for getting and for
// giving (so no light is lost on the way from those that give to those that get).

#include "bounce/bounce_parts.h"

#include <vector>

namespace ghost::bake {

using scene::FoundLink;

// rows: links of each node, sorted by receiver and emitter; so they are afterwards, too.
void make_reciprocal(const scene::BounceLevel& level, std::vector<std::vector<FoundLink>>& rows);

} // namespace ghost::bake
