#pragma once
// SPDX-License-Identifier: Apache-2.0
// What standard error leads to. Any thread.

namespace ghost {

bool stderr_is_terminal();

} // namespace ghost
