// SPDX-License-Identifier: Apache-2.0
#include "base/private/terminal.h"

#include <unistd.h>

namespace ghost {

bool stderr_is_terminal() {
    return ::isatty(STDERR_FILENO) != 0;
}

} // namespace ghost
