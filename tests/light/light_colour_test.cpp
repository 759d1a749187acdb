// SPDX-License-Identifier: Apache-2.0
// The colour of beams against known chromaticities (CIE 15, data of gels) and the real files' own numbers.
#include "fixture_files/gdtf/gdtf.h"
#include "image/colour.h"
#include "light/private/beam_colour.h"
#include "light/rig.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

using fixture::Beam;
using fixture::ColorCie;
using fixture::Optics;
using fixture::Type;
using glm::vec3;

float luminance(const vec3& rgb) {
    return image::rec2020_to_xyz(rgb).y;
}

void expect_xy(const vec3& rgb, float x, float y, float tolerance) {
    const vec3 xyy = image::rec2020_to_xyy(rgb);
    EXPECT_NEAR(xyy.x, x, tolerance);
    EXPECT_NEAR(xyy.y, y, tolerance);
}

// McCamy 1992, good to a few kelvin between 2800 and 6500 K.
float cct_of(const vec3& rgb) {
    const vec3 xyy = image::rec2020_to_xyy(rgb);
    const float n = (xyy.x - 0.3320f) / (0.1858f - xyy.y);
    return ((449.0f * n + 3525.0f) * n + 6823.3f) * n + 5520.33f;
}

struct Lamp {
    Type type;
    Beam beam;
    Optics optics;

    explicit Lamp(float kelvin = 6000.0f) { beam.color_temperature_k = kelvin; }
    vec3 source() const { return source_colour(type, beam, optics); }
    vec3 all() const { return source() * flags_colour(type, beam, optics); }
    int filter(const ColorCie& color) {
        type.filters.push_back({.name = "filter", .color = color});
        return static_cast<int>(type.filters.size()) - 1;
    }
};

// CIE 15: illuminant A; the daylight locus at 5600 K and 6504 K; a black body of 3200 K.
TEST(light_colour, whites_of_lamps) {
    expect_xy(Lamp(2856).source(), 0.44758f, 0.40745f, 1e-3f);
    expect_xy(Lamp(3200).source(), 0.4234f, 0.3990f, 1e-3f);
    expect_xy(Lamp(5600).source(), 0.3302f, 0.3456f, 1e-3f);
    expect_xy(Lamp(6504).source(), 0.3127f, 0.3290f, 1e-3f);
    for (const float kelvin : {2000.0f, 3200.0f, 5600.0f, 9000.0f})
        EXPECT_NEAR(luminance(Lamp(kelvin).source()), 1.0f, 1e-4f) << kelvin;
    Lamp dimmed(3200);
    dimmed.optics.lamp_cct_fraction = 0.9f;
    EXPECT_NEAR(cct_of(dimmed.source()), 2880.0f, 15.0f);
    EXPECT_NEAR(luminance(dimmed.source()), 1.0f, 1e-4f);
}

TEST(light_colour, a_measured_lamp_is_its_emitter) {
    Lamp lamp;
    lamp.type.emitters.push_back({.name = "arc", .color = {0.3004f, 0.3422f, 100.0f}});
    lamp.beam.emitter = 0;
    expect_xy(lamp.source(), 0.3004f, 0.3422f, 1e-5f);
    // Filters beside it are the colour of the beam behind them.
    const ColorCie blue{0.2000f, 0.2400f, 30.0f};
    expect_xy(lamp.source() * filter_colour(lamp.type, lamp.beam, blue), 0.2f, 0.24f, 1e-5f);
    EXPECT_NEAR(luminance(lamp.source() * filter_colour(lamp.type, lamp.beam, blue)), 0.3f, 1e-4f);
    EXPECT_NEAR(luminance(lamp.source() * filter_colour(lamp.type, lamp.beam, {})), 1.0f, 0.02f) << "open";
    lamp.optics.lamp_cct_fraction = 0.8f;
    EXPECT_GT(image::rec2020_to_xyy(lamp.source()).x, 0.32f) << "redder";
    EXPECT_NEAR(luminance(lamp.source()), 1.0f, 1e-4f);
}

TEST(light_colour, emitters_at_full_are_the_sum_of_their_tristimulus_values) {
    Lamp lamp;
    const ColorCie red{0.6857f, 0.2915f, 30.0f};
    const ColorCie green{0.1742f, 0.6912f, 60.0f};
    const ColorCie blue{0.1500f, 0.0600f, 10.0f};
    lamp.optics.emitters = {{red, 1.0f}, {green, 1.0f}, {blue, 1.0f}};
    glm::dvec3 sum(0.0);
    for (const ColorCie& color : {red, green, blue})
        sum += static_cast<double>(color.Y) * glm::dvec3(color.x, color.y, 1.0f - color.x - color.y) /
               static_cast<double>(color.y);
    const double all = sum.x + sum.y + sum.z;
    expect_xy(lamp.source(), static_cast<float>(sum.x / all), static_cast<float>(sum.y / all), 1e-4f);
    EXPECT_NEAR(luminance(lamp.source()), 1.0f, 1e-4f);
    lamp.optics.emitters = {{red, 0.5f}, {green, 0.0f}, {blue, 0.0f}};
    expect_xy(lamp.source(), red.x, red.y, 1e-4f);
    EXPECT_NEAR(luminance(lamp.source()), 0.15f, 1e-4f);
}

