// SPDX-License-Identifier: Apache-2.0
#include "disk/private/system_files.h"

#include <windows.h>

#include <shlobj.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

// Those who set what Linux has mean it here, too; relative paths mean nothing. Else the user's folder of this
// machine.
fs::path absolute_or_local(const wchar_t* variable) {
    const wchar_t* const value = ::_wgetenv(variable);
    const fs::path path = value != nullptr ? value : L"";
    if (path.is_absolute()) return path;
    wchar_t* known = nullptr;
    const HRESULT found = ::SHGetKnownFolderPath(FOLDERID_LocalAppData, 0, nullptr, &known);
    const fs::path local = SUCCEEDED(found) ? known : L"";
    ::CoTaskMemFree(known);
    return local;
}

} // namespace

fs::path cache_of_user() {
    return absolute_or_local(L"XDG_CACHE_HOME");
}

fs::path state_of_user() {
    return absolute_or_local(L"XDG_STATE_HOME");
}

// The file attribute "read-only" says nothing of a folder; who may do so stands in its list.
bool may_write_in(const fs::path& folder) {
    const HANDLE handle = ::CreateFileW(folder.c_str(), FILE_ADD_FILE | FILE_ADD_SUBDIRECTORY,
                                        FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                        OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (handle == INVALID_HANDLE_VALUE) return false;
    ::CloseHandle(handle);
    return true;
}

} // namespace ghost
