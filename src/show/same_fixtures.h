#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which fixture of one show is which of another: of its text before or after an edit, of its next version, or
// of what was made of its plot. One is the same where it is the same object of a plot; without a plot, where
// it has the same name, or is one that was renamed: of the same file, and of the same number where no fixture
// came or went, or the only one at that address and place. Pure, any thread.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct PatchedFixture; // show/show.h
struct Show;

// From the name that a fixture had to the one that it has.
using FixtureNames = std::map<std::string, std::string>;

// By object or name alone.
bool is_same_fixture(const PatchedFixture& a, const PatchedFixture& b);

// For each fixture of `now` its index in `before`; each is one's alone.
std::vector<std::optional<std::size_t>> same_fixtures(const Show& before, const Show& now);

// Of fixtures that are the same: names that only the one and only the other show has.
FixtureNames renamed_fixtures(const Show& before, const Show& now);

} // namespace ghost::scene
