#pragma once
// SPDX-License-Identifier: Apache-2.0
// Base64 as files embed it (RFC 4648, sections 4 and 5: both alphabets, padding or none). Pure, any thread.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace ghost {

// Nothing where a character is not of base64.
std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);

} // namespace ghost
