// SPDX-License-Identifier: Apache-2.0
// Files of the cue book for those who asked for one: read one at a time by a thread apart, and only while
// what is on its way to all of them has room for it.
#include "web/private/server_loop.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ghost::web {
namespace {

constexpr std::size_t kMostBookBytes = std::size_t{64} << 20; // and one more

} // namespace

void ServerLoop::read_book() {
    for (Guest& guest : guests_) {
        if (is_reading_) return;
        if (!guest.book || guest.reading > 0 || guest.connection.is_ending()) continue;
        if (book_bytes() >= kMostBookBytes) {
            guest.book.reset();
            Answer busy = refusal(503);
            busy.body = "Much of the cue book is on its way already; try again in a moment.\n";
            answer(guest, busy);
            continue;
        }
        guest.reading = ++readings_;
        is_reading_ = true;
        reader_.put([this, book = book_, name = *guest.book, reading = readings_]() -> Worker::Done {
            return [this, reading, file = book->file(name)] { answer_book(reading, file); };
        });
    }
}

void ServerLoop::answer_book(std::uint64_t reading, const Result<BookShelf::File>& file) {
    is_reading_ = false;
    const auto guest = std::find_if(guests_.begin(), guests_.end(),
                                    [&](const Guest& one) { return one.reading == reading; });
    if (guest == guests_.end()) return;
    guest->book.reset();
    if (!file.ok()) {
        Answer missing = refusal(404);
        missing.text = file.error().what + "\n"; // no path of this machine
        missing.body = {};
        return answer(*guest, missing);
    }
    const Answer found{.type = file->type, .body = {}, .text = {}, .fields = {}};
    guest->file = file->bytes;
    guest->connection.put(answer_head(found, file->bytes->size()));
    guest->connection.put(file->bytes);
    guest->connection.end(now_s());
}

// What several get is there once.
std::size_t ServerLoop::book_bytes() const {
    std::set<SharedText> files;
    for (const Guest& guest : guests_)
        if (guest.file && guest.connection.unsent() > 0) files.insert(guest.file);
    std::size_t bytes = 0;
    for (const SharedText& file : files) bytes += file->size();
    return bytes;
}

} // namespace ghost::web
