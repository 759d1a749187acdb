#pragma once
// SPDX-License-Identifier: Apache-2.0
// PrintStyle: in which language and which units paper is printed. Values are metres, kilograms and watts
// until here; imperial lengths are feet and inches to the nearest quarter of an inch. Pure, any thread.

#include "print/words.h"

#include <initializer_list>
#include <string>

namespace ghost::scene {

enum class Units { metric, imperial };

struct PrintStyle {
    Language language = Language::english;
    Units units = Units::metric;

    // The words of the language, "%1", "%2" in them replaced.
    std::string operator()(Word word, std::initializer_list<std::string> values = {}) const;
    // At most so many decimals, none that are 0, with the language's own point: "12,5".
    std::string number(double value, int decimals) const;
    // "6.26" or "20'-6 1/2"", for below length_unit().
    std::string length(double metres, int decimals = 2) const;
    // "6.26 m" or "20'-6 1/2"".
    std::string length_said(double metres, int decimals = 2) const;
    std::string length_unit() const { return units == Units::metric ? "m" : "ft"; }
    // In kilograms or pounds, without its unit.
    std::string weight(double kilograms) const;
    std::string weight_unit() const { return units == Units::metric ? "kg" : "lb"; }
};

} // namespace ghost::scene
