// SPDX-License-Identifier: Apache-2.0
#include "book/private/paper_tables.h"

#include "dmx/wire/universes.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <map>
#include <set>

namespace ghost::scene {
namespace {

constexpr int kSlots = static_cast<int>(dmx::kSlots);

// Channels of one universe that a fixture or an axis of a machine reads.
struct Segment {
    int from = 1; // 1..512
    int to = 1;
    const PatchedFixture* fixture = nullptr; // nullptr: a machine's
    std::string name;
    std::string what;     // "", "break 2", "track", "axis left", "goes on"
    bool is_whole = true; // false: its footprint is not known
};

// Segments by universe, each sorted by its first channel.
using Segments = std::map<int, std::vector<Segment>>;

// What runs past channel 512 goes on in the next universe.
void add(Segments& all, const PrintStyle& style, const fixture::Address& address, int count,
         Segment segment) {
    int universe = address.universe, from = address.channel;
    segment.is_whole = count > 0;
    for (int left = std::max(count, 1); left > 0 && universe <= dmx::kMaxUniverse; ++universe) {
        segment.from = from;
        segment.to = std::min(from + left - 1, kSlots);
        all[universe].push_back(segment);
        left -= segment.to - segment.from + 1;
        from = 1;
        segment.what += (segment.what.empty() ? "" : ", ") + style("goes on");
    }
}

void add_fixture(Segments& all, const PrintStyle& style, const PatchedFixture& fixture) {
    const auto segment = [&](const std::string& what) {
        return Segment{.fixture = &fixture, .name = fixture.name, .what = what};
    };
    const std::vector<fixture::Address> addresses = addresses_of(fixture);
    for (std::size_t part = 0; part < addresses.size(); ++part) {
        const fixture::Address& address = addresses[part];
        if (address.channel < 1 || address.channel > kSlots || address.universe < 1) continue;
        const int count = footprint_of(fixture, part);
        if (is_mode_said(fixture) && count == 0) continue; // its mode has no channels there
        add(all, style, address, count,
            segment(part > 0 ? style("break %1", {std::to_string(part + 1)}) : ""));
    }
    if (fixture.track && fixture.track->address > 0)
        add(all, style, {fixture.track->universe, fixture.track->address}, 2, segment(style("track")));
    const auto add_select = [&](const auto& pictures) {
        if (pictures && pictures->address > 0)
            add(all, style, {pictures->universe, pictures->address}, 1, segment(style("chooses the medium")));
    };
    add_select(fixture.projector);
    add_select(fixture.wall);
}

// The channels of an axis that a fixture drives are the fixture's.
void add_mover(Segments& all, const PrintStyle& style, const Mover& mover) {
    for (const MoverAxis& axis : mover.axes)
        if (axis.fixture.empty() && !axis.levels.empty())
            add(all, style, axis.levels.front(), static_cast<int>(axis.levels.size()),
                {.name = mover.name, .what = style("axis %1", {axis.name})});
}

Segments segments_of(const Show& show, const PrintStyle& style) {
    Segments all;
    for (const PatchedFixture& fixture : show.fixtures) add_fixture(all, style, fixture);
    for (const Mover& mover : show.movers) add_mover(all, style, mover);
    for (auto& [universe, segments] : all)
        std::stable_sort(segments.begin(), segments.end(),
                         [](const Segment& a, const Segment& b) { return a.from < b.from; });
    return all;
}

struct Gap {
    int from = 1, to = 0;
    int count() const { return to - from + 1; }
};

// What nobody reads before this segment, and after the last one.
std::vector<Gap> gaps_of(const std::vector<Segment>& segments) {
    std::vector<Gap> gaps;
    int next = 1;
    for (const Segment& segment : segments) {
        if (segment.from > next) gaps.push_back({next, segment.from - 1});
        next = std::max(next, segment.to + 1);
    }
    if (next <= kSlots) gaps.push_back({next, kSlots});
    return gaps;
}

PaperRow free_row(const PrintStyle& style, int universe, const Gap& gap, bool is_certain) {
    return {{std::to_string(universe), std::to_string(gap.from), std::to_string(gap.to),
             std::to_string(gap.count()), is_certain ? style("free") : style("free at most"), "", "", "", ""},
            true};
}

// Channels of whose address cannot be read may be anywhere.
void say_anywhere(PaperTable& table, const std::vector<std::string>& addressless, const PrintStyle& style) {
    if (!addressless.empty())
        table.unknown.push_back(style("The address of %1 cannot be read: less may be free, in any universe.",
                                      {names_text(addressless, style)}));
}

} // namespace

PaperTable patch_of(const Show& show, const PrintStyle& style) {
    const std::vector<std::string> addressless = addressless_of(show);
    const std::vector<Hanging> hangings = hangings_of(show);
    PaperTable table{"patch", style("Patch by universe"), {}, {}, {}};
    table.columns = {{style("universe"), true}, {style("from"), true}, {style("to"), true},
                     {style("channels"), true}, {style("name")},       {style("number"), false, true},
                     {style("type")},           {style("mode")},       {style("remarks")}};
    for (const auto& entry : segments_of(show, style)) {
        const int universe = entry.first;
        const std::vector<Segment>& segments = entry.second;
        const std::vector<Gap> gaps = gaps_of(segments);
        std::size_t gap = 0;
        const Segment* before = nullptr; // that reaches farthest
        // Whether what is free is: a fixture of unknown length may reach to the universe's end.
        bool is_certain = addressless.empty();
        const auto put_gaps = [&](int until) {
            for (; gap < gaps.size() && gaps[gap].from < until; ++gap)
                table.rows.push_back(free_row(style, universe, gaps[gap], is_certain));
        };
        for (const Segment& segment : segments) {
            put_gaps(segment.from);
            const PatchedFixture none, &fixture = segment.fixture ? *segment.fixture : none;
            const Hanging no_hanging,
                &hanging = segment.fixture
                               ? hangings[static_cast<std::size_t>(segment.fixture - show.fixtures.data())]
                               : no_hanging;
            std::string remarks = segment.what;
            const auto remark = [&](const std::string& what) {
                remarks += (remarks.empty() ? "" : ", ") + what;
            };
            if (before && segment.from <= before->to)
                remark(style("shares channels with %1", {before->name}));
            if (!segment.is_whole) remark(style("how many channels is not known"));
            table.rows.push_back({{std::to_string(universe), std::to_string(segment.from),
                                   segment.is_whole ? std::to_string(segment.to) : "",
                                   segment.is_whole ? std::to_string(segment.to - segment.from + 1) : "",
                                   segment.name, fixture.fixture_id, written_type(fixture, hanging),
                                   written_mode(fixture, hanging), remarks}});
            is_certain = is_certain && segment.is_whole;
            if (!before || segment.to > before->to) before = &segment;
        }
        put_gaps(kSlots + 1);
    }
    std::vector<std::string> unpatched;
    for (const PatchedFixture& fixture : show.fixtures) {
        const auto addresses = addresses_of(fixture);
        if (fixture.is_address_known &&
            std::none_of(addresses.begin(), addresses.end(),
                         [](const fixture::Address& address) { return address.channel > 0; }))
            unpatched.push_back(fixture.name);
    }
    if (!unpatched.empty())
        table.unknown.push_back(style("Not patched: %1.", {names_text(unpatched, style)}));
    say_anywhere(table, addressless, style);
    drop_empty_columns(table);
    return table;
}

PaperTable universes_of(const Show& show, const PrintStyle& style) {
    PaperTable table{"universes", style("Universes"), {}, {}, {}};
    table.columns = {{style("universe"), true}, {style("fixtures"), true},    {style("channels used"), true},
                     {style("free"), true},     {style("largest gap"), true}, {style("last used"), true},
                     {style("counted")}};
    const bool is_addressless = !addressless_of(show).empty();
    for (const auto& [universe, segments] : segments_of(show, style)) {
        int free = 0, largest = 0, last = 0;
        for (const Gap& gap : gaps_of(segments)) {
            free += gap.count();
            largest = std::max(largest, gap.count());
        }
        std::set<const PatchedFixture*> fixtures;
        for (const Segment& segment : segments) {
            last = std::max(last, segment.to);
            if (segment.fixture) fixtures.insert(segment.fixture);
        }
        const bool is_open =
            std::any_of(segments.begin(), segments.end(), [](const Segment& one) { return !one.is_whole; });
        if (is_open)
            table.unknown.push_back(
                style("Universe %1: less may be free, for a fixture's channels are not known.",
                      {std::to_string(universe)}));
        table.rows.push_back(
            {{std::to_string(universe), std::to_string(fixtures.size()), std::to_string(kSlots - free),
              std::to_string(free), std::to_string(largest), std::to_string(last),
              is_open || is_addressless ? style("free at most") : style("whole")}});
    }
    say_anywhere(table, addressless_of(show), style);
    return table;
}

} // namespace ghost::scene
