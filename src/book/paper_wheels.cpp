// SPDX-License-Identifier: Apache-2.0
#include "book/private/paper_tables.h"

#include "book/fixture_values.h"
#include "show/show.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ghost::scene {
namespace {

using fixture::Role;

// What a wheel is for, by the functions of the modes that are hung; nothing: for something else.
std::optional<Word> kind_of(Role role) {
    switch (role) {
    case Role::color_wheel:
    case Role::color_wheel_index:
    case Role::color_macro:
        return Word("colour");
    case Role::gobo_wheel:
    case Role::gobo_wheel_index:
    case Role::gobo_select_spin:
    case Role::gobo_select_shake:
        return Word("gobo");
    case Role::animation_wheel:
    case Role::animation_select_spin:
        return Word("animation");
    case Role::prism:
    case Role::prism_select_spin:
        return Word("prism");
    default:
        return std::nullopt;
    }
}

std::map<int, Word> wheels_in_use(const fixture::Mode& mode) {
    std::map<int, Word> wheels;
    for (const fixture::Channel& channel : mode.channels)
        for (const fixture::ChannelFunction& function : channel.functions)
            if (const auto kind = kind_of(function.meaning.role); function.wheel >= 0 && kind)
                wheels.try_emplace(function.wheel, *kind);
    return wheels;
}

// White is what files say of a gobo or a prism that has no colour of its own.
std::string colour_of(const fixture::Type& type, const fixture::Slot& slot, bool is_colour,
                      const PrintStyle& style) {
    if (is_open(slot)) return style("open");
    const std::string colour = colour_text(
        slot.filter >= 0 ? type.filters[static_cast<std::size_t>(slot.filter)].color : slot.color);
    return !is_colour && colour == "#ffffff" ? "" : colour;
}

struct HungType {
    const fixture::Type* type = nullptr;
    std::size_t count = 0;
    std::map<int, Word> wheels;                 // of all modes in which it is hung
    std::vector<std::vector<std::string>> rows; // from the wheel's name on
};

// Files of one name, in the order of the show; those that say the same are one.
using HungTypes = std::map<std::string, std::vector<HungType>>;

HungTypes hung_types(const Show& show) {
    HungTypes types;
    for (const PatchedFixture& fixture : show.fixtures) {
        if (!fixture.type || fixture.type->modes.empty()) continue;
        std::vector<HungType>& files = types[type_name(fixture)];
        auto file = std::find_if(files.begin(), files.end(),
                                 [&](const HungType& one) { return one.type == fixture.type.get(); });
        if (file == files.end()) file = files.insert(file, {.type = fixture.type.get()});
        ++file->count;
        file->wheels.merge(wheels_in_use(fixture.patch().mode_of()));
    }
    return types;
}

void add_rows(HungType& hung, const PrintStyle& style) {
    for (const auto& [index, kind] : hung.wheels) {
        const fixture::Wheel& wheel = hung.type->wheels[static_cast<std::size_t>(index)];
        for (std::size_t k = 0; k < wheel.slots.size(); ++k) {
            const fixture::Slot& slot = wheel.slots[k];
            hung.rows.push_back({wheel.name, style(kind), std::to_string(k + 1), slot.name, slot.media_file,
                                 colour_of(*hung.type, slot, style(kind) == style("colour"), style)});
        }
    }
}

std::vector<HungType> without_copies(std::vector<HungType> files) {
    std::vector<HungType> different;
    for (HungType& file : files) {
        const auto same = std::find_if(different.begin(), different.end(),
                                       [&](const HungType& one) { return one.rows == file.rows; });
        if (same == different.end())
            different.push_back(std::move(file));
        else
            same->count += file.count;
    }
    return different;
}

} // namespace

PaperTable wheels_of(const Show& show, const PrintStyle& style) {
    PaperTable table{"gobos_colours", style("Gobos and colours"), {}, {}, {}};
    table.columns = {{style("type")},    {style("fixtures"), true},     {style("wheel")},
                     {style("kind")},    {style("slot"), true},         {style("name")},
                     {style("picture")}, {style("colour"), false, true}};
    bool is_twice = false;
    HungTypes types = hung_types(show);
    for (auto& [name, files] : types) {
        for (HungType& file : files) add_rows(file, style);
        const std::vector<HungType> different = without_copies(std::move(files));
        is_twice = is_twice || different.size() > 1;
        for (const HungType& hung : different)
            for (const std::vector<std::string>& row : hung.rows) {
                PaperRow& added = table.rows.emplace_back();
                added.cells = {name, std::to_string(hung.count)};
                added.cells.insert(added.cells.end(), row.begin(), row.end());
            }
    }
    if (is_twice && !table.rows.empty())
        table.unknown.push_back(style("Rows of one name are of fixture files that say different things."));
    if (table.rows.empty()) table.unknown.push_back(style("No fixture file names a wheel with slots."));
    drop_empty_columns(table);
    return table;
}

} // namespace ghost::scene
