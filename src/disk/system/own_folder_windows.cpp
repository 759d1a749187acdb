// SPDX-License-Identifier: Apache-2.0
// Each step is opened from the handle of the one above it, which only the kernel's own call can (NtCreateFile
// with a RootDirectory); links, junctions and all other reparse points are opened as themselves, seen and
// refused. An open folder can be neither renamed nor replaced by a link, for no handle here shares that.
#include "disk/own_folder.h"

#include "base/windows_text.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <windows.h>
#include <winternl.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

constexpr ULONG kListing = FILE_LIST_DIRECTORY | FILE_TRAVERSE | FILE_READ_ATTRIBUTES | SYNCHRONIZE;
constexpr ULONG kShared = FILE_SHARE_READ | FILE_SHARE_WRITE;
constexpr NTSTATUS kNoName = static_cast<NTSTATUS>(0xC0000033); // STATUS_OBJECT_NAME_INVALID
// Of the kernel's headers, for CreateDisposition and CreateOptions.
constexpr ULONG kOpen = 1, kOpenOrMake = 3;
constexpr ULONG kFolder = 0x1, kNoFolder = 0x40, kWaits = 0x20, kLinkItself = 0x00200000;
constexpr std::size_t kListBytes = std::size_t{64} << 10;

// Handles of the system have 32 bits that count (base/private/start_windows.h).
HANDLE as_handle(int number) {
    return reinterpret_cast<HANDLE>(static_cast<INT_PTR>(number));
}
int as_number(HANDLE handle) {
    return handle == INVALID_HANDLE_VALUE || handle == nullptr
               ? -1
               : static_cast<int>(reinterpret_cast<INT_PTR>(handle));
}

struct Opened {
    HANDLE handle = nullptr;
    NTSTATUS status = 0;
    Opened() = default;
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
    ~Opened() {
        if (handle != nullptr) ::CloseHandle(handle);
    }
};

// One name of this folder, and no way through it.
void open_in(Opened& opened, int folder, const std::string& name, ULONG access, ULONG shared,
             ULONG disposition, ULONG options) {
    std::wstring wide = wide_text(name);
    if (wide.empty() || wide == L"." || wide == L".." || wide.find_first_of(L"\\/:") != std::wstring::npos ||
        wide.size() > 255) {
        opened.status = kNoName;
        return;
    }
    UNICODE_STRING text{};
    text.Buffer = wide.data();
    text.Length = text.MaximumLength = static_cast<USHORT>(wide.size() * sizeof(wchar_t));
    OBJECT_ATTRIBUTES attributes{};
    InitializeObjectAttributes(&attributes, &text, OBJ_CASE_INSENSITIVE, as_handle(folder), nullptr);
    IO_STATUS_BLOCK block{};
    opened.status =
        ::NtCreateFile(&opened.handle, access, &attributes, &block, nullptr, FILE_ATTRIBUTE_NORMAL, shared,
                       disposition, options | kWaits | kLinkItself, nullptr, 0);
    if (opened.status < 0) opened.handle = nullptr;
}

std::string reason_of(NTSTATUS status) {
    return windows_reason(::RtlNtStatusToDosError(status));
}

bool is_reparse_point(HANDLE handle) {
    FILE_ATTRIBUTE_TAG_INFO info{};
    return ::GetFileInformationByHandleEx(handle, FileAttributeTagInfo, &info, sizeof info) &&
           (info.FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
}

std::chrono::system_clock::time_point time_of(const LARGE_INTEGER& since_1601) {
    using Ticks = std::chrono::duration<LONGLONG, std::ratio<1, 10'000'000>>;
    constexpr Ticks k1970(116444736000000000LL);
    return std::chrono::system_clock::time_point(
        std::chrono::duration_cast<std::chrono::system_clock::duration>(Ticks(since_1601.QuadPart) - k1970));
}

bool remove_in(int folder, const std::string& name, ULONG kind) {
    Opened entry;
    open_in(entry, folder, name, DELETE | SYNCHRONIZE | FILE_READ_ATTRIBUTES, kShared | FILE_SHARE_DELETE,
            kOpen, kind);
    if (entry.handle == nullptr) return false;
    // At once, as POSIX has it, and also where it is read-only; where the file system does not know that, by
    // the old way.
    struct {
        ULONG flags = 0x1 | 0x2 | 0x10; // delete, POSIX semantics, also what is read-only
    } now;
    constexpr auto kDeleteNow = static_cast<FILE_INFO_BY_HANDLE_CLASS>(21); // FileDispositionInfoEx
    if (::SetFileInformationByHandle(entry.handle, kDeleteNow, &now, sizeof now)) return true;
    FILE_DISPOSITION_INFO later{};
    later.DeleteFile = TRUE;
    return ::SetFileInformationByHandle(entry.handle, FileDispositionInfo, &later, sizeof later) != 0;
}

} // namespace

