// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/toml_text.h"

#include "json_xml_toml/toml_problem.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace ghost::scene {
namespace {

// Lines on which a value of several lines goes on: no header begins there.
void mark_values(const toml::node& node, std::vector<bool>& inside) {
    if (const toml::table* table = node.as_table(); table && !table->is_inline()) {
        for (const auto& [key, value] : *table) mark_values(value, inside);
        return;
    }
    if (const toml::array* array = node.as_array(); array && array->is_array_of_tables()) {
        for (const toml::node& entry : *array) mark_values(entry, inside);
        // [[name]] has no brackets around it, = [ ... ] has.
        if (!array->empty() && !array->front().as_table()->is_inline()) return;
    }
    const toml::source_region& region = node.source();
    for (std::size_t line = region.begin.line + std::size_t{1};
         line <= region.end.line && line < inside.size(); ++line)
        inside[line] = true;
}

// Whether a header line opens a table below [[name]].
bool is_below(std::string_view header, const std::string& name) {
    const std::size_t begin = header.find_first_not_of("[ \t");
    if (begin == std::string_view::npos) return false;
    header.remove_prefix(begin);
    return header.starts_with(name + ".");
}

} // namespace

Result<TomlText> TomlText::parse(std::string text) {
    TomlText document;
    try {
        document.root_ = toml::parse(text);
    } catch (const toml::parse_error& problem) {
        const TomlProblem found = toml_problem(problem);
        return Error{found.what, "line " + std::to_string(found.line)};
    }
    document.text_ = std::move(text);
    if (document.text_.find("\r\n") != std::string::npos) document.line_end_ = "\r\n";
    document.lines_.push_back(0);
    for (std::size_t i = 0; i < document.text_.size(); ++i)
        if (document.text_[i] == '\n') document.lines_.push_back(i + 1);
    return document;
}

std::vector<const toml::table*> TomlText::tables(const std::string& name) const {
    std::vector<const toml::table*> found;
    if (const toml::array* array = root_[name].as_array())
        for (const toml::node& entry : *array) found.push_back(entry.as_table());
    return found;
}

std::size_t TomlText::line_begin(std::size_t line) const {
    return line - 1 < lines_.size() ? lines_[line - 1] : text_.size();
}

std::size_t TomlText::end_of_line_at(std::size_t offset) const {
    const std::size_t end = text_.find('\n', offset);
    return end == std::string::npos ? text_.size() : end + 1;
}

// Columns count code points.
std::size_t TomlText::offset_of(toml::source_position position) const {
    std::size_t offset = line_begin(position.line);
    for (toml::source_index column = 1; column < position.column && offset < text_.size(); ++column) {
        ++offset;
        while (offset < text_.size() && (static_cast<unsigned char>(text_[offset]) & 0xc0) == 0x80) ++offset;
    }
    return offset;
}

Result<TomlText::Span> TomlText::span_of(const toml::table& table, const std::string& name) const {
    if (table.is_inline())
        return Error{"is written as an inline table; only [[" + name + "]] can be edited",
                     "line " + std::to_string(table.source().begin.line)};
    std::vector<bool> inside(lines_.size() + 1, false);
    mark_values(root_, inside);
    const std::size_t first = table.source().begin.line;
    std::size_t last = first; // with anything but blanks and comments
    for (std::size_t line = first + 1; line <= lines_.size(); ++line) {
        const std::size_t begin = line_begin(line);
        const std::string_view words = std::string_view(text_).substr(begin, line_begin(line + 1) - begin);
        const std::size_t letter = words.find_first_not_of(" \t\r\n");
        if (!inside[line]) {
            if (letter == std::string_view::npos || words[letter] == '#') continue;
            if (words[letter] == '[' && !is_below(words, name)) break;
        }
        last = line;
    }
    return Span{line_begin(first), line_begin(last + 1)};
}

Result<void> TomlText::set(const toml::table& table, const std::string& key, const std::string& value) {
    if (const toml::node* node = table.get(key)) {
        replace({offset_of(node->source().begin), offset_of(node->source().end)}, value);
        return {};
    }
    if (table.is_inline())
        return Error{"is written as an inline table, which is not edited",
                     "line " + std::to_string(table.source().begin.line)};
    std::size_t line = table.source().begin.line;
    for (const auto& [name, node] : table) {
        const toml::table* below = node.as_table();
        const toml::array* array = node.as_array();
        const bool has_header = (below && !below->is_inline()) || (array && array->is_array_of_tables());
        if (!has_header) line = std::max<std::size_t>(line, node.source().end.line);
    }
    const std::size_t at = line_begin(line + 1);
    const bool is_open = at == text_.size() && (text_.empty() || text_.back() != '\n');
    replace({at, at}, (is_open ? line_end_ : "") + key + " = " + value + line_end_);
    return {};
}

void TomlText::unset(const toml::table& table, const std::string& key) {
    const auto entry = table.find(key);
    if (entry == table.end()) return;
    replace(
        {line_begin(entry->first.source().begin.line), end_of_line_at(offset_of(entry->second.source().end))},
        "");
}

void TomlText::append(const std::string& block) {
    std::string with;
    if (!text_.empty() && text_.back() != '\n') with += line_end_;
    if (!text_.empty()) with += line_end_;
    replace({text_.size(), text_.size()}, with + block);
}

std::string TomlText::cut() const {
    std::vector<const Cut*> order;
    for (const Cut& one : cuts_) order.push_back(&one);
    // Insertions at one place keep the order in which they were asked for.
    std::stable_sort(order.begin(), order.end(),
                     [](const Cut* a, const Cut* b) { return a->span.begin < b->span.begin; });
    std::string result;
    std::size_t at = 0;
    for (const Cut* one : order) {
        result.append(text_, at, one->span.begin - at);
        result += one->with;
        at = one->span.end;
    }
    return result.append(text_, at, std::string::npos);
}

std::string toml_text(const std::string& words) {
    std::string quoted = "\"";
    for (const char letter : words) {
        if (letter == '"' || letter == '\\') quoted += '\\';
        if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f)
            quoted += ' '; // a name has no control characters
        else
            quoted += letter;
    }
    return quoted + '"';
}

std::string toml_text(const std::vector<std::string>& names) {
    std::string text = "[";
    for (const std::string& name : names) text += (text.size() > 1 ? ", " : "") + toml_text(name);
    return text + "]";
}

std::string toml_text(float number) {
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), number == 0 ? 0.0f : number).ptr;
    return {digits.data(), end};
}

} // namespace ghost::scene
