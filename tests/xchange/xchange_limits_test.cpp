// SPDX-License-Identifier: Apache-2.0
// What stations of MVR-xchange may not do without end.
#include "support/stations.h"

#include "xchange/private/xchange_peer.h"

namespace ghost::app {
namespace {

using namespace stations;

struct Ends {
    Ends() {
        const auto listener = must(dmx::TcpListener::open(0x7F000001, 0));
        visitor = must(dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), listener->port()));
        std::unique_ptr<dmx::TcpStream> stream;
        for (int k = 0; k < 10'000 && !(stream = listener->accept()); ++k) std::this_thread::sleep_for(1ms);
        if (stream) peer = std::make_unique<XchangePeer>(std::move(stream), 0);
    }
    std::unique_ptr<dmx::TcpStream> visitor;
    std::unique_ptr<XchangePeer> peer;
};

const XchangePeer::Sink kNobody{[](const scene::XchangeMessage&) {},
                                [](Bytes, bool) -> Result<void> { return {}; }};

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
    Ends ends;
    ASSERT_TRUE(ends.peer);
    XchangePeer& peer = *ends.peer;
    scene::XchangeMessage answer;
    answer.type = "MVR_JOIN_RET";
    answer.commits.resize(200);
    for (scene::XchangeCommit& commit : answer.commits) commit.comment = std::string(200, 'x');
    std::string question = package(R"({"Type":"MVR_JOIN"})"), questions;
    while (questions.size() < 60'000) questions += question;
    Result<void> turned;
    std::size_t most = 0;
    for (int round = 0; round < 200 && turned.ok(); ++round) {
        (void)ends.visitor->send({reinterpret_cast<const std::uint8_t*>(questions.data()), questions.size()});
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

// Somebody who reads as fast as he asks, and never all of it.
TEST(XchangePeer, what_was_sent_is_not_kept) {
    Ends ends;
    ASSERT_TRUE(ends.peer);
    XchangePeer& peer = *ends.peer;
    scene::XchangeMessage answer;
    answer.type = "MVR_JOIN_RET";
    answer.commits.resize(200);
    for (scene::XchangeCommit& commit : answer.commits) commit.comment = std::string(200, 'x');
    constexpr std::size_t kWaits = 2u << 20, kRead = 96u << 20, kMostKept = 12u << 20;
    std::size_t read = 0, most = 0;
    for (int round = 0; round < 100'000 && read < kRead; ++round) {
        while (peer.waiting_bytes() < kWaits) peer.say(answer);
        const Result<void> turned = peer.turn(0, kNobody);
        ASSERT_TRUE(turned.ok()) << turned.error().text();
        most = std::max(most, peer.memory_bytes());
        for (int k = 0; k < 8; ++k) {
            const auto bytes = ends.visitor->read();
            ASSERT_TRUE(bytes.has_value());
            if (bytes->empty()) break;
            read += bytes->size();
        }
    }
    EXPECT_GE(read, kRead);
    EXPECT_LT(most, kMostKept);
}

// The others of the thread wait meanwhile.
TEST(XchangePeer, a_turn_sends_a_part_of_a_plot_however_fast_it_is_read) {
    constexpr std::size_t kPlot = 64u << 20, kMostSent = 1u << 20;
    const Folder folder;
    const fs::path plot = folder.path / "plot.mvr";
    ASSERT_TRUE(write_file_atomic(plot, std::string()).ok());
    fs::resize_file(plot, kPlot);
    Ends ends;
    ASSERT_TRUE(ends.peer);
    std::atomic<std::size_t> read{0};
    std::atomic<bool> stop{false};
    std::thread reader([&] {
        while (!stop)
            if (const auto bytes = ends.visitor->read()) read += bytes->size();
    });
    EXPECT_TRUE(ends.peer->send_file(plot).ok());
    EXPECT_TRUE(ends.peer->turn(0, kNobody).ok());
    for (std::size_t before = 0; read == 0 || read != before;) {
        before = read;
        std::this_thread::sleep_for(200ms);
    }
    EXPECT_LE(read, kMostSent);
    for (int turns = 1; turns < 10'000 && read < kPlot; ++turns) {
        EXPECT_TRUE(ends.peer->turn(0, kNobody).ok()) << turns;
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_GE(read, kPlot) << "the next turns send the rest";
    stop = true;
    reader.join();
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

// Half a minute is what such a plot is waited for.
TEST(XchangeStations, a_plot_of_a_station_that_comes_late_is_asked_for_when_it_is_offered_again) {
    const Folder folder;
    std::atomic<int> requests{0};
    const Forged forged([&](const scene::XchangeMessage& message) -> std::string {
        if (message.type == "MVR_JOIN")
            return package(R"({"Type":"MVR_JOIN_RET","OK":true,"StationUUID":"f"})");
        if (message.type == "MVR_REQUEST") ++requests;
        return package(R"({"Type":"MVR_REQUEST_RET","OK":false})");
    });
    XchangeOptions options = station("B");
    options.save = folder.path / "come";
    options.peers = {at(forged.port())};
    const auto b = start(options);
    ASSERT_TRUE(wait_for(*b, Kind::joined).has_value());
    std::vector<std::unique_ptr<dmx::TcpStream>> visitors;
    const auto offer = [&](const std::string& station) {
        visitors.push_back(must(dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), b->port())));
        std::this_thread::sleep_for(300ms); // until it is connected
        const std::string commit =
            package(R"({"Type":"MVR_COMMIT","StationUUID":")" + station + R"(","FileUUID":"one"})");
        EXPECT_EQ(
            visitors.back()->send({reinterpret_cast<const std::uint8_t*>(commit.data()), commit.size()}),
            commit.size());
    };
    offer("nobody yet");
    const auto said = wait_for(*b, Kind::trouble, 45s);
    ASSERT_TRUE(said.has_value());
    EXPECT_NE(said->text.find("a station that cannot be reached"), std::string::npos) << said->text;
    offer("f");
    for (int k = 0; k < 500 && requests == 0; ++k) std::this_thread::sleep_for(10ms);
    EXPECT_EQ(requests, 1);
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
    for (int k = 0; k < 3000 && requests < 4; ++k) std::this_thread::sleep_for(10ms);
    ASSERT_EQ(requests, 4);
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
