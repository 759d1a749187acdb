#pragma once
// SPDX-License-Identifier: Apache-2.0
// BookValues: values.csv of a cue book: what each lamp that shines does at each entry, as numbers, for
// programs and spreadsheets. Pure, one thread.

#include "book/fixture_values.h"
#include "book/paper.h"

#include <cstddef>
#include <span>
#include <string>

namespace ghost::scene {

struct BookEntry;
struct Show;

inline constexpr std::size_t kMostValuesBytes = std::size_t{64} << 20; // some 700,000 lines

class BookValues {
public:
    BookValues();

    // values: one for each of the show's fixtures. A fixture of which nobody knows the mode is left out.
    void add(const BookEntry& entry, const Show& show, std::span<const FixtureValues> values);
    const std::string& csv() const { return csv_; }
    std::size_t left_out() const { return left_out_; } // entries, whole, that found no room

private:
    PaperTable table_; // of one entry
    std::size_t entries_ = 0, left_out_ = 0;
    std::string csv_;
};

} // namespace ghost::scene
