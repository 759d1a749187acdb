// SPDX-License-Identifier: Apache-2.0
#include "disk/user_cache.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>

namespace ghost {
namespace fs = std::filesystem;
namespace {

std::string hash_of(const std::string& text) { // FNV-1a
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3u;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    return digits;
}

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

fs::path user_cache_for(const fs::path& folder) {
    std::error_code code;
    const fs::path place = folder.empty() ? fs::path(".") : folder;
    if (!fs::is_directory(place, code) || fs::exists(fs::symlink_status(place / ".ghost", code)) ||
        ::access(place.c_str(), W_OK | X_OK) == 0)
        return {};
    const fs::path cache = absolute_or("XDG_CACHE_HOME", ".cache");
    if (cache.empty()) return {};
    fs::create_directories(cache, code);
    const fs::path whole = fs::canonical(place, code);
    if (code || ::access(cache.c_str(), W_OK | X_OK) != 0) return {};
    return cache / "ghostlight" / hash_of(whole.string());
}

fs::path user_state() {
    const fs::path state = absolute_or("XDG_STATE_HOME", ".local/state");
    return state.empty() ? state : state / "ghostlight";
}

} // namespace ghost
