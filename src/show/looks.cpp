// SPDX-License-Identifier: Apache-2.0
#include "show/looks.h"

#include "base/suggest.h"
#include "base/text.h"
#include "disk/files.h"
#include "disk/user_file.h"
#include "json_xml_toml/toml_problem.h"
#include "json_xml_toml/toml_reader.h"
#include "json_xml_toml/toml_text.h"
#include "show/show.h"

#include <algorithm>
#include <set>
#include <type_traits>

namespace ghost::scene {
namespace {

constexpr std::size_t kMostFixtures = 65536; // of one look
constexpr double kMost_deg = 100000;         // as fixture::apply has it
constexpr double kMostLux = 100000;
constexpr double kMostSmoke = 20;
constexpr double kMostLamp = 1000;
constexpr double kLeastLamp_k = 1000, kMostLamp_k = 25000;
constexpr std::size_t kLongestName = 100;
constexpr std::size_t kMostLevels = 65536;
constexpr std::size_t kMostChannels = 4096;

void put(std::optional<float>& target, const std::optional<double>& value) {
    if (value) target = static_cast<float>(*value);
}

std::optional<std::pair<std::string, fixture::Programmer>>
read_fixture(const toml::table& table, const std::string& file, Report& report) {
    TableReader reader(table, "[[look.fixture]]", file, report);
    const auto name = reader.text("name");
    if (!reader.has("name")) reader.missing("name", "that of a fixture of the show");
    fixture::Programmer programmer;
    put(programmer.intensity, reader.number("intensity", 0, 1));
    programmer.colour = reader.light_colour("colour_rec2020");
    put(programmer.zoom_deg, reader.number("zoom_deg", 0, 180));
    put(programmer.pan_deg, reader.number("pan_deg", -kMost_deg, kMost_deg));
    put(programmer.tilt_deg, reader.number("tilt_deg", -kMost_deg, kMost_deg));
    programmer.gobo = reader.integer("gobo", 0, 255);
    programmer.gel = reader.light_colour("gel_rec2020");
    put(programmer.lamp, reader.number("lamp", 0, kMostLamp));
    put(programmer.lamp_k, reader.number("lamp_k", kLeastLamp_k, kMostLamp_k));
    programmer.levels = reader.bytes("levels", kMostLevels).value_or(std::vector<std::uint8_t>{});
    programmer.channels = reader.fractions("channels", kMostChannels);
    reader.finish();
    if (!name || programmer.is_empty()) return std::nullopt;
    return std::pair{*name, programmer};
}

std::optional<std::pair<std::string, std::vector<float>>>
read_mover(const toml::table& table, const std::string& file, Report& report) {
    TableReader reader(table, "[[look.mover]]", file, report);
    const auto name = reader.text("name");
    if (!reader.has("name")) reader.missing("name", "that of a mover of the show");
    const toml::array* const list = table["values"].as_array();
    const std::size_t count = std::clamp(list ? list->size() : 0, std::size_t{1}, kMostMoverAxes);
    const auto values = reader.numbers("values", count, -kMost_deg, kMost_deg);
    if (!reader.has("values")) reader.missing("values", "a number for each axis, in metres or degrees");
    reader.finish();
    if (!name || !values) return std::nullopt;
    return std::pair{*name, std::vector<float>(values->begin(), values->end())};
}

std::optional<StoredLook> read_look(const toml::table& table, const std::string& file, Report& report) {
    TableReader reader(table, "[[look]]", file, report);
    StoredLook look;
    const auto name = reader.text("name");
    if (!reader.has("name")) reader.missing("name", "what it is called; the look is left out");
    look.name = name.value_or("");
    const Result<void> good_name = name ? check_stored_name("look", look.name) : Result<void>();
    if (!good_name.ok()) reader.problem(Severity::error, "name", good_name.error().what);
    look.fade_s = static_cast<float>(reader.number("fade_s", 0, kLongestFade_s).value_or(0));
    put(look.scene.smoke, reader.number("smoke", 0, kMostSmoke));
    put(look.scene.ambient_lux, reader.number("ambient_lux", 0, kMostLux));
    look.scene.ambient_colour = reader.light_colour("ambient_rec2020");
    look.scene.attenuation = reader.light_colour("attenuation");
    if (look.scene.attenuation == glm::vec3(0)) {
        reader.problem(Severity::error, "attenuation", "is 0, 0, 0, expected one of the three above 0");
        look.scene.attenuation.reset();
    }
    look.scene.shadows = reader.boolean("shadows");
    for (const toml::table* fixture : reader.tables("fixture", kMostFixtures)) {
        auto one = read_fixture(*fixture, file, report);
        if (!one) continue;
        if (!look.fixtures.insert(std::move(*one)).second)
            report.add(Severity::error, file_line(file, static_cast<int>(fixture->source().begin.line)),
                       "[[look.fixture]] name is there twice in the look '" + look.name + "'");
    }
    for (const toml::table* mover : reader.tables("mover", kMostMovers)) {
        auto one = read_mover(*mover, file, report);
        if (one && !look.movers.insert(std::move(*one)).second)
            report.add(Severity::error, file_line(file, static_cast<int>(mover->source().begin.line)),
                       "[[look.mover]] name is there twice in the look '" + look.name + "'");
    }
    reader.finish();
    if (!name || !good_name.ok()) return std::nullopt;
    return look;
}

class Lines {
public:
    template <class T>
    void add(const char* key, const std::optional<T>& value) {
        if (!value) return;
        if constexpr (std::is_same_v<T, glm::vec3>)
            text += std::string(key) + " = [" + toml_text(value->x) + ", " + toml_text(value->y) + ", " +
                    toml_text(value->z) + "]\n";
        else if constexpr (std::is_same_v<T, bool>)
            text += std::string(key) + (*value ? " = true\n" : " = false\n");
        else if constexpr (std::is_same_v<T, int>)
            text += std::string(key) + " = " + std::to_string(*value) + "\n";
        else
            text += std::string(key) + " = " + toml_text(*value) + "\n";
    }
    void add(const char* key, const std::vector<std::uint8_t>& bytes) {
        if (bytes.empty()) return;
        text += std::string(key) + " = [";
        for (std::size_t k = 0; k < bytes.size(); ++k) text += (k > 0 ? ", " : "") + std::to_string(bytes[k]);
        text += "]\n";
    }
    void add(const char* key, const std::map<std::string, float>& shares) {
        if (shares.empty()) return;
        text += std::string(key) + " = {";
        for (const auto& [name, share] : shares)
            text += (text.back() == '{' ? " " : ", ") + toml_text(name) + " = " + toml_text(share);
        text += " }\n";
    }
    std::string text;
};

// Levels are of one mode; those of another one would mean something else.
bool fits(const fixture::Programmer& programmer, const PatchedFixture& fixture) {
    return programmer.levels.empty() ||
           (fixture.type && programmer.levels.size() == fixture::level_count(fixture.patch().mode_of()));
}

} // namespace

std::filesystem::path looks_file(const Show& show) {
    return show.folder / (show.cache_name.empty() ? "looks.toml" : show.cache_name + ".looks.toml");
}

Result<void> check_stored_name(const std::string& what, const std::string& name) {
    const bool printable = std::none_of(name.begin(), name.end(),
                                        [](char letter) { return static_cast<unsigned char>(letter) < 32; });
    if (!name.empty() && name.size() <= kLongestName && printable && name.front() != ' ' &&
        name.back() != ' ')
        return {};
    return Error{"'" + name.substr(0, kLongestName) + "' is no name of a " + what +
                     ", expected 1 to 100 bytes, no blanks at its ends",
                 ""};
}

Result<std::vector<StoredLook>> parse_looks(const std::string& text, const std::string& file,
                                            Report& report) {
    toml::table root;
    try {
        root = toml::parse(text, file);
    } catch (const toml::parse_error& problem) {
        const TomlProblem found = toml_problem(problem);
        return Error{found.what, file_line(file, found.line)};
    }
    std::vector<StoredLook> looks;
    std::set<std::string> names;
    TableReader top(root, "the file", file, report);
    for (const toml::table* table : top.tables("look", kMostLooks)) {
        auto look = read_look(*table, file, report);
        if (!look) continue;
        if (names.insert(look->name).second)
            looks.push_back(std::move(*look));
        else
            report.add(Severity::error, file_line(file, static_cast<int>(table->source().begin.line)),
                       "[[look]] name '" + look->name + "' is there twice; the first one is taken");
    }
    top.finish();
    return looks;
}

Result<std::vector<StoredLook>> load_looks(const std::filesystem::path& file, Report& report) {
    std::error_code code;
    if (!std::filesystem::exists(file, code)) return std::vector<StoredLook>{};
    TRY(const std::string text, read_text_file(file, kMostLooksBytes));
    return parse_looks(text, file.string(), report);
}

std::string text_of(const std::vector<StoredLook>& looks) {
    Lines lines;
    lines.text = "# Looks of a show, written by the window of ghostlight (docs/guide/window.md). Comments do "
                 "not stay.\n";
    for (const StoredLook& look : looks) {
        lines.text += "\n[[look]]\nname = " + toml_text(look.name) + "\n";
        if (look.fade_s > 0) lines.add("fade_s", std::optional(look.fade_s));
        lines.add("smoke", look.scene.smoke);
        lines.add("ambient_lux", look.scene.ambient_lux);
        lines.add("ambient_rec2020", look.scene.ambient_colour);
        lines.add("attenuation", look.scene.attenuation);
        lines.add("shadows", look.scene.shadows);
        for (const auto& [name, programmer] : look.fixtures) {
            lines.text += "\n[[look.fixture]]\nname = " + toml_text(name) + "\n";
            lines.add("intensity", programmer.intensity);
            lines.add("colour_rec2020", programmer.colour);
            lines.add("zoom_deg", programmer.zoom_deg);
            lines.add("pan_deg", programmer.pan_deg);
            lines.add("tilt_deg", programmer.tilt_deg);
            lines.add("gobo", programmer.gobo);
            lines.add("gel_rec2020", programmer.gel);
            lines.add("lamp", programmer.lamp);
            lines.add("lamp_k", programmer.lamp_k);
            lines.add("levels", programmer.levels);
            lines.add("channels", programmer.channels);
        }
        for (const auto& [name, values] : look.movers) {
            lines.text += "\n[[look.mover]]\nname = " + toml_text(name) + "\nvalues = [";
            for (std::size_t k = 0; k < values.size(); ++k)
                lines.text += (k > 0 ? ", " : "") + toml_text(values[k]);
            lines.text += "]\n";
        }
    }
    return lines.text;
}

Result<void> write_looks(const std::filesystem::path& file, const std::string& text) {
    if (text.size() > kMostLooksBytes)
        return Error{"would be " + std::to_string(text.size() >> 20) + " MiB, at most " +
                         std::to_string(kMostLooksBytes >> 20) + " are read again; remove a look first",
                     file.string()};
    return write_user_file(file, text);
}

Result<std::size_t> find_look(const std::vector<StoredLook>& looks, const std::string& name) {
    std::vector<std::string> names;
    for (const StoredLook& look : looks) {
        if (look.name == name) return names.size();
        names.push_back(look.name);
    }
    return Error{"there is no look '" + name + "'" + did_you_mean(name, names), ""};
}

std::map<std::size_t, fixture::Programmer> programmer_of(const StoredLook& look, const Show& show) {
    std::map<std::size_t, fixture::Programmer> programmer;
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        auto found = look.fixtures.find(show.fixtures[i].name);
        if (found == look.fixtures.end() && !show.fixtures[i].written_name.empty())
            found = look.fixtures.find(show.fixtures[i].written_name);
        if (found == look.fixtures.end()) continue;
        fixture::Programmer one = found->second;
        if (!fits(one, show.fixtures[i])) one.levels.clear();
        if (!one.is_empty()) programmer[i] = std::move(one);
    }
    return programmer;
}

