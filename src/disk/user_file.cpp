// SPDX-License-Identifier: Apache-2.0
#include "disk/user_file.h"

#include "disk/files.h"
#include "disk/links.h"
#include "disk/private/system_files.h"

#include <optional>
#include <string>

namespace ghost {
namespace fs = std::filesystem;

Result<void> write_user_file(const fs::path& path, std::string_view text) {
    if (!is_link(path)) return write_file_atomic(path, text);
    std::error_code code, no_folder;
    const fs::path target = behind_links(path, code);
    const fs::path folder = behind_links(path.has_parent_path() ? path.parent_path() : ".", no_folder);
    const fs::path inside = target.lexically_relative(folder);
    if (code || no_folder || inside.empty() || *inside.begin() == "..")
        return Error{"is a link to " + target.string() +
                         ", expected a file of this folder: put the file itself here, or save a copy",
                     path.string()};
    return write_file_atomic(target, text);
}

Result<bool> commit_new(const fs::path& temporary, const fs::path& path) {
    std::string why;
    const std::optional<bool> done = rename_to_new(temporary, path, why);
    if (!done) return Error{"cannot put into place: " + why, path.string()};
    return *done;
}

} // namespace ghost
