#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sizes of paper (ISO 216, ANSI and ARCH), by their names. Points of 1/72 inch, upright. Pure, any thread.

#include <array>
#include <string>
#include <string_view>

namespace ghost::scene {

enum class PaperSize { a4, a3, a2, a1, letter, tabloid, arch_d };

struct PaperFormat {
    PaperSize size;
    std::string_view name; // as an option and CSS (where it is a4, a3 or letter) call it
    double width_pt, height_pt;
};

inline constexpr double kPointsOfMm = 72.0 / 25.4;

inline constexpr std::array kPaperFormats{
    PaperFormat{PaperSize::a4, "A4", 210 * kPointsOfMm, 297 * kPointsOfMm},
    PaperFormat{PaperSize::a3, "A3", 297 * kPointsOfMm, 420 * kPointsOfMm},
    PaperFormat{PaperSize::a2, "A2", 420 * kPointsOfMm, 594 * kPointsOfMm},
    PaperFormat{PaperSize::a1, "A1", 594 * kPointsOfMm, 841 * kPointsOfMm},
    PaperFormat{PaperSize::letter, "Letter", 612, 792},
    PaperFormat{PaperSize::tabloid, "Tabloid", 792, 1224},
    PaperFormat{PaperSize::arch_d, "ArchD", 1728, 2592}};

constexpr const PaperFormat& format_of(PaperSize size) {
    return kPaperFormats[static_cast<std::size_t>(size)];
}

// One of the names; A4 where it is none of them.
constexpr PaperSize paper_named(std::string_view name) {
    for (const PaperFormat& format : kPaperFormats)
        if (format.name == name) return format.size;
    return PaperSize::a4;
}

} // namespace ghost::scene