std::map<std::size_t, std::vector<float>> movers_of(const StoredLook& look, const Show& show) {
    std::map<std::size_t, std::vector<float>> movers;
    for (std::size_t i = 0; i < show.movers.size(); ++i)
        if (const auto found = look.movers.find(show.movers[i].name);
            found != look.movers.end() && found->second.size() == show.movers[i].axes.size())
            movers[i] = found->second;
    return movers;
}

void check_look(const StoredLook& look, const Show& show, const std::string& file, Report& report) {
    std::vector<std::string> missing;
    for (const auto& [name, programmer] : look.fixtures)
        if (std::ranges::none_of(show.fixtures, [&](const PatchedFixture& fixture) {
                return fixture.name == name || (!name.empty() && fixture.written_name == name);
            }))
            missing.push_back(name);
    if (!missing.empty())
        report.add(Severity::warning, file,
                   "look '" + look.name +
                       "' has values for fixtures that the show does not have: " + name_list(missing));
    std::vector<std::string> strange;
    const auto movers = movers_of(look, show);
    for (const auto& [name, values] : look.movers)
        if (std::none_of(movers.begin(), movers.end(), [&, &called = name](const auto& one) {
                return show.movers[one.first].name == called;
            }))
            strange.push_back(name);
    if (!strange.empty())
        report.add(Severity::warning, file,
                   "look '" + look.name +
                       "' has values for movers that the show does not have, or not with as many axes: " +
                       name_list(strange));
    std::vector<std::string> others;
    for (const PatchedFixture& fixture : show.fixtures)
        if (const auto found = look.fixtures.find(fixture.name);
            found != look.fixtures.end() && fixture.type && !fits(found->second, fixture))
            others.push_back(fixture.name);
    if (!others.empty())
        report.add(Severity::warning, file,
                   "look '" + look.name +
                       "' has levels of another mode, which are left out (store it again) for: " +
                       name_list(others));
    for (const auto& [name, programmer] : look.fixtures) {
        const auto fixture = std::ranges::find(show.fixtures, name, &PatchedFixture::name);
        if (!programmer.gobo || fixture == show.fixtures.end() || !fixture->type) continue;
        const auto slots = static_cast<int>(fixture::gobo_names(fixture->patch()).size());
        if (*programmer.gobo < std::max(slots, 1)) continue;
        report.add(
            Severity::warning, file,
            "look '" + look.name + "': gobo " + std::to_string(*programmer.gobo) + " of '" + name + "', " +
                (slots > 0 ? "whose wheel has 0 to " + std::to_string(slots - 1) + "; it shows the last one"
                           : "which has no gobo wheel"));
    }
}

} // namespace ghost::scene
