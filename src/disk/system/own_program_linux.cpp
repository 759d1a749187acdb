// SPDX-License-Identifier: Apache-2.0
#include "disk/own_program.h"

#include <system_error>

namespace ghost {

std::filesystem::path own_program() {
    std::error_code code;
    return starter_of(std::filesystem::read_symlink("/proc/self/exe", code));
}

} // namespace ghost
