// SPDX-License-Identifier: Apache-2.0
// Two stations of MVR-xchange on the loopback interface, and stations that do what none should: no mDNS here,
// that is tests/scripts/xchange_test.py.
#include "xchange/private/xchange_peer.h"
#include "xchange/xchange.h"

#include "support/must.h"
#include "support/tiny_gdtf.h"

#include "disk/files.h"
#include "net/mdns.h"
#include "net/socket.h"
#include "net/tcp.h"
#include "xchange/protocol.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Kind = XchangeEvent::Kind;

struct Folder {
    fs::path path;
    Folder() {
        std::string name = (fs::temp_directory_path() / "ghost_xchange_XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
};

// A plot without anything in it, and so many bytes beside.
std::string write_plot(const fs::path& path, std::size_t bytes) {
    std::string filler;
    for (std::size_t i = 0; filler.size() < bytes; ++i) filler += static_cast<char>(i * 2654435761u >> 13);
    const auto zip =
        fixture::make_zip({{"GeneralSceneDescription.xml",
                            "<GeneralSceneDescription verMajor=\"1\" verMinor=\"6\"><Scene><Layers/>"
                            "</Scene></GeneralSceneDescription>"},
                           {"filler.bin", filler}});
    const std::string content(zip.begin(), zip.end());
    EXPECT_TRUE(write_file_atomic(path, content).ok());
    return content;
}

XchangeOptions station(const std::string& name) {
    XchangeOptions options;
    options.station = name;
    options.interface = "127.0.0.1";
    options.finds = false;
    return options;
}

std::string at(std::uint16_t port) {
    return "127.0.0.1:" + std::to_string(port);
}

// What a station tells, until it tells one of that kind; nothing when that takes too long.
std::optional<XchangeEvent> wait_for(Xchange& xchange, Kind kind, std::chrono::seconds patience = 20s) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
        for (XchangeEvent& event : xchange.take())
            if (event.kind == kind) return std::move(event);
        std::this_thread::sleep_for(5ms);
    }
    return std::nullopt;
}

std::string content_of(const fs::path& path) {
    const auto text = read_text_file(path, 1u << 30);
    return text.ok() ? *text : text.error().text();
}

std::unique_ptr<Xchange> start(const XchangeOptions& options) {
    return must(Xchange::start(options));
}

TEST(XchangeStations, a_plot_goes_from_one_to_the_other_whole) {
    const Folder folder;
    const std::string content = write_plot(folder.path / "tour.mvr", 5'000'000);
    XchangeOptions sharing = station("A");
    sharing.share = {folder.path / "tour.mvr"};
    const auto a = start(sharing);
    XchangeOptions saving = station("B");
    saving.save = folder.path / "come";
    saving.peers = {at(a->port())};
    const auto b = start(saving);
    const auto received = wait_for(*b, Kind::received);
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(received->station, "A");
    EXPECT_EQ(received->file, folder.path / "come" / "tour.mvr");
    EXPECT_EQ(content_of(received->file), content);
    EXPECT_TRUE(wait_for(*a, Kind::sent).has_value());
    // Another station with the same folder writes over nothing.
    saving.station = "C";
    const auto c = start(saving);
    const auto again = wait_for(*c, Kind::received);
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->file, folder.path / "come" / "tour (2).mvr");
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder.path / "come")) files += entry.is_regular_file();
    EXPECT_EQ(files, 2u); // and no temporary one
}

// A link that leads to nothing is there all the same.
TEST(XchangeStations, what_comes_replaces_no_link) {
    const Folder folder;
    const std::string content = write_plot(folder.path / "tour.mvr", 1000);
    fs::create_directory(folder.path / "come");
    fs::create_symlink(folder.path / "nowhere", folder.path / "come" / "tour.mvr");
    XchangeOptions sharing = station("A");
    sharing.share = {folder.path / "tour.mvr"};
    const auto a = start(sharing);
    XchangeOptions saving = station("B");
    saving.save = folder.path / "come";
    saving.peers = {at(a->port())};
    const auto b = start(saving);
    const auto received = wait_for(*b, Kind::received);
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(received->file, folder.path / "come" / "tour (2).mvr");
    EXPECT_EQ(content_of(received->file), content);
    EXPECT_TRUE(fs::is_symlink(folder.path / "come" / "tour.mvr"));
    EXPECT_FALSE(fs::exists(folder.path / "nowhere"));
}

