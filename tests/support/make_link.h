#pragma once
// SPDX-License-Identifier: Apache-2.0
// A symbolic link for a test. False: this user may make none here (Windows without its developer mode, Wine).
#include <filesystem>
#if defined(_WIN32)
#include <windows.h>
#endif

namespace ghost {

inline constexpr const char* kNoLinks = "this user may make no links here";

inline bool make_link(const std::filesystem::path& target, const std::filesystem::path& link) {
#if defined(_WIN32)
    const DWORD kind = std::filesystem::is_directory(link.parent_path() / target) ? 1 : 0;
    const DWORD as_developer = 2;
    return ::CreateSymbolicLinkW(link.c_str(), target.c_str(), kind | as_developer) &&
           (::GetFileAttributesW(link.c_str()) != INVALID_FILE_ATTRIBUTES);
#else
    std::filesystem::create_symlink(target, link);
    return true;
#endif
}

} // namespace ghost
