#pragma once
// SPDX-License-Identifier: Apache-2.0
// Words that are printed on paper, in each language: one table. A Word is written as its English text, and
// one that is not in the table does not compile, so every language has all of them. "%1", "%2" stand for
// values (PrintStyle fills them in). Pure, any thread.

#include "print/word_table.h"

#include <cstddef>
#include <string_view>

namespace ghost::scene {

enum class Language { english, german };

class Word {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a literal is a word
    consteval Word(const char* english) : index_(index_of(english)) {}

    constexpr std::string_view in(Language language) const {
        return language == Language::english ? kWords[index_].english : kWords[index_].german;
    }

private:
    static consteval std::size_t index_of(std::string_view english) {
        for (std::size_t i = 0; i < std::size(kWords); ++i)
            if (kWords[i].english == english) return i;
        throw "not in the table of words"; // while it compiles: it does not
    }

    std::size_t index_;
};

} // namespace ghost::scene
