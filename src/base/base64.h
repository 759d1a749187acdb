#pragma once
// SPDX-License-Identifier: Apache-2.0
// Base64 as files embed it (RFC 4648, sections 4 and 5: both alphabets, padding or none). Pure, any thread.

#include "base/byte_reader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ghost {

// Nothing where a character is not of base64.
std::optional<std::vector<std::uint8_t>> from_base64(std::string_view text);
// Of section 4, padded.
std::string to_base64(Bytes bytes);

} // namespace ghost