TEST(XchangeStations, says_goodbye) {
    const Folder folder;
    const auto a = start(station("A"));
    XchangeOptions other = station("B");
    other.peers = {at(a->port())};
    {
        const auto b = start(other);
        ASSERT_TRUE(wait_for(*b, Kind::joined).has_value());
    }
    const auto left = wait_for(*a, Kind::left);
    ASSERT_TRUE(left.has_value());
}

TEST(XchangeStations, a_peer_that_cannot_be_joined_is_said_once) {
    std::uint16_t port = 0;
    {
        const auto gone = dmx::TcpListener::open(0x7F000001, 0);
        ASSERT_TRUE(gone.ok());
        port = (*gone)->port();
    }
    XchangeOptions options = station("B");
    options.peers = {at(port)};
    const auto b = start(options);
    const auto trouble = wait_for(*b, Kind::trouble);
    ASSERT_TRUE(trouble.has_value());
    EXPECT_EQ(trouble->station, at(port));
    EXPECT_NE(trouble->text.find("cannot be joined: Connection refused"), std::string::npos) << trouble->text;
    // It comes, and is joined; nothing more is said of it meanwhile.
    XchangeOptions late = station("A");
    late.port = port;
    const auto a = start(late);
    const auto end = std::chrono::steady_clock::now() + 40s;
    bool joined = false;
    while (!joined && std::chrono::steady_clock::now() < end) {
        for (const XchangeEvent& event : b->take()) {
            EXPECT_NE(event.kind, Kind::trouble) << event.text;
            joined |= event.kind == Kind::joined;
        }
        std::this_thread::sleep_for(5ms);
    }
    EXPECT_TRUE(joined);
}

TEST(XchangeStations, what_is_no_plot_is_not_shared) {
    const Folder folder;
    const auto bytes = fixture::make_zip({{"else.txt", "no description"}});
    for (const std::string& content : {std::string("not a zip"), std::string("PK\3\4 nor this", 13),
                                       std::string(bytes.begin(), bytes.end())}) {
        ASSERT_TRUE(write_file_atomic(folder.path / "tour.mvr", content).ok());
        XchangeOptions options = station("A");
        options.share = {folder.path / "tour.mvr"};
        const auto started = Xchange::start(options);
        ASSERT_FALSE(started.ok()) << content;
        EXPECT_EQ(started.error().where, (folder.path / "tour.mvr").string());
        EXPECT_NE(started.error().what.find("it is no .mvr"), std::string::npos) << started.error().what;
    }
}

TEST(XchangeStations, what_cannot_be_is_said_at_the_start) {
    const Folder folder;
    XchangeOptions options = station("A");
    options.share = {folder.path / "none.mvr"};
    EXPECT_FALSE(Xchange::start(options).ok());
    options = station("A");
    options.peers = {"127.0.0.1"};
    EXPECT_FALSE(Xchange::start(options).ok());
    options = station("A");
    options.save = "/proc/none";
    EXPECT_FALSE(Xchange::start(options).ok());
    options = station("A");
    options.group = "";
    EXPECT_FALSE(Xchange::start(options).ok());
    options = station("A");
    options.interface = "nothing0";
    EXPECT_FALSE(Xchange::start(options).ok());
}

std::string package(const std::string& content,
                    scene::XchangePayload payload = scene::XchangePayload::message) {
    const auto header = scene::build_xchange_header(payload, content.size());
    return std::string(header.begin(), header.end()) + content;
}

