// SPDX-License-Identifier: Apache-2.0
#include "book/difference.h"

#include "book/private/paper_tables.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <set>

namespace ghost::scene {
namespace {

constexpr float kLeastMove_m = 0.01f;
constexpr float kOtherwise_deg = 0.5f;

std::string quoted(const std::string& name) {
    return "'" + name + "'";
}

std::string time_text(const BookEntry& entry, const PrintStyle& style) {
    return entry.at_s ? style.number(*entry.at_s, 2) + " s" : style("no time");
}

// Places of the longest row that stays in order: the others are those that moved.
std::set<std::size_t> in_order(const std::vector<std::size_t>& numbers) {
    constexpr std::size_t kNone = ~std::size_t{0};
    std::vector<std::size_t> ends, before(numbers.size(), kNone); // ends[k]: of the rows of k + 1, by place
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto place =
            std::lower_bound(ends.begin(), ends.end(), numbers[i],
                             [&](std::size_t at, std::size_t number) { return numbers[at] < number; });
        if (place != ends.begin()) before[i] = *(place - 1);
        if (place == ends.end())
            ends.push_back(i);
        else
            *place = i;
    }
    std::set<std::size_t> kept;
    for (std::size_t at = ends.empty() ? kNone : ends.back(); at != kNone; at = before[at]) kept.insert(at);
    return kept;
}

void compare_entries(const Book& old, const Book& now, const PrintStyle& style,
                     std::vector<std::string>& said) {
    const std::vector<std::optional<std::size_t>> before = older_entries(old, now);
    std::set<std::size_t> stayed;          // of the older book
    std::vector<std::size_t> places, both; // in the older book, in this one
    for (std::size_t i = 0; i < now.entries.size(); ++i) {
        if (!before[i]) {
            said.push_back(style("%1 is new", {quoted(now.entries[i].name)}));
            continue;
        }
        stayed.insert(*before[i]);
        places.push_back(*before[i]);
        both.push_back(i);
    }
    for (std::size_t i = 0; i < old.entries.size(); ++i)
        if (!stayed.contains(i)) said.push_back(style("%1 is gone", {quoted(old.entries[i].name)}));
    const std::set<std::size_t> kept = in_order(places);
    for (std::size_t k = 0; k < both.size(); ++k) {
        const BookEntry& entry = now.entries[both[k]];
        const BookEntry& was = old.entries[places[k]];
        if (entry.name != was.name)
            said.push_back(style("%1 was called %2", {quoted(entry.name), quoted(was.name)}));
        if (entry.number != was.number)
            said.push_back(style("%1 has the number %2, had %3",
                                 {quoted(entry.name), quoted(entry.number), quoted(was.number)}));
        if (!kept.contains(k))
            said.push_back(
                style("%1 moved in the list, from place %2 to %3",
                      {quoted(entry.name), std::to_string(places[k] + 1), std::to_string(both[k] + 1)}));
        if (entry.at_s != was.at_s)
            said.push_back(style("%1 is at %2, was at %3",
                                 {quoted(entry.name), time_text(entry, style), time_text(was, style)}));
        if (entry.look != was.look)
            said.push_back(style("%1 has the look %2, had %3",
                                 {quoted(entry.name), quoted(entry.look), quoted(was.look)}));
    }
}

std::string addresses_text(const BookFixture& fixture, const PrintStyle& style) {
    std::string text;
    for (const fixture::Address& address : fixture.addresses)
        text += (text.empty() ? "" : " + ") + said_address(style, address.universe, address.channel);
    return text.empty() ? style("not known") : text;
}

bool are_equal(const fixture::Address& a, const fixture::Address& b) {
    return a.universe == b.universe && a.channel == b.channel;
}

// Lines of fixtures to which the same happened, in the order in which they come. What happened begins with
// "%1", where their names go.
class Lines {
public:
    void add(const std::string& what, const std::string& name) {
        const auto [found, is_new] = known_.try_emplace(what, lines_.size());
        if (is_new) lines_.push_back({what, {}});
        lines_[found->second].names.push_back(name);
    }
    void say(const PrintStyle& style, std::vector<std::string>& said) const {
        for (const Line& line : lines_) said.push_back(names_text(line.names, style) + line.what.substr(2));
    }

private:
    struct Line {
        std::string what;
        std::vector<std::string> names;
    };
    std::vector<Line> lines_;
    std::map<std::string, std::size_t> known_;
};

// The angle of the one turn that leads from one to the other.
float turned_deg(const glm::vec3& from_deg, const glm::vec3& to_deg) {
    const glm::mat3 between =
        glm::transpose(glm::mat3(placed(glm::vec3(0), from_deg))) * glm::mat3(placed(glm::vec3(0), to_deg));
    const float trace = between[0][0] + between[1][1] + between[2][2];
    return glm::degrees(std::acos(std::clamp((trace - 1) / 2, -1.0f, 1.0f)));
}

std::string key_of(const BookFixture& fixture, bool by_uuid) {
    return by_uuid && !fixture.uuid.empty() ? "uuid " + fixture.uuid : "name " + fixture.name;
}

// For each fixture of this book the older one, or null. A UUID that the older book does not have is a new
// object, unless its name is known.
std::vector<const BookFixture*> older(const Book& old, const Book& now) {
    std::map<std::string, const BookFixture*> known;
    for (const bool by_uuid : {true, false})
        for (const BookFixture& fixture : old.fixtures) known.try_emplace(key_of(fixture, by_uuid), &fixture);
    std::vector<const BookFixture*> found(now.fixtures.size(), nullptr);
    std::set<const BookFixture*> taken;
    for (const bool by_uuid : {true, false})
        for (std::size_t i = 0; i < now.fixtures.size(); ++i) {
            const auto one = known.find(key_of(now.fixtures[i], by_uuid));
            if (!found[i] && one != known.end() && taken.insert(one->second).second) found[i] = one->second;
        }
    return found;
}

void compare_fixtures(const Book& old, const Book& now, const PrintStyle& style,
                      std::vector<std::string>& said) {
    const std::vector<const BookFixture*> before = older(old, now);
    const std::set<const BookFixture*> kept(before.begin(), before.end());
    Lines lines;
    for (std::size_t i = 0; i < now.fixtures.size(); ++i)
        if (!before[i]) lines.add(style("%1 is new", {"%1"}), now.fixtures[i].name);
    for (const BookFixture& fixture : old.fixtures)
        if (!kept.contains(&fixture)) lines.add(style("%1 is gone", {"%1"}), fixture.name);
    for (std::size_t i = 0; i < now.fixtures.size(); ++i) {
        if (!before[i]) continue;
        const BookFixture &fixture = now.fixtures[i], &was = *before[i];
        if (fixture.name != was.name)
            lines.add(style("%1 was called %2", {"%1", quoted(was.name)}), fixture.name);
        const bool are_placed = fixture.position_m && was.position_m;
        const float way_m = are_placed ? glm::length(*fixture.position_m - *was.position_m) : 0;
        if (fixture.position_m && !was.position_m)
            lines.add(style("%1 has a place, which was not known", {"%1"}), fixture.name);
        if (!fixture.position_m && was.position_m)
            lines.add(style("%1 has no place any more that is known", {"%1"}), fixture.name);
        if (way_m >= kLeastMove_m)
            lines.add(style("%1 moved by %2", {"%1", style.length_said(static_cast<double>(way_m))}),
                      fixture.name);
        if (fixture.rotation_deg && was.rotation_deg)
            if (const float turn_deg = turned_deg(*was.rotation_deg, *fixture.rotation_deg);
                turn_deg >= kOtherwise_deg)
                lines.add(style("%1 hangs otherwise, turned by %2 deg",
                                {"%1", style.number(static_cast<double>(turn_deg), 1)}),
                          fixture.name);
        if (!std::equal(fixture.addresses.begin(), fixture.addresses.end(), was.addresses.begin(),
                        was.addresses.end(), are_equal))
            lines.add(style("%1 is patched at %2, was at %3",
                            {"%1", addresses_text(fixture, style), addresses_text(was, style)}),
                      fixture.name);
        if (fixture.type != was.type || fixture.mode != was.mode)
            lines.add(
                style("%1 is %2 in mode %3, was %4 in mode %5",
                      {"%1", quoted(fixture.type), quoted(fixture.mode), quoted(was.type), quoted(was.mode)}),
                fixture.name);
    }
    lines.say(style, said);
    if (std::any_of(old.fixtures.begin(), old.fixtures.end(),
                    [](const BookFixture& fixture) { return !fixture.rotation_deg; }))
        said.push_back(style(
            "whether a fixture hangs otherwise is not known: the older book does not say how they hang"));
}

std::set<std::string> cameras_of(const Book& book) {
    std::set<std::string> names;
    for (const BookEntry& entry : book.entries)
        for (const BookPicture& picture : entry.pictures) names.insert(picture.camera);
    return names;
}

// What is in both books follows each other in both.
bool is_one_order(const std::vector<std::optional<std::size_t>>& older) {
    std::optional<std::size_t> before;
    for (const std::optional<std::size_t>& place : older) {
        if (!place) continue;
        if (before && *place != *before + 1) return false;
        before = place;
    }
    return true;
}

} // namespace

