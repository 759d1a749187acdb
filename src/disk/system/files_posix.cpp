// SPDX-License-Identifier: Apache-2.0
#include "disk/files.h"

#include "disk/disk_sync.h"
#include "disk/private/system_files.h"
#include "disk/temporary.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

Error errno_error(const std::string& action, const fs::path& path) {
    return Error{action + ": " + std::strerror(errno), path.string()};
}

// Closes on every way out.
struct Descriptor {
    int fd = -1;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
};

// A file system of Linux or macOS, or a container's filter, that does not know a call.
bool is_not_known(int error) {
    constexpr std::array kErrors{EINVAL, ENOSYS, EPERM, EOPNOTSUPP, ENOTSUP};
    return std::find(kErrors.begin(), kErrors.end(), error) != kErrors.end();
}

bool link_and_unlink(const fs::path& from, const fs::path& to) {
    return ::link(from.c_str(), to.c_str()) == 0 && (::unlink(from.c_str()), true);
}

// The name is taken by an empty file, which is replaced.
bool rename_over_empty(const fs::path& from, const fs::path& to) {
    const int taken = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (taken < 0) return false;
    ::close(taken);
    if (::rename(from.c_str(), to.c_str()) == 0) return true;
    const int why = errno;
    ::unlink(to.c_str());
    errno = why;
    return false;
}

} // namespace

std::FILE* open_stream(const fs::path& path, const char* mode) {
    return std::fopen(path.c_str(), mode);
}

int own_process() {
    return ::getpid();
}

bool is_running(int process) {
    return ::kill(process, 0) == 0 || errno == EPERM;
}

Result<std::size_t> read_bytes(const fs::path& path, std::span<char> bytes) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.fd < 0) return errno_error("cannot open", path);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::read(file.fd, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno_error("cannot read", path);
        if (got == 0) break; // cut short meanwhile
        done += static_cast<std::size_t>(got);
    }
    return done;
}

std::optional<bool> rename_to_new(const fs::path& from, const fs::path& to, std::string& error) {
    if (rename_without_replacing(from, to)) return true;
    if (is_not_known(errno) && link_and_unlink(from, to)) return true;
    if (is_not_known(errno) && rename_over_empty(from, to)) return true;
    if (errno == EEXIST) return false;
    error = std::strerror(errno);
    return std::nullopt;
}

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

Result<void> commit_temporary(const fs::path& temporary, const fs::path& path) {
    {
        const Descriptor file{::open(temporary.c_str(), O_RDONLY | O_CLOEXEC)};
        if (file.fd < 0) return errno_error("cannot reopen to flush", temporary);
        if (!flush_file(file.fd)) {
            const Error error = errno_error("cannot flush to disk", path);
            ::unlink(temporary.c_str());
            return error;
        }
    }
    if (::rename(temporary.c_str(), path.c_str()) != 0) {
        const Error error = errno_error("cannot put into place", path);
        ::unlink(temporary.c_str());
        return error;
    }
    return {};
}

Result<void> write_file_atomic(const fs::path& path, Bytes bytes) {
    const fs::path temporary = temporary_beside(path);
    {
        // Not through what others left under this name.
        const Descriptor file{::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)};
        if (file.fd < 0) return errno_error("cannot create", path);
        struct stat old {};
        if (::lstat(path.c_str(), &old) == 0 && S_ISREG(old.st_mode)) ::fchmod(file.fd, old.st_mode & 0777);
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t wrote = ::write(file.fd, bytes.data() + done, bytes.size() - done);
            if (wrote < 0 && errno == EINTR) continue;
            if (wrote < 0) {
                const Error error = errno_error("cannot write", path);
                ::unlink(temporary.c_str());
                return error;
            }
            done += static_cast<std::size_t>(wrote);
        }
    }
    return commit_temporary(temporary, path);
}

} // namespace ghost
