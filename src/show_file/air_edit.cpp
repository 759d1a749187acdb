// SPDX-License-Identifier: Apache-2.0
#include "show_file/air_edit.h"

#include "json_xml_toml/toml_keys.h"
#include "shared/air.h"
#include "show/show.h"

namespace ghost::scene {
namespace {

template <class T>
void put(Keys& keys, const char* key, const std::optional<T>& value) {
    if (value) keys.emplace_back(key, toml_text(*value));
}

Keys keys_of(const HazerEdit& edit) {
    Keys keys;
    put(keys, "position_m", edit.position_m);
    put(keys, "direction", edit.direction);
    put(keys, "rate", edit.rate);
    put(keys, "spread_deg", edit.spread_deg);
    put(keys, "reach_m", edit.reach_m);
    return keys;
}

Result<void> check_hazer(const TomlText& document, const std::vector<Hazer>& hazers, std::size_t index) {
    if (index >= hazers.size()) return Error{"has no hazer number " + std::to_string(index + 1), "show.toml"};
    if (document.tables("hazer").size() != hazers.size())
        return Error{"has a [[hazer]] that cannot be read (Messages say which); mend it there first",
                     "show.toml"};
    return {};
}

} // namespace

Result<std::string> edit_haze(const std::string& text, const HazeEdit& edit) {
    Keys keys;
    if (edit.preset || edit.extinction_per_m) {
        for (const char* const other :
             {"preset", "milligrams_per_m3", "concentration_mg_per_m3", "extinction_per_m", "intensity"})
            keys.emplace_back(other, std::nullopt);
        std::erase_if(keys, [&](const auto& one) {
            return one.first == (edit.preset ? "preset" : "extinction_per_m");
        });
        if (edit.preset)
            put(keys, "preset", edit.preset);
        else
            put(keys, "extinction_per_m", edit.extinction_per_m);
    }
    put(keys, "unevenness", edit.unevenness);
    put(keys, "patch_m", edit.patch_m);
    put(keys, "wind_m_s", edit.wind_m_s);
    return set_in(text, "haze", keys);
}

Result<std::string> edit_hazer(const std::string& text, const std::vector<Hazer>& hazers, std::size_t index,
                               const HazerEdit& edit) {
    TRY(TomlText document, TomlText::parse(text));
    TRY_VOID(check_hazer(document, hazers, index));
    TRY(const toml::table* table, entry_of(document, "hazer", index));
    toml::table expected = document.root();
    const Keys keys = keys_of(edit);
    TRY_VOID(write(document, *table, keys));
    write(*array_of(expected, "hazer").get(index)->as_table(), keys);
    return checked(document, expected);
}

Result<std::string> add_hazer(const std::string& text, const Hazer& hazer) {
    TRY(const TomlText document, TomlText::parse(text));
    if (document.tables("hazer").size() >= shared::kMostHazers)
        return Error{"has " + std::to_string(shared::kMostHazers) + " hazers, the most there can be",
                     "show.toml"};
    return add_entry(text, "hazer",
                     keys_of({.position_m = hazer.position_m,
                              .direction = hazer.direction,
                              .rate = hazer.rate,
                              .spread_deg = hazer.spread_deg,
                              .reach_m = hazer.reach_m}));
}

Result<std::string> remove_hazer(const std::string& text, const std::vector<Hazer>& hazers,
                                 std::size_t index) {
    TRY(const TomlText document, TomlText::parse(text));
    TRY_VOID(check_hazer(document, hazers, index));
    return remove_entries(text, "hazer", {index});
}

Result<std::string> edit_bounce(const std::string& text, BounceDetail detail) {
    return set_in(text, "light", {{"bounce", toml_text(std::string(name_of(detail)))}});
}

} // namespace ghost::scene
