#pragma once
// SPDX-License-Identifier: Apache-2.0
// An address as a QR code (ISO/IEC 18004): its modules, or as letters for a terminal. Pure.

#include <optional>
#include <string>
#include <vector>

namespace ghost::web {

struct QrCode {
    int side = 0; // modules, without the quiet zone
    std::vector<bool> dark;

    bool is_dark(int x, int y) const {
        return x >= 0 && y >= 0 && x < side && y < side && dark[static_cast<std::size_t>(y * side + x)];
    }
};
// Nothing where the text is too long for one.
std::optional<QrCode> qr_code(const std::string& text);

// Lines of half blocks, light on dark with a quiet zone; "" where there is no code.
std::string qr_text(const std::string& text);

} // namespace ghost::web