// A station made by hand: what it answers to a message of a type is the test's. It joins by --peer.
class Forged {
public:
    explicit Forged(std::function<std::string(const scene::XchangeMessage&)> answer)
        : answer_(std::move(answer)) {
        listener_ = std::move(*dmx::TcpListener::open(0x7F000001, 0));
        thread_ = std::thread([this] { run(); });
    }
    ~Forged() {
        stop_ = true;
        thread_.join();
    }
    std::uint16_t port() const { return listener_->port(); }
    // From now on whoever was answered gets a byte more now and then.
    void trickle() { trickles_ = true; }

private:
    struct Visitor {
        std::unique_ptr<dmx::TcpStream> stream;
        scene::XchangeReader reader;
        std::string out;
        bool answered = false;
    };
    void run() {
        int turns = 0;
        std::vector<Visitor> visitors;
        while (!stop_) {
            while (auto stream = listener_->accept()) visitors.push_back({std::move(stream), {}, {}, false});
            for (Visitor& visitor : visitors) {
                if (!visitor.stream) continue;
                const scene::XchangeReader::Sink sink{[&](std::string_view json) -> Result<void> {
                                                          visitor.out +=
                                                              answer_(*scene::parse_xchange_message(json));
                                                          return {};
                                                      },
                                                      [](Bytes, bool) -> Result<void> { return {}; }};
                const auto bytes = visitor.stream->read();
                if (!bytes || (!bytes->empty() && !visitor.reader.take(*bytes, sink).ok())) {
                    visitor.stream.reset();
                    continue;
                }
                const auto sent = visitor.stream->send(
                    {reinterpret_cast<const std::uint8_t*>(visitor.out.data()), visitor.out.size()});
                if (sent) visitor.out.erase(0, *sent);
                visitor.answered |= sent && *sent > 0;
                if (trickles_ && visitor.answered && turns % 500 == 0) visitor.out += '\0';
            }
            ++turns;
            std::this_thread::sleep_for(1ms);
        }
    }

    std::function<std::string(const scene::XchangeMessage&)> answer_;
    std::unique_ptr<dmx::TcpListener> listener_;
    std::atomic<bool> stop_{false}, trickles_{false};
    std::thread thread_;
};

// Offers one plot, and answers the request for it with these bytes.
std::function<std::string(const scene::XchangeMessage&)> offering(const std::string& reply,
                                                                  const std::string& name = "x.mvr") {
    return [=](const scene::XchangeMessage& message) -> std::string {
        if (message.type == "MVR_REQUEST") return reply;
        if (message.type != "MVR_JOIN") return "";
        return package(R"({"Type":"MVR_JOIN_RET","OK":"true","StationName":"Forged","StationUUID":"f",)"
                       R"("Commits":[{"FileUUID":"1","FileName":")" +
                       name + R"("}]})");
    };
}

TEST(XchangeStations, messages_without_what_tells_them_apart_are_refused) {
    const Folder folder;
    XchangeOptions options = station("A");
    options.save = folder.path / "come";
    const auto a = start(options);
    const auto answer_to = [&](const std::string& message) {
        const auto stream = must(dmx::TcpStream::connect(0x7F000001, a->port()));
        const std::string bytes = package(message);
        std::string answer;
        const scene::XchangeReader::Sink sink{[&](std::string_view json) -> Result<void> {
                                                  answer = json;
                                                  return {};
                                              },
                                              [](Bytes, bool) -> Result<void> { return {}; }};
        scene::XchangeReader reader;
        std::size_t sent = 0;
        const auto end = std::chrono::steady_clock::now() + 10s;
        while (answer.empty() && std::chrono::steady_clock::now() < end) {
            sent +=
                stream
                    ->send({reinterpret_cast<const std::uint8_t*>(bytes.data()) + sent, bytes.size() - sent})
                    .value_or(0);
            if (const auto piece = stream->read(); piece && !piece->empty()) (void)reader.take(*piece, sink);
            std::this_thread::sleep_for(5ms);
        }
        return must(scene::parse_xchange_message(answer));
    };
    const auto nameless = answer_to(R"({"Type":"MVR_JOIN","StationName":"B","Commits":[]})");
    EXPECT_EQ(nameless.type, "MVR_JOIN_RET");
    EXPECT_FALSE(nameless.ok);
    EXPECT_NE(nameless.text.find("StationUUID"), std::string::npos) << nameless.text;
    const auto fileless = answer_to(R"({"Type":"MVR_COMMIT","StationUUID":"b","FileName":"x.mvr"})");
    EXPECT_EQ(fileless.type, "MVR_COMMIT_RET");
    EXPECT_FALSE(fileless.ok);
    EXPECT_NE(fileless.text.find("FileUUID"), std::string::npos) << fileless.text;
    EXPECT_TRUE(answer_to(R"({"Type":"MVR_JOIN","StationName":"B","StationUUID":"b","Commits":[]})").ok);
}

