#pragma once
// SPDX-License-Identifier: Apache-2.0
// The one entrance for JSON that comes from outside: files, manifests, messages of the network. It is walked
// through before anything is built of it: size, depth and counts are known to be sane then, it is UTF-8, and
// no object has a key twice. Errors name file, place and limit. Any thread.

#include "base/result.h"

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace ghost {

inline constexpr std::size_t kJsonDepth = 32;

struct JsonLimits {
    std::size_t bytes = std::size_t{4} << 20;
    std::size_t values = 200'000;
    std::size_t members = 2048; // of one object: looking one up may be a walk
    std::size_t depth = kJsonDepth;
};

Result<void> check_json(std::string_view text, const std::string& where, const JsonLimits& limits);
Result<nlohmann::json> read_json(std::string_view text, const std::string& where,
                                 const JsonLimits& limits = {});
// Keeps the order of members.
Result<nlohmann::ordered_json> read_ordered_json(std::string_view text, const std::string& where,
                                                 const JsonLimits& limits = {});

} // namespace ghost
