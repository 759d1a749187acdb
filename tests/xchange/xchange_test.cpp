// SPDX-License-Identifier: Apache-2.0
// Two stations of MVR-xchange on the loopback interface, and stations that do what none should: no mDNS here,
// that is tests/scripts/xchange_test.py.
#include "support/stations.h"

#include "net/mdns.h"

namespace ghost::app {
namespace {

using namespace stations;

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
constexpr std::uint32_t kHere = 0x7F000001, kBeside = 0x7F000002;

bool says(std::uint32_t from, std::uint16_t port, const std::string& name, bool gone) {
    const scene::XchangeStation one{name, name, "Default", dmx::IpAddress(kHere), 9, gone};
    const auto bytes = dmx::build_dns(scene::xchange_announcement(one));
    const auto out = dmx::UdpSocket::open(from, 0, 1 << 16);
    return out.ok() && (*out)->send(bytes, dmx::IpAddress(kHere), port).ok();
}

// Through the loopback, with an address of another network.
TEST(XchangeStations, who_is_not_on_the_link_is_not_met) {
    XchangeOptions options = station("B");
    options.finds = true;
    options.mdns_port = 25'355;
    const auto b = start(options);
    int tried = 0;
    for (const dmx::NetInterface& far : dmx::list_interfaces())
        if (!far.loopback && far.address != 0) {
            EXPECT_TRUE(says(far.address, options.mdns_port, "Far", false));
            ++tried;
        }
    if (tried == 0) GTEST_SKIP() << "this machine has the loopback alone: nobody else's address to send from";
    ASSERT_TRUE(says(kHere, options.mdns_port, "Near", false));
    const auto met = wait_for(*b, Kind::found);
    ASSERT_TRUE(met.has_value());
    EXPECT_EQ(met->station, "Near") << "the first that is met";
}

TEST(XchangeStations, neighbours_are_met_and_speak_for_themselves) {
    XchangeOptions options = station("B");
    options.finds = true;
    options.mdns_port = 25'354;
    const auto b = start(options);
    ASSERT_TRUE(says(kHere, options.mdns_port, "Near", false));
    const auto met = wait_for(*b, Kind::found);
    ASSERT_TRUE(met.has_value());
    EXPECT_EQ(met->station, "Near") << "the first that is met";
    ASSERT_TRUE(says(kBeside, options.mdns_port, "Near", true));
    ASSERT_TRUE(says(kHere, options.mdns_port, "Second", false));
    const auto next = wait_for(*b, Kind::found); // by then the goodbye of another has been heard
    ASSERT_TRUE(next.has_value());
    EXPECT_EQ(next->station, "Second");
    ASSERT_TRUE(says(kHere, options.mdns_port, "Near", true));
    const auto left = wait_for(*b, Kind::left);
    ASSERT_TRUE(left.has_value());
    EXPECT_EQ(left->station, "Near");
    EXPECT_FALSE(wait_for(*b, Kind::left, 1s).has_value()) << "once, by its own word";
}

} // namespace
} // namespace ghost::app
