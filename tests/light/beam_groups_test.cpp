// SPDX-License-Identifier: Apache-2.0
// Cells of bars, matrices and sticks as lights: how many, where, with what light, from which distance maps.
#include "beam_groups/beam_groups.h"

#include "passes/distance_maps_file.h"
#include "shared/beam.h"
#include "show/show.h"
#include "support/explain_trial.h"

#include <cstring>
#include <set>

namespace ghost::scene {
namespace {

using glm::vec2;
using glm::vec3;
using std::string;
using trial::channel;
using trial::function;
using trial::simple;

struct CellSpec {
    vec3 place_m{0};
    string type = "Wash";
    float beam_deg = 40;
    float field_deg = 60;
    float lumens = 100;
    float lean_deg = 0; // about Y
    string inside;
};

string cell(int number, const CellSpec& spec) {
    const float turn = glm::radians(spec.lean_deg);
    char place[200];
    std::snprintf(place, sizeof place, "{%f,0,%f,%f}{0,1,0,%f}{%f,0,%f,%f}{0,0,0,1}", std::cos(turn),
                  std::sin(turn), spec.place_m.x, spec.place_m.y, -std::sin(turn), std::cos(turn),
                  spec.place_m.z);
    return "<Beam Name=\"Cell " + std::to_string(number) + "\" BeamType=\"" + spec.type +
           "\" LuminousFlux=\"" + std::to_string(spec.lumens) + "\" BeamAngle=\"" +
           std::to_string(spec.beam_deg) + "\" FieldAngle=\"" + std::to_string(spec.field_deg) +
           "\" BeamRadius=\"0.01\" Position=\"" + place + "\"/>";
}

// Red, green and blue of each cell from channel 1 on, and whatever else.
std::shared_ptr<const fixture::Type> cells_type(const std::vector<CellSpec>& cells, const string& more = "",
                                                const string& wheels = "", const string& around = "") {
    string beams, channels;
    for (int k = 0; k < static_cast<int>(cells.size()); ++k) {
        beams += cell(k + 1, cells[static_cast<std::size_t>(k)]);
        int offset = 3 * k + 1;
        for (const char* colour : {"ColorAdd_R", "ColorAdd_G", "ColorAdd_B"})
            channels += channel(std::to_string(offset++), colour, function(colour, colour, 0, 0, 1),
                                "Cell " + std::to_string(k + 1));
    }
    if (!around.empty()) beams = around + beams + "</Axis>";
    return trial::type_of(channels + more, beams, wheels);
}

std::vector<CellSpec> bar(int count, float length_m, const CellSpec& like = {}) {
    std::vector<CellSpec> cells(static_cast<std::size_t>(count), like);
    for (int k = 0; k < count; ++k)
        cells[static_cast<std::size_t>(k)].place_m.x =
            length_m * (static_cast<float>(k) / static_cast<float>(count - 1) - 0.5f);
    return cells;
}

BeamGroups emitters_in(const std::shared_ptr<const fixture::Type>& type) {
    return beam_groups_of(*type, type->modes[0]);
}

// One fixture at address 1, 6 m up; all cells full and white unless set.
struct Hall {
    Show show;
    Report report;
    dmx::Levels levels{};
    GoboStack gobos;

    explicit Hall(const std::shared_ptr<const fixture::Type>& type) {
        PatchedFixture fixture;
        fixture.name = "Bar";
        fixture.type = type;
        fixture.position_m = {1, 2, 6};
        fixture.rotation_deg = {0, 0, 30};
        show.fixtures.push_back(fixture);
        levels.fill(255);
        gobos = build_gobos(show, report);
    }
    Hall& set(int channel, int value) {
        levels[static_cast<std::size_t>(channel - 1)] = static_cast<std::uint8_t>(value);
        return *this;
    }
    FrameLights lit(Cells cells = Cells::grouped, const DistanceMaps& maps = {}) const {
        Rig rig(show);
        dmx::Universes universes;
        universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
        rig.step(universes, 1.0 / 30);
        return rig.lit(gobos, maps, cells);
    }
};

vec3 sum_cd(const std::vector<shared::Light>& lights) {
    vec3 sum(0.0f);
    for (const shared::Light& light : lights) sum += light.intensity_cd;
    return sum;
}

void expect_within(const vec3& value, const vec3& expected, float tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], expected[c], tolerance) << "component " << c;
}

vec3 lens_of(const shared::Light& light) {
    return light.position_m + light.lens_m * light.axis_w;
}

