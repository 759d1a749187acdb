#pragma once
// SPDX-License-Identifier: Apache-2.0
// A count, an offset or an index in a glTF's JSON, of which nothing is certain. Pure.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>

namespace ghost::scene {

// Nothing where the object has no such key, or something else there.
inline std::optional<std::size_t> unsigned_at(const nlohmann::json& object, const char* key) {
    if (!object.is_object() || !object.contains(key) || !object[key].is_number_unsigned())
        return std::nullopt;
    return object[key].get<std::size_t>();
}

} // namespace ghost::scene
