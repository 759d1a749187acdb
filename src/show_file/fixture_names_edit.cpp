// SPDX-License-Identifier: Apache-2.0
#include "show_file/fixture_names_edit.h"

#include "base/text.h"
#include "json_xml_toml/toml_keys.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace ghost::scene {
namespace {

using Names = std::vector<std::string>;

bool fits_one(const std::string& pattern, const std::set<std::string>& names) {
    return std::any_of(names.begin(), names.end(), [&](const auto& name) { return matches(pattern, name); });
}

// Nothing: it is no list of names, or none of them is another one now.
std::optional<Names> renamed_list(const toml::array* list, const FixtureNames& renamed,
                                  const std::set<std::string>& all) {
    if (!list) return std::nullopt;
    Names before, after;
    for (const toml::node& node : *list) {
        const auto name = node.value<std::string>();
        if (!name) return std::nullopt;
        before.push_back(*name);
    }
    const auto put = [&](const std::string& name) {
        if (std::find(after.begin(), after.end(), name) == after.end()) after.push_back(name);
    };
    Names beside; // what patterns no longer fit
    for (const std::string& name : before) {
        if (const auto found = renamed.find(name); found != renamed.end()) {
            put(found->second);
            continue;
        }
        bool had_one = false;
        for (const auto& [old_name, new_name] : renamed) {
            if (!matches(name, old_name)) continue;
            had_one = true;
            if (!matches(name, new_name)) beside.push_back(new_name);
        }
        if (!had_one || fits_one(name, all)) put(name);
    }
    for (const std::string& name : beside) put(name);
    return after == before ? std::nullopt : std::optional(after);
}

// Writes into the text and, to compare, into the values that it should then have.
class Renaming {
public:
    Renaming(TomlText& document, const FixtureNames& renamed, const std::set<std::string>& all)
        : document_(document), renamed_(renamed), all_(all) {}

    Result<void> text(const toml::table& table, toml::table& expected, const char* key) {
        const auto found = renamed_.find(table[key].value_or(std::string()));
        if (found == renamed_.end()) return {};
        return put(table, expected, {{key, toml_text(found->second)}});
    }
    Result<void> list(const toml::table& table, toml::table& expected, const char* key) {
        const std::optional<Names> names = renamed_list(table[key].as_array(), renamed_, all_);
        if (!names) return {};
        return put(table, expected, {{key, toml_text(*names)}});
    }
    // f: for each table of the list.
    template <class F>
    static Result<void> each(const toml::node_view<const toml::node>& list,
                             const toml::node_view<toml::node>& expected, F&& f) {
        const toml::array* const tables = list.as_array();
        for (std::size_t i = 0; tables && i < tables->size(); ++i)
            if (const toml::table* const table = tables->get(i)->as_table())
                TRY_VOID(f(*table, *expected.as_array()->get(i)->as_table()));
        return {};
    }

private:
    Result<void> put(const toml::table& table, toml::table& expected, const Keys& keys) {
        TRY_VOID(write(document_, table, keys));
        write(expected, keys);
        return {};
    }

    TomlText& document_;
    const FixtureNames& renamed_;
    const std::set<std::string>& all_;
};

} // namespace

Result<std::string> rename_in_references(const std::string& text, const FixtureNames& renamed,
                                         const std::set<std::string>& all) {
    TRY(TomlText document, TomlText::parse(text));
    const toml::table& root = document.root();
    toml::table expected = root;
    Renaming names(document, renamed, all);
    TRY_VOID(
        Renaming::each(root["tracker"], expected["tracker"], [&](const toml::table& table, toml::table& to) {
            return names.list(table, to, "fixtures");
        }));
    TRY_VOID(Renaming::each(root["mover"], expected["mover"],
                            [&](const toml::table& table, toml::table& to) -> Result<void> {
                                TRY_VOID(names.list(table, to, "fixtures"));
                                return Renaming::each(table["axis"], to["axis"],
                                                      [&](const toml::table& axis, toml::table& to_axis) {
                                                          return names.text(axis, to_axis, "fixture");
                                                      });
                            }));
    TRY_VOID(
        Renaming::each(root["palette"], expected["palette"], [&](const toml::table& table, toml::table& to) {
            return Renaming::each(
                table["fixture"], to["fixture"],
                [&](const toml::table& own, toml::table& to_own) { return names.text(own, to_own, "name"); });
        }));
    return checked(document, expected);
}

Result<std::string> rename_camera_in_references(const std::string& text, const FixtureNames& renamed,
                                                const std::set<std::string>& all) {
    TRY(TomlText document, TomlText::parse(text));
    const toml::table& root = document.root();
    toml::table expected = root;
    Renaming names(document, renamed, all);
    for (const char* const list : {"cue", "tracker"})
        TRY_VOID(Renaming::each(root[list], expected[list], [&](const toml::table& table, toml::table& to) {
            return names.text(table, to, "camera");
        }));
    TRY_VOID(Renaming::each(root["mover"], expected["mover"], [&](const toml::table& table, toml::table& to) {
        return names.list(table, to, "cameras");
    }));
    return checked(document, expected);
}

} // namespace ghost::scene
