// SPDX-License-Identifier: Apache-2.0
#include "show_file/mover_edit.h"

#include "base/text.h"
#include "dmx/wire/universes.h"
#include "json_xml_toml/toml_keys.h"

#include <algorithm>
#include <optional>

namespace ghost::scene {
namespace {

constexpr int kChannels = static_cast<int>(dmx::kSlots); // of a universe
constexpr int kBitsOfByte = 8;

std::string range_text(float from, float to) {
    return "[" + toml_text(from) + ", " + toml_text(to) + "]";
}

// of a hoist
Keys keys_of(const MoverAxis& axis) {
    Keys keys{{"name", toml_text(axis.name)},
              {"point_m", toml_text(axis.point_m)},
              {"range_m", range_text(axis.from, axis.to)}};
    if (!axis.levels.empty()) {
        keys.emplace_back("universe", std::to_string(axis.levels.front().universe));
        keys.emplace_back("address", std::to_string(axis.levels.front().channel));
        keys.emplace_back("bits", std::to_string(axis.levels.size() * kBitsOfByte));
    }
    keys.emplace_back("speed_m_s", toml_text(axis.speed));
    keys.emplace_back("acceleration_m_s2", toml_text(axis.acceleration));
    return keys;
}

// Movers that cannot be read are entries of the text, too.
Result<std::size_t> number_of(const TomlText& document, const std::string& name) {
    const std::vector<const toml::table*> tables = document.tables("mover");
    for (std::size_t k = 0; k < tables.size(); ++k)
        if (tables[k] && (*tables[k])["name"].value_or(std::string()) == name) return k;
    return Error{"has no [[mover]] '" + name + "'", "show.toml"};
}

} // namespace

Result<std::string> add_mover(const std::string& text, const Mover& mover) {
    std::string block = block_of("[[mover]]",
                                 {{"name", toml_text(mover.name)},
                                  {"kind", toml_text(std::string("hoists"))},
                                  {"objects", toml_text(mover.objects)},
                                  {"fixtures", toml_text(mover.fixtures)}},
                                 "\n");
    for (const MoverAxis& axis : mover.axes) block += "\n" + block_of("[[mover.axis]]", keys_of(axis), "\n");
    return add_block(text, "mover", block);
}

Result<std::string> set_mover_address(const std::string& text, const Mover& mover,
                                      const fixture::Address& first, int bits) {
    const int bytes = bits / kBitsOfByte;
    const int last = first.channel + bytes * static_cast<int>(mover.axes.size()) - 1;
    if (last > kChannels)
        return Error{"'" + mover.name + "' would end at channel " + std::to_string(last) +
                         " of its universe, expected at most 512",
                     ""};
    TRY(TomlText document, TomlText::parse(text));
    TRY(const std::size_t number, number_of(document, mover.name));
    TRY(const toml::table* table, entry_of(document, "mover", number));
    toml::table expected = document.root();
    const toml::array* const axes = (*table)["axis"].as_array();
    if (!axes || axes->size() != mover.axes.size())
        return Error{"has an axis of '" + mover.name + "' that cannot be read; mend it there first",
                     "show.toml"};
    for (std::size_t k = 0; k < axes->size(); ++k) {
        const toml::table* const axis = axes->get(k)->as_table();
        if (!axis) return Error{"has an axis of '" + mover.name + "' that is no table", "show.toml"};
        const Keys keys{{"universe", std::to_string(first.universe)},
                        {"address", std::to_string(first.channel + bytes * static_cast<int>(k))},
                        {"bits", std::to_string(bits)},
                        {"fixture", std::nullopt},
                        {"attribute", std::nullopt}};
        TRY_VOID(write(document, *axis, keys));
        write(*array_of(*array_of(expected, "mover").get(number)->as_table(), "axis").get(k)->as_table(),
              keys);
    }
    return checked(document, expected);
}

Result<std::string> hang_on_mover(const std::string& text, const std::string& name,
                                  const std::vector<std::string>& fixtures) {
    TRY(TomlText document, TomlText::parse(text));
    toml::table expected = document.root();
    const std::vector<const toml::table*> tables = document.tables("mover");
    for (std::size_t k = 0; k < tables.size(); ++k) {
        if (!tables[k]) continue;
        std::vector<std::string> carried;
        if (const toml::array* const list = (*tables[k])["fixtures"].as_array())
            for (const toml::node& node : *list) carried.push_back(node.value_or(std::string()));
        const std::vector<std::string> before = carried;
        const bool is_it = (*tables[k])["name"].value_or(std::string()) == name;
        for (const std::string& fixture : fixtures) {
            if (!is_it)
                std::erase(carried, fixture);
            else if (std::none_of(carried.begin(), carried.end(),
                                  [&](const std::string& pattern) { return matches(pattern, fixture); }))
                carried.push_back(fixture);
        }
        if (carried == before) continue;
        const Keys keys{{"fixtures", carried.empty() ? std::nullopt : std::optional(toml_text(carried))}};
        TRY_VOID(write(document, *tables[k], keys));
        write(*array_of(expected, "mover").get(k)->as_table(), keys);
    }
    return checked(document, expected);
}

} // namespace ghost::scene