BookDifference difference_of(const Book& old, const Book& now, const PrintStyle& style) {
    BookDifference difference;
    difference.old_name = old.show;
    compare_entries(old, now, style, difference.entries);
    if (old.is_for_client)
        difference.fixtures.push_back(
            style("the older one is a tour, which names no fixtures: they are not compared"));
    else
        compare_fixtures(old, now, style, difference.fixtures);
    if (old.device != now.device)
        difference.unknown.push_back(
            style("the older pictures were drawn by '%1': what two devices draw differs a little by itself",
                  {old.device}));
    if (old.is_for_client || cameras_of(old) != cameras_of(now) || !is_one_order(older_entries(old, now)))
        difference.unknown.push_back(
            style("the older pictures were drawn in another order: where one is drawn after another one "
                  "it may round otherwise, which is not seen"));
    if (old.ev100 != now.ev100)
        difference.unknown.push_back(
            style("the older pictures have exposure %1, these %2: all of them differ by that",
                  {style.number(static_cast<double>(old.ev100), 2),
                   style.number(static_cast<double>(now.ev100), 2)}));
    return difference;
}

std::vector<std::optional<std::size_t>> older_entries(const Book& old, const Book& now) {
    std::vector<std::optional<std::size_t>> found(now.entries.size());
    std::vector<bool> taken(old.entries.size(), false);
    for (std::string BookEntry::*key : {&BookEntry::number, &BookEntry::name}) {
        std::multimap<std::string, std::size_t> known;
        for (std::size_t i = 0; i < old.entries.size(); ++i)
            if (!taken[i] && !(old.entries[i].*key).empty()) known.emplace(old.entries[i].*key, i);
        for (std::size_t i = 0; i < now.entries.size(); ++i) {
            const auto one = found[i] ? known.end() : known.find(now.entries[i].*key);
            if (one == known.end()) continue;
            found[i] = one->second;
            taken[one->second] = true;
            known.erase(one);
        }
    }
    return found;
}

} // namespace ghost::scene
