#pragma once
// SPDX-License-Identifier: Apache-2.0
// An address as a QR code (ISO/IEC 18004) of letters, for a terminal. Pure.

#include <string>

namespace ghost::web {

// Lines of half blocks, light on dark with a quiet zone; "" where the text is too long for one.
std::string qr_text(const std::string& text);

} // namespace ghost::web
