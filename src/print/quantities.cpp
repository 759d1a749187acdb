// SPDX-License-Identifier: Apache-2.0
#include "print/quantities.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostPieces = 12;
constexpr std::size_t kMostDigits = 9;

// "Spot 1" and "Spot 2"; "Spot 09" and "Spot 10".
bool counts_on(const std::string& before, const std::string& after) {
    const std::size_t digits = digits_at_end(before), more = digits_at_end(after);
    if (digits == 0 || more == 0) return false;
    const std::size_t at = before.size() - digits, from = after.size() - more;
    if (before.compare(0, at, after, 0, from) != 0) return false;
    if (digits != more && (before[at] == '0' || after[from] == '0')) return false;
    return std::strtol(before.c_str() + at, nullptr, 10) + 1 ==
           std::strtol(after.c_str() + from, nullptr, 10);
}

} // namespace

// Of the decimals that people wrote, not of the binary number nearest to them: 13.25 is 13.3, 4.325 is 4.33.
std::string number_text(float value, int decimals) {
    if (!std::isfinite(value)) return "?";
    char text[128];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
    if (error != std::errc()) return "?";
    std::string result(text, end);
    const std::size_t point = result.find('.');
    const std::size_t last = point + static_cast<std::size_t>(decimals); // that stays, or the point
    if (point != std::string::npos && last + 1 < result.size()) {
        bool is_up = result[last + 1] >= '5';
        result.resize(last + (decimals > 0 ? 1 : 0));
        for (std::size_t k = result.size(); is_up && k-- > 0;) {
            if (result[k] == '.') continue;
            if (result[k] == '-') break;
            is_up = result[k] == '9';
            result[k] = is_up ? '0' : static_cast<char>(result[k] + 1);
        }
        if (is_up) result.insert(result[0] == '-' ? 1 : 0, "1");
    }
    if (result.find('.') != std::string::npos) {
        result.erase(result.find_last_not_of('0') + 1);
        if (result.back() == '.') result.pop_back();
    }
    return result == "-0" ? "0" : result;
}

std::string with_whole_quantities(const std::string& text) {
    constexpr std::string_view kUnits[] = {"s",  "m",  "%",  "A",  "V",   "W",   "K",
                                           "kg", "lb", "Hz", "lx", "deg", "Grad"};
    constexpr std::string_view kSpace = "\xc2\xa0";
    std::string whole;
    for (std::size_t i = 0; i < text.size(); ++i) {
        bool is_within = false;
        if (text[i] == ' ' && i > 0 && std::isdigit(static_cast<unsigned char>(text[i - 1]))) {
            std::size_t end = i + 1;
            while (end < text.size() &&
                   (std::isalpha(static_cast<unsigned char>(text[end])) || text[end] == '%'))
                ++end;
            const std::string_view unit = std::string_view(text).substr(i + 1, end - i - 1);
            is_within = std::find(std::begin(kUnits), std::end(kUnits), unit) != std::end(kUnits);
        }
        is_within ? whole += kSpace : whole += text[i];
    }
    return whole;
}

std::size_t digits_at_end(const std::string& name) {
    std::size_t digits = 0;
    while (digits < std::min(name.size(), kMostDigits) &&
           std::isdigit(static_cast<unsigned char>(name[name.size() - 1 - digits])))
        ++digits;
    return digits;
}

namespace {

constexpr std::string_view kLeftToRight = "\xe2\x80\x8e"; // U+200E

// Letters from right to left: scripts from U+0590 to U+08FF, what stands for them in U+FB1D to U+FEFF, and
// those of the upper planes.
bool runs_right_to_left(std::string_view text) {
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[i + k]); };
        const bool is_longer = i + 2 < text.size();
        if (byte(0) >= 0xD6 && byte(0) <= 0xDF) return true;
        if (byte(0) == 0xE0 && byte(1) >= 0xA0 && byte(1) <= 0xA3) return true;
        if (byte(0) == 0xEF && byte(1) >= 0xAC && byte(1) <= 0xBB) return true;
        if (is_longer && byte(0) == 0xF0 && (byte(1) == 0x90 || byte(1) == 0x9E) && byte(2) >= 0xA0)
            return true;
    }
    return false;
}

struct SaidNames {
    std::string text;
    std::size_t left = 0; // not said
};

// marks: so that names from right to left do not turn round what stands beside them.
SaidNames say_names(const std::vector<std::string>& names, std::size_t most, bool marks) {
    std::string text;
    std::size_t pieces = 0, first = 0;
    for (; first < names.size() && pieces < most; ++pieces) {
        std::size_t last = first;
        while (last + 1 < names.size() && counts_on(names[last], names[last + 1])) ++last;
        text += (pieces > 0 ? ", " : "") + names[first];
        if (last > first) text += "-" + names[last].substr(names[last].size() - digits_at_end(names[last]));
        if (marks && runs_right_to_left(names[first])) text += kLeftToRight;
        first = last + 1;
    }
    return {text, names.size() - first};
}

} // namespace

std::string names_text(const std::vector<std::string>& names, const PrintStyle& style) {
    SaidNames said = say_names(names, kMostPieces, true);
    if (runs_right_to_left(said.text)) said.text.insert(0, kLeftToRight);
    return said.left > 0 ? style("%1 and %2 more", {said.text, std::to_string(said.left)}) : said.text;
}

std::string all_names_text(const std::vector<std::string>& names) {
    return say_names(names, names.size(), false).text;
}

std::string address_text(int universe, int channel) {
    return channel < 1 ? "not patched" : std::to_string(universe) + "." + std::to_string(channel);
}

} // namespace ghost::scene
