// SPDX-License-Identifier: Apache-2.0
#include "disk/links.h"

#include <string>
#include <vector>

#include <windows.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

constexpr DWORD kEveryShare = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

// Of what is there.
fs::path final_path(const fs::path& path) {
    const HANDLE handle = ::CreateFileW(path.c_str(), 0, kEveryShare, nullptr, OPEN_EXISTING,
                                        FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (handle == INVALID_HANDLE_VALUE) return {};
    std::wstring name(32768, L'\0');
    name.resize(::GetFinalPathNameByHandleW(handle, name.data(), 32768, FILE_NAME_NORMALIZED));
    ::CloseHandle(handle);
    // As people write them: \\?\C:\show is C:\show, \\?\UNC\server\show is \\server\show.
    if (name.starts_with(L"\\\\?\\UNC\\")) return L"\\" + name.substr(7);
    return name.starts_with(L"\\\\?\\") ? name.substr(4) : name;
}

} // namespace

bool is_link(const fs::path& path) {
    const DWORD what = ::GetFileAttributesW(path.c_str());
    return what != INVALID_FILE_ATTRIBUTES && (what & FILE_ATTRIBUTE_REPARSE_POINT) != 0;
}

fs::path behind_links(const fs::path& path, std::error_code& code) {
    code.clear();
    fs::path found = final_path(path);
    if (found.empty()) {
        const fs::path folder = final_path(path.has_parent_path() ? path.parent_path() : ".");
        if (!folder.empty() && !is_link(path)) found = folder / path.filename();
    }
    if (found.empty()) code = std::make_error_code(std::errc::no_such_file_or_directory);
    return found;
}

void remove_whole(const fs::path& folder) {
    std::error_code code;
    std::vector<fs::path> entries;
    if (!is_link(folder))
        for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
            entries.push_back(entry->path());
    for (const fs::path& entry : entries) {
        const DWORD what = ::GetFileAttributesW(entry.c_str());
        if (what == INVALID_FILE_ATTRIBUTES) continue;
        if ((what & FILE_ATTRIBUTE_READONLY) != 0)
            ::SetFileAttributesW(entry.c_str(), what & ~DWORD{FILE_ATTRIBUTE_READONLY});
        if ((what & FILE_ATTRIBUTE_DIRECTORY) == 0)
            ::DeleteFileW(entry.c_str());
        else
            remove_whole(entry);
    }
    ::RemoveDirectoryW(folder.c_str());
}

} // namespace ghost
