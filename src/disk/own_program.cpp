// SPDX-License-Identifier: Apache-2.0
#include "disk/own_program.h"

#include <system_error>

namespace ghost {

namespace fs = std::filesystem;

fs::path starter_of(const fs::path& program) {
    if (program.parent_path().filename() != "libexec") return program;
    fs::path launcher = program.parent_path().parent_path() / "bin" / program.filename();
    std::error_code code;
    return fs::is_regular_file(launcher, code) ? launcher : program;
}

} // namespace ghost
