// SPDX-License-Identifier: Apache-2.0
#include "show_folder/hold.h"

#include "disk/files.h"
#include "show_folder/private/hold_text.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

bool is_same_file(int handle, const fs::path& path) {
    struct stat ours {
    }, there{};
    return ::fstat(handle, &ours) == 0 && ::lstat(path.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
           ours.st_dev == there.st_dev;
}

enum class Lock { taken, held, unknown };

Lock lock(int handle) {
    if (::flock(handle, LOCK_EX | LOCK_NB) == 0) return Lock::taken;
    return errno == EWOULDBLOCK ? Lock::held : Lock::unknown;
}

bool write_ours(int handle) {
    const std::string text = text_of_this_hold();
    return ::ftruncate(handle, 0) == 0 &&
           ::pwrite(handle, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

} // namespace

bool local_time(std::time_t time, std::tm& local) {
    return ::localtime_r(&time, &local) != nullptr;
}

Result<Hold> Hold::take(const fs::path& file, const fs::path& home, Other other) {
    TRY_VOID(make_folders(file.parent_path(), home));
    constexpr int kOpened = O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW;
    const auto failed = [&](int handle) {
        const Error error{"cannot be written: " + std::string(std::strerror(errno)), file.string()};
        if (handle >= 0) ::close(handle);
        return error;
    };
    Hold hold(file);
    for (int attempt = 0; attempt < kTries; ++attempt) {
        const int handle = ::open(file.c_str(), kOpened, 0644);
        if (handle < 0) return failed(handle);
        const Lock found = lock(handle);
        const bool is_free = found == Lock::taken || (found == Lock::unknown && !is_alive(holder_in(file)));
        if (is_free && !is_same_file(handle, file)) { // given back in between
            ::close(handle);
            continue;
        }
        if (is_free) {
            if (!write_ours(handle)) return failed(handle);
            hold.handle_ = handle;
            return hold;
        }
        ::close(handle);
        if (other == Other::keeps) return hold;
        // Another file takes the place of theirs, which they see.
        const fs::path temporary = temporary_beside(file);
        const int ours = ::open(temporary.c_str(), kOpened | O_EXCL, 0644);
        if (ours < 0) return failed(ours);
        lock(ours);
        if (!write_ours(ours) || ::rename(temporary.c_str(), file.c_str()) != 0) {
            const Error error = failed(ours);
            ::unlink(temporary.c_str());
            return error;
        }
        hold.handle_ = ours;
        return hold;
    }
    return hold;
}

Hold::~Hold() {
    if (handle_ < 0) return;
    if (is_same_file(handle_, file_)) ::unlink(file_.c_str());
    ::close(handle_);
}

bool Hold::is_ours() const {
    std::error_code code;
    // Who clears .ghost takes nothing over.
    return handle_ >= 0 && (is_same_file(handle_, file_) || !fs::exists(file_, code));
}

} // namespace ghost
