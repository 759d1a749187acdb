// SPDX-License-Identifier: Apache-2.0
#include "show_file/show_edit.h"

#include "json_xml_toml/toml_keys.h"
#include "show/show.h"

#include <algorithm>
#include <map>

namespace ghost::scene {
namespace {

Keys keys_of(const FixtureEdit& edit, bool of_plot) {
    Keys keys;
    if (edit.name) keys.emplace_back("name", toml_text(*edit.name));
    if (edit.mode) keys.emplace_back("mode", toml_text(*edit.mode));
    if (edit.address) {
        keys.emplace_back("universe", std::to_string(edit.address->universe));
        // In a plot's change 0 says "not patched"; a [[fixture]] says so by having none.
        if (edit.address->channel > 0 || of_plot)
            keys.emplace_back("address", std::to_string(edit.address->channel));
        else
            keys.emplace_back("address", std::nullopt);
    }
    if (edit.position_m) keys.emplace_back("position_m", toml_text(*edit.position_m));
    if (edit.rotation_deg) keys.emplace_back("rotation_deg", toml_text(*edit.rotation_deg));
    if (edit.hidden && of_plot) keys.emplace_back("hidden", *edit.hidden ? "true" : "false");
    return keys;
}

// Of a plot's object; the last one, for later changes win. -1: none.
int change_of(const TomlText& document, const std::string& uuid) {
    const std::vector<const toml::table*> tables = document.tables("change");
    int found = -1;
    for (std::size_t i = 0; i < tables.size(); ++i)
        if (tables[i] && (*tables[i])["uuid"].value_or(std::string()) == uuid &&
            (*tables[i])["break"].value_or(1) == 1)
            found = static_cast<int>(i);
    return found;
}

} // namespace

FixturePlace place_of(const PatchedFixture& fixture, std::size_t index) {
    return {index, fixture.uuid};
}

Result<std::string> edit_fixtures(const std::string& text,
                                  const std::vector<std::pair<FixturePlace, FixtureEdit>>& edits) {
    TRY(TomlText document, TomlText::parse(text));
    toml::table expected = document.root();
    for (const auto& [place, edit] : edits) {
        const Keys keys = keys_of(edit, !place.uuid.empty());
        if (keys.empty()) continue;
        if (place.uuid.empty()) {
            TRY(const toml::table* table, entry_of(document, "fixture", place.number));
            TRY_VOID(write(document, *table, keys));
            write(*array_of(expected, "fixture").get(place.number)->as_table(), keys);
        } else if (const int change = change_of(document, place.uuid); change >= 0) {
            const auto number = static_cast<std::size_t>(change);
            TRY_VOID(write(document, *document.tables("change")[number], keys));
            write(*array_of(expected, "change").get(number)->as_table(), keys);
        } else {
            Keys all{{"uuid", toml_text(place.uuid)}};
            all.insert(all.end(), keys.begin(), keys.end());
            document.append(block_of("[[change]]", all, document.line_end()));
            toml::table made;
            write(made, all);
            array_of(expected, "change").push_back(std::move(made));
        }
    }
    return checked(document, expected);
}

Result<std::string> copy_fixture(const std::string& text, std::size_t number, const FixtureEdit& edit) {
    TRY(TomlText document, TomlText::parse(text));
    TRY(const toml::table* table, entry_of(document, "fixture", number));
    TRY(const TomlText::Span span, document.span_of(*table, "fixture"));
    std::string block = document.text().substr(span.begin, span.end - span.begin);
    if (block.back() != '\n') block = document.line_end() + block;
    document.replace({span.end, span.end}, document.line_end() + block);
    toml::table expected = document.root();
    toml::array& fixtures = array_of(expected, "fixture");
    fixtures.insert(fixtures.begin() + static_cast<std::ptrdiff_t>(number) + 1, toml::table(*table));
    TRY(const std::string copied, checked(document, expected));
    return edit_fixtures(copied, {{FixturePlace{number + 1, ""}, edit}});
}

Result<std::string> add_fixture(const std::string& text, const NewFixture& fixture) {
    Keys keys;
    if (fixture.keys.name) keys.emplace_back("name", toml_text(*fixture.keys.name));
    keys.emplace_back("gdtf", toml_text(fixture.gdtf));
    FixtureEdit rest = fixture.keys;
    rest.name.reset();
    const Keys more = keys_of(rest, false);
    keys.insert(keys.end(), more.begin(), more.end());
    return add_entry(text, "fixture", keys);
}

Result<std::string> remove_fixtures(const std::string& text, const std::vector<std::size_t>& numbers) {
    return remove_entries(text, "fixture", {numbers.begin(), numbers.end()});
}

Result<std::string> add_camera(const std::string& text, const Camera& camera) {
    TRY(TomlText document, TomlText::parse(text));
    Keys keys{{"name", toml_text(camera.name)},
              {"position_m", toml_text(camera.position_m)},
              {"target_m", toml_text(camera.target_m)},
              {"fov_y_deg", toml_text(camera.fov_y_deg)},
              {"size", "[" + std::to_string(camera.width) + ", " + std::to_string(camera.height) + "]"}};
    if (camera.auto_exposure)
        keys.emplace_back("exposure", toml_text(std::string("auto")));
    else
        keys.emplace_back("ev100", toml_text(camera.ev100));
    document.append(block_of("[[camera]]", keys, document.line_end()));
    toml::table expected = document.root();
    toml::table made;
    write(made, keys);
    array_of(expected, "camera").push_back(std::move(made));
    return checked(document, expected);
}

Result<std::string> add_model(const std::string& text, const std::string& file, const glm::vec3& position_m) {
    return add_entry(text, "model", {{"file", toml_text(file)}, {"position_m", toml_text(position_m)}});
}

Result<std::string> set_of_show(const std::string& text, const std::string& key, const std::string& value) {
    return set_in(text, "show", {{key, toml_text(value)}});
}

bool differ_in_fixtures_air_and_cues_only(const std::string& a, const std::string& b) {
    const auto rest = [](const std::string& text) -> Result<toml::table> {
        TRY(const TomlText document, TomlText::parse(text));
        toml::table root = document.root();
        for (const char* const name : {"fixture", "change", "haze", "hazer", "light", "cue", "palette"})
            root.erase(name);
        return root;
    };
    const auto first = rest(a);
    const auto second = rest(b);
    return first.ok() && second.ok() && *first == *second;
}

} // namespace ghost::scene
