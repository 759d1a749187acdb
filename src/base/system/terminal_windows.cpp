// SPDX-License-Identifier: Apache-2.0
#include "base/private/terminal.h"

#include <windows.h>

namespace ghost {

// Not the C library's isatty(), which takes NUL for one.
bool stderr_is_terminal() {
    DWORD mode = 0;
    return ::GetConsoleMode(::GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

} // namespace ghost
