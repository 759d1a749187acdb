#pragma once
// SPDX-License-Identifier: Apache-2.0
// Measured light of a luminaire, from an IES file (ANSI/IES LM-63-1995, 2002, 2019; photometry of type C) or
// an EULUMDAT file (.ldt): candela over directions. Degrees; gamma 0 along the beam, C about it,
// counter-clockwise seen from the lamp. Errors name file and line. Pure, any thread.

#include "base/report.h"
#include "base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::fixture {

inline constexpr std::size_t kMaxPhotometricBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMaxPhotometricAngles = 1000; // of each kind
inline constexpr float kMaxCandela = 1e9f;

struct Photometric {
    std::string name;                        // of the luminaire, as the file has it
    std::vector<float> gamma_deg;            // rising, within 0..180
    std::vector<float> c_deg;                // rising, from 0, below 360; one: the same all round
    std::vector<std::vector<float>> candela; // [c][gamma]

    // Between neighbours evenly; beyond the angles of the file nothing.
    float at(float c, float gamma) const;
    // Lumens below this gamma.
    double flux_lm(double to_gamma_deg = 180.0) const;
};

struct LoadedPhotometric {
    Photometric light;
    std::vector<Message> messages;
};

// file: for messages.
Result<LoadedPhotometric> parse_ies(std::string_view text, const std::string& file);
Result<LoadedPhotometric> parse_ldt(std::string_view text, const std::string& file);

// By its ending: .ies, or .ldt and .eulumdat.
Result<LoadedPhotometric> load_photometric(const std::filesystem::path& path);

// Both readers share these: a number for a message, "12.5", "100000000"; rising angles.
std::string number_text(float value);
Result<void> check_angles(const std::vector<float>& angles, float low, float high, const std::string& what,
                          const std::string& where);

} // namespace ghost::fixture