TEST(XchangeStations, hostile_answers_save_nothing_and_end_nothing) {
    const Folder folder;
    std::string huge = package("", scene::XchangePayload::file);
    for (std::size_t i = 20; i < 28; ++i) huge[i] = '\x7F';
    const std::vector<std::pair<std::string, std::string>> replies = {
        {"a length nobody should believe", huge},
        {"wrong magic", std::string(4096, 'G')},
        {"a file that is no zip", package("<html>not here</html>", scene::XchangePayload::file)},
        {"an empty file", package("", scene::XchangePayload::file)},
        {"a refusal", package(R"({"Type":"MVR_REQUEST_RET","OK":false,"Message":"no"})")},
        {"no JSON", package("}{")},
    };
    for (const auto& [what, reply] : replies) {
        const Forged forged(offering(reply));
        XchangeOptions options = station("B");
        options.save = folder.path / "come";
        options.peers = {at(forged.port())};
        const auto b = start(options);
        const auto trouble = wait_for(*b, Kind::trouble);
        ASSERT_TRUE(trouble.has_value()) << what;
        EXPECT_NE(trouble->text.find("did not come"), std::string::npos) << what << ": " << trouble->text;
        EXPECT_TRUE(fs::is_empty(folder.path / "come")) << what;
    }
}

TEST(XchangeStations, a_name_leads_nowhere_else) {
    const Folder folder;
    const Forged forged(
        offering(package(std::string("PK\3\4xyz", 7), scene::XchangePayload::file), "../../../outside.mvr"));
    XchangeOptions options = station("B");
    options.save = folder.path / "come";
    options.peers = {at(forged.port())};
    const auto b = start(options);
    const auto received = wait_for(*b, Kind::received);
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(received->file.parent_path(), folder.path / "come");
    EXPECT_EQ(content_of(received->file), std::string("PK\3\4xyz", 7));
}

TEST(XchangeStations, visitors_that_say_nothing_or_nonsense_leave_room_for_others) {
    const Folder folder;
    const std::string content = write_plot(folder.path / "tour.mvr", 100'000);
    XchangeOptions sharing = station("A");
    sharing.share = {folder.path / "tour.mvr"};
    const auto a = start(sharing);
    std::vector<std::unique_ptr<dmx::TcpStream>> visitors;
    for (int i = 0; i < 300; ++i) {
        auto visitor = dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), a->port());
        if (!visitor.ok()) break;
        visitors.push_back(std::move(*visitor));
        const std::string bytes = i % 3 == 0 ? std::string(100, 'x') : package("{").substr(0, 29);
        std::this_thread::sleep_for(1ms);
        if (i % 3 != 2)
            (void)visitors.back()->send({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    }
    ASSERT_GT(visitors.size(), 100u);
    XchangeOptions saving = station("B");
    saving.save = folder.path / "come";
    saving.peers = {at(a->port())};
    const auto b = start(saving);
    const auto received = wait_for(*b, Kind::received, 40s);
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(content_of(received->file), content);
}

TEST(XchangeStations, a_thousand_offers_are_bounded) {
    const Folder folder;
    std::atomic<int> requests{0};
    std::string commits;
    for (int i = 0; i < 1000; ++i)
        commits +=
            package(R"({"Type":"MVR_COMMIT","StationUUID":"f","FileUUID":"c)" + std::to_string(i) + "\"}");
    const Forged forged([&](const scene::XchangeMessage& message) -> std::string {
        if (message.type == "MVR_REQUEST") ++requests;
        if (message.type == "MVR_REQUEST") return package(R"({"Type":"MVR_REQUEST_RET","OK":false})");
        if (message.type != "MVR_JOIN") return "";
        return commits + package(R"({"Type":"MVR_JOIN_RET","OK":true,"StationUUID":"f"})");
    });
    XchangeOptions options = station("B");
    options.save = folder.path / "come";
    options.peers = {at(forged.port())};
    const auto b = start(options);
    const auto joined = wait_for(*b, Kind::joined);
    ASSERT_TRUE(joined.has_value());
    std::this_thread::sleep_for(1s);
    EXPECT_LE(requests, 300); // at most 256 wait at a time
    EXPECT_LE(b->take().size(), 1000u);
}

