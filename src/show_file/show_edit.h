#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of show.toml as text: what an edit is not about stays byte for byte, comments and order too, so that
// people and programs can work on one file. Each function gives the whole new text; it has been read again
// and says what was asked for and nothing else. Units as in docs/reference/show-file.md. Pure unless said,
// any thread.

#include "base/report.h"
#include "base/result.h"
#include "fixture/patch.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ghost::scene {

struct Camera;
struct PatchedFixture;
struct Show;

// Which one: the number-th [[fixture]], which is Show::fixtures[number], or, where uuid says so, an object of
// the plot, which gets a [[change]].
struct FixturePlace {
    std::size_t number = 0;
    std::string uuid;
};
FixturePlace place_of(const PatchedFixture& fixture, std::size_t index);

// What is set is written, anything else stays.
struct FixtureEdit {
    std::optional<std::string> name;
    std::optional<std::string> mode;
    std::optional<fixture::Address> address; // of break 1; channel 0: not patched
    std::optional<glm::vec3> position_m;
    std::optional<glm::vec3> rotation_deg;
    std::optional<bool> hidden; // objects of the plot only
};

struct NewFixture {
    std::string gdtf; // as it shall be written
    FixtureEdit keys;
};

// Error, of all of them: no TOML, no such [[fixture]], one written as an inline table or in another way that
// cannot be edited; the text then stays as it is.
Result<std::string> edit_fixtures(const std::string& text,
                                  const std::vector<std::pair<FixturePlace, FixtureEdit>>& edits);
// Puts a copy with all its keys behind the fixture itself, then edits it.
Result<std::string> copy_fixture(const std::string& text, std::size_t number, const FixtureEdit& edit);
// Behind the last [[fixture]].
Result<std::string> add_fixture(const std::string& text, const NewFixture& fixture);
Result<std::string> remove_fixtures(const std::string& text, const std::vector<std::size_t>& numbers);

// At the end: a [[camera]] with its name, place, field of view, size and exposure.
Result<std::string> add_camera(const std::string& text, const Camera& camera);
// At the end: a [[model]] of that file, relative to the show, there.
Result<std::string> add_model(const std::string& text, const std::string& file, const glm::vec3& position_m);
// A text of [show]: its stage, its plot.
Result<std::string> set_of_show(const std::string& text, const std::string& key, const std::string& value);

// Whether two show files say the same but for [[fixture]], [[change]], [[cue]], [haze], [[hazer]] and
// [light], and [[palette]], which changes no picture. False where one is no TOML.
bool differ_in_fixtures_air_and_cues_only(const std::string& a, const std::string& b);

} // namespace ghost::scene
