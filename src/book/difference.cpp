// SPDX-License-Identifier: Apache-2.0
#include "book/difference.h"

#include "book/quantities.h"

#include <algorithm>
#include <map>
#include <set>

namespace ghost::scene {
namespace {

constexpr float kLeastMove_m = 0.01f;

std::string quoted(const std::string& name) {
    return "'" + name + "'";
}

std::string time_text(const BookEntry& entry) {
    return entry.at_s ? number_text(static_cast<float>(*entry.at_s), 2) + " s" : "no time";
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

void compare_entries(const Book& old, const Book& now, std::vector<std::string>& said) {
    std::map<std::string, std::size_t> known, present;
    for (std::size_t i = 0; i < old.entries.size(); ++i) known.try_emplace(old.entries[i].name, i);
    std::vector<std::size_t> places, both; // in the older book, in this one
    for (std::size_t i = 0; i < now.entries.size(); ++i) {
        const BookEntry& entry = now.entries[i];
        present.try_emplace(entry.name, i);
        const auto found = known.find(entry.name);
        if (found == known.end()) {
            said.push_back(quoted(entry.name) + " is new");
            continue;
        }
        places.push_back(found->second);
        both.push_back(i);
    }
    for (const BookEntry& entry : old.entries)
        if (!present.contains(entry.name)) said.push_back(quoted(entry.name) + " is gone");
    const std::set<std::size_t> kept = in_order(places);
    for (std::size_t k = 0; k < both.size(); ++k) {
        const BookEntry& entry = now.entries[both[k]];
        const BookEntry& before = old.entries[places[k]];
        if (!kept.contains(k))
            said.push_back(quoted(entry.name) + " moved in the list, from place " +
                           std::to_string(places[k] + 1) + " to " + std::to_string(both[k] + 1));
        if (entry.at_s != before.at_s)
            said.push_back(quoted(entry.name) + " is at " + time_text(entry) + ", was at " +
                           time_text(before));
        if (entry.look != before.look)
            said.push_back(quoted(entry.name) + " has the look " + quoted(entry.look) + ", had " +
                           quoted(before.look));
    }
}

std::string addresses_text(const BookFixture& fixture) {
    std::string text;
    for (const fixture::Address& address : fixture.addresses)
        text += (text.empty() ? "" : " + ") + address_text(address.universe, address.channel);
    return text;
}

bool are_equal(const fixture::Address& a, const fixture::Address& b) {
    return a.universe == b.universe && a.channel == b.channel;
}

// Lines of fixtures to which the same happened, in the order in which they come.
class Lines {
public:
    void add(const std::string& what, const std::string& name) {
        const auto [found, is_new] = known_.try_emplace(what, lines_.size());
        if (is_new) lines_.push_back({what, {}});
        lines_[found->second].names.push_back(name);
    }
    void say(std::vector<std::string>& said) const {
        for (const Line& line : lines_) said.push_back(names_text(line.names) + " " + line.what);
    }

private:
    struct Line {
        std::string what;
        std::vector<std::string> names;
    };
    std::vector<Line> lines_;
    std::map<std::string, std::size_t> known_;
};

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

void compare_fixtures(const Book& old, const Book& now, std::vector<std::string>& said) {
    const std::vector<const BookFixture*> before = older(old, now);
    const std::set<const BookFixture*> kept(before.begin(), before.end());
    Lines lines;
    for (std::size_t i = 0; i < now.fixtures.size(); ++i)
        if (!before[i]) lines.add("is new", now.fixtures[i].name);
    for (const BookFixture& fixture : old.fixtures)
        if (!kept.contains(&fixture)) lines.add("is gone", fixture.name);
    for (std::size_t i = 0; i < now.fixtures.size(); ++i) {
        if (!before[i]) continue;
        const BookFixture &fixture = now.fixtures[i], &was = *before[i];
        if (fixture.name != was.name) lines.add("was called " + quoted(was.name), fixture.name);
        const float way_m = glm::length(fixture.position_m - was.position_m);
        if (way_m >= kLeastMove_m) lines.add("moved by " + number_text(way_m, 2) + " m", fixture.name);
        if (!std::equal(fixture.addresses.begin(), fixture.addresses.end(), was.addresses.begin(),
                        was.addresses.end(), are_equal))
            lines.add("is patched at " + addresses_text(fixture) + ", was at " + addresses_text(was),
                      fixture.name);
        if (fixture.type != was.type || fixture.mode != was.mode)
            lines.add("is " + quoted(fixture.type) + " in mode " + quoted(fixture.mode) + ", was " +
                          quoted(was.type) + " in mode " + quoted(was.mode),
                      fixture.name);
    }
    lines.say(said);
}

} // namespace

BookDifference difference_of(const Book& old, const Book& now) {
    BookDifference difference;
    difference.old_name = old.show;
    compare_entries(old, now, difference.entries);
    compare_fixtures(old, now, difference.fixtures);
    if (old.device != now.device)
        difference.unknown.push_back("the older pictures were drawn by '" + old.device +
                                     "': what two devices draw differs a little by itself");
    if (old.ev100 != now.ev100)
        difference.unknown.push_back("the older pictures have exposure " + number_text(old.ev100, 2) +
                                     ", these " + number_text(now.ev100, 2) + ": all of them differ by that");
    return difference;
}

std::optional<std::size_t> entry_named(const Book& book, const std::string& name) {
    for (std::size_t i = 0; i < book.entries.size(); ++i)
        if (book.entries[i].name == name) return i;
    return std::nullopt;
}

} // namespace ghost::scene
