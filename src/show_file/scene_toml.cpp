// SPDX-License-Identifier: Apache-2.0
#include "show_file/scene_toml.h"

#include "passes/distance_maps.h"
#include "shared/air.h"
#include "shared/develop.h"
#include "show/haze_presets.h"
#include "show/show.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <utility>

namespace ghost::scene {
namespace {

constexpr double kMaxExtinction_per_m = 10;
constexpr float kOpaque_per_m = 1; // nothing is seen through this on a stage
constexpr double kMaxMilligrams_per_m3 = 1000;
constexpr std::size_t kMaxHazers = shared::kMostHazers;
constexpr std::size_t kMaxObjects = 1000;

void put_number(float& target, const std::optional<double>& value) {
    if (value) target = static_cast<float>(*value);
}

void put_number(std::optional<float>& target, const std::optional<double>& value) {
    if (value) target = static_cast<float>(*value);
}

void read_scene(const toml::table& table, const std::string& file, const std::string& ambient_where,
                Show& show, Report& report) {
    TableReader reader(table, "[scene]", file, report);
    const auto intensity = reader.number("intensity", 0, kMaxAmbient_lux);
    if (intensity && !ambient_where.empty())
        report.add(Severity::warning, ambient_where,
                   "[show] ambient_lux is not used: [scene] intensity (line " +
                       std::to_string(reader.line_of("intensity")) + ") says the same");
    put_number(show.ambient_lux, intensity);
    if (const auto colour = reader.colour("colour")) {
        const float luminance = shared::luminance_of(*colour);
        if (luminance <= 0.0f)
            reader.problem(
                Severity::error, "colour",
                "is black, expected the colour of some light; it stays white. intensity = 0 turns it "
                "off");
        else
            show.ambient_colour = *colour / luminance;
        if (!intensity && ambient_where.empty() && !reader.has("intensity"))
            reader.problem(Severity::warning, "colour", "colours nothing: intensity (lux) is missing");
    }
    reader.finish();
}

// The most exact of the ways to say how thick it is wins.
void read_density(TableReader& reader, HazeMedium& haze) {
    const auto from_milligrams = [&](const std::string& key) {
        auto value = reader.number(key, 0, kMaxMilligrams_per_m3);
        if (value) *value *= kExtinctionPerMilligram;
        return value;
    };
    std::optional<double> of_preset;
    if (const auto name = reader.text("preset")) {
        if (const HazePreset* preset = find_haze_preset(*name))
            of_preset = preset->extinction_per_m();
        else
            reader.problem(Severity::error, "preset", no_such_haze_preset(*name));
    }
    const std::pair<std::string, std::optional<double>> ways[] = {
        {"extinction_per_m", reader.number("extinction_per_m", 0, kMaxExtinction_per_m)},
        {"milligrams_per_m3", from_milligrams("milligrams_per_m3")},
        {"concentration_mg_per_m3", from_milligrams("concentration_mg_per_m3")},
        {"preset", of_preset},
    };
    std::string used;
    for (const auto& [key, extinction] : ways) {
        if (!extinction) continue;
        if (used.empty()) {
            used = key;
            put_number(haze.extinction_per_m, extinction);
        } else {
            reader.problem(Severity::warning, key, "is not used: " + used + " is there, too");
        }
    }
    if (const auto intensity = reader.number("intensity", 0, 10))
        haze.extinction_per_m = static_cast<float>(
            std::min(static_cast<double>(haze.extinction_per_m) * *intensity, kMaxExtinction_per_m));
    if (haze.extinction_per_m > kOpaque_per_m)
        reader.problem(Severity::warning, used.empty() ? "intensity" : used,
                       "is denser than any fog: half of all light is gone after " +
                           std::to_string(std::lround(69.3 / static_cast<double>(haze.extinction_per_m))) +
                           " cm");
}

void read_haze(const toml::table& table, const std::string& file, HazeMedium& haze, Report& report) {
    TableReader reader(table, "[haze]", file, report);
    read_density(reader, haze);
    put_number(haze.albedo, reader.number("albedo", 0, 1));
    put_number(haze.forward_g, reader.number("forward_g", -0.99, 0.99));
    put_number(haze.back_g, reader.number("back_g", -0.99, 0.99));
    put_number(haze.back_weight, reader.number("back_weight", 0, 1));
    put_number(haze.unevenness, reader.number("unevenness", 0, 1));
    put_number(haze.patch_m, reader.number("patch_m", 0.1, 100));
    haze.wind_m_s = reader.vec3("wind_m_s", 20).value_or(haze.wind_m_s);
    reader.finish();
}

std::optional<Hazer> read_hazer(const toml::table& table, const std::string& file, Report& report) {
    TableReader reader(table, "[[hazer]]", file, report);
    Hazer hazer;
    const auto position = reader.vec3("position_m", kMaxCoordinate_m);
    if (!reader.has("position_m"))
        reader.missing("position_m", "where its nozzle is, [x, y, z]; the hazer is left out");
    hazer.position_m = position.value_or(hazer.position_m);
    if (const auto direction = reader.vec3("direction", 1000)) {
        if (glm::length(*direction) < 1e-3f)
            reader.problem(Severity::error, "direction",
                           "has no length, expected where the haze is blown; it goes up");
        else
            hazer.direction = glm::normalize(*direction);
    }
    put_number(hazer.rate, reader.number("rate", 0, 1000));
    put_number(hazer.spread_deg, reader.number("spread_deg", 1, 180));
    put_number(hazer.reach_m, reader.number("reach_m", 0.1, 1000));
    reader.finish();
    if (!position) return std::nullopt;
    return hazer;
}

void read_light(const toml::table& table, const std::string& file, BounceDetail& bounce, Report& report) {
    TableReader reader(table, "[light]", file, report);
    if (const auto name = reader.text("bounce")) {
        if (const auto detail = find_bounce_detail(*name))
            bounce = *detail;
        else
            reader.problem(Severity::error, "bounce", no_such_bounce_detail(*name));
    }
    reader.finish();
}

void read_attenuation(const toml::table& table, const std::string& file, Attenuation& attenuation,
                      Report& report) {
    TableReader reader(table, "[attenuation]", file, report);
    Attenuation read;
    put_number(read.constant, reader.number("constant", 0, 1000));
    put_number(read.linear, reader.number("linear", 0, 1000));
    put_number(read.quadratic, reader.number("quadratic", 0, 1000));
    if (read.constant + read.linear + read.quadratic > 0.0f)
        attenuation = read;
    else
        reader.problem(
            Severity::error, "quadratic",
            "is 0 as constant and linear are, expected one of the three above 0; light falls off with "
            "the square of the distance");
    reader.finish();
}

void read_shadows(const toml::table& table, const std::string& file, Show& show, Report& report) {
    TableReader reader(table, "[shadows]", file, report);
    if (const auto on = reader.boolean("on")) show.shadows = *on;
    show.distance_map_size =
        reader.integer("map_size", kMinDistanceMapSize, kMaxDistanceMapSize).value_or(show.distance_map_size);
    // Maps are halved where memory is short.
    const auto side = static_cast<unsigned>(show.distance_map_size);
    if (side > 0 && !std::has_single_bit(side)) {
        show.distance_map_size = static_cast<int>(std::bit_floor(side));
        reader.problem(Severity::warning, "map_size",
                       std::to_string(side) + " is not a power of two; " +
                           std::to_string(show.distance_map_size) + " is taken");
    }
    reader.finish();
}

void read_diffuse(TableReader& reader, ObjectSettings& object) {
    if (reader.is_number("diffuse"))
        put_number(object.diffuse_factor, reader.number("diffuse", 0, 100));
    else
        object.diffuse = reader.colour("diffuse");
}

std::optional<ObjectSettings> read_object(const toml::table& table, const std::string& file, Report& report) {
    TableReader reader(table, "[[object]]", file, report);
    ObjectSettings object;
    const auto name = reader.text("name");
    if (!reader.has("name"))
        reader.missing("name", "that of an object, mesh or material, with * and ? for any letters");
    object.name = name.value_or("");
    object.where = reader.where("name");
    read_diffuse(reader, object);
    put_number(object.specular, reader.number("specular", 0, 1));
    const auto shininess = reader.number("shininess", 1, 10'000);
    if (shininess) object.roughness = roughness_from_shininess(static_cast<float>(*shininess));
    const auto roughness = reader.number("roughness", 0, 1);
    put_number(object.roughness, roughness);
    if (shininess && roughness)
        reader.problem(Severity::warning, "shininess", "is not used: roughness is there, too");
    put_number(object.metalness, reader.number("metalness", 0, 1));
    object.shown = reader.boolean("shown");
    object.move_m = reader.vec3("move_m", kMaxCoordinate_m);
    if (name && table.size() == 1)
        reader.problem(
            Severity::warning, "name",
            "'" + name->substr(0, 40) +
                "' says nothing about the object, expected diffuse, specular, shininess, roughness, "
                "metalness, shown or move_m");
    reader.finish();
    if (!name) return std::nullopt;
    return object;
}

} // namespace

void read_scene_sections(TableReader& top, const std::string& file, const std::string& ambient_where,
                         Show& show, Report& report) {
    if (const toml::table* table = top.table("scene")) read_scene(*table, file, ambient_where, show, report);
    if (const toml::table* table = top.table("haze")) read_haze(*table, file, show.haze, report);
    for (const toml::table* table : top.tables("hazer", kMaxHazers))
        if (const auto hazer = read_hazer(*table, file, report)) show.hazers.push_back(*hazer);
    if (const toml::table* table = top.table("light")) read_light(*table, file, show.bounce, report);
    if (const toml::table* table = top.table("attenuation"))
        read_attenuation(*table, file, show.attenuation, report);
    if (const toml::table* table = top.table("shadows")) read_shadows(*table, file, show, report);
    for (const toml::table* table : top.tables("object", kMaxObjects))
        if (auto object = read_object(*table, file, report)) show.objects.push_back(std::move(*object));
}

} // namespace ghost::scene