TEST(light_colour, what_rec2020_cannot_show_keeps_luminance_and_hue) {
    Lamp lamp;
    lamp.optics.emitters = {{{0.1700f, 0.0120f, 5.0f}, 1.0f}};
    const vec3 violet = lamp.source();
    EXPECT_GE(std::min({violet.x, violet.y, violet.z}), 0.0f);
    EXPECT_NEAR(luminance(violet), 0.05f, 1e-4f);
    EXPECT_GT(violet.z, 5.0f * violet.x);
    EXPECT_GT(violet.x, violet.y);
}

TEST(light_colour, flags_mix_subtractively) {
    Lamp lamp(6504);
    lamp.optics.cyan = 1.0f;
    const vec3 cyan = lamp.all();
    const vec3 xyy = image::rec2020_to_xyy(cyan);
    EXPECT_LT(xyy.x, 0.24f);
    EXPECT_LT(cyan.x, 0.05f * cyan.y) << "the complement of red";
    lamp.optics.yellow = 1.0f;
    const vec3 green = lamp.all();
    EXPECT_GT(green.y, 15.0f * std::max(green.x, green.z));
    lamp.optics.magenta = 1.0f;
    EXPECT_LT(luminance(lamp.all()), 0.03f) << "all three are nearly dark";
    EXPECT_GT(luminance(lamp.all()), 0.0f);
    lamp.optics = {};
    EXPECT_EQ(flags_colour(lamp.type, lamp.beam, lamp.optics), vec3(1.0f));
    lamp.optics.magenta = 0.5f;
    const vec3 half = flags_colour(lamp.type, lamp.beam, lamp.optics);
    lamp.optics.magenta = 1.0f;
    const vec3 full = flags_colour(lamp.type, lamp.beam, lamp.optics);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(half[k] * half[k], full[k], 1e-5f);
    lamp.optics = {};
    lamp.optics.color_flags = {{'R', 1.0f, -1}};
    EXPECT_GT(lamp.all().x, 20.0f * lamp.all().y);
}

TEST(light_colour, flags_of_a_file_are_its_filters) {
    Lamp lamp(6504);
    lamp.optics.cyan = 1.0f;
    lamp.optics.flag_filters[0] = lamp.filter({0.1390f, 0.1355f, 12.21f});
    const vec3 full = flags_colour(lamp.type, lamp.beam, lamp.optics);
    expect_xy(full, 0.1390f, 0.1355f, 1e-4f);
    EXPECT_NEAR(luminance(full), 0.1221f, 1e-4f);
    // A measured insertion: 0.25 of 0.0625 at half is half the density, 0.5 a quarter.
    lamp.type.filters[0].measurements = {{.physical_percent = 50.0f, .transmission = 0.5f},
                                         {.physical_percent = 100.0f, .transmission = 0.0625f}};
    lamp.optics.cyan = 0.5f;
    const vec3 half = flags_colour(lamp.type, lamp.beam, lamp.optics);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(half[k], std::pow(full[k], 0.25f), 1e-4f);
}

TEST(light_colour, a_filter_passes_its_luminance_and_adds_no_light) {
    Lamp lamp(6504);
    const vec3 blue = filter_colour(lamp.type, lamp.beam, {0.1600f, 0.0900f, 8.0f});
    expect_xy(blue, 0.1600f, 0.0900f, 1e-4f);
    EXPECT_NEAR(luminance(blue), 0.08f, 1e-5f);
    const vec3 unsaid = filter_colour(lamp.type, lamp.beam, {0.1600f, 0.0900f, 100.0f});
    expect_xy(unsaid, 0.1600f, 0.0900f, 1e-4f);
    EXPECT_NEAR(unsaid.z, 1.0f, 1e-5f) << "all of the blue, not all of the light";
    EXPECT_LT(luminance(unsaid), 0.2f);
    const vec3 open = filter_colour(lamp.type, lamp.beam, {});
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(open[k], 1.0f, 1e-4f);
}

TEST(light_colour, correction_gives_the_kelvin_that_was_asked_for) {
    for (const float kelvin : {2700.0f, 3200.0f, 4000.0f, 5600.0f}) {
        Lamp lamp(6000);
        lamp.optics.cct_k = kelvin;
        EXPECT_NEAR(cct_of(lamp.source()), kelvin, 50.0f);
        EXPECT_LT(luminance(lamp.source()), 1.0f) << "a filter costs light";
    }
    Lamp cto(6500); // Lee 204 lets 55 % through
    cto.optics.cct_k = 1e6f / (1e6f / 6500.0f + 159.0f);
    EXPECT_NEAR(cct_of(cto.source()), 3197.0f, 50.0f);
    EXPECT_NEAR(luminance(cto.source()), 0.55f, 0.005f);
    Lamp ctb(3200); // Lee 201: 34 %
    ctb.optics.cct_k = 1e6f / (1e6f / 3200.0f - 137.0f);
    EXPECT_NEAR(cct_of(ctb.source()), 5697.0f, 50.0f);
    EXPECT_NEAR(luminance(ctb.source()), 0.34f, 0.06f);
    Lamp led(6000);
    led.optics.cct_k = 3200.0f;
    led.optics.cct_is_filter = false;
    EXPECT_NEAR(luminance(led.source()), 1.0f, 1e-4f) << "an LED mixes its white";
    EXPECT_NEAR(cct_of(led.source()), 3200.0f, 50.0f);
}

