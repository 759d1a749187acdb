// SPDX-License-Identifier: Apache-2.0
#include "disk/files.h"

#include "disk/crc32.h"
#include "disk/own_folder.h"
#include "disk/temporary.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <random>
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

// Two machines may have processes of the same number.
std::uint32_t host_code() {
    const std::string name = host_name();
    return crc32(Bytes(reinterpret_cast<const std::uint8_t*>(name.data()), name.size()));
}

template <class Container>
Result<Container> read_into(const fs::path& path, std::uintmax_t limit_bytes) {
    std::error_code code;
    if (!fs::exists(path, code)) return Error{"no such file", path.string()};
    if (!fs::is_regular_file(path, code)) return Error{"not a plain file", path.string()};
    const std::uintmax_t size = fs::file_size(path, code);
    if (code) return Error{"cannot read its size: " + code.message(), path.string()};
    if (size > limit_bytes)
        return Error{"is " + std::to_string(size) + " bytes, more than the limit of " +
                         std::to_string(limit_bytes),
                     path.string()};
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.fd < 0) return errno_error("cannot open", path);
    Container content(static_cast<std::size_t>(size), typename Container::value_type{});
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t got = ::read(file.fd, content.data() + done, content.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno_error("cannot read", path);
        if (got == 0) break; // cut short meanwhile
        done += static_cast<std::size_t>(got);
    }
    content.resize(done);
    return content;
}

} // namespace

Result<std::vector<std::uint8_t>> read_file(const fs::path& path, std::uintmax_t limit_bytes) {
    return read_into<std::vector<std::uint8_t>>(path, limit_bytes);
}

Result<std::string> read_text_file(const fs::path& path, std::uintmax_t limit_bytes) {
    return read_into<std::string>(path, limit_bytes);
}

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

fs::path temporary_beside(const fs::path& path) {
    static std::atomic<std::uint32_t> counter{std::random_device{}()};
    const std::uint64_t number = std::uint64_t{host_code()} << 32 | counter++;
    fs::path result = path;
    // The extension stays last: writers choose their format by it.
    result.replace_filename("." + path.stem().string() + ".part" + std::to_string(::getpid()) + "_" +
                            std::to_string(number) + path.extension().string());
    return result;
}

Writer writer_of(const fs::path& path) {
    const std::string name = path.filename().string();
    const std::size_t part = name.rfind(".part");
    if (part == std::string::npos || name[0] != '.') return Writer::none;
    int pid = 0;
    const char* const digits = name.c_str() + part + 5;
    const char* const name_end = name.c_str() + name.size();
    const auto [end, error] = std::from_chars(digits, name_end, pid);
    if (error != std::errc() || pid <= 0 || *end != '_') return Writer::none;
    std::uint64_t number = 0;
    if (std::from_chars(end + 1, name_end, number).ec == std::errc() && number >> 32 != 0 &&
        number >> 32 != host_code())
        return Writer::elsewhere;
    const auto owner = static_cast<pid_t>(pid);
    return ::kill(owner, 0) == 0 || errno == EPERM ? Writer::here : Writer::gone;
}

bool is_temporary_in_use(const fs::path& path) {
    const Writer writer = writer_of(path);
    return writer == Writer::here || writer == Writer::elsewhere;
}

Result<void> commit_temporary(const fs::path& temporary, const fs::path& path) {
    {
        const Descriptor file{::open(temporary.c_str(), O_RDONLY | O_CLOEXEC)};
        if (file.fd < 0) return errno_error("cannot reopen to flush", temporary);
        if (::fsync(file.fd) != 0) {
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

Result<void> make_folders(const fs::path& folder, const fs::path& home) {
    TRY_VOID(OwnFolder::open(folder, home, OwnFolder::Missing::is_made));
    return {};
}

Result<void> write_file_atomic(const fs::path& path, std::string_view text) {
    return write_file_atomic(path, Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

} // namespace ghost
