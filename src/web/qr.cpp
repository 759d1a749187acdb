// SPDX-License-Identifier: Apache-2.0
#include "web/qr.h"

#include <qrencode.h>

#include <memory>

namespace ghost::web {

std::optional<QrCode> qr_code(const std::string& text) {
    const std::unique_ptr<QRcode, void (*)(QRcode*)> code(
        QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_L), QRcode_free);
    if (!code) return std::nullopt;
    QrCode modules{code->width, {}};
    for (int i = 0; i < code->width * code->width; ++i) modules.dark.push_back((code->data[i] & 1) != 0);
    return modules;
}

std::string qr_text(const std::string& text) {
    constexpr int kQuiet = 2; // modules; the standard asks for 4, readers do with 2
    const std::optional<QrCode> code = qr_code(text);
    if (!code) return "";
    const int side = code->side;
    std::string lines;
    // Terminals are dark, as a rule: what is light in the code is written.
    for (int y = -kQuiet; y < side + kQuiet; y += 2) {
        for (int x = -kQuiet; x < side + kQuiet; ++x) {
            const bool above = !code->is_dark(x, y),
                       below = !code->is_dark(x, y + 1) && y + 1 < side + kQuiet;
            lines += above ? (below ? "\u2588" : "\u2580") : (below ? "\u2584" : " ");
        }
        lines += '\n';
    }
    return lines;
}

} // namespace ghost::web
