// SPDX-License-Identifier: Apache-2.0
// The cue book as browsers get it from the server: what is on its way to all of them together has a limit.
#include "server_peer.h"

#include "book/book_json.h"
#include "disk/files.h"
#include "support/test_folder.h"

#include <algorithm>

namespace ghost::web {
namespace {

constexpr const char* kPicture = "pictures/0001-1.png";
constexpr std::size_t kPictureBytes = std::size_t{16} << 20;

class WebBook : public ::testing::Test {
protected:
    WebBook() {
        scene::Book book;
        book.show = "tour";
        scene::BookEntry entry;
        entry.name = "Verse";
        entry.pictures = {{"house", kPicture}};
        book.entries.push_back(entry);
        std::filesystem::create_directories(folder.path / "pictures");
        EXPECT_TRUE(write_file_atomic(folder.path / "book.json", scene::text_of(book)).ok());
        EXPECT_TRUE(write_file_atomic(folder.path / kPicture, std::string(kPictureBytes, 'p')).ok());
        ServerOptions options;
        options.book = folder.path.string();
        server = must(Server::open(link, options));
    }
    std::unique_ptr<Peer> ask_for(const std::string& file) {
        auto peer = std::make_unique<Peer>(server->port());
        peer->send(request_for(file));
        return peer;
    }
    std::string request_for(const std::string& file) const {
        return "GET /book/" + file + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server->port()) +
               "\r\nAuthorization: Bearer " + server->keys().token + "\r\n\r\n";
    }

    TestFolder folder;
    ui::Link link;
    std::unique_ptr<Server> server;
};

TEST_F(WebBook, a_file_comes_whole_and_the_connection_ends) {
    const auto text = ask_for("book.json");
    EXPECT_EQ(text->status(), 200);
    EXPECT_TRUE(text->is_closed());
    EXPECT_NE(text->text().find("ghostlight_book"), std::string::npos);
    const auto picture = ask_for(kPicture);
    EXPECT_TRUE(picture->is_closed());
    EXPECT_EQ(picture->status(), 200);
    const std::string all = picture->text();
    EXPECT_EQ(all.size() - all.find("\r\n\r\n") - 4, kPictureBytes);
    EXPECT_EQ(ask_for("pictures/0002-1.png")->status(), 404);
}

TEST_F(WebBook, those_who_read_nothing_hold_64_MiB_together_and_no_more) {
    std::vector<std::unique_ptr<Peer>> greedy;
    std::size_t given = 0, refused = 0;
    for (int i = 0; i < 8; ++i) {
        greedy.push_back(ask_for(kPicture));
        const int status = greedy.back()->status();
        given += status == 200;
        refused += status == 503;
    }
    EXPECT_EQ(given, 4u);
    EXPECT_EQ(refused, 4u);
    EXPECT_NE(greedy.back()->text().find("on its way already"), std::string::npos) << "a sentence";
    greedy.clear();
    int status = 503;
    for (int tries = 0; tries < 200 && status == 503; ++tries) {
        std::this_thread::sleep_for(20ms);
        status = ask_for(kPicture)->status();
    }
    EXPECT_EQ(status, 200) << "they have left";
}

TEST_F(WebBook, who_goes_on_while_a_file_is_read_is_refused) {
    Peer endless(server->port()), hasty(server->port());
    endless.send(request_for("book.json") + std::string(20'000, 'x'));
    EXPECT_EQ(endless.status(), 413);
    hasty.send(request_for("book.json") + request_for("book.json"));
    EXPECT_EQ(hasty.status(), 200) << "one answer, as for who asks once";
}

} // namespace
} // namespace ghost::web
