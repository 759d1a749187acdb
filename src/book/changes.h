#pragma once
// SPDX-License-Identifier: Apache-2.0
// What changed between two moments of a show, in words: "Spot 1-8: 0 to 80 %, gobo open to slot 3 'Congo'".
// Fixtures that change alike are one line, most light first; what is below 1 % or half a degree is no change.
// Pure, any thread.

#include "book/fixture_values.h"
#include "print/print_style.h"

#include <string>
#include <vector>

namespace ghost::scene {

struct SceneLook; // show/looks.h
struct Show;      // show/show.h

struct BookChange {
    std::vector<std::string>
        fixtures;     // names, in the order of the show; none: the air, the even light, a machine
    std::string what; // "0 to 80 %, moves"

    // With the names, those that count on as one: "Spot 1-8: 0 to 80 %".
    std::string line(const PrintStyle& style = {}) const;
    bool operator==(const BookChange&) const = default;
};

// "": nothing. Of a fixture that is dark before and after what it does there is told in a word.
std::string change_of(const FixtureValues& before, const FixtureValues& after, const PrintStyle& style = {});

// values: one for each of the show's fixtures.
std::vector<BookChange> changes_of(const Show& show, const std::vector<FixtureValues>& before,
                                   const std::vector<FixtureValues>& after, const PrintStyle& style = {});

// Of the air, the even light, and how light falls off and throws shadows, as a look sets them.
std::vector<BookChange> changes_of(const Show& show, const SceneLook& before, const SceneLook& after,
                                   const PrintStyle& style = {});

// Of machines: values of all axes of each of the show's movers.
std::vector<BookChange> changes_of(const Show& show, const std::vector<std::vector<float>>& before,
                                   const std::vector<std::vector<float>>& after,
                                   const PrintStyle& style = {});

} // namespace ghost::scene
