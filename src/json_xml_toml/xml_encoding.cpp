// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/xml_encoding.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ghost::fixture {
namespace {

constexpr std::uint32_t kUnknown = 0xfffd;
// 0x80 to 0x9f of Windows-1252; what is above is as in Unicode.
constexpr std::uint32_t kLetters[] = {0x20ac,   kUnknown, 0x201a, 0x0192, 0x201e, 0x2026,   0x2020, 0x2021,
                                      0x02c6,   0x2030,   0x0160, 0x2039, 0x0152, kUnknown, 0x017d, kUnknown,
                                      kUnknown, 0x2018,   0x2019, 0x201c, 0x201d, 0x2022,   0x2013, 0x2014,
                                      0x02dc,   0x2122,   0x0161, 0x203a, 0x0153, kUnknown, 0x017e, 0x0178};

// Bytes of the UTF-8 letter that begins here, 0 where none does (RFC 3629, table 3-7 of Unicode).
std::size_t length_of_letter(const std::vector<std::uint8_t>& text, std::size_t at) {
    const std::uint8_t first = text[at];
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xc2 && first <= 0xdf   ? 2
                               : first >= 0xe0 && first <= 0xef ? 3
                               : first >= 0xf0 && first <= 0xf4 ? 4
                                                                : 0;
    if (length == 0 || length > text.size() - at) return 0;
    for (std::size_t k = 1; k < length; ++k)
        if ((text[at + k] & 0xc0) != 0x80) return 0;
    const std::uint8_t second = text[at + 1];
    const bool too_long = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool no_letter = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
    return too_long || no_letter ? 0 : length;
}

bool is_wide(const std::vector<std::uint8_t>& text) {
    if (text.size() < 2) return false;
    const auto begin = text.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min<std::size_t>(4, text.size()));
    return (text[0] == 0xfe && text[1] == 0xff) || (text[0] == 0xff && text[1] == 0xfe) ||
           std::find(begin, end, 0) != end;
}

} // namespace

bool repair_utf8(std::vector<std::uint8_t>& xml) {
    if (is_wide(xml)) return false;
    std::size_t at = 0;
    while (at < xml.size()) {
        const std::size_t length = length_of_letter(xml, at);
        if (length == 0) break;
        at += length;
    }
    if (at == xml.size()) return false;
    std::vector<std::uint8_t> text(xml.begin(), xml.begin() + static_cast<std::ptrdiff_t>(at));
    while (at < xml.size()) {
        if (const std::size_t length = length_of_letter(xml, at); length > 0) {
            const auto letter = xml.begin() + static_cast<std::ptrdiff_t>(at);
            text.insert(text.end(), letter, letter + static_cast<std::ptrdiff_t>(length));
            at += length;
            continue;
        }
        const std::uint32_t code = xml[at] < 0xa0 ? kLetters[xml[at] - 0x80] : xml[at];
        ++at;
        if (code >= 0x800) text.push_back(static_cast<std::uint8_t>(0xe0 | (code >> 12)));
        text.push_back(
            static_cast<std::uint8_t>(code >= 0x800 ? 0x80 | ((code >> 6) & 0x3f) : 0xc0 | (code >> 6)));
        text.push_back(static_cast<std::uint8_t>(0x80 | (code & 0x3f)));
    }
    xml = std::move(text);
    return true;
}

} // namespace ghost::fixture
