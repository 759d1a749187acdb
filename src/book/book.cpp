// SPDX-License-Identifier: Apache-2.0
#include "book/book.h"

#include "book/private/paper_tables.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <set>

namespace ghost::scene {

Book book_of(const Show& show, const PrintStyle& style, bool is_for_client) {
    Book book;
    book.show = show.name.empty() ? show.folder.filename().string() : show.name;
    std::size_t unread = 0;
    std::vector<std::string> placeless, modeless;
    for (const PatchedFixture& fixture : show.fixtures) {
        BookFixture& entry = book.fixtures.emplace_back();
        entry.name = fixture.name;
        entry.id = fixture.fixture_id;
        entry.uuid = fixture.uuid;
        entry.type = type_name(fixture);
        entry.mode = mode_name(fixture);
        entry.addresses = addresses_of(fixture);
        if (!fixture.is_address_known &&
            std::none_of(entry.addresses.begin(), entry.addresses.end(),
                         [](const fixture::Address& address) { return address.channel > 0; }))
            entry.addresses.clear();
        if (fixture.is_rotation_known) entry.rotation_deg = fixture.rotation_deg;
        if (fixture.is_place_known)
            entry.position_m = fixture.position_m;
        else
            placeless.push_back(fixture.name);
        if (!fixture.type)
            ++unread;
        else if (!is_mode_said(fixture))
            modeless.push_back(fixture.name);
    }
    if (unread > 0)
        book.unknown.push_back(
            unread == 1 ? style("1 fixture has no file that could be read: its light is in no picture")
                        : style("%1 fixtures have no file that could be read: their light is in no picture",
                                {std::to_string(unread)}));
    if (show.fixtures.empty()) book.unknown.push_back(style("the show has no fixtures"));
    const std::vector<std::string> addressless = addressless_of(show);
    if (is_for_client) {
        std::set<std::string> assumed(addressless.begin(), addressless.end());
        assumed.insert(placeless.begin(), placeless.end());
        assumed.insert(modeless.begin(), modeless.end());
        if (assumed.size() == 1)
            book.unknown.push_back(style("of 1 fixture address, place or mode is not known: what it does in "
                                         "the pictures is assumed"));
        if (assumed.size() > 1)
            book.unknown.push_back(style("of %1 fixtures address, place or mode is not known: what they do "
                                         "in the pictures is assumed",
                                         {std::to_string(assumed.size())}));
        return book;
    }
    if (!addressless.empty())
        book.unknown.push_back(
            style("the address of %1 cannot be read: all their channels have their defaults",
                  {names_text(addressless, style)}));
    if (!placeless.empty())
        book.unknown.push_back(style(
            "nobody says a place that can be used of %1: they are drawn at the origin of what they hang on",
            {names_text(placeless, style)}));
    if (!modeless.empty())
        book.unknown.push_back(style(
            "nobody names a mode that the type has of %1: what they do is read as in another one of its",
            {names_text(modeless, style)}));
    return book;
}

} // namespace ghost::scene
