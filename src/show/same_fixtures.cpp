// SPDX-License-Identifier: Apache-2.0
#include "show/same_fixtures.h"

#include "show/show.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace ghost::scene {
namespace {

// What a fixture keeps where it gets another name.
using Unnamed = std::tuple<std::string, std::string, int, int, float, float, float>;

Unnamed unnamed(const PatchedFixture& fixture) {
    return {fixture.uuid,         fixture.gdtf.string(), fixture.universe,    fixture.address,
            fixture.position_m.x, fixture.position_m.y,  fixture.position_m.z};
}

std::set<std::string> fixture_names(const Show& show) {
    std::set<std::string> names;
    for (const PatchedFixture& fixture : show.fixtures) names.insert(fixture.name);
    return names;
}

class Pairs {
public:
    Pairs(const Show& before, const Show& now)
        : before_(before.fixtures), now_(now.fixtures), is_taken_(before_.size()), same_(now_.size()) {}

    // Of the same object or name, in the first place that of the same number.
    void pair_known() {
        for (std::size_t i = 0; i < std::min(before_.size(), now_.size()); ++i)
            if (is_same_fixture(before_[i], now_[i])) pair(i, i);
        std::map<std::pair<bool, std::string>, std::size_t> left;
        const auto key = [](const PatchedFixture& fixture) {
            const bool has_object = !fixture.uuid.empty();
            return std::pair(has_object, has_object ? fixture.uuid : fixture.name);
        };
        for (std::size_t i = 0; i < before_.size(); ++i)
            if (!is_taken_[i]) left.try_emplace(key(before_[i]), i);
        for (std::size_t i = 0; i < now_.size(); ++i) {
            if (same_[i]) continue;
            const auto found = left.find(key(now_[i]));
            if (found != left.end() && !is_taken_[found->second]) pair(found->second, i);
        }
    }
    void pair_renamed() {
        for (std::size_t i = 0; before_.size() == now_.size() && i < now_.size(); ++i)
            if (!same_[i] && !is_taken_[i] && before_[i].uuid == now_[i].uuid &&
                before_[i].gdtf == now_[i].gdtf)
                pair(i, i);
        std::map<Unnamed, std::pair<std::vector<std::size_t>, std::vector<std::size_t>>> places;
        for (std::size_t i = 0; i < before_.size(); ++i)
            if (!is_taken_[i]) places[unnamed(before_[i])].first.push_back(i);
        for (std::size_t i = 0; i < now_.size(); ++i)
            if (!same_[i]) places[unnamed(now_[i])].second.push_back(i);
        // Where several may be it, nobody knows.
        for (const auto& [place, at] : places)
            if (at.first.size() == 1 && at.second.size() == 1) pair(at.first[0], at.second[0]);
    }
    std::vector<std::optional<std::size_t>> take() { return std::move(same_); }

private:
    void pair(std::size_t before, std::size_t now) {
        is_taken_[before] = true;
        same_[now] = before;
    }

    const std::vector<PatchedFixture>& before_;
    const std::vector<PatchedFixture>& now_;
    std::vector<bool> is_taken_;
    std::vector<std::optional<std::size_t>> same_;
};

} // namespace

bool is_same_fixture(const PatchedFixture& a, const PatchedFixture& b) {
    return a.uuid == b.uuid && (!a.uuid.empty() || a.name == b.name);
}

std::vector<std::optional<std::size_t>> same_fixtures(const Show& before, const Show& now) {
    Pairs pairs(before, now);
    pairs.pair_known();
    pairs.pair_renamed();
    return pairs.take();
}

FixtureNames renamed_fixtures(const Show& before, const Show& now) {
    const std::set<std::string> were = fixture_names(before), are = fixture_names(now);
    const std::vector<std::optional<std::size_t>> same = same_fixtures(before, now);
    FixtureNames names;
    for (std::size_t i = 0; i < same.size(); ++i) {
        if (!same[i]) continue;
        const std::string& was = before.fixtures[*same[i]].name;
        const std::string& is = now.fixtures[i].name;
        if (!are.contains(was) && !were.contains(is)) names[was] = is;
    }
    return names;
}

} // namespace ghost::scene
