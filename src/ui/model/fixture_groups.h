#pragma once
// SPDX-License-Identifier: Apache-2.0
// Fixture groups: fixtures that belong together: of one type, in one layer of the plot, under one truss, and
// those that are dark for one reason. Pure.

#include "link/link.h"

#include <QString>

#include <set>
#include <vector>

namespace ghost::scene {
struct PatchedFixture;
struct Show;
} // namespace ghost::scene

namespace ghost::ui {

struct FixtureGroup {
    QString title; // "Type: VL2500 Spot"
    std::set<std::size_t> fixtures;
};
// By type, then layer, then truss; each by its name.
std::vector<FixtureGroup> groups_of(const scene::Show& show, const std::vector<Object>& objects);
// What does not shine, the most frequent reason first.
std::vector<FixtureGroup> dark_groups_of(const std::vector<Verdict>& verdicts);
// Why no head shines whatever it is told: a black-out, a master at nothing; "": nothing holds them back.
QString held_back(const ViewRequest& request, const RemoteNow& remote);
// The same of one head, for others are solo, too.
QString held_back(const ViewRequest& request, const RemoteNow& remote, const Look& look, std::size_t fixture);
// Fixtures that shine by a beam that was assumed, for their file has none, or not at all, for it cannot be
// read, by the file that a [[substitute]] would be for.
// It has a beam, of its own or an assumed one.
bool can_shine(const scene::PatchedFixture& fixture);
std::vector<FixtureGroup> without_optics(const scene::Show& show);

} // namespace ghost::ui
