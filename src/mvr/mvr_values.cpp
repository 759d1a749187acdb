// SPDX-License-Identifier: Apache-2.0
#include "mvr/private/mvr_values.h"

#include "base/text.h"
#include "fixture/values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace ghost::scene {
namespace {

constexpr double kMetresPerUnit = 0.001;

std::optional<glm::dvec3> parse_three(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) return std::nullopt;
    glm::dvec3 result;
    for (int i = 0; i < 3; ++i) {
        const auto number = parse_mvr_number(parts[static_cast<std::size_t>(i)]);
        if (!number) return std::nullopt;
        result[i] = *number;
    }
    return result;
}

std::string number_text(double number) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number + 0.0).ptr;
    return {buffer.data(), end};
}

} // namespace

std::optional<double> parse_mvr_number(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (end != text.data() + text.size() || text.empty()) return std::nullopt;
    if (error == std::errc::result_out_of_range)
        return text.find("e-") != text.npos || text.find("E-") != text.npos ? std::optional<double>(0)
                                                                            : std::nullopt;
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    return number;
}

std::optional<glm::dvec3> parse_mvr_vector(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('{') && text.ends_with('}')) text = text.substr(1, text.size() - 2);
    return parse_three(text);
}

std::optional<glm::dmat4> parse_mvr_matrix(std::string_view text) {
    glm::dmat4 matrix(1.0);
    for (int row = 0; row < 4; ++row) {
        text = trimmed(text);
        const std::size_t close = text.find('}');
        if (!text.starts_with('{') || close == text.npos) return std::nullopt;
        const auto numbers = parse_three(text.substr(1, close - 1));
        if (!numbers) return std::nullopt;
        const double limit = row < 3 ? kMaxMvrScale : kMaxMvrDistance_m / kMetresPerUnit;
        for (int i = 0; i < 3; ++i)
            if (std::abs((*numbers)[i]) > limit) return std::nullopt;
        matrix[row] = row < 3 ? glm::dvec4(*numbers, 0.0) : glm::dvec4(*numbers * kMetresPerUnit, 1.0);
        text.remove_prefix(close + 1);
    }
    if (!trimmed(text).empty()) return std::nullopt;
    return matrix;
}

std::string mvr_matrix_text(const glm::dmat4& matrix) {
    std::string text;
    for (int row = 0; row < 4; ++row) {
        text += "{";
        for (int i = 0; i < 3; ++i) {
            // Millimetres to nine digits after the point: 5.2 m is 5200, not 5200.000000000001.
            const double number =
                row < 3 ? matrix[row][i] : std::round(matrix[row][i] / kMetresPerUnit * 1e9) / 1e9;
            text += (i ? "," : "") + number_text(number);
        }
        text += "}";
    }
    return text;
}

std::optional<fixture::Address> parse_mvr_address(std::string_view text) {
    text = trimmed(text);
    const std::size_t dot = text.find('.');
    if (dot == text.npos) {
        const auto number = fixture::parse_int(text);
        if (!number || *number < -1 || *number > kMaxUniverse * 512) return std::nullopt;
        if (*number <= 0) return fixture::Address{};
        return fixture::Address{(*number - 1) / 512 + 1, (*number - 1) % 512 + 1};
    }
    const auto universe = fixture::parse_int(text.substr(0, dot));
    const auto channel = fixture::parse_int(text.substr(dot + 1));
    if (!universe || !channel || *universe < 0 || *universe > kMaxUniverse || *channel < 0 || *channel > 512)
        return std::nullopt;
    if (*universe == 0 || *channel == 0) return fixture::Address{};
    return fixture::Address{*universe, *channel};
}

PlotCommand parse_mvr_command(std::string text) {
    PlotCommand command;
    const std::size_t comma = text.rfind(',');
    if (comma != text.npos) {
        const std::string_view rest = trimmed(std::string_view(text).substr(comma + 1));
        const std::size_t blank = rest.find(' ');
        if (blank != rest.npos) {
            command.value = parse_mvr_number(rest.substr(blank + 1));
            if (command.value) {
                command.unit = rest.substr(0, blank);
                command.function = trimmed(std::string_view(text).substr(0, comma));
            }
        }
    }
    command.text = std::move(text);
    return command;
}

std::optional<PictureScale> parse_picture_scale(std::string_view text) {
    text = trimmed(text);
    if (text.empty() || text == "ScaleKeepRatio") return PictureScale::keep_ratio;
    if (text == "ScaleIgnoreRatio") return PictureScale::ignore_ratio;
    if (text == "KeepSizeCenter") return PictureScale::keep_size_centred;
    return std::nullopt;
}

bool is_usable(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(matrix[column][row]) <= kMaxMvrDistance_m)) return false;
    return true;
}

} // namespace ghost::scene
