// SPDX-License-Identifier: Apache-2.0
// Colours by hex code, name and temperature; facets of a prism that is only counted.
#include "base/text.h"
#include "fixture_files/common/type_builder.h"
#include "image/colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ghost::fixture {
namespace {

ColorCie from_rec2020(const glm::vec3& rgb) {
    const glm::vec3 xyz = glm::max(image::rec2020_to_xyz(rgb), glm::vec3(0.0f));
    const float sum = xyz.x + xyz.y + xyz.z;
    if (!(sum > 1e-6f)) return {0.3127f, 0.3290f, 0.0f};
    return {xyz.x / sum, xyz.y / sum, 100.0f * xyz.y};
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

struct NamedColor {
    std::string_view word;
    std::string_view hex;
};

// The longest word that a name holds decides, so "deep blue" goes before "blue". Guesses: a name is no
// filter.
constexpr NamedColor kNamed[] = {
    {"open", "#ffffff"},        {"white", "#ffffff"},        {"no color", "#ffffff"},
    {"no colour", "#ffffff"},   {"red", "#ff0000"},          {"dark red", "#a00000"},
    {"deep red", "#a00000"},    {"light red", "#ff6050"},    {"orange", "#ff7f00"},
    {"dark orange", "#e05a00"}, {"amber", "#ffa000"},        {"dark amber", "#e07800"},
    {"yellow", "#ffff00"},      {"light yellow", "#ffff90"}, {"dark yellow", "#d8b000"},
    {"lime", "#b0ff20"},        {"green", "#00ff00"},        {"light green", "#80ff80"},
    {"dark green", "#008020"},  {"deep green", "#008020"},   {"turquoise", "#00e0c0"},
    {"aqua", "#00e0e0"},        {"cyan", "#00ffff"},         {"blue", "#0000ff"},
    {"light blue", "#60b0ff"},  {"dark blue", "#0000a0"},    {"deep blue", "#0000a0"},
    {"sky blue", "#80c8ff"},    {"indigo", "#4b0082"},       {"violet", "#8020e0"},
    {"purple", "#9000d0"},      {"lavender", "#b090ff"},     {"magenta", "#ff00ff"},
    {"pink", "#ff80c0"},        {"dark pink", "#e04090"},    {"rose", "#ff6090"},
    {"uv", "#4000b0"},          {"congo", "#3000b0"},        {"salmon", "#ff8c70"},
    {"gold", "#ffc840"},        {"cto", "#ffb46b"},          {"ctb", "#a8c8ff"},
    {"minus green", "#ffd0ff"}, {"peach", "#ffb890"},        {"mint", "#80ffc0"},
    {"fuchsia", "#ff20a0"},     {"hot pink", "#ff50b0"},
};

} // namespace

std::optional<ColorCie> color_from_hex(std::string_view text) {
    text = trimmed(text);
    if (!text.starts_with('#') || (text.size() != 7 && text.size() != 4)) return std::nullopt;
    glm::vec3 linear;
    for (int k = 0; k < 3; ++k) {
        const std::size_t place =
            text.size() == 7 ? 1 + 2 * static_cast<std::size_t>(k) : 1 + static_cast<std::size_t>(k);
        const int high = hex_digit(text[place]);
        const int low = text.size() == 7 ? hex_digit(text[place + 1]) : high;
        if (high < 0 || low < 0) return std::nullopt;
        linear[k] = image::srgb_to_linear(static_cast<float>(16 * high + low) / 255.0f);
    }
    return from_rec2020(image::rec709_to_rec2020(linear));
}

std::optional<ColorCie> color_from_name(std::string_view name) {
    const std::string text = lower(name);
    const NamedColor* best = nullptr;
    for (const NamedColor& named : kNamed)
        if (text.find(named.word) != std::string::npos && (!best || named.word.size() > best->word.size()))
            best = &named;
    return best ? color_from_hex(best->hex) : std::nullopt;
}

ColorCie color_from_temperature(float wanted_k, float lamp_k) {
    const auto sane = [](float kelvin) { return std::clamp(kelvin, 1667.0f, 25000.0f); };
    const glm::vec3 wanted = image::cct_to_rec2020(sane(wanted_k));
    const glm::vec3 lamp = glm::max(image::cct_to_rec2020(sane(lamp_k)), glm::vec3(1e-3f));
    const glm::vec3 ratio = glm::max(wanted, glm::vec3(0.0f)) / lamp;
    return from_rec2020(ratio / std::max({ratio.x, ratio.y, ratio.z, 1e-6f}));
}

std::vector<Facet> prism_facets(int count) {
    constexpr float kShift = 1.2f; // gate radii: the pictures just meet
    std::vector<Facet> facets;
    count = std::clamp(count, 2, 64);
    for (int i = 0; i < count; ++i) {
        const float angle =
            2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(count);
        Facet facet;
        facet.rotation = {1, 0, 0, 0, 1, 0, kShift * std::cos(angle), kShift * std::sin(angle), 1};
        facets.push_back(facet);
    }
    return facets;
}

} // namespace ghost::fixture
