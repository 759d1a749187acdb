// SPDX-License-Identifier: Apache-2.0
// GCC 12 takes the result inside of std::async, which is placed in memory of the future, for one on the
// stack.
#pragma GCC diagnostic ignored "-Wfree-nonheap-object"
#include "live/engine/engine.h"

namespace ghost::app {

void Engine::reopen(std::function<Result<std::unique_ptr<Session>>()> open) {
    reopening_ = std::async(std::launch::async, std::move(open));
}

} // namespace ghost::app
