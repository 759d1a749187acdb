// SPDX-License-Identifier: Apache-2.0
#include "base/print.h"

#include <cstdarg>
#include <cstdint>
#include <cstdio>

namespace ghost {
namespace {

constexpr char kUnknown[] = "\xef\xbf\xbd"; // U+FFFD

// Bytes of the UTF-8 character that begins here, and which it is; 0: none does.
std::size_t character_at(std::string_view text, std::uint32_t& character) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned first = byte(0);
    const std::size_t size = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (size == 0 || size > text.size() || first > 0xF4) return 0;
    character = size == 1 ? first : first & (0x7Fu >> size);
    for (std::size_t k = 1; k < size; ++k) {
        if ((byte(k) & 0xC0) != 0x80) return 0;
        character = character << 6 | (byte(k) & 0x3Fu);
    }
    const bool is_long = (size == 3 && character < 0x800) || (size == 4 && character < 0x10000);
    const bool is_half = character >= 0xD800 && character < 0xE000;
    return is_long || is_half || character > 0x10FFFF ? 0 : size;
}

// Turns the order of all letters behind it: U+202A to U+202E, U+2066 to U+2069.
bool turns_order(std::uint32_t character) {
    return (character >= 0x202A && character <= 0x202E) || (character >= 0x2066 && character <= 0x2069);
}

std::string shown(std::string_view text, bool keeps_lines) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        std::uint32_t character = 0;
        const std::size_t size = character_at(text, character);
        const bool is_line = keeps_lines && (character == '\n' || character == '\t');
        const bool is_control = (character < 0x20 && !is_line) || (character >= 0x7F && character < 0xA0) ||
                                turns_order(character);
        if (size == 0) {
            result += kUnknown;
        } else if (is_control) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(character));
            result += escape;
        } else {
            result += text.substr(0, size);
        }
        text.remove_prefix(size == 0 ? 1 : size);
    }
    return result;
}

} // namespace

std::string printable(std::string_view text) {
    return shown(text, true);
}

std::string one_line(std::string_view text) {
    return shown(text, false);
}

void print_text(const char* format, ...) {
    std::va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int size = std::vsnprintf(nullptr, 0, format, arguments);
    va_end(arguments);
    if (size > 0) {
        std::string text(static_cast<std::size_t>(size) + 1, '\0');
        std::vsnprintf(text.data(), text.size(), format, again);
        text.pop_back();
        const std::string whole = printable(text);
        std::fwrite(whole.data(), 1, whole.size(), stdout);
    }
    va_end(again);
}

} // namespace ghost
