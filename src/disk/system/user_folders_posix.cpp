// SPDX-License-Identifier: Apache-2.0
#include "disk/private/system_files.h"

#include <cstdlib>
#include <unistd.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

// Below the user's folder. On macOS, where this was never compiled, those who set what Linux has mean it,
// too.
#if defined(__APPLE__)
constexpr const char* kCaches = "Library/Caches";
constexpr const char* kStates = "Library/Application Support";
#else
constexpr const char* kCaches = ".cache";
constexpr const char* kStates = ".local/state";
#endif

// Relative paths mean nothing there, says the XDG specification.
fs::path absolute_in(const char* variable) {
    const char* const value = std::getenv(variable);
    const fs::path path = value != nullptr ? value : "";
    return path.is_absolute() ? path : fs::path();
}

// Else this one of the user's folder; empty: neither is set.
fs::path absolute_or(const char* variable, const char* in_home) {
    const fs::path path = absolute_in(variable), home = absolute_in("HOME");
    return !path.empty() || home.empty() ? path : home / in_home;
}

} // namespace

fs::path cache_of_user() {
    return absolute_or("XDG_CACHE_HOME", kCaches);
}

fs::path state_of_user() {
    return absolute_or("XDG_STATE_HOME", kStates);
}

bool may_write_in(const fs::path& folder) {
    return ::access(folder.c_str(), W_OK | X_OK) == 0;
}

} // namespace ghost
