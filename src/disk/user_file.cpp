// SPDX-License-Identifier: Apache-2.0
#include "disk/user_file.h"

#include "disk/files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace ghost {
namespace fs = std::filesystem;

Result<void> write_user_file(const fs::path& path, std::string_view text) {
    std::error_code code;
    if (!fs::is_symlink(path, code)) return write_file_atomic(path, text);
    const fs::path target = fs::weakly_canonical(path, code);
    const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", code);
    const fs::path inside = target.lexically_relative(folder);
    if (code || inside.empty() || *inside.begin() == "..")
        return Error{"is a link to " + target.string() +
                         ", expected a file of this folder: put the file itself here, or save a copy",
                     path.string()};
    return write_file_atomic(target, text);
}

Result<bool> commit_new(const fs::path& temporary, const fs::path& path) {
    // A file system without this call may have links.
    int done = ::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, path.c_str(), RENAME_NOREPLACE);
    if (done != 0 && errno == EINVAL) {
        done = ::link(temporary.c_str(), path.c_str());
        if (done == 0) ::unlink(temporary.c_str());
    }
    if (done != 0 && errno == EEXIST) return false;
    if (done != 0) return Error{"cannot put into place: " + std::string(std::strerror(errno)), path.string()};
    return true;
}

} // namespace ghost