// Somebody who asks and asks, and never reads what he is answered.
TEST(XchangePeer, answers_that_nobody_reads_have_an_end) {
    const auto listener = dmx::TcpListener::open(0x7F000001, 0);
    ASSERT_TRUE(listener.ok());
    auto visitor = dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), (*listener)->port());
    ASSERT_TRUE(visitor.ok());
    std::unique_ptr<dmx::TcpStream> stream;
    while (!(stream = (*listener)->accept())) std::this_thread::sleep_for(1ms);
    XchangePeer peer(std::move(stream), 0);
    scene::XchangeMessage answer;
    answer.type = "MVR_JOIN_RET";
    answer.commits.resize(200);
    for (scene::XchangeCommit& commit : answer.commits) commit.comment = std::string(200, 'x');
    std::string question = package(R"({"Type":"MVR_JOIN"})"), questions;
    while (questions.size() < 60'000) questions += question;
    Result<void> turned;
    std::size_t most = 0;
    for (int round = 0; round < 200 && turned.ok(); ++round) {
        (void)(*visitor)->send({reinterpret_cast<const std::uint8_t*>(questions.data()), questions.size()});
        turned = peer.turn(0, {[&](const scene::XchangeMessage&) {
                                   peer.say(answer);
                                   most = std::max(most, peer.waiting_bytes());
                               },
                               [](Bytes, bool) -> Result<void> { return {}; }});
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_FALSE(turned.ok());
    EXPECT_LT(most, 5u << 20);
}

// The address of --peer is the user's: what the network says of it changes nothing.
TEST(XchangeStations, a_forged_goodbye_does_not_erase_a_fixed_peer) {
    const Forged forged(offering(""));
    XchangeOptions options = station("B");
    options.peers = {at(forged.port())};
    options.finds = true;
    options.mdns_port = 25'353;
    const auto b = start(options);
    ASSERT_TRUE(wait_for(*b, Kind::joined).has_value());
    scene::XchangeStation gone{"Forged", "", "Default", dmx::IpAddress(0x7F000001), forged.port(), true};
    const auto bytes = dmx::build_dns(scene::xchange_announcement(gone));
    const auto out = dmx::UdpSocket::open(0, 0, 1 << 16);
    ASSERT_TRUE(out.ok());
    for (int k = 0; k < 10; ++k) {
        ASSERT_TRUE((*out)->send(bytes, dmx::IpAddress(0x7F000001), options.mdns_port).ok());
        std::this_thread::sleep_for(100ms);
    }
    for (const XchangeEvent& event : b->take()) EXPECT_NE(event.kind, Kind::left) << event.text;
}

// What a network further away says, and what one station says for another.
TEST(XchangeStations, neighbours_are_met_and_speak_for_themselves) {
    XchangeOptions options = station("B");
    options.finds = true;
    options.mdns_port = 25'354;
    const auto b = start(options);
    constexpr std::uint32_t kHere = 0x7F000001, kBeside = 0x7F000002;
    const auto says = [&](std::uint32_t from, const std::string& name, bool gone) {
        const scene::XchangeStation one{name, name, "Default", dmx::IpAddress(kHere), 9, gone};
        const auto bytes = dmx::build_dns(scene::xchange_announcement(one));
        const auto out = dmx::UdpSocket::open(from, 0, 1 << 16);
        return out.ok() && (*out)->send(bytes, dmx::IpAddress(kHere), options.mdns_port).ok();
    };
    for (const dmx::NetInterface& far : dmx::list_interfaces())
        if (!far.loopback && far.address != 0) {
            EXPECT_TRUE(says(far.address, "Far", false));
        }
    ASSERT_TRUE(says(kHere, "Near", false));
    const auto met = wait_for(*b, Kind::found);
    ASSERT_TRUE(met.has_value());
    EXPECT_EQ(met->station, "Near") << "the first that is met";
    ASSERT_TRUE(says(kBeside, "Near", true));
    ASSERT_TRUE(says(kHere, "Second", false));
    const auto next = wait_for(*b, Kind::found); // by then the goodbye of another has been heard
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(next->station, "Second");
    ASSERT_TRUE(says(kHere, "Near", true));
    const auto left = wait_for(*b, Kind::left);
    ASSERT_TRUE(left.has_value());
    EXPECT_EQ(left->station, "Near");
    EXPECT_FALSE(wait_for(*b, Kind::left, 1s).has_value()) << "once, by its own word";
}

TEST(XchangeStations, plots_of_ever_new_numbers_are_counted) {
    const Folder folder;
    std::atomic<int> requests{0};
    const std::string plot = package(std::string("PK\3\4xyz", 7), scene::XchangePayload::file);
    const Forged forged([&](const scene::XchangeMessage& message) -> std::string {
        if (message.type == "MVR_JOIN")
            return package(R"({"Type":"MVR_JOIN_RET","OK":true,"StationUUID":"f"})");
        if (message.type != "MVR_REQUEST") return "";
        ++requests;
        return plot;
    });
    XchangeOptions options = station("B");
    options.save = folder.path / "come";
    options.peers = {at(forged.port())};
    const auto b = start(options);
    ASSERT_TRUE(wait_for(*b, Kind::joined).has_value());
    const auto visitor = must(dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), b->port()));
    constexpr int kAtOnce = 200, kRounds = 6, kMostTaken = 1000;
    for (int round = 1; round <= kRounds; ++round) {
        std::string commits;
        for (int k = 0; k < kAtOnce; ++k)
            commits += package(R"({"Type":"MVR_COMMIT","StationUUID":"f","FileUUID":")" +
                               std::to_string(round * kAtOnce + k) + "\"}");
        ASSERT_EQ(visitor->send({reinterpret_cast<const std::uint8_t*>(commits.data()), commits.size()}),
                  commits.size());
        const int wanted = std::min(round * kAtOnce, kMostTaken);
        for (int k = 0; k < 3000 && requests < wanted; ++k) std::this_thread::sleep_for(10ms);
        ASSERT_EQ(requests, wanted);
    }
    std::this_thread::sleep_for(300ms);
    EXPECT_EQ(requests, kMostTaken);
    const auto said = wait_for(*b, Kind::trouble);
    ASSERT_TRUE(said.has_value());
    EXPECT_NE(said->text.find("more plots at once than are taken"), std::string::npos) << said->text;
}

