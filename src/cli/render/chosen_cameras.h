#pragma once
// SPDX-License-Identifier: Apache-2.0
// The cameras of a show that a sheet or a book draws from. Main thread.

#include "base/result.h"
#include "show/camera.h"
#include "show/show.h"

#include <string>
#include <vector>

namespace ghost::app {

// views: names, each once, in their order; empty: all. Pictures of width x height. The last camera of a
// session with a size is that of its window, and left out. Error: no such camera.
Result<std::vector<scene::Camera>>
chosen_cameras(const scene::Show& show, const std::vector<std::string>& views, int width, int height);

} // namespace ghost::app
