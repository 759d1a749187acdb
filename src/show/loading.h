#pragma once
// SPDX-License-Identifier: Apache-2.0
// ShowLoading: how far the loading of a show is, and whether it shall end. Called from the loading thread.

#include <functional>
#include <string>

namespace ghost::scene {

struct ShowLoading {
    // share 0..1 and what is being read; a few hundred times at most.
    std::function<void(double share, const std::string& what)> progress;
    std::function<bool()> stop; // asked as often; true: loading ends with an error
};

} // namespace ghost::scene