TEST(BeamGroups, ABarOfWideCellsIsOneLightInItsMiddle) {
    const auto type = cells_type(bar(32, 1.0f));
    const BeamGroups emitters = emitters_in(type);
    ASSERT_EQ(emitters.lights.size(), 1u);
    EXPECT_EQ(emitters.lights[0].beams.size(), 32u);
    ASSERT_EQ(emitters.places_m.size(), 1u);
    expect_within(emitters.places_m[0], {0, 0, 0}, 1e-5f);
    Hall hall(type);
    const FrameLights lit = hall.lit();
    ASSERT_EQ(lit.lights.size(), 1u);
    ASSERT_EQ(lit.faces.size(), 32u);
    expect_within(lens_of(lit.lights[0]), {1, 2, 6}, 1e-4f);
    expect_within(lit.lights[0].position_m - lit.lights[0].off_map_m, {1, 2, 6}, 1e-4f);
    // A row of this length has the spread of a disc of 0.2976 m x sqrt 2, and its cells 1 cm more.
    EXPECT_NEAR(lit.lights[0].disc_radius_m, std::sqrt(2.0f) * 0.29783f, 1e-3f);
    EXPECT_EQ(distance_places(hall.show, 64).size(), 1u) << "32 cells, one map";
}

// Whatever the cells do, the candela and the lumens of the light are theirs.
TEST(BeamGroups, TheLightOfAGroupIsTheSumOfItsCells) {
    std::vector<CellSpec> cells = bar(12, 0.5f);
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k].lumens = 40.0f + 30.0f * static_cast<float>(k);
    Hall hall(cells_type(cells));
    for (int trial = 0; trial < 5; ++trial) {
        for (int c = 1; c <= 36; ++c) hall.set(c, (c * 37 + trial * 91) % 256);
        const FrameLights grouped = hall.lit(), apart = hall.lit(Cells::apart);
        ASSERT_EQ(grouped.lights.size(), 1u);
        ASSERT_EQ(apart.lights.size(), 12u);
        const vec3 sum = sum_cd(apart.lights);
        EXPECT_GT(sum.y, 10.0f);
        expect_within(grouped.lights[0].intensity_cd / sum, vec3(1.0f), 1e-5f);
        vec3 bounced(0.0f);
        for (const shared::Light& light : apart.lights) bounced += light.bounce_cd;
        expect_within(grouped.lights[0].bounce_cd / bounced, vec3(1.0f), 1e-5f);
        // The same profile, so equal candela on the axis are equal lumens.
        EXPECT_EQ(grouped.lights[0].tan_field, apart.lights[0].tan_field);
        EXPECT_EQ(grouped.lights[0].profile_power, apart.lights[0].profile_power);
        EXPECT_EQ(grouped.lights[0].profile_scale, apart.lights[0].profile_scale);
        EXPECT_EQ(grouped.lights[0].iris_radius, apart.lights[0].iris_radius);
    }
}

TEST(BeamGroups, OneCellChangesItsFaceAndTheColourOfItsGroupOnly) {
    Hall hall(cells_type(bar(8, 0.4f)));
    const FrameLights before = hall.lit();
    hall.set(13, 0).set(14, 80); // of cell 5
    const FrameLights after = hall.lit();
    ASSERT_EQ(after.faces.size(), 8u);
    for (std::size_t k = 0; k < 8; ++k)
        EXPECT_EQ(std::memcmp(&before.faces[k].light, &after.faces[k].light, sizeof(shared::Light)) == 0,
                  k != 4)
            << "cell " << k + 1;
    ASSERT_EQ(after.lights.size(), 1u);
    shared::Light same = after.lights[0];
    expect_within(before.lights[0].intensity_cd - same.intensity_cd,
                  before.faces[4].light.intensity_cd - after.faces[4].light.intensity_cd, 1e-3f);
    EXPECT_GT(before.lights[0].intensity_cd.x, same.intensity_cd.x);
    same.intensity_cd = before.lights[0].intensity_cd;
    same.bounce_cd = before.lights[0].bounce_cd;
    EXPECT_EQ(std::memcmp(&same, &before.lights[0], sizeof same), 0) << "it stays where it is";
    for (int c = 1; c <= 24; ++c) hall.set(c, 0);
    EXPECT_EQ(hall.lit().lights.size(), 1u) << "dark, and still a light";
}

