// SPDX-License-Identifier: Apache-2.0
#include "book/book_values.h"

#include "book/book.h"
#include "book/paper_pages.h"
#include "show/show.h"

namespace ghost::scene {

BookValues::BookValues() {
    table_.columns = {{"entry", true},
                      {"entry_number"},
                      {"entry_name"},
                      {"fixture_number"},
                      {"fixture"},
                      {"colour"},
                      {"gobo"},
                      {"light_percent", true},
                      {"zoom_deg", true},
                      {"iris_percent", true},
                      {"frost_percent", true},
                      {"focus_percent", true},
                      {"shutters_percent", true},
                      {"strobe_hz", true},
                      {"pan_deg", true},
                      {"tilt_deg", true}};
    csv_ = csv_of(table_);
}

void BookValues::add(const BookEntry& entry, const Show& show, std::span<const FixtureValues> values) {
    const std::string place = std::to_string(++entries_);
    table_.rows.clear();
    for (std::size_t i = 0; i < values.size() && i < show.fixtures.size(); ++i) {
        const PatchedFixture& fixture = show.fixtures[i];
        const FixtureValues& of = values[i];
        if (!fixture.type || !fixture.is_mode_known || of.is_dark()) continue;
        PaperRow row{{place, entry.number, entry.name, fixture.fixture_id, fixture.name, of.colour, of.gobo}};
        for (const float value : {of.light_percent, of.zoom_deg, of.iris_percent, of.frost_percent,
                                  of.focus_percent, of.blades_percent, of.strobe_hz, of.pan_deg, of.tilt_deg})
            row.cells.push_back(PrintStyle{}.number(static_cast<double>(value), 2));
        table_.rows.push_back(std::move(row));
    }
    std::string rows = csv_rows_of(table_);
    if (csv_.size() + rows.size() > kMostValuesBytes) {
        ++left_out_;
        return;
    }
    csv_ += rows;
}

} // namespace ghost::scene
