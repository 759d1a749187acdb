// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/toml_keys.h"

namespace ghost::scene {
namespace {

std::string with_line_ends(const std::string& block, const std::string& line_end) {
    std::string lines;
    for (const char letter : block) lines += letter == '\n' ? line_end : std::string(1, letter);
    return lines;
}

// What a block says of its one [[name]].
toml::table entry_in(const std::string& block, const std::string& name) {
    toml::table root = toml::parse(block);
    return std::move(*root[name][0].as_table());
}

} // namespace

std::string toml_text(const glm::vec3& numbers) {
    return "[" + toml_text(numbers.x) + ", " + toml_text(numbers.y) + ", " + toml_text(numbers.z) + "]";
}

Result<void> write(TomlText& document, const toml::table& table, const Keys& keys) {
    for (const auto& [key, value] : keys) {
        if (value)
            TRY_VOID(document.set(table, key, *value));
        else
            document.unset(table, key);
    }
    return {};
}

void write(toml::table& table, const Keys& keys) {
    for (const auto& [key, value] : keys) {
        table.erase(key);
        if (!value) continue;
        const toml::table one = toml::parse("k = " + *value);
        one.get("k")->visit([&, name = key](const auto& node) { table.insert_or_assign(name, node); });
    }
}

std::string block_of(const std::string& header, const Keys& keys, const std::string& line_end) {
    std::string block = header + line_end;
    for (const auto& [key, value] : keys)
        if (value) block += key + " = " + *value + line_end;
    return block;
}

toml::array& array_of(toml::table& root, const std::string& name) {
    if (!root[name].as_array()) root.insert_or_assign(name, toml::array{});
    return *root[name].as_array();
}

Result<std::string> checked(const TomlText& document, const toml::table& expected) {
    std::string text = document.cut();
    TRY(const TomlText after, TomlText::parse(text));
    if (after.root() != expected)
        return Error{"is written in a way that cannot be edited here; change it in a text editor",
                     "show.toml"};
    return text;
}

Result<const toml::table*> entry_of(const TomlText& document, const std::string& name, std::size_t number) {
    const std::vector<const toml::table*> tables = document.tables(name);
    for (const toml::table* const table : tables) // who reads the show does not count it
        if (!table)
            return Error{name + " has an entry that is no table: write [[" + name + "]]", "show.toml"};
    if (number >= tables.size())
        return Error{"has no [[" + name + "]] number " + std::to_string(number + 1), "show.toml"};
    return tables[number];
}

Result<std::string> set_in(const std::string& text, const std::string& name, const Keys& keys) {
    TRY(TomlText document, TomlText::parse(text));
    toml::table expected = document.root();
    if (const toml::table* table = document.root()[name].as_table()) {
        TRY_VOID(write(document, *table, keys));
        write(*expected[name].as_table(), keys);
    } else {
        document.append(block_of("[" + name + "]", keys, document.line_end()));
        toml::table made;
        write(made, keys);
        expected.insert_or_assign(name, std::move(made));
    }
    return checked(document, expected);
}

Result<std::string> add_entry(const std::string& text, const std::string& name, const Keys& keys) {
    return add_block(text, name, block_of("[[" + name + "]]", keys, "\n"));
}

Result<std::string> add_block(const std::string& text, const std::string& name, const std::string& block) {
    TRY(TomlText document, TomlText::parse(text));
    const std::string lines = with_line_ends(block, document.line_end());
    const std::vector<const toml::table*> tables = document.tables(name);
    if (!tables.empty() && tables.back() && !tables.back()->is_inline()) {
        TRY(const TomlText::Span span, document.span_of(*tables.back(), name));
        const bool is_open = document.text()[span.end - 1] != '\n';
        document.replace({span.end, span.end},
                         (is_open ? document.line_end() : "") + document.line_end() + lines);
    } else {
        document.append(lines);
    }
    toml::table expected = document.root();
    array_of(expected, name).push_back(entry_in(block, name));
    return checked(document, expected);
}

Result<std::string> replace_entry(const std::string& text, const std::string& name, std::size_t number,
                                  const std::string& block) {
    TRY(TomlText document, TomlText::parse(text));
    TRY(const toml::table* table, entry_of(document, name, number));
    TRY(const TomlText::Span span, document.span_of(*table, name));
    document.replace(span, with_line_ends(block, document.line_end()));
    toml::table expected = document.root();
    *array_of(expected, name).get(number)->as_table() = entry_in(block, name);
    return checked(document, expected);
}

Result<std::string> remove_entries(const std::string& text, const std::string& name,
                                   const std::set<std::size_t>& numbers) {
    TRY(TomlText document, TomlText::parse(text));
    toml::table expected = document.root();
    for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
        TRY(const toml::table* table, entry_of(document, name, *number));
        TRY(TomlText::Span span, document.span_of(*table, name));
        const std::string& all = document.text();
        if (all.compare(span.end, document.line_end().size(), document.line_end()) == 0)
            span.end += document.line_end().size();
        document.replace(span, "");
        toml::array& entries = array_of(expected, name);
        entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(*number));
        if (entries.empty()) expected.erase(name);
    }
    return checked(document, expected);
}

} // namespace ghost::scene
