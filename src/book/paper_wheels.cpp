// SPDX-License-Identifier: Apache-2.0
#include "book/private/paper_tables.h"

#include "book/fixture_values.h"
#include "show/show.h"

#include <map>
#include <optional>
#include <set>

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
    std::size_t count = 0;
    std::map<int, Word> wheels; // of all modes in which it is hung
};

} // namespace

PaperTable wheels_of(const Show& show, const PrintStyle& style) {
    PaperTable table{"gobos_colours", style("Gobos and colours"), {}, {}, {}};
    table.columns = {{style("type")},    {style("fixtures"), true},     {style("wheel")},
                     {style("kind")},    {style("slot"), true},         {style("name")},
                     {style("picture")}, {style("colour"), false, true}};
    std::map<std::string, std::pair<const fixture::Type*, HungType>> types;
    for (const PatchedFixture& fixture : show.fixtures) {
        if (!fixture.type || fixture.type->modes.empty()) continue;
        auto& [type, hung] =
            types.try_emplace(type_name(fixture), fixture.type.get(), HungType{}).first->second;
        ++hung.count;
        if (fixture.type.get() == type) hung.wheels.merge(wheels_in_use(fixture.patch().mode_of()));
    }
    for (const auto& [name, both] : types) {
        const auto& [type, hung] = both;
        for (const auto& [index, kind] : hung.wheels) {
            const fixture::Wheel& wheel = type->wheels[static_cast<std::size_t>(index)];
            for (std::size_t k = 0; k < wheel.slots.size(); ++k) {
                const fixture::Slot& slot = wheel.slots[k];
                table.rows.push_back({{name, std::to_string(hung.count), wheel.name, style(kind),
                                       std::to_string(k + 1), slot.name, slot.media_file,
                                       colour_of(*type, slot, style(kind) == style("colour"), style)}});
            }
        }
    }
    if (table.rows.empty()) table.unknown.push_back(style("No fixture file names a wheel with slots."));
    drop_empty_columns(table);
    return table;
}

} // namespace ghost::scene