TEST(XchangeStations, the_plots_of_a_session_have_so_many_bytes_and_no_more) {
    const Folder folder;
    const std::string content = write_plot(folder.path / "tour.mvr", 50'000);
    XchangeOptions sharing = station("A");
    sharing.share = {folder.path / "tour.mvr"};
    const auto a = start(sharing);
    XchangeOptions saving = station("B");
    EXPECT_EQ(saving.most_bytes, 16ull << 30);
    saving.save = folder.path / "come";
    saving.peers = {at(a->port())};
    saving.most_bytes = content.size();
    {
        const auto b = start(saving);
        const auto received = wait_for(*b, Kind::received);
        ASSERT_TRUE(received.has_value());
        EXPECT_EQ(content_of(received->file), content);
    }
    saving.most_bytes = content.size() - 1;
    const auto b = start(saving);
    const auto said = wait_for(*b, Kind::trouble);
    ASSERT_TRUE(said.has_value());
    EXPECT_NE(said->text.find("more than " + std::to_string(content.size() - 1) + " bytes"),
              std::string::npos)
        << said->text;
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder.path / "come")) files += entry.is_regular_file();
    EXPECT_EQ(files, 1u) << "nothing of it is left";
}

// Four stations that bring a byte now and then do not hold the places of others for half an hour.
TEST(XchangeStations, slow_stations_give_their_places_to_those_that_wait) {
    const Folder folder;
    const std::string content = write_plot(folder.path / "tour.mvr", 100'000);
    std::uint16_t late_port = 0;
    {
        const auto reserved = dmx::TcpListener::open(0x7F000001, 0);
        ASSERT_TRUE(reserved.ok());
        late_port = (*reserved)->port();
    }
    XchangeOptions saving = station("B");
    saving.save = folder.path / "come";
    saving.peers = {at(late_port)};
    const auto header = scene::build_xchange_header(scene::XchangePayload::file, 1u << 20);
    const std::string begun = std::string(header.begin(), header.end()) + "PK\3\4";
    std::atomic<int> requests{0};
    std::vector<std::unique_ptr<Forged>> slow;
    for (int k = 0; k < 4; ++k) {
        slow.push_back(std::make_unique<Forged>([&, k](const scene::XchangeMessage& message) -> std::string {
            if (message.type == "MVR_REQUEST") {
                ++requests;
                return begun;
            }
            if (message.type != "MVR_JOIN") return "";
            const std::string number = std::to_string(k);
            return package(R"({"Type":"MVR_JOIN_RET","OK":true,"StationUUID":"f)" + number +
                           R"(","Commits":[{"FileUUID":"slow)" + number + R"("}]})");
        }));
        slow.back()->trickle();
        saving.peers.push_back(at(slow.back()->port()));
    }
    const auto b = start(saving);
    while (requests < 4) std::this_thread::sleep_for(10ms);
    XchangeOptions sharing = station("A");
    sharing.share = {folder.path / "tour.mvr"};
    sharing.port = late_port;
    const auto a = start(sharing);
    const auto received = wait_for(*b, Kind::received, 90s);
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(content_of(received->file), content);
}

} // namespace
} // namespace ghost::app
