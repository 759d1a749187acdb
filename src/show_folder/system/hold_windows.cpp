// SPDX-License-Identifier: Apache-2.0
// A file that somebody has open is replaced or removed only where he shares that, as all do here, and by the
// rules of POSIX, which Windows has since version 1709 of 10; where a disk does not know them, nobody takes
// over.
#include "show_folder/hold.h"

#include "base/windows_text.h"
#include "disk/files.h"
#include "show_folder/private/hold_text.h"

#include <cstddef>
#include <vector>

#include <windows.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

// Handles of the system have 32 bits that count.
HANDLE hold_handle(int number) {
    return reinterpret_cast<HANDLE>(static_cast<INT_PTR>(number));
}

int open_hold(const fs::path& file, DWORD disposition) {
    const HANDLE handle = ::CreateFileW(file.c_str(), GENERIC_READ | GENERIC_WRITE | DELETE,
                                        FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                        disposition, FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
    if (handle == INVALID_HANDLE_VALUE) return -1;
    FILE_ATTRIBUTE_TAG_INFO info{};
    if (::GetFileInformationByHandleEx(handle, FileAttributeTagInfo, &info, sizeof info) &&
        (info.FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0) {
        ::CloseHandle(handle);
        ::SetLastError(ERROR_CANT_ACCESS_FILE); // a link, which is not followed
        return -1;
    }
    return static_cast<int>(reinterpret_cast<INT_PTR>(handle));
}

bool is_same_file(int handle, const fs::path& path) {
    const HANDLE other = ::CreateFileW(path.c_str(), FILE_READ_ATTRIBUTES,
                                       FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                       OPEN_EXISTING, FILE_FLAG_OPEN_REPARSE_POINT, nullptr);
    if (other == INVALID_HANDLE_VALUE) return false;
    BY_HANDLE_FILE_INFORMATION ours{}, there{};
    const bool known = ::GetFileInformationByHandle(hold_handle(handle), &ours) &&
                       ::GetFileInformationByHandle(other, &there);
    ::CloseHandle(other);
    return known && ours.dwVolumeSerialNumber == there.dwVolumeSerialNumber &&
           ours.nFileIndexHigh == there.nFileIndexHigh && ours.nFileIndexLow == there.nFileIndexLow;
}

enum class Lock { taken, held, unknown };

// What is locked nobody else can read there, so it is a byte where nothing is.
Lock lock(int handle) {
    OVERLAPPED place{};
    place.OffsetHigh = 0x40000000;
    if (::LockFileEx(hold_handle(handle), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0,
                     &place))
        return Lock::taken;
    const DWORD code = ::GetLastError();
    return code == ERROR_LOCK_VIOLATION || code == ERROR_IO_PENDING ? Lock::held : Lock::unknown;
}

bool write_ours(int handle) {
    const std::string text = text_of_this_hold();
    DWORD wrote = 0;
    const HANDLE file = hold_handle(handle);
    return ::SetFilePointer(file, 0, nullptr, FILE_BEGIN) != INVALID_SET_FILE_POINTER &&
           ::SetEndOfFile(file) &&
           ::WriteFile(file, text.data(), static_cast<DWORD>(text.size()), &wrote, nullptr) &&
           wrote == text.size();
}

bool put_in_place(int handle, const fs::path& file) {
    const std::wstring name = fs::absolute(file).wstring();
    std::vector<std::max_align_t> memory(
        (sizeof(FILE_RENAME_INFO) + name.size() * sizeof(wchar_t)) / sizeof(std::max_align_t) + 1);
    auto* const wish = reinterpret_cast<FILE_RENAME_INFO*>(memory.data());
    constexpr DWORD kReplace = 0x1, kAsPosix = 0x2;
    *reinterpret_cast<DWORD*>(memory.data()) = kReplace | kAsPosix; // Flags, in the place of ReplaceIfExists
    wish->RootDirectory = nullptr;
    wish->FileNameLength = static_cast<DWORD>(name.size() * sizeof(wchar_t));
    name.copy(wish->FileName, name.size());
    constexpr auto kRenameNow = static_cast<FILE_INFO_BY_HANDLE_CLASS>(22); // FileRenameInfoEx
    const auto size = static_cast<DWORD>(memory.size() * sizeof(std::max_align_t));
    return ::SetFileInformationByHandle(hold_handle(handle), kRenameNow, wish, size) != 0;
}

void remove_open(int handle) {
    constexpr auto kRemoveNow = static_cast<FILE_INFO_BY_HANDLE_CLASS>(21); // FileDispositionInfoEx
    DWORD as_posix = 0x1 | 0x2;
    if (::SetFileInformationByHandle(hold_handle(handle), kRemoveNow, &as_posix, sizeof as_posix)) return;
    FILE_DISPOSITION_INFO later{};
    later.DeleteFile = TRUE;
    (void)::SetFileInformationByHandle(hold_handle(handle), FileDispositionInfo, &later, sizeof later);
}

} // namespace

bool local_time(std::time_t time, std::tm& local) {
    return ::localtime_s(&local, &time) == 0;
}

Result<Hold> Hold::take(const fs::path& file, const fs::path& home, Other other) {
    TRY_VOID(make_folders(file.parent_path(), home));
    const auto failed = [&](int handle) {
        const Error error{"cannot be written: " + windows_reason(::GetLastError()), file.string()};
        if (handle != -1) ::CloseHandle(hold_handle(handle));
        return error;
    };
    Hold hold(file);
    for (int attempt = 0; attempt < kTries; ++attempt) {
        const int handle = open_hold(file, OPEN_ALWAYS);
        if (handle == -1) return failed(handle);
        const Lock found = lock(handle);
        const bool is_free = found == Lock::taken || (found == Lock::unknown && !is_alive(holder_in(file)));
        if (is_free && !is_same_file(handle, file)) { // given back in between
            ::CloseHandle(hold_handle(handle));
            continue;
        }
        if (is_free) {
            if (!write_ours(handle)) return failed(handle);
            hold.handle_ = handle;
            return hold;
        }
        ::CloseHandle(hold_handle(handle));
        if (other == Other::keeps) return hold;
        // Another file takes the place of theirs, which they see.
        const fs::path temporary = temporary_beside(file);
        const int ours = open_hold(temporary, CREATE_NEW);
        if (ours == -1) return failed(ours);
        lock(ours);
        if (!write_ours(ours) || !put_in_place(ours, file)) {
            const Error error = failed(ours);
            ::DeleteFileW(temporary.c_str());
            return error;
        }
        hold.handle_ = ours;
        return hold;
    }
    return hold;
}

Hold::~Hold() {
    if (handle_ == -1) return;
    if (is_same_file(handle_, file_)) remove_open(handle_);
    ::CloseHandle(hold_handle(handle_));
}

bool Hold::is_ours() const {
    std::error_code code;
    // Who clears .ghost takes nothing over.
    return handle_ != -1 && (is_same_file(handle_, file_) || !fs::exists(file_, code));
}

} // namespace ghost