TEST(BeamGroups, NarrowCellsAreSeveralLightsNoneFartherThanTheRule) {
    CellSpec narrow;
    narrow.beam_deg = 5;
    narrow.field_deg = 10;
    const std::vector<CellSpec> cells = bar(48, 1.2f, narrow);
    const BeamGroups emitters = emitters_in(cells_type(cells));
    const float limit_m = 0.5f * 5.0f * std::tan(glm::radians(2.5f)); // 0.109 m
    EXPECT_EQ(emitters.lights.size(), 6u);
    std::set<int> seen;
    for (const BeamGroup& light : emitters.lights) {
        vec3 middle_m(0.0f);
        float sum = 0.0f;
        for (std::size_t k = 0; k < light.beams.size(); ++k) {
            EXPECT_TRUE(seen.insert(light.beams[k]).second);
            middle_m += light.weights[k] * cells[static_cast<std::size_t>(light.beams[k])].place_m;
            sum += light.weights[k];
        }
        EXPECT_NEAR(sum, 1.0f, 1e-5f);
        for (const int beam : light.beams)
            EXPECT_LE(glm::distance(cells[static_cast<std::size_t>(beam)].place_m, middle_m),
                      limit_m + 1e-4f);
        EXPECT_LE(glm::distance(emitters.places_m.at(static_cast<std::size_t>(light.place)), middle_m),
                  kMapShare_m + 1e-4f);
    }
    EXPECT_EQ(seen.size(), cells.size());
    EXPECT_EQ(emitters.places_m.size(), 3u) << "a map for each half metre";
    expect_within(emitters.middle_m, {0, 0, 0}, 1e-4f);
}

TEST(BeamGroups, AStickOfLasersIsAsManyLightsAndOneMap) {
    std::vector<CellSpec> cells = bar(21, 0.4f);
    for (std::size_t k = 0; k < cells.size(); ++k) {
        cells[k].beam_deg = cells[k].field_deg = 0.1f;
        cells[k].lean_deg = 2.0f * (static_cast<float>(k) - 10.0f);
    }
    const auto type = cells_type(cells);
    const BeamGroups emitters = emitters_in(type);
    EXPECT_EQ(emitters.lights.size(), 21u);
    EXPECT_EQ(emitters.places_m.size(), 1u);
    const FrameLights lit = Hall(type).lit();
    ASSERT_EQ(lit.lights.size(), 21u);
    // Each begins at its own lens, and knows how far that is from the map.
    const vec3 along(std::cos(glm::radians(30.0f)), std::sin(glm::radians(30.0f)), 0);
    for (std::size_t k = 0; k < 21; ++k) {
        expect_within(lens_of(lit.lights[k]), vec3(1, 2, 6) + cells[k].place_m.x * along, 0.02f);
        expect_within(lit.lights[k].position_m - lit.lights[k].off_map_m, {1, 2, 6}, 1e-4f);
    }
}

TEST(BeamGroups, CellsThatLeanApartAreGroupedByDirection) {
    std::vector<CellSpec> cells = bar(6, 0.2f);
    for (std::size_t k = 0; k < 6; ++k) cells[k].lean_deg = k < 3 ? -15.0f : 15.0f;
    const BeamGroups emitters = emitters_in(cells_type(cells));
    ASSERT_EQ(emitters.lights.size(), 2u);
    EXPECT_EQ(emitters.lights[0].beams, (std::vector<int>{0, 1, 2}));
    for (std::size_t k = 0; k < 6; ++k) cells[k].lean_deg = k < 3 ? -2.0f : 2.0f;
    EXPECT_EQ(emitters_in(cells_type(cells)).lights.size(), 1u);
}

TEST(BeamGroups, OfTypeNoneAndGlowAreSeenAndLightNothing) {
    for (const char* kind : {"None", "Glow"}) {
        CellSpec glow;
        glow.type = kind;
        const auto type = cells_type(bar(16, 0.5f, glow));
        Hall hall(type);
        const FrameLights lit = hall.lit();
        EXPECT_TRUE(lit.lights.empty());
        ASSERT_EQ(lit.faces.size(), 16u);
        for (const LensFace& face : lit.faces) {
            EXPECT_TRUE(face.glows);
            EXPECT_NEAR(face.light.bounce_cd.y, 100.0f / (4.0f * shared::kPi), 8.0f) << "its lumens";
        }
        EXPECT_TRUE(distance_places(hall.show, 64).empty());
    }
    std::vector<CellSpec> mixed = bar(4, 0.2f);
    mixed[1].type = "Glow";
    const FrameLights lit = Hall(cells_type(mixed)).lit();
    EXPECT_EQ(lit.lights.size(), 1u);
    ASSERT_EQ(lit.faces.size(), 4u);
    EXPECT_TRUE(lit.faces[1].glows);
    EXPECT_FALSE(lit.faces[0].glows);
}

