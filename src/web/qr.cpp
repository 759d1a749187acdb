// SPDX-License-Identifier: Apache-2.0
#include "web/qr.h"

#include <qrencode.h>

#include <memory>

namespace ghost::web {

std::string qr_text(const std::string& text) {
    constexpr int kQuiet = 2; // modules; the standard asks for 4, readers do with 2
    const std::unique_ptr<QRcode, void (*)(QRcode*)> code(
        QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_L), QRcode_free);
    if (!code) return "";
    const int side = code->width;
    const auto is_dark = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < side && y < side && (code->data[y * side + x] & 1) != 0;
    };
    std::string lines;
    // Terminals are dark, as a rule: what is light in the code is written.
    for (int y = -kQuiet; y < side + kQuiet; y += 2) {
        for (int x = -kQuiet; x < side + kQuiet; ++x) {
            const bool above = !is_dark(x, y), below = !is_dark(x, y + 1) && y + 1 < side + kQuiet;
            lines += above ? (below ? "\u2588" : "\u2580") : (below ? "\u2584" : " ");
        }
        lines += '\n';
    }
    return lines;
}

} // namespace ghost::web
