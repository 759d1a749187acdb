// SPDX-License-Identifier: Apache-2.0
#include "book/book.h"

#include "book/private/paper_tables.h"
#include "show/show.h"

namespace ghost::scene {

Book book_of(const Show& show, const PrintStyle& style) {
    Book book;
    book.show = show.name.empty() ? show.folder.filename().string() : show.name;
    std::size_t unread = 0;
    for (const PatchedFixture& fixture : show.fixtures) {
        BookFixture& entry = book.fixtures.emplace_back();
        entry.name = fixture.name;
        entry.id = fixture.fixture_id;
        entry.uuid = fixture.uuid;
        entry.addresses = addresses_of(fixture);
        entry.position_m = fixture.position_m;
        entry.rotation_deg = fixture.rotation_deg;
        if (!fixture.type) {
            ++unread;
            continue;
        }
        entry.type =
            fixture.type->manufacturer + (fixture.type->manufacturer.empty() ? "" : " ") + fixture.type->name;
        if (!fixture.type->modes.empty()) entry.mode = fixture.patch().mode_of().name;
    }
    if (unread > 0)
        book.unknown.push_back(
            style("%1 fixtures have no file that could be read: their light is in no picture",
                  {std::to_string(unread)}));
    if (show.fixtures.empty()) book.unknown.push_back(style("the show has no fixtures"));
    return book;
}

} // namespace ghost::scene
