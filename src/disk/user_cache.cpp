// SPDX-License-Identifier: Apache-2.0
#include "disk/user_cache.h"

#include "disk/private/system_files.h"

#include <cstdint>
#include <cstdio>
#include <string>

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

} // namespace

fs::path user_cache_for(const fs::path& folder) {
    std::error_code code;
    const fs::path place = folder.empty() ? fs::path(".") : folder;
    if (!fs::is_directory(place, code) || fs::exists(fs::symlink_status(place / ".ghost", code)) ||
        may_write_in(place))
        return {};
    const fs::path cache = cache_of_user();
    if (cache.empty()) return {};
    fs::create_directories(cache, code);
    const fs::path whole = fs::canonical(place, code);
    if (code || !may_write_in(cache)) return {};
    return cache / "ghostlight" / hash_of(whole.string());
}

fs::path user_cache() {
    const fs::path cache = cache_of_user();
    return cache.empty() ? cache : cache / "ghostlight";
}

fs::path user_state() {
    const fs::path state = state_of_user();
    return state.empty() ? state : state / "ghostlight";
}

} // namespace ghost
