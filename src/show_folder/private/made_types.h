#pragma once
// SPDX-License-Identifier: Apache-2.0
// Types of fixtures that name no file. Any thread.

#include "fixture/type.h"

#include <memory>

namespace ghost::scene {

struct PatchedFixture;

// By what the show sets: that of a wall, of a projector, of a laser; else null.
std::shared_ptr<const fixture::Type> type_without_file(const PatchedFixture& fixture);

} // namespace ghost::scene