OwnFolder::OwnFolder(OwnFolder&& other) noexcept
    : handle_(std::exchange(other.handle_, -1)), path_(std::move(other.path_)) {}

OwnFolder& OwnFolder::operator=(OwnFolder&& other) noexcept {
    std::swap(handle_, other.handle_);
    std::swap(path_, other.path_);
    return *this;
}

OwnFolder::~OwnFolder() {
    if (handle_ != -1) ::CloseHandle(as_handle(handle_));
}

Result<OwnFolder> OwnFolder::open(const fs::path& folder, const fs::path& home, Missing missing) {
    const fs::path start = home.empty() ? fs::path(".") : home;
    OwnFolder at(as_number(::CreateFileW(start.c_str(), kListing, kShared, nullptr, OPEN_EXISTING,
                                         FILE_FLAG_BACKUP_SEMANTICS, nullptr)),
                 home);
    if (at.handle_ == -1 || !fs::is_directory(start)) return Error{"this folder is gone", home.string()};
    for (const fs::path& step : folder.lexically_relative(home)) {
        if (step.empty() || step == ".") continue;
        if (step == "..") return Error{"lies outside of the folder " + start.string(), folder.string()};
        if (missing == Missing::is_made) {
            Opened made;
            open_in(made, at.handle_, step.string(), FILE_READ_ATTRIBUTES | SYNCHRONIZE, kShared, kOpenOrMake,
                    kFolder);
            constexpr auto kNoDirectory = static_cast<NTSTATUS>(0xC0000103); // which below() says
            if (made.status < 0 && made.status != kNoDirectory)
                return Error{"cannot make the folder: " + reason_of(made.status), (at.path_ / step).string()};
        }
        TRY(at, at.below(step.string()));
    }
    return at;
}

Result<OwnFolder> OwnFolder::below(const std::string& name) const {
    const fs::path path = path_ / name;
    Opened opened;
    open_in(opened, handle_, name, kListing, kShared, kOpen, 0);
    if (opened.handle == nullptr)
        return Error{"cannot be opened: " + reason_of(opened.status), path.string()};
    if (is_reparse_point(opened.handle))
        return Error{"is a link, expected a folder of this show: nothing is written or removed there",
                     path.string()};
    BY_HANDLE_FILE_INFORMATION info{};
    if (!::GetFileInformationByHandle(opened.handle, &info) ||
        (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0)
        return Error{"cannot be opened: " + windows_reason(ERROR_DIRECTORY), path.string()};
    return OwnFolder(as_number(std::exchange(opened.handle, nullptr)), path);
}

OwnFolder::Entries OwnFolder::entries() const {
    Entries result;
    std::vector<std::max_align_t> buffer(kListBytes / sizeof(std::max_align_t));
    for (auto kind = FileIdBothDirectoryRestartInfo; ::GetFileInformationByHandleEx(
             as_handle(handle_), kind, buffer.data(), static_cast<DWORD>(kListBytes));
         kind = FileIdBothDirectoryInfo) {
        const auto* at = reinterpret_cast<const unsigned char*>(buffer.data());
        for (;;) {
            const auto& entry = *reinterpret_cast<const FILE_ID_BOTH_DIR_INFO*>(at);
            const std::wstring_view wide(entry.FileName, entry.FileNameLength / sizeof(wchar_t));
            const DWORD what = entry.FileAttributes;
            if (wide != L"." && wide != L".." && (what & FILE_ATTRIBUTE_REPARSE_POINT) == 0) {
                if (what & FILE_ATTRIBUTE_DIRECTORY)
                    result.folders.push_back(utf8_text(wide));
                else
                    result.files.push_back({utf8_text(wide), time_of(entry.LastWriteTime)});
            }
            if (entry.NextEntryOffset == 0) break;
            at += entry.NextEntryOffset;
        }
    }
    std::ranges::sort(result.files, {}, &File::name);
    std::ranges::sort(result.folders);
    return result;
}

bool OwnFolder::remove_file(const std::string& name) const {
    return remove_in(handle_, name, kNoFolder);
}

bool OwnFolder::remove_empty_folder(const std::string& name) const {
    return remove_in(handle_, name, kFolder);
}

} // namespace ghost
