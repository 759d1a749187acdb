#pragma once
// SPDX-License-Identifier: Apache-2.0
// Looks: what hands set, kept under a name in a file beside the show (looks.toml, docs/guide/window.md):
// values of fixtures, air, even light and movers. Fixtures and movers go by name, so a look outlives edits of
// the patch. Metres, degrees, seconds, lux; colours linear Rec.2020. Values; any thread.

#include "base/report.h"
#include "base/result.h"
#include "fixture/programmer.h"

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;

inline constexpr std::size_t kMostLooks = 1000;
inline constexpr std::size_t kMostLooksBytes = std::size_t{16} << 20; // of their file
inline constexpr double kLongestFade_s = 3600;

// Instead of the show's [haze], [ambient], [attenuation] and [shadows].
struct SceneLook {
    std::optional<float> smoke; // times the show's extinction
    std::optional<float> ambient_lux;
    std::optional<glm::vec3> ambient_colour;
    std::optional<glm::vec3> attenuation; // constant, linear, quadratic
    std::optional<bool> shadows;

    bool operator==(const SceneLook&) const = default;
};

struct StoredLook {
    std::string name;
    float fade_s = 0; // of the crossfade when it is recalled
    SceneLook scene;
    std::map<std::string, fixture::Programmer> fixtures; // by name
    std::map<std::string, std::vector<float>> movers;    // by name: values of all their axes

    bool operator==(const StoredLook&) const = default;
};

// Beside the show; an .mvr that was opened as it is has one of its own.
std::filesystem::path looks_file(const Show& show);

// Error: no TOML, with its line. What is wrong with one look goes to the report, and the rest is kept.
Result<std::vector<StoredLook>> parse_looks(const std::string& text, const std::string& file, Report& report);
// None where there is no such file. Error: as above, or it cannot be read.
Result<std::vector<StoredLook>> load_looks(const std::filesystem::path& file, Report& report);
std::string text_of(const std::vector<StoredLook>& looks);
// Error: more than load_looks takes, or it cannot be written; what was there stays.
Result<void> write_looks(const std::filesystem::path& file, const std::string& text);

// what: "look", or what else is kept under a name. Error: what such a name must be.
Result<void> check_stored_name(const std::string& what, const std::string& name);
// Index of that look; the error lists a near name.
Result<std::size_t> find_look(const std::vector<StoredLook>& looks, const std::string& name);
// Of the fixtures that the show has, by index; levels whose number is not that of the fixture's mode are left
// out.
std::map<std::size_t, fixture::Programmer> programmer_of(const StoredLook& look, const Show& show);
// Of the movers that the show has, with as many axes, by index.
std::map<std::size_t, std::vector<float>> movers_of(const StoredLook& look, const Show& show);
// A warning where the look has values for fixtures or movers that the show has not, or levels of another
// mode. file: that the look is from.
void check_look(const StoredLook& look, const Show& show, const std::string& file, Report& report);

} // namespace ghost::scene
