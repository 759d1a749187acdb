// SPDX-License-Identifier: Apache-2.0
#include "disk/own_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace ghost {
namespace fs = std::filesystem;
namespace {

constexpr int kFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

} // namespace

OwnFolder::OwnFolder(OwnFolder&& other) noexcept
    : handle_(std::exchange(other.handle_, -1)), path_(std::move(other.path_)) {}

OwnFolder& OwnFolder::operator=(OwnFolder&& other) noexcept {
    std::swap(handle_, other.handle_);
    std::swap(path_, other.path_);
    return *this;
}

OwnFolder::~OwnFolder() {
    if (handle_ >= 0) ::close(handle_);
}

Result<OwnFolder> OwnFolder::open(const fs::path& folder, const fs::path& home, Missing missing) {
    const fs::path start = home.empty() ? fs::path(".") : home;
    OwnFolder at(::open(start.c_str(), kFolder), home);
    if (at.handle_ < 0) return Error{"this folder is gone", home.string()};
    for (const fs::path& step : folder.lexically_relative(home)) {
        if (step.empty() || step == ".") continue;
        if (step == "..") return Error{"lies outside of the folder " + start.string(), folder.string()};
        if (missing == Missing::is_made && ::mkdirat(at.handle_, step.c_str(), 0777) != 0 && errno != EEXIST)
            return Error{"cannot make the folder: " + std::string(std::strerror(errno)),
                         (at.path_ / step).string()};
        TRY(at, at.below(step.string()));
    }
    return at;
}

Result<OwnFolder> OwnFolder::below(const std::string& name) const {
    OwnFolder folder(::openat(handle_, name.c_str(), kFolder | O_NOFOLLOW), path_ / name);
    if (folder.handle_ >= 0) return folder;
    const int why = errno;
    struct stat entry {};
    const bool is_link =
        ::fstatat(handle_, name.c_str(), &entry, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(entry.st_mode);
    return Error{is_link ? "is a link, expected a folder of this show: nothing is written or removed there"
                         : "cannot be opened: " + std::string(std::strerror(why)),
                 folder.path_.string()};
}

OwnFolder::Entries OwnFolder::entries() const {
    Entries result;
    // A handle of its own: reading moves it on.
    DIR* const opened = ::fdopendir(::openat(handle_, ".", kFolder));
    if (opened == nullptr) return result;
    const std::unique_ptr<DIR, int (*)(DIR*)> list(opened, ::closedir);
    while (const dirent* const next = ::readdir(list.get())) {
        const std::string name = next->d_name;
        struct stat entry {};
        if (name == "." || name == ".." || ::fstatat(handle_, name.c_str(), &entry, AT_SYMLINK_NOFOLLOW) != 0)
            continue;
        if (S_ISDIR(entry.st_mode)) result.folders.push_back(name);
        if (!S_ISREG(entry.st_mode)) continue;
#if defined(__APPLE__)
        const timespec written = entry.st_mtimespec;
#else
        const timespec written = entry.st_mtim;
#endif
        const auto since = std::chrono::seconds(written.tv_sec) + std::chrono::nanoseconds(written.tv_nsec);
        result.files.push_back(
            {name, std::chrono::system_clock::time_point(
                       std::chrono::duration_cast<std::chrono::system_clock::duration>(since))});
    }
    std::ranges::sort(result.files, {}, &File::name);
    std::ranges::sort(result.folders);
    return result;
}

bool OwnFolder::remove_file(const std::string& name) const {
    return ::unlinkat(handle_, name.c_str(), 0) == 0;
}

bool OwnFolder::remove_empty_folder(const std::string& name) const {
    return ::unlinkat(handle_, name.c_str(), AT_REMOVEDIR) == 0;
}

} // namespace ghost
