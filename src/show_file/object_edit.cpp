// SPDX-License-Identifier: Apache-2.0
#include "show_file/object_edit.h"

#include "base/text.h"
#include "json_xml_toml/toml_keys.h"

#include <optional>

namespace ghost::scene {

Result<std::string> set_object_move(const std::string& text, const std::string& name,
                                    const glm::vec3& move_m) {
    TRY(TomlText document, TomlText::parse(text));
    const std::vector<const toml::table*> entries = document.tables("object");
    std::optional<std::size_t> own;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i] == nullptr) continue;
        const std::string pattern = (*entries[i])["name"].value_or(std::string());
        if (pattern == name)
            own = i;
        else if (entries[i]->contains("move_m") && matches(pattern, name))
            own.reset(); // later entries win
    }
    const Keys keys{{"move_m", toml_text(move_m)}};
    if (!own) return add_entry(text, "object", {{"name", toml_text(name)}, keys.front()});
    TRY(const toml::table* table, entry_of(document, "object", *own));
    toml::table expected = document.root();
    TRY_VOID(write(document, *table, keys));
    write(*array_of(expected, "object").get(*own)->as_table(), keys);
    return checked(document, expected);
}

} // namespace ghost::scene
