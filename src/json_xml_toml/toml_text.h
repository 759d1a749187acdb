#pragma once
// SPDX-License-Identifier: Apache-2.0
// TomlText: a TOML document with the places of its tables and values in the text, and cuts that change some
// bytes and leave all others. Pure, any thread.

#include "base/result.h"

#include <cstddef>
#include <string>
#include <toml++/toml.h>
#include <vector>

namespace ghost::scene {

class TomlText {
public:
    // Error: no TOML, with its line.
    static Result<TomlText> parse(std::string text);

    const std::string& text() const { return text_; }
    const toml::table& root() const { return root_; }
    // The tables [[name]]; an entry that is none is null.
    std::vector<const toml::table*> tables(const std::string& name) const;

    // Bytes of the text: from the header of a table to the end of its last line, tables below it ([name.x])
    // too, comments before the next header not.
    struct Span {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    Result<Span> span_of(const toml::table& table, const std::string& name) const;

    // Cuts, carried out by cut(): they must not overlap.
    Result<void> set(const toml::table& table, const std::string& key, const std::string& value);
    void unset(const toml::table& table, const std::string& key);
    void replace(Span span, std::string with) { cuts_.push_back({span, std::move(with)}); }
    // A whole block at the end of the text, with a blank line before it.
    void append(const std::string& block);
    std::string cut() const;

    // "\n", or "\r\n" where the text has it.
    const std::string& line_end() const { return line_end_; }

private:
    struct Cut {
        Span span;
        std::string with;
    };

    std::size_t offset_of(toml::source_position position) const;
    std::size_t line_begin(std::size_t line) const;       // 1-based; past the last: the end of the text
    std::size_t end_of_line_at(std::size_t offset) const; // behind its line end

    std::string text_;
    toml::table root_;
    std::vector<std::size_t> lines_; // where each begins
    std::string line_end_ = "\n";
    std::vector<Cut> cuts_;
};

// As TOML writes it.
std::string toml_text(const std::string& words);              // "quoted"
std::string toml_text(const std::vector<std::string>& names); // ["a", "b"]
std::string toml_text(float number);

} // namespace ghost::scene