TEST(BeamGroups, TheNarrowestZoomDecides) {
    const string zoom = channel("50", "Zoom", function("Zoom", "Zoom", 0, 4, 60), "Base");
    const auto type = cells_type(bar(12, 0.6f), zoom);
    const std::size_t lights = emitters_in(type).lights.size();
    EXPECT_GT(lights, 4u);
    EXPECT_LT(lights, 12u);
    Hall hall(type);
    for (const int level : {0, 100, 255}) {
        const FrameLights lit = hall.set(50, level).lit();
        EXPECT_EQ(lit.lights.size(), lights) << "at any zoom";
        expect_within(sum_cd(lit.lights) / sum_cd(hall.lit(Cells::apart).lights), vec3(1.0f), 1e-5f);
    }
    EXPECT_EQ(emitters_in(cells_type(bar(12, 0.6f))).lights.size(), 1u) << "without it";
    // A zoom for one cell alone makes it a light of its own.
    const string own = channel("50", "Zoom", function("Zoom", "Zoom", 0, 40, 60), "Cell 3");
    const BeamGroups emitters = emitters_in(cells_type(bar(12, 0.1f), own));
    ASSERT_EQ(emitters.lights.size(), 2u);
    EXPECT_EQ(emitters.lights[1].beams, std::vector<int>{2});
}

TEST(BeamGroups, ATurningBarKeepsThePlacesOfItsMaps) {
    CellSpec narrow;
    narrow.beam_deg = narrow.field_deg = 5;
    narrow.place_m.z = -0.1f;
    const string tilt = channel("100", "Tilt", function("Tilt", "Tilt", 0, -90, 90), "Head");
    const auto type = cells_type(bar(20, 1.2f, narrow), tilt, "", "<Axis Name=\"Head\">");
    const BeamGroups emitters = emitters_in(type);
    EXPECT_EQ(emitters.places_m.size(), 3u) << "the tilt axis runs along the bar";
    for (const vec3& place_m : emitters.places_m) EXPECT_NEAR(place_m.z, 0.0f, 1e-5f) << "on the axis";
    Hall hall(type);
    for (const int level : {0, 128, 200})
        for (const shared::Light& light : hall.set(100, level).lit().lights) {
            const vec3 lens_m = lens_of(light) - (light.position_m - light.off_map_m);
            EXPECT_LE(glm::length(lens_m), glm::length(vec2(kMapShare_m, 0.1f)) + 0.01f);
            EXPECT_NEAR(glm::dot(lens_m, light.axis_w), 0.1f, 0.011f);
        }
    // With pan, too, nothing but the pivot stays.
    const string pan = channel("101", "Pan", function("Pan", "Pan", 0, -90, 90), "Base");
    EXPECT_EQ(emitters_in(cells_type(bar(20, 1.2f, narrow), tilt + pan, "", "<Axis Name=\"Head\">"))
                  .places_m.size(),
              1u);
}

TEST(BeamGroups, MapsAreFoundByTheirPlaces) {
    CellSpec narrow;
    narrow.beam_deg = narrow.field_deg = 5;
    const auto type = cells_type(bar(48, 1.2f, narrow));
    Hall hall(type);
    const std::vector<DistancePlace> places = distance_places(hall.show, 64);
    ASSERT_EQ(places.size(), 3u);
    std::set<std::filesystem::path> files;
    DistanceMaps maps;
    for (const DistancePlace& place : places) {
        files.insert(place.file);
        maps.maps.push_back({place.fixture, place.stop, place.place, place.position_m, {}});
    }
    EXPECT_EQ(files.size(), 3u);
    for (const shared::Light& light : hall.lit(Cells::grouped, maps).lights) {
        ASSERT_GT(light.map, 0u);
        const vec3 made_m = maps.maps[light.map - 1].position_m;
        expect_within(light.position_m - light.off_map_m, made_m, 1e-4f);
        for (const DistanceMap& map : maps.maps)
            EXPECT_LE(glm::distance(lens_of(light), made_m),
                      glm::distance(lens_of(light), map.position_m) + 0.02f);
    }
    maps.maps.pop_back();
    const std::vector<shared::Light> fewer = hall.lit(Cells::grouped, maps).lights;
    EXPECT_EQ(std::count_if(fewer.begin(), fewer.end(), [](const auto& light) { return light.map == 0; }), 2);
}