TEST(light_colour, tint_is_across_the_locus) {
    const auto uv = [](const vec3& rgb) {
        const vec3 c = image::rec2020_to_xyy(rgb);
        return glm::vec2(4.0f * c.x, 6.0f * c.y) / (12.0f * c.y - 2.0f * c.x + 3.0f);
    };
    for (const float kelvin : {2700.0f, 3200.0f, 5600.0f, 8000.0f}) {
        Lamp lamp(kelvin);
        const glm::vec2 neutral = uv(lamp.source());
        lamp.optics.tint = 1.0f;
        const glm::vec2 green = uv(lamp.source());
        lamp.optics.tint = -1.0f;
        const glm::vec2 magenta = uv(lamp.source());
        EXPECT_NEAR(glm::length(green - neutral), 0.02f, 5e-4f) << kelvin;
        EXPECT_NEAR(glm::length(magenta - neutral), 0.02f, 5e-4f) << kelvin;
        EXPECT_GT(green.y, neutral.y) << kelvin;
        const glm::vec2 along = uv(Lamp(kelvin * 1.01f).source()) - uv(Lamp(kelvin / 1.01f).source());
        EXPECT_NEAR(glm::dot(glm::normalize(along), glm::normalize(green - magenta)), 0.0f, 0.05f) << kelvin;
    }
}

TEST(light_colour, indirect_colours_take_the_place_of_the_lamp) {
    Lamp lamp(3200);
    lamp.optics.has_mix = true;
    lamp.optics.mix = {0.25f, 0.40f, 60.0f};
    expect_xy(lamp.source(), 0.25f, 0.40f, 1e-5f);
    EXPECT_NEAR(luminance(lamp.source()), 0.6f, 1e-5f);
    lamp.optics.has_mix = false;
    lamp.optics.brightness = 0.25f;
    EXPECT_NEAR(luminance(lamp.source()), 0.25f, 1e-5f);
}

const std::filesystem::path kFolder = std::filesystem::path(GHOST_SOURCE_DIR) / "../shared/fixtures/gdtf";

// Every colour of a slot or filter that a file states is what light_from makes of a D65 source; or, beside a
// measured lamp, the colour of the beam. Outside of Rec.2020 it is the border.
TEST(light_colour, filters_and_slots_of_real_files) {
    if (!std::filesystem::exists(kFolder)) GTEST_SKIP() << "no ../shared/fixtures beside the checkout";
    int colours = 0;
    int outside = 0;
    int dimmed = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        const auto loaded = fixture::load_gdtf(entry.path());
        if (!loaded) continue;
        const Type& type = loaded->type;
        Beam beam;
        for (const fixture::Geometry& geometry : type.geometries)
            if (geometry.beam) beam = *geometry.beam;
        const auto check = [&](const ColorCie& color, const std::string& name) {
            if (!(color.y > 0.0f) || !(color.Y > 0.0f)) return;
            ++colours;
            const vec3 passed = filter_colour(type, beam, color);
            EXPECT_TRUE(passed.x >= 0.0f && passed.x <= 1.00001f && passed.y >= 0.0f && passed.z >= 0.0f)
                << name;
            const vec3 exact = image::xyy_to_rec2020({color.x, color.y, color.Y / 100.0f});
            if (std::min({exact.x, exact.y, exact.z}) < 0.0f) {
                ++outside;
                return;
            }
            const bool is_open = color.x == ColorCie{}.x && color.y == ColorCie{}.y;
            Optics optics;
            const vec3 seen =
                beam.emitter >= 0 && !is_open ? passed * source_colour(type, beam, optics) : passed;
            const vec3 xyy = image::rec2020_to_xyy(seen);
            EXPECT_LT(std::hypot(xyy.x - color.x, xyy.y - color.y), 2e-3f)
                << entry.path().filename() << ": " << name;
            EXPECT_LE(xyy.z, color.Y / 100.0f + 1e-3f);
            dimmed += xyy.z < 0.98f * color.Y / 100.0f;
        };
        for (const fixture::Filter& filter : type.filters) check(filter.color, filter.name);
        for (const fixture::Wheel& wheel : type.wheels)
            for (const fixture::Slot& slot : wheel.slots) check(slot.color, wheel.name + "/" + slot.name);
    }
    EXPECT_GT(colours, 500);
    std::printf("%d colours, %d outside of Rec.2020, %d with more luminance than such a filter can pass\n",
                colours, outside, dimmed);
}

} // namespace
} // namespace ghost::scene
