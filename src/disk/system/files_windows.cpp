// SPDX-License-Identifier: Apache-2.0
// What a person set of a file (its list of who may) stays with the old one: the new one has that of its
// folder.
#include "disk/files.h"

#include "base/windows_text.h"
#include "disk/disk_sync.h"
#include "disk/private/system_files.h"
#include "disk/temporary.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include <fcntl.h>
#include <io.h>
#include <windows.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

constexpr DWORD kAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
constexpr std::size_t kMostAtOnce = std::size_t{1} << 26;
// Those who look at each new file (virus scanners, the index of the search) have it open for a moment.
constexpr int kTries = 20;
constexpr DWORD kBetween_ms = 25;

Error last_error(const std::string& action, const fs::path& path) {
    return Error{action + ": " + windows_reason(::GetLastError()), path.string()};
}

// Closes on every way out.
struct File {
    HANDLE handle = INVALID_HANDLE_VALUE;
    ~File() {
        if (is_open()) ::CloseHandle(handle);
    }
    bool is_open() const { return handle != INVALID_HANDLE_VALUE; }
};

bool move(const fs::path& from, const fs::path& to, DWORD flags) {
    for (int tries = 1;; ++tries) {
        if (::MoveFileExW(from.c_str(), to.c_str(), flags | MOVEFILE_WRITE_THROUGH)) return true;
        const DWORD code = ::GetLastError();
        if (tries == kTries || (code != ERROR_SHARING_VIOLATION && code != ERROR_ACCESS_DENIED)) return false;
        ::Sleep(kBetween_ms);
        ::SetLastError(code);
    }
}

HANDLE handle_of_file(std::FILE* file) {
    return reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(file)));
}

} // namespace

std::FILE* open_stream(const fs::path& path, const char* mode) {
    // What the C library opens nobody can rename meanwhile.
    const char kind = mode[0];
    const HANDLE handle =
        ::CreateFileW(path.c_str(), kind == 'r' ? GENERIC_READ : GENERIC_READ | GENERIC_WRITE, kAll, nullptr,
                      kind == 'r'   ? OPEN_EXISTING
                      : kind == 'w' ? CREATE_ALWAYS
                                    : OPEN_ALWAYS,
                      0, nullptr);
    if (handle == INVALID_HANDLE_VALUE) {
        const DWORD code = ::GetLastError();
        errno = code == ERROR_FILE_NOT_FOUND || code == ERROR_PATH_NOT_FOUND ? ENOENT
                : code == ERROR_DISK_FULL                                    ? ENOSPC
                                                                             : EACCES;
        return nullptr;
    }
    const int fd = ::_open_osfhandle(reinterpret_cast<intptr_t>(handle),
                                     kind == 'a' ? _O_APPEND | _O_BINARY : _O_BINARY);
    std::FILE* const file = fd == -1 ? nullptr : ::_fdopen(fd, mode);
    if (file != nullptr) return file;
    if (fd != -1)
        ::_close(fd);
    else
        ::CloseHandle(handle);
    return nullptr;
}

int own_process() {
    return static_cast<int>(::GetCurrentProcessId());
}

bool is_running(int process) {
    const File one{::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process))};
    if (one.handle == nullptr) return ::GetLastError() == ERROR_ACCESS_DENIED;
    return ::WaitForSingleObject(one.handle, 0) == WAIT_TIMEOUT;
}

std::string host_name() {
    std::array<wchar_t, 256> name{};
    auto size = static_cast<DWORD>(name.size());
    return ::GetComputerNameExW(ComputerNameDnsHostname, name.data(), &size) ? utf8_text({name.data(), size})
                                                                             : "";
}

Result<std::size_t> read_bytes(const fs::path& path, std::span<char> bytes) {
    const File file{::CreateFileW(path.c_str(), GENERIC_READ, kAll, nullptr, OPEN_EXISTING, 0, nullptr)};
    if (!file.is_open()) return last_error("cannot open", path);
    std::size_t done = 0;
    while (done < bytes.size()) {
        DWORD got = 0;
        const auto most = static_cast<DWORD>(std::min(bytes.size() - done, kMostAtOnce));
        if (!::ReadFile(file.handle, bytes.data() + done, most, &got, nullptr))
            return last_error("cannot read", path);
        if (got == 0) break; // cut short meanwhile
        done += got;
    }
    return done;
}

Result<void> commit_temporary(const fs::path& temporary, const fs::path& path) {
    {
        const File file{
            ::CreateFileW(temporary.c_str(), GENERIC_WRITE, kAll, nullptr, OPEN_EXISTING, 0, nullptr)};
        if (!file.is_open()) return last_error("cannot reopen to flush", temporary);
        if (!::FlushFileBuffers(file.handle)) {
            const Error error = last_error("cannot flush to disk", path);
            ::DeleteFileW(temporary.c_str());
            return error;
        }
    }
    if (!move(temporary, path, MOVEFILE_REPLACE_EXISTING)) {
        const Error error = last_error("cannot put into place", path);
        ::DeleteFileW(temporary.c_str());
        return error;
    }
    return {};
}

Result<void> write_file_atomic(const fs::path& path, Bytes bytes) {
    const fs::path temporary = temporary_beside(path);
    {
        // Not through what others left under this name.
        const File file{::CreateFileW(temporary.c_str(), GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE,
                                      nullptr, CREATE_NEW, 0, nullptr)};
        if (!file.is_open()) return last_error("cannot create", path);
        std::size_t done = 0;
        while (done < bytes.size()) {
            DWORD wrote = 0;
            const auto most = static_cast<DWORD>(std::min(bytes.size() - done, kMostAtOnce));
            if (!::WriteFile(file.handle, bytes.data() + done, most, &wrote, nullptr)) {
                const Error error = last_error("cannot write", path);
                ::DeleteFileW(temporary.c_str());
                return error;
            }
            done += wrote;
        }
    }
    return commit_temporary(temporary, path);
}

std::optional<bool> rename_to_new(const fs::path& from, const fs::path& to, std::string& error) {
    if (move(from, to, 0)) return true;
    const DWORD code = ::GetLastError();
    if (code == ERROR_ALREADY_EXISTS || code == ERROR_FILE_EXISTS) return false;
    error = windows_reason(code);
    return std::nullopt;
}

bool flush_file(int fd) {
    return ::FlushFileBuffers(reinterpret_cast<HANDLE>(::_get_osfhandle(fd))) != 0;
}

bool sync_to_disk(std::FILE* file) {
    return flush_file(::_fileno(file));
}

// What is locked nobody else can read there, so it is a byte where nothing is.
bool lock_file(std::FILE* file) {
    OVERLAPPED place{};
    place.OffsetHigh = 0x40000000;
    return ::LockFileEx(handle_of_file(file), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0,
                        &place) != 0;
}

} // namespace ghost
