// SPDX-License-Identifier: Apache-2.0
#include "show_file/cue_edit.h"

#include "json_xml_toml/toml_keys.h"

namespace ghost::scene {
namespace {

// Nothing: the key goes.
Keys keys_of(const Cue& cue) {
    const auto text = [](const std::string& words) {
        return words.empty() ? std::nullopt : std::optional(toml_text(words));
    };
    const auto seconds = [](const std::optional<float>& value) {
        return value ? std::optional(toml_text(*value)) : std::nullopt;
    };
    return {{"name", toml_text(cue.name)},
            {"number", text(cue.number)},
            {"page", text(cue.page)},
            {"at_s", cue.at_s ? std::optional(toml_text(static_cast<float>(*cue.at_s))) : std::nullopt},
            {"camera", text(cue.camera)},
            {"flight_s", cue.flight_s > 0 ? std::optional(toml_text(cue.flight_s)) : std::nullopt},
            {"look", text(cue.look)},
            {"fade_s", seconds(cue.fade_s)},
            {"follow_s", seconds(cue.follow_s)},
            {"notes", text(cue.notes)}};
}

Result<void> check(const TomlText& document, const std::vector<Cue>& cues, std::size_t index) {
    if (index >= cues.size()) return Error{"has no cue number " + std::to_string(index + 1), "show.toml"};
    if (document.tables("cue").size() == cues.size()) return {};
    return Error{"has a [[cue]] that cannot be read (Messages say which); mend it there first", "show.toml"};
}

} // namespace

Result<std::string> edit_cue(const std::string& text, const std::vector<Cue>& cues, std::size_t index,
                             const Cue& cue) {
    TRY(TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, cues, index));
    TRY(const toml::table* table, entry_of(document, "cue", index));
    toml::table expected = document.root();
    const Keys keys = keys_of(cue);
    TRY_VOID(write(document, *table, keys));
    write(*array_of(expected, "cue").get(index)->as_table(), keys);
    return checked(document, expected);
}

Result<std::string> add_cue(const std::string& text, const Cue& cue) {
    Keys keys = keys_of(cue);
    std::erase_if(keys, [](const auto& key) { return !key.second; });
    return add_entry(text, "cue", keys);
}

Result<std::string> remove_cue(const std::string& text, const std::vector<Cue>& cues, std::size_t index) {
    TRY(const TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, cues, index));
    return remove_entries(text, "cue", {index});
}

Result<std::string> move_cue_up(const std::string& text, const std::vector<Cue>& cues, std::size_t index) {
    if (index == 0) return Error{"is the first cue", "show.toml"};
    TRY(TomlText document, TomlText::parse(text));
    TRY_VOID(check(document, cues, index));
    TRY(const toml::table* above, entry_of(document, "cue", index - 1));
    TRY(const toml::table* below, entry_of(document, "cue", index));
    TRY(const TomlText::Span first, document.span_of(*above, "cue"));
    TRY(const TomlText::Span second, document.span_of(*below, "cue"));
    const auto block = [&](const TomlText::Span& span) {
        std::string words = text.substr(span.begin, span.end - span.begin);
        if (words.back() != '\n') words += document.line_end();
        return words;
    };
    document.replace(first, block(second));
    document.replace(second, block(first));
    toml::table expected = document.root();
    toml::array& entries = array_of(expected, "cue");
    const toml::table lower = *entries.get(index)->as_table();
    entries.replace(entries.cbegin() + static_cast<std::ptrdiff_t>(index),
                    *entries.get(index - 1)->as_table());
    entries.replace(entries.cbegin() + static_cast<std::ptrdiff_t>(index) - 1, lower);
    return checked(document, expected);
}

} // namespace ghost::scene
