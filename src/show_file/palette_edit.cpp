// SPDX-License-Identifier: Apache-2.0
#include "show_file/palette_edit.h"

#include "json_xml_toml/toml_keys.h"

namespace ghost::scene {
namespace {

std::string inline_table(const std::map<std::string, float>& fractions) {
    std::string text = "{";
    for (const auto& [name, fraction] : fractions)
        text += (text.size() == 1 ? " " : ", ") + toml_text(name) + " = " + toml_text(fraction);
    return text + " }";
}

Keys keys_of(const PaletteValues& values) {
    Keys keys;
    const auto put = [&](const char* key, const auto& value) {
        if (value) keys.emplace_back(key, toml_text(*value));
    };
    put("pan_deg", values.pan_deg);
    put("tilt_deg", values.tilt_deg);
    put("colour_rec2020", values.colour);
    put("zoom_deg", values.zoom_deg);
    if (values.gobo) keys.emplace_back("gobo", std::to_string(*values.gobo));
    if (!values.attributes.empty()) keys.emplace_back("attributes", inline_table(values.attributes));
    return keys;
}

std::string text_of(const Palette& palette) {
    Keys keys{{"name", toml_text(palette.name)},
              {"kind", toml_text(std::string(kPaletteKinds[static_cast<std::size_t>(palette.kind)]))}};
    const Keys values = keys_of(palette.values);
    keys.insert(keys.end(), values.begin(), values.end());
    std::string block = block_of("[[palette]]", keys, "\n");
    for (const auto& [name, own] : palette.fixtures) {
        Keys of_fixture{{"name", toml_text(name)}};
        const Keys more = keys_of(own);
        of_fixture.insert(of_fixture.end(), more.begin(), more.end());
        block += block_of("[[palette.fixture]]", of_fixture, "\n");
    }
    return block;
}

Result<void> check(const TomlText& document, const std::vector<Palette>& palettes, std::size_t index) {
    if (index >= palettes.size())
        return Error{"has no palette number " + std::to_string(index + 1), "show.toml"};
    if (document.tables("palette").size() == palettes.size()) return {};
    return Error{"has a [[palette]] that cannot be read (Messages say which); mend it there first",
                 "show.toml"};
}

} // namespace

Result<std::string> add_palette(const std::string& text, const Palette& palette) {
    return add_block(text, "palette", text_of(palette));
}

Result<std::string> replace_palette(const std::string& text, const std::vector<Palette>& palettes,
                                    std::size_t index, const Palette& palette) {
    TRY(const TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, palettes, index));
    return replace_entry(text, "palette", index, text_of(palette));
}

Result<std::string> rename_palette(const std::string& text, const std::vector<Palette>& palettes,
                                   std::size_t index, const std::string& name) {
    TRY(TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, palettes, index));
    TRY(const toml::table* table, entry_of(document, "palette", index));
    const Keys keys{{"name", toml_text(name)}};
    TRY_VOID(write(document, *table, keys));
    toml::table expected = document.root();
    write(*array_of(expected, "palette").get(index)->as_table(), keys);
    return checked(document, expected);
}

Result<std::string> remove_palette(const std::string& text, const std::vector<Palette>& palettes,
                                   std::size_t index) {
    TRY(const TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, palettes, index));
    return remove_entries(text, "palette", {index});
}

} // namespace ghost::scene
