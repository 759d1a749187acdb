// SPDX-License-Identifier: Apache-2.0
#include "show_file/camera_edit.h"

#include "json_xml_toml/toml_keys.h"
#include "show_file/fixture_names_edit.h"
#include "show_file/show_edit.h"

namespace ghost::scene {
namespace {

Result<void> check(const TomlText& document, const std::vector<Camera>& cameras, std::size_t index) {
    if (index >= cameras.size())
        return Error{"has no camera number " + std::to_string(index + 1), "show.toml"};
    const std::size_t written = document.tables("camera").size();
    if (written == 0)
        return Error{"camera '" + cameras[index].name +
                         "' is made from where the fixtures hang, for the show has none of its own; keep one "
                         "first (Ctrl+K)",
                     ""};
    if (written == cameras.size()) return {};
    return Error{"has a [[camera]] that cannot be read (Messages say which); mend it there first",
                 "show.toml"};
}

} // namespace

Result<std::string> own_cameras(const std::string& text, const std::vector<Camera>& cameras) {
    TRY(const TomlText document, TomlText::parse(text));
    if (!document.tables("camera").empty()) return text;
    std::string with = text;
    for (const Camera& camera : cameras) {
        TRY(with, add_camera(with, camera));
    }
    return with;
}

Result<std::string> rename_camera(const std::string& text, const std::vector<Camera>& cameras,
                                  std::size_t index, const std::string& name) {
    TRY(TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, cameras, index));
    TRY(const toml::table* table, entry_of(document, "camera", index));
    const Keys keys{{"name", toml_text(name)}};
    TRY_VOID(write(document, *table, keys));
    toml::table expected = document.root();
    write(*array_of(expected, "camera").get(index)->as_table(), keys);
    TRY(const std::string renamed, checked(document, expected));
    std::set<std::string> all;
    for (std::size_t i = 0; i < cameras.size(); ++i) all.insert(i == index ? name : cameras[i].name);
    return rename_camera_in_references(renamed, {{cameras[index].name, name}}, all);
}

Result<std::string> remove_camera(const std::string& text, const std::vector<Camera>& cameras,
                                  std::size_t index) {
    TRY(const TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, cameras, index));
    return remove_entries(text, "camera", {index});
}

} // namespace ghost::scene
