// SPDX-License-Identifier: Apache-2.0
#include "disk/links.h"

namespace ghost {
namespace fs = std::filesystem;

bool is_link(const fs::path& path) {
    std::error_code code;
    return fs::is_symlink(path, code);
}

fs::path behind_links(const fs::path& path, std::error_code& code) {
    return fs::weakly_canonical(path, code);
}

void remove_whole(const fs::path& folder) {
    std::error_code code;
    fs::remove_all(folder, code);
}

} // namespace ghost
