// SPDX-License-Identifier: Apache-2.0
// Lamp and lens of a fixture whose file says little: docs/reference/fixture-formats.md has the table.
#include "base/text.h"
#include "fixture_files/common/type_builder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

namespace ghost::fixture {
namespace {

enum class Lamp { led, discharge, tungsten };

bool has(const std::string& text, std::string_view word) {
    return text.find(word) != std::string::npos;
}

Lamp lamp_kind(const std::string& bulb) {
    for (const std::string_view word : {"led", "rgb", "cob", "laser", "diode", "smd"})
        if (has(bulb, word)) return Lamp::led;
    for (const std::string_view word :
         {"hmi",    "msr",       "msd", "hti", "hsr",   "hsd", "hri", "cdm",    "uhp",     "uhe",  "platinum",
          "sirius", "discharge", "mhl", "hid", "xenon", "xop", "arc", "lok-it", "hpl arc", "metal"})
        if (has(bulb, word)) return Lamp::discharge;
    for (const std::string_view word : {"elc", "efr", "efp", "ehj", "evc", "gx5", "hal", "tungsten", "hpl",
                                        "par", "qt", "gkv", "incand", "cp"})
        if (has(bulb, word)) return Lamp::tungsten;
    return bulb.empty() ? Lamp::led : Lamp::discharge;
}

// "MSR 575W" -> 575; 0 where there is no such number.
float watts_of(const std::string& bulb) {
    for (std::size_t w = bulb.find('w'); w != std::string::npos; w = bulb.find('w', w + 1)) {
        std::size_t end = w;
        while (end > 0 && bulb[end - 1] == ' ') --end;
        std::size_t begin = end;
        while (begin > 0 && bulb[begin - 1] >= '0' && bulb[begin - 1] <= '9') --begin;
        float value = 0.0f;
        if (begin < end && std::from_chars(bulb.data() + begin, bulb.data() + end, value).ec == std::errc{})
            return std::min(value, 1e5f);
    }
    return 0.0f;
}

std::string said(const char* format, double a, double b = 0.0, double c = 0.0) {
    char text[240];
    std::snprintf(text, sizeof text, format, a, b, c);
    return text;
}

constexpr float kLampShare = 0.35f;         // of a bare lamp's light that leaves a fixture
constexpr float kBareLamp_lm_per_w = 45.0f; // no fixture with a discharge lamp gives more
constexpr float kBestLed_lm_per_w = 130.0f;

float flux_of(const LampFacts& facts, Carriage carriage, Lamp lamp, float lamp_w,
              std::vector<std::string>& assumed) {
    if (facts.lumens > 0.0f) {
        if (lamp == Lamp::discharge && lamp_w > 0.0f && facts.lumens > kBareLamp_lm_per_w * lamp_w) {
            assumed.push_back(
                said("%g lm are the bare lamp's, more than a fixture with %g W gives: %g lm leave it",
                     static_cast<double>(facts.lumens), static_cast<double>(lamp_w),
                     static_cast<double>(kLampShare * facts.lumens)));
            return kLampShare * facts.lumens;
        }
        const float most = kBestLed_lm_per_w * facts.power_w;
        if (lamp == Lamp::led && facts.power_w > 0.0f && facts.lumens > most) {
            assumed.push_back(said("%g lm from %g W cannot be: taking %g lm",
                                   static_cast<double>(facts.lumens), static_cast<double>(facts.power_w),
                                   static_cast<double>(most)));
            return most;
        }
        return facts.lumens;
    }
    const float per_w = lamp == Lamp::led ? 30.0f : (lamp == Lamp::discharge ? 15.0f : 12.0f);
    const float watts = lamp_w > 0.0f ? lamp_w : 0.75f * facts.power_w;
    float lumens = carriage == Carriage::fixed ? 3000.0f : 8000.0f;
    if (watts >= 1.0f) {
        lumens = per_w * watts;
        assumed.push_back(said("no lumens in the file: %g lm taken, %g for each of %g W",
                               static_cast<double>(lumens), static_cast<double>(per_w),
                               static_cast<double>(watts)));
    } else {
        assumed.push_back(
            said("neither lumens nor watts in the file: %g lm taken", static_cast<double>(lumens)));
    }
    return lumens;
}

} // namespace

BeamGuess beam_from(const LampFacts& facts, Carriage carriage) {
    BeamGuess guess;
    Beam& beam = guess.beam;
    const std::string bulb = lower(facts.bulb);
    const std::string lens = lower(facts.lens);
    const Lamp lamp = lamp_kind(bulb);
    const float lamp_w = lamp == Lamp::led ? 0.0f : watts_of(bulb);
    beam.lamp_type = lamp == Lamp::led ? "LED" : (lamp == Lamp::discharge ? "Discharge" : "Tungsten");
    beam.luminous_flux_lm =
        std::clamp(flux_of(facts, carriage, lamp, lamp_w, guess.assumed), 1.0f, 10'000'000.0f);
    beam.power_w = facts.power_w > 0.0f ? facts.power_w : (lamp_w > 0.0f ? lamp_w : 100.0f);
    beam.color_temperature_k = facts.color_temperature_k;
    if (!(beam.color_temperature_k >= 1000.0f && beam.color_temperature_k <= 25000.0f)) {
        beam.color_temperature_k = lamp == Lamp::tungsten ? 3200.0f : 6000.0f;
        guess.assumed.push_back(said("no colour temperature in the file: %g K taken",
                                     static_cast<double>(beam.color_temperature_k)));
    }
    const float wide = std::max(facts.degrees_min, facts.degrees_max);
    const bool spot = facts.has_gobos || carriage == Carriage::mirror || has(lens, "profile");
    float field = wide;
    if (!(field >= 0.1f && field <= 360.0f)) {
        field = spot ? 18.0f : (carriage == Carriage::head ? 20.0f : 25.0f);
        guess.assumed.push_back(
            said("no beam angle in the file: %g degrees taken", static_cast<double>(field)));
    }
    // A bare bulb that says 360 is a wide flood.
    beam.field_angle_deg = std::min(field, 160.0f);
    beam.beam_angle_deg = beam.field_angle_deg * (spot ? 0.9f : 0.6f);
    beam.beam_type = spot ? BeamType::spot : BeamType::wash;
    if (!spot && has(lens, "fresnel")) beam.beam_type = BeamType::fresnel;
    if (!spot && lens == "pc") beam.beam_type = BeamType::pc;
    beam.color_rendering_index = lamp == Lamp::tungsten ? 99.0f : 80.0f;
    return guess;
}

} // namespace ghost::fixture
