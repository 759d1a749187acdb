// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
#include "disk/own_program.h"

#include <mach-o/dyld.h>

#include <string>
#include <system_error>

namespace ghost {

namespace fs = std::filesystem;

fs::path own_program() {
    std::uint32_t size = 0;
    _NSGetExecutablePath(nullptr, &size);
    std::string file(size, '\0');
    if (_NSGetExecutablePath(file.data(), &size) != 0) return {};
    std::error_code code;
    return starter_of(fs::canonical(file.c_str(), code));
}

} // namespace ghost
