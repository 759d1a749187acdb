// SPDX-License-Identifier: Apache-2.0
#include "base/windows_text.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <cwchar>

#include <windows.h>

namespace ghost {
namespace {

struct Taken {
    std::size_t bytes = 0; // 0: it is no UTF-8
    bool whole = false;
    std::uint32_t bits = 0;
};

// What is there of the UTF-8 character that begins here.
Taken take(const unsigned char* text, std::size_t most) {
    const unsigned first = text[0];
    const std::size_t size = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
    if (size == 0) return {};
    Taken taken{1, size == 1, size == 1 ? first : first & (0x7Fu >> size)};
    for (; taken.bytes < size && taken.bytes < most; ++taken.bytes) {
        const unsigned next = text[taken.bytes];
        const bool is_long =
            taken.bytes == 1 && ((first == 0xE0 && next < 0xA0) || (first == 0xF0 && next < 0x90));
        const bool is_none =
            taken.bytes == 1 && ((first == 0xED && next >= 0xA0) || (first == 0xF4 && next >= 0x90));
        if ((next & 0xC0) != 0x80 || is_long || is_none) return {};
        taken.bits = taken.bits << 6 | (next & 0x3F);
    }
    taken.whole = taken.bytes == size;
    return taken;
}

// What is left of a character; the state is a number in one C library of Windows, and a struct in the other.
int kept_in(const std::mbstate_t& state) {
    int value = 0;
    std::memcpy(&value, &state, sizeof value);
    return value;
}
void keep(std::mbstate_t& state, int value) {
    std::memcpy(&state, &value, sizeof value);
}

} // namespace

std::wstring wide_text(std::string_view utf8) {
    if (utf8.empty()) return {};
    const int size = static_cast<int>(utf8.size());
    const int letters = ::MultiByteToWideChar(CP_UTF8, 0, utf8.data(), size, nullptr, 0);
    std::wstring wide(static_cast<std::size_t>(letters), L'\0');
    ::MultiByteToWideChar(CP_UTF8, 0, utf8.data(), size, wide.data(), letters);
    return wide;
}

std::string utf8_text(std::wstring_view wide) {
    if (wide.empty()) return {};
    const int letters = static_cast<int>(wide.size());
    const int size = ::WideCharToMultiByte(CP_UTF8, 0, wide.data(), letters, nullptr, 0, nullptr, nullptr);
    std::string utf8(static_cast<std::size_t>(size), '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, wide.data(), letters, utf8.data(), size, nullptr, nullptr);
    return utf8;
}

std::string windows_reason(unsigned long code) {
    wchar_t text[512];
    const DWORD letters = ::FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS |
                                               FORMAT_MESSAGE_MAX_WIDTH_MASK,
                                           nullptr, code, 0, text, 512, nullptr);
    std::string reason = utf8_text({text, letters});
    while (!reason.empty() && (reason.back() == ' ' || reason.back() == '.')) reason.pop_back();
    return reason.empty() ? "error " + std::to_string(code) : reason;
}

} // namespace ghost

// std::filesystem::path of libstdc++ reads a std::string by this function of the C library, and gives one as
// UTF-8. The library's own reads the code page of the user's country, in which "Bühne" is another name; so it
// is replaced, in all of the program, by one that reads UTF-8. A character above U+FFFF is two letters of
// Windows: the first one comes of three bytes, the second one of the fourth, with what is left in the state.
extern "C" std::size_t mbrtowc(wchar_t* wide, const char* text, std::size_t most, std::mbstate_t* state) {
    static thread_local std::mbstate_t own{};
    std::mbstate_t& kept = state != nullptr ? *state : own;
    if (text == nullptr) {
        ghost::keep(kept, 0);
        return 0;
    }
    if (most == 0) return static_cast<std::size_t>(-2);
    const auto* const bytes = reinterpret_cast<const unsigned char*>(text);
    constexpr int kSecond = 0xDC00; // and what three bytes said of it
    wchar_t letter = 0;
    std::size_t taken = 1;
    if (const int second = ghost::kept_in(kept); second != 0) {
        if ((bytes[0] & 0xC0) != 0x80) {
            errno = EILSEQ;
            return static_cast<std::size_t>(-1);
        }
        letter = static_cast<wchar_t>(second | (bytes[0] & 0x3F));
        ghost::keep(kept, 0);
    } else {
        const ghost::Taken character = ghost::take(bytes, most);
        const bool is_pair = character.bytes >= 3 && bytes[0] >= 0xF0;
        if (character.bytes == 0) {
            errno = EILSEQ;
            return static_cast<std::size_t>(-1);
        }
        if (!character.whole && !is_pair) return static_cast<std::size_t>(-2);
        taken = is_pair ? 3 : character.bytes;
        if (is_pair) {
            const std::uint32_t upper =
                (character.whole ? character.bits >> 6 : character.bits) - (0x10000 >> 6);
            letter = static_cast<wchar_t>(0xD800 | upper >> 4);
            ghost::keep(kept, kSecond | static_cast<int>((upper & 0xF) << 6));
        } else {
            letter = static_cast<wchar_t>(character.bits);
        }
    }
    if (wide != nullptr) *wide = letter;
    return letter == 0 ? 0 : taken;
}

// Its neighbours in the library's own file, without which the linker would take both.
extern "C" std::size_t mbrlen(const char* text, std::size_t most, std::mbstate_t* state) {
    static thread_local std::mbstate_t own{};
    return mbrtowc(nullptr, text, most, state != nullptr ? state : &own);
}

extern "C" std::size_t mbsrtowcs(wchar_t* wide, const char** text, std::size_t most, std::mbstate_t* state) {
    static thread_local std::mbstate_t own{};
    std::mbstate_t& kept = state != nullptr ? *state : own;
    const char* at = *text;
    for (std::size_t letters = 0; wide == nullptr || letters < most; ++letters) {
        wchar_t letter = 0;
        const std::size_t taken = mbrtowc(&letter, at, 4, &kept);
        if (taken == static_cast<std::size_t>(-1) || taken == static_cast<std::size_t>(-2)) {
            errno = EILSEQ;
            return static_cast<std::size_t>(-1);
        }
        if (wide != nullptr) wide[letters] = letter;
        if (letter == 0) {
            if (wide != nullptr) *text = nullptr;
            return letters;
        }
        at += taken;
    }
    *text = at;
    return most;
}