// What grouping costs: illuminance on a wall against the cells one by one, at the distance of the rule and
// nearer.
TEST(BeamGroups, HowFarAGroupIsFromItsCells) {
    for (const float beam_deg : {5.0f, 40.0f}) {
        CellSpec spec;
        spec.beam_deg = beam_deg;
        spec.field_deg = 1.6f * beam_deg;
        const float reach_m = kMergeShare * kMergeDistance_m * std::tan(glm::radians(0.5f * beam_deg));
        Hall hall(cells_type(bar(24, 1.98f * reach_m, spec))); // as long as one group may be
        hall.show.fixtures[0].rotation_deg = {0, 0, 0};
        const FrameLights grouped = hall.lit(), apart = hall.lit(Cells::apart);
        ASSERT_EQ(grouped.lights.size(), 1u);
        for (const float distance_m : {2.5f, 5.0f, 10.0f}) {
            const auto lux = [&](const std::vector<shared::Light>& lights, const vec3& place_m) {
                float sum = 0;
                for (const shared::Light& light : lights) {
                    const vec3 way = place_m - light.position_m;
                    const float squared = glm::dot(way, way);
                    const vec3 candela =
                        shared::beam_candela(light, shared::to_gate(light, way), hall.gobos.images);
                    sum += candela.y * -way.z / (squared * std::sqrt(squared));
                }
                return sum;
            };
            double worst = 0, difference = 0, all = 0, peak = 0;
            const float half_m = 2.0f * distance_m * std::tan(glm::radians(0.5f * beam_deg));
            for (int y = -20; y <= 20; ++y)
                for (int x = -20; x <= 20; ++x) {
                    const vec3 place_m(1 + half_m * static_cast<float>(x) / 20,
                                       2 + half_m * static_cast<float>(y) / 20, 6 - distance_m);
                    const double one = lux(grouped.lights, place_m), many = lux(apart.lights, place_m);
                    worst = std::max(worst, std::abs(one - many));
                    peak = std::max(peak, many);
                    difference += one - many;
                    all += many;
                }
            std::printf("beam of %.0f degrees, group of %.2f m, wall at %.1f m: worst %.1f %% of the peak, "
                        "sum %+.2f %%\n",
                        double{beam_deg}, 2.0 * double{reach_m}, double{distance_m}, 100 * worst / peak,
                        100 * difference / all);
            EXPECT_LT(worst / peak, distance_m < 5 ? 0.35 : distance_m < 10 ? 0.08 : 0.03);
            EXPECT_NEAR(difference / all, 0.0, distance_m < 5 ? 0.03 : 0.005);
        }
    }
}

TEST(BeamGroups, ExplainKnowsCells) {
    trial::Trial one(cells_type(bar(8, 0.4f)));
    for (int c = 1; c <= 24; ++c) one.set(c, 255);
    one.set(13, 0).set(14, 0).set(15, 0);
    const Explanation whole = one.explain();
    ASSERT_EQ(whole.beams.size(), 8u);
    EXPECT_EQ(whole.beams[4].grouped, 8);
    EXPECT_EQ(whole.beams[4].output_lm, 0.0f);
    EXPECT_NEAR(whole.beams[3].output_lm, 100.0f, 1.0f);
    EXPECT_NE(words_of(whole, one.reception).find("part of one light for 8 cells"), string::npos);

    one.beam = 4; // "Lamp/Cell 5"
    const Explanation dark = one.explain();
    EXPECT_EQ(dark.fixture, "Lamp/Cell 5");
    EXPECT_EQ(dark.main_beam, 4);
    EXPECT_EQ(dark.visibility, Visibility::dark);
    EXPECT_EQ(dark.cause, Cause::emitters);
    one.beam = 5;
    EXPECT_EQ(one.explain().visibility, Visibility::lit);

    CellSpec glow;
    glow.type = "None";
    trial::Trial none(cells_type(bar(4, 0.2f, glow)));
    for (int c = 1; c <= 12; ++c) none.set(c, 255);
    const Explanation glowing = none.explain();
    EXPECT_TRUE(glowing.beams[0].glows);
    EXPECT_FALSE(glowing.beams[0].hit.has_value());
    EXPECT_EQ(glowing.visibility, Visibility::lit);
    EXPECT_NE(glowing.verdict.find("it glows and throws no beam"), string::npos) << glowing.verdict;
}

} // namespace
} // namespace ghost::scene
