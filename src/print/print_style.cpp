// SPDX-License-Identifier: Apache-2.0
#include "print/print_style.h"

#include "print/quantities.h"

#include <cmath>
#include <cstdlib>

namespace ghost::scene {
namespace {

constexpr double kInch_m = 0.0254, kPound_kg = 0.45359237;
constexpr double kFarthest_m = 1e9; // beyond it quarters of an inch have no meaning

std::string feet_and_inches(double metres) {
    const long quarters = std::lround(std::abs(metres) / kInch_m * 4);
    const long feet = quarters / 48, inches = quarters % 48 / 4, rest = quarters % 4;
    constexpr const char* kQuarters[] = {"", " 1/4", " 1/2", " 3/4"};
    return std::string(metres < 0 && quarters > 0 ? "-" : "") + std::to_string(feet) + "'-" +
           std::to_string(inches) + kQuarters[rest] + "\"";
}

} // namespace

std::string PrintStyle::operator()(Word word, std::initializer_list<std::string> values) const {
    const std::string_view words = word.in(language);
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t index =
            words[i] == '%' && i + 1 < words.size() ? static_cast<std::size_t>(words[i + 1] - '1') : 9;
        if (index < values.size()) {
            text += *(values.begin() + index);
            ++i;
        } else {
            text += words[i];
        }
    }
    return text;
}

std::string PrintStyle::number(double value, int decimals) const {
    std::string text = number_text(static_cast<float>(value), decimals);
    if (language == Language::german)
        if (const std::size_t point = text.find('.'); point != std::string::npos) text[point] = ',';
    return text;
}

std::string PrintStyle::length(double metres, int decimals) const {
    if (units == Units::metric || !(std::abs(metres) < kFarthest_m)) return number(metres, decimals);
    return feet_and_inches(metres);
}

std::string PrintStyle::length_said(double metres, int decimals) const {
    return length(metres, decimals) + (units == Units::metric ? " m" : "");
}

std::string PrintStyle::weight(double kilograms) const {
    return number(units == Units::metric ? kilograms : kilograms / kPound_kg, 1);
}

} // namespace ghost::scene
