// SPDX-License-Identifier: Apache-2.0
#include "show_file/substitute_edit.h"

#include "json_xml_toml/toml_keys.h"

namespace ghost::scene {

Result<std::string> set_substitute(const std::string& text, const std::string& wanted,
                                   const std::string& gdtf, const std::string& mode) {
    TRY(TomlText document, TomlText::parse(text));
    const std::vector<const toml::table*> entries = document.tables("substitute");
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i] == nullptr || (*entries[i])["for"].value_or(std::string()) != wanted) continue;
        TRY(const toml::table* table, entry_of(document, "substitute", i));
        toml::table expected = document.root();
        const Keys keys{{"gdtf", toml_text(gdtf)},
                        {"mode", mode.empty() ? std::nullopt : std::optional(toml_text(mode))}};
        TRY_VOID(write(document, *table, keys));
        write(*array_of(expected, "substitute").get(i)->as_table(), keys);
        return checked(document, expected);
    }
    Keys keys{{"for", toml_text(wanted)}, {"gdtf", toml_text(gdtf)}};
    if (!mode.empty()) keys.push_back({"mode", toml_text(mode)});
    return add_entry(text, "substitute", keys);
}

} // namespace ghost::scene
