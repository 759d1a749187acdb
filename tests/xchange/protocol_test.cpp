// SPDX-License-Identifier: Apache-2.0
// MVR-xchange as bytes and texts: packages whole and in pieces, messages as different programs write them,
// stations as their mDNS answers tell them, and what nobody should send.
#include "base/report.h"
#include "xchange/protocol.h"

#include <gtest/gtest.h>

#include <random>

namespace ghost::scene {
namespace {

using Buffer = std::vector<std::uint8_t>;

Buffer package(std::string_view content, XchangePayload payload = XchangePayload::message,
               std::uint32_t number = 0, std::uint32_t count = 1) {
    Buffer bytes = build_xchange_header(payload, content.size(), number, count);
    bytes.insert(bytes.end(), content.begin(), content.end());
    return bytes;
}

Buffer operator+(Buffer a, const Buffer& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

struct Heard {
    std::vector<std::string> messages;
    std::string file;
    int files = 0;
    std::string error;

    XchangeReader::Sink sink() {
        return {[this](std::string_view json) -> Result<void> {
                    messages.emplace_back(json);
                    return {};
                },
                [this](Bytes piece, bool last) -> Result<void> {
                    file.append(piece.begin(), piece.end());
                    files += last ? 1 : 0;
                    return {};
                }};
    }
};

// Bytes in pieces of so many.
Heard hear(const Buffer& bytes, std::size_t piece = 1u << 20) {
    Heard heard;
    XchangeReader reader;
    for (std::size_t i = 0; i < bytes.size() && heard.error.empty(); i += piece) {
        const auto taken =
            reader.take(Bytes(bytes).subspan(i, std::min(piece, bytes.size() - i)), heard.sink());
        if (!taken.ok()) heard.error = taken.error().what;
    }
    return heard;
}

TEST(Xchange, a_package_is_the_standards_28_bytes_and_its_content) {
    const Buffer expected{0x00, 0x0B, 0xE1, 0xBA, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0,   0,
                          1,    0,    0,    0,    0, 0, 0, 0, 0, 0, 0, 0, 2, '{', '}'};
    EXPECT_EQ(package("{}"), expected);
    EXPECT_EQ(hear(expected).messages, std::vector<std::string>{"{}"});
}

TEST(Xchange, packages_come_in_any_pieces) {
    const Buffer all = package("{\"a\":1}") + package("PK-file", XchangePayload::file) + package("{}");
    for (const std::size_t piece : {1u, 2u, 3u, 27u, 28u, 29u, 1000u}) {
        const Heard heard = hear(all, piece);
        EXPECT_EQ(heard.messages, (std::vector<std::string>{"{\"a\":1}", "{}"})) << piece;
        EXPECT_EQ(heard.file, "PK-file");
        EXPECT_EQ(heard.files, 1);
        EXPECT_EQ(heard.error, "");
    }
}

TEST(Xchange, several_packages_are_one_message_whichever_way_they_are_counted) {
    const Buffer counted = package("{\"a\"", XchangePayload::message, 0, 3) +
                           package(":", XchangePayload::message, 1, 3) +
                           package("2}", XchangePayload::message, 2, 3);
    EXPECT_EQ(hear(counted).messages, std::vector<std::string>{"{\"a\":2}"});
    // As the other table of the standard has it: count, then number.
    const Buffer turned = package("{\"a\"", XchangePayload::message, 3, 0) +
                          package(":", XchangePayload::message, 3, 1) +
                          package("2}", XchangePayload::message, 3, 2);
    EXPECT_EQ(hear(turned).messages, std::vector<std::string>{"{\"a\":2}"});
    for (const auto& [number, count] : {std::pair{1u, 0u}, {0u, 0u}, {1u, 1u}})
        EXPECT_EQ(hear(package("{}", XchangePayload::message, number, count)).messages.size(), 1u);
    const Heard file =
        hear(package("PK", XchangePayload::file, 0, 2) + package("34", XchangePayload::file, 1, 2));
    EXPECT_EQ(file.file, "PK34");
    EXPECT_EQ(file.files, 1);
}

TEST(Xchange, what_is_no_package_ends_the_connection) {
    const auto wrong = [](const Buffer& bytes) { return hear(bytes).error; };
    EXPECT_NE(wrong(Buffer(28, 'G')).find("no MVR-xchange"), std::string::npos);
    EXPECT_NE(wrong(build_xchange_header(static_cast<XchangePayload>(2), 1)).find("kind 2"),
              std::string::npos);
    // Lengths nobody should believe.
    for (const std::uint64_t length : {std::uint64_t{kMaxXchangeMessageBytes} + 1, ~std::uint64_t{0}})
        EXPECT_NE(wrong(build_xchange_header(XchangePayload::message, length)).find("limit"),
                  std::string::npos);
    for (const std::uint64_t length : {kMaxXchangeFileBytes + 1, ~std::uint64_t{0}})
        EXPECT_NE(wrong(build_xchange_header(XchangePayload::file, length)).find("limit"), std::string::npos);
    // Pieces that together are more than one may be.
    Buffer large;
    for (std::uint32_t i = 0; i < 3; ++i)
        large = large + package(std::string(kMaxXchangeMessageBytes / 2, ' '), XchangePayload::message, i, 3);
    EXPECT_NE(wrong(large).find("limit"), std::string::npos);
    // Packages out of turn, of another message, of too many.
    EXPECT_NE(wrong(package("x", XchangePayload::message, 1, 3)).find("expected 0"), std::string::npos);
    EXPECT_NE(wrong(package("x", XchangePayload::message, 0, 3) + package("x", XchangePayload::file, 1, 3)),
              "");
    EXPECT_NE(wrong(package("x", XchangePayload::message, 0, kMaxXchangePackages + 1)), "");
}

TEST(Xchange, random_bytes_never_do_more_than_end_it) {
    std::mt19937 random(5);
    const Buffer good = package("{\"Type\":\"MVR_JOIN\"}") + package("PK\3\4", XchangePayload::file);
    int ended = 0;
    for (int i = 0; i < 20'000; ++i) {
        Buffer bytes = good;
        for (int flips = 0; flips < 3; ++flips)
            bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1u << random() % 8);
        const Heard heard = hear(bytes, 1 + random() % 40);
        EXPECT_LE(heard.messages.size(), 2u); // what goes on behind a fault is read as packages of nothing
        EXPECT_LE(heard.file.size(), bytes.size());
        ended += heard.error.empty() ? 0 : 1;
    }
    EXPECT_GT(ended, 10'000) << "most flips are in the 28 bytes of a head";
}

TEST(Xchange, a_join_as_the_standard_prints_it) {
    const auto message = parse_xchange_message(R"({"Type": "MVR_JOIN", "Provider":"MVRApplication",
        "verMajor":"1", "verMinor":"6", "StationUUID":"{4AA291A1-1a62-45fe-aabc-e90e5e2399a8}",
        "StationName":"MVR Application\nfrom user A",
        "Files": [{"Type":"MVR_COMMIT","FileUUID":"A-1","FileSize":"256","Comment":"one"},
                  {"FileUUID":"A-2","fileName":"two.mvr","FileSize":512.0,"ForStationsUUID":["X","",7]}]})");
    ASSERT_TRUE(message.ok()) << message.error().what;
    EXPECT_EQ(message->type, "MVR_JOIN");
    EXPECT_EQ(message->station_uuid, "4aa291a1-1a62-45fe-aabc-e90e5e2399a8");
    EXPECT_EQ(message->station_name, "MVR Application from user A");
    ASSERT_EQ(message->commits.size(), 2u);
    EXPECT_EQ(message->commits[0].file_size, 256u);
    EXPECT_EQ(message->commits[0].station_uuid, message->station_uuid);
    EXPECT_EQ(message->commits[1].file_uuid, "a-2");
    EXPECT_EQ(message->commits[1].file_name, "two.mvr");
    EXPECT_EQ(message->commits[1].for_stations, std::vector<std::string>{"x"});
}

TEST(Xchange, messages_as_the_standard_prints_them) {
    const auto joined = parse_xchange_message(R"({"Type": "MVR_JOIN_RET", "OK": "true", "Message": "",
        "verMajor":"1", "verMinor":"6", "StationUUID":"a7669ff9-bd61-4486-aea6-c190f8ba6b8c",
        "StationName":"MVR Application from user A at location B", "Files": []})");
    ASSERT_TRUE(joined.ok());
    EXPECT_TRUE(joined->ok && joined->is_answer() && joined->provider.empty());
    EXPECT_EQ(joined->station_uuid, "a7669ff9-bd61-4486-aea6-c190f8ba6b8c");
    const auto left = parse_xchange_message(R"({"Type": "MVR_LEAVE", "StationUUID":""})");
    ASSERT_TRUE(left.ok());
    EXPECT_EQ(left->station_uuid, "");
    const auto commit = parse_xchange_message(R"({"Type": "MVR_COMMIT", "verMajor":1, "verMinor":6,
        "FileUUID":"", "ForStationsUUID":[], "FileSize":256,
        "Comment":"My complete description of what I have changed"})");
    ASSERT_TRUE(commit.ok());
    ASSERT_EQ(commit->commits.size(), 1u);
    EXPECT_EQ(commit->commits[0].file_size, 256u);
    EXPECT_TRUE(commit->commits[0].file_uuid.empty() && commit->commits[0].for_stations.empty());
    const auto request =
        parse_xchange_message(R"({"Type": "MVR_REQUEST", "FromStationUUID":"", "FileUUID":""})");
    ASSERT_TRUE(request.ok());
    EXPECT_EQ(request->file_uuid, "");
    EXPECT_FALSE(parse_xchange_message(R"({"Type":"MVR_REQUEST_RET","OK":"false","Message":"no"})")->ok);
}

// Before anything is built of it: the stack is no place for a neighbour's brackets.
TEST(Xchange, a_message_nested_without_end_is_refused) {
    for (const char* const bracket : {"[", "{\"a\":"}) {
        std::string text = R"({"Type": "MVR_COMMIT", "Files": )";
        while (text.size() < kMaxXchangeMessageBytes - 10) text += bracket;
        const auto message = parse_xchange_message(text);
        ASSERT_FALSE(message.ok());
        EXPECT_EQ(message.error().what, "a message that is nested deeper than 32");
        std::string closed = R"({"Type": "MVR_COMMIT", "Files": )" + std::string(520'000, '[');
        closed += std::string(520'000, ']') + "}";
        EXPECT_FALSE(parse_xchange_message(closed).ok());
    }
    EXPECT_FALSE(parse_xchange_message(R"({"Type": "MVR_JOIN", "Type": "MVR_LEAVE"})").ok());
}

TEST(Xchange, a_commit_with_capitals_and_without_a_name_and_how_its_file_is_asked_for) {
    const auto message = parse_xchange_message(
        R"({"Comment":"new truss","FileSize":4711,"FileUUID":"AAB19E5D-66F0-4B1B-98E8-A8C6AC1F2E1F",
            "ForStationsUUID":["4AA291A1-1A62-45FE-AABC-E90E5E2399A8"],
            "StationUUID":"A7669FF9-BD61-4486-AEA6-C190F8BA6B8C","Type":"MVR_COMMIT","verMajor":1,"verMinor":6})");
    ASSERT_TRUE(message.ok());
    ASSERT_EQ(message->commits.size(), 1u);
    const XchangeCommit& commit = message->commits[0];
    EXPECT_EQ(commit.file_uuid, "aab19e5d-66f0-4b1b-98e8-a8c6ac1f2e1f");
    EXPECT_EQ(commit.asked_as, "AAB19E5D-66F0-4B1B-98E8-A8C6AC1F2E1F") << "stations may compare letters";
    EXPECT_EQ(commit.for_stations, std::vector<std::string>{"4aa291a1-1a62-45fe-aabc-e90e5e2399a8"});
    EXPECT_EQ(commit.station_uuid, "a7669ff9-bd61-4486-aea6-c190f8ba6b8c");
    EXPECT_EQ(commit.station_asked_as, "A7669FF9-BD61-4486-AEA6-C190F8BA6B8C");
    EXPECT_EQ(commit.file_name, "");
}

// A strict reader throws where one of these is missing or of another kind.
TEST(Xchange, our_messages_have_every_attribute_that_is_not_optional) {
    XchangeMessage message;
    message.station_uuid = "a7669ff9-bd61-4486-aea6-c190f8ba6b8c";
    message.commits.push_back(
        {"aab19e5d-66f0-4b1b-98e8-a8c6ac1f2e1f", "", message.station_uuid, "n.mvr", "", 7, {}, ""});
    const auto has = [&](const char* type, std::initializer_list<const char*> parts) {
        message.type = type;
        const std::string text = xchange_message_text(message);
        for (const char* const part : parts) EXPECT_NE(text.find(part), std::string::npos) << type << part;
    };
    for (const char* const type : {"MVR_JOIN", "MVR_JOIN_RET"})
        has(type, {"\"Provider\":\"", "\"StationName\":\"", "\"StationUUID\":\"a7669ff9-", "\"verMajor\":1",
                   "\"verMinor\":6", "\"Commits\":[{", "\"FileSize\":7", "\"ForStationsUUID\":[]",
                   "\"Comment\":\"\""});
    for (const char* const type : {"MVR_JOIN_RET", "MVR_COMMIT_RET", "MVR_LEAVE_RET", "MVR_REQUEST_RET"})
        has(type, {"\"OK\":true", "\"Message\":\"\""});
    has("MVR_LEAVE", {"\"FromStationUUID\":\"a7669ff9-"});
    has("MVR_REQUEST", {"\"FromStationUUID\":[\"a7669ff9-", "\"FileUUID\":\""});
}

TEST(Xchange, truth_is_a_word_a_text_or_a_number) {
    const auto ok = [](const char* value) {
        return parse_xchange_message("{\"Type\":\"MVR_JOIN_RET\",\"OK\":" + std::string(value) + "}")->ok;
    };
    EXPECT_TRUE(ok("true") && ok("\"true\"") && ok("\"True\"") && ok("1"));
    EXPECT_FALSE(ok("false") || ok("\"false\"") || ok("0") || ok("\"\""));
    EXPECT_EQ(parse_xchange_message(R"({"Type":"MVR_LEAVE","FromStationUUID":["AB"]})")->station_uuid, "ab");
    EXPECT_EQ(parse_xchange_message(R"({"Type":"MVR_LEAVE","StationUUID":"CD"})")->station_uuid, "cd");
    EXPECT_EQ(parse_xchange_message(std::string_view("{\"Type\":\"mvr_leave\"}\0", 21))->type, "MVR_LEAVE");
}

TEST(Xchange, messages_that_are_none) {
    for (const char* wrong : {"", "null", "[]", "{}", "{\"Type\":7}", "{\"Type\":\"\"}",
                              "{\"Type\":\"MVR_JOIN\"", "\xFF\xFE", "{\"Type\":\"\xC3\x28\"}"})
        EXPECT_FALSE(parse_xchange_message(wrong).ok()) << wrong;
    EXPECT_FALSE(parse_xchange_message(std::string(1u << 20, '[')).ok());
    EXPECT_FALSE(parse_xchange_message("{\"a\":" + std::string(500'000, '[')).ok());
    std::string many = "{\"Type\":\"MVR_JOIN\",\"Commits\":[";
    for (int i = 0; i < 5000; ++i) many += "{\"FileUUID\":\"" + std::to_string(i) + "\"},";
    many.back() = ']';
    const auto message = parse_xchange_message(many + "}");
    ASSERT_TRUE(message.ok());
    ASSERT_EQ(message->commits.size(), kMostXchangeCommits);
    EXPECT_EQ(message->commits.back().file_uuid, "4999"); // the newest
}

TEST(Xchange, what_is_written_is_read_again) {
    XchangeMessage join;
    join.type = "MVR_JOIN_RET";
    join.ok = false;
    join.text = "no \"room\"";
    join.provider = "Ghostlight";
    join.station_name = "FOH";
    join.station_uuid = "ab";
    join.commits.push_back({"f", "", "ab", "n.mvr", "c", 77, {}});
    const auto read = parse_xchange_message(xchange_message_text(join));
    ASSERT_TRUE(read.ok());
    EXPECT_FALSE(read->ok);
    EXPECT_EQ(read->text, join.text);
    EXPECT_EQ(read->station_name, "FOH");
    ASSERT_EQ(read->commits.size(), 1u);
    EXPECT_EQ(read->commits[0].file_size, 77u);
    EXPECT_EQ(read->commits[0].file_name, "n.mvr");
    XchangeMessage request;
    request.type = "MVR_REQUEST";
    request.file_uuid = "f";
    request.station_uuid = "ab";
    EXPECT_EQ(xchange_message_text(request),
              R"({"FileUUID":"f","FromStationUUID":["ab"],"Type":"MVR_REQUEST"})");
}

constexpr std::uint32_t kUs = 0x0A000002, kThem = 0x0A000007;

XchangeStation us() {
    return {"FOH 1", "4aa291a1-1a62", "Default", dmx::IpAddress(kUs), 4711, false};
}

TEST(Xchange, stations_find_each_other_by_every_name_that_is_in_use) {
    // Ours, asked for by the service and by the group.
    for (const dmx::DnsName& name : {dmx::DnsName{"_MVRxchange", "_tcp", "local"},
                                     dmx::DnsName{"default", "_mvrxchange", "_tcp", "local"}}) {
        const auto answer = xchange_answer({false, {{name, dmx::DnsType::ptr}}, {}}, us());
        ASSERT_TRUE(answer.has_value());
        const auto sent = dmx::parse_dns(dmx::build_dns(*answer));
        EXPECT_EQ(xchange_stations(*sent, dmx::IpAddress(kUs)), std::vector<XchangeStation>{us()});
    }
    EXPECT_FALSE(xchange_answer({false, {{{"_http", "_tcp", "local"}, dmx::DnsType::ptr}}, {}}, us()));
    EXPECT_FALSE(xchange_answer({true, {{{"_mvrxchange", "_tcp", "local"}, dmx::DnsType::ptr}}, {}}, us()));
    EXPECT_TRUE(xchange_answer(xchange_question("Default"), us()).has_value());
    // Others'.
    const auto station = [](const dmx::DnsName& instance) {
        dmx::DnsPacket packet{true, {}, {}};
        packet.records.push_back({instance, dmx::DnsType::srv, 120, {"h", "local"}, 9000, {}, {}});
        packet.records.push_back({instance, dmx::DnsType::txt, 120, {}, 0, {}, {"stationuuid=AB-CD"}});
        packet.records.push_back(
            {{"h", "local"}, dmx::DnsType::a, 120, {}, 0, dmx::IpAddress(0x0A0000FF), {}});
        packet.records.push_back({{"h", "local"}, dmx::DnsType::a, 120, {}, 0, dmx::IpAddress(kThem), {}});
        return xchange_stations(packet, dmx::IpAddress(kThem)).at(0);
    };
    for (const dmx::DnsName& instance : {dmx::DnsName{"Tour", "_mvrxchange", "_tcp", "local"},
                                         dmx::DnsName{"Desk", "Tour", "_mvrxchange", "_tcp", "local"},
                                         dmx::DnsName{"Desk@Tour", "_mvrxchange", "_tcp", "local"}}) {
        EXPECT_EQ(station(instance).group, "Tour");
        EXPECT_EQ(station(instance).uuid, "ab-cd");
        EXPECT_EQ(station(instance).port, 9000);
        EXPECT_EQ(station(instance).address, dmx::IpAddress(kThem)); // of two the one that it speaks from
    }
    EXPECT_EQ(station({"Desk@Tour", "_mvrxchange", "_tcp", "local"}).name, "Desk");
    // Both attributes in one text.
    dmx::DnsPacket packet{true, {}, {}};
    const dmx::DnsName instance{"Tour", "_mvrxchange", "_tcp", "local"};
    packet.records.push_back({instance, dmx::DnsType::srv, 120, {"h", "local"}, 9000, {}, {}});
    packet.records.push_back(
        {instance, dmx::DnsType::txt, 120, {}, 0, {}, {"StationName=A;B;StationUUID=AB-CD"}});
    EXPECT_EQ(xchange_stations(packet, dmx::IpAddress(kThem)).at(0).name, "A;B");
    EXPECT_EQ(xchange_stations(packet, dmx::IpAddress(kThem)).at(0).uuid, "ab-cd");
}

TEST(Xchange, a_goodbye_and_a_thousand_stations_in_a_packet) {
    XchangeStation leaving = us();
    leaving.gone = true;
    const auto goodbye = xchange_stations(xchange_announcement(leaving), dmx::IpAddress(kUs));
    ASSERT_FALSE(goodbye.empty());
    EXPECT_TRUE(goodbye[0].gone);
    dmx::DnsPacket many{true, {}, {}};
    for (int i = 0; i < 1000; ++i)
        many.records.push_back({{"S" + std::to_string(i), "G", "_mvrxchange", "_tcp", "local"},
                                dmx::DnsType::srv,
                                120,
                                {"h"},
                                9000,
                                {},
                                {}});
    EXPECT_EQ(xchange_stations(many, dmx::IpAddress(kThem)).size(), 64u);
}

TEST(Xchange, file_names_stay_in_their_folder) {
    EXPECT_EQ(plot_file_name("tour.mvr"), "tour.mvr");
    EXPECT_EQ(plot_file_name("tour.MVR.mvr"), "tour.mvr");
    EXPECT_EQ(plot_file_name(""), "plot.mvr");
    EXPECT_EQ(plot_file_name("."), "plot.mvr");
    EXPECT_EQ(plot_file_name(".mvr"), "plot.mvr");
    EXPECT_EQ(plot_file_name("../../etc/passwd"), "_.._etc_passwd.mvr");
    EXPECT_EQ(plot_file_name("C:\\x|y?.mvr"), "C__x_y_.mvr");
    EXPECT_EQ(plot_file_name(std::string("a\0b\n", 4)), "a_b_.mvr");
    EXPECT_EQ(plot_file_name("B\xC3\xBChne"), "B\xC3\xBChne.mvr");
    std::string ue;
    for (int i = 0; i < 300; ++i) ue += "\xC3\xBC";
    const std::string cut = plot_file_name("x" + ue);
    EXPECT_LE(cut.size(), 124u);
    EXPECT_EQ((cut.size() - 5) % 2, 0u); // no half letter
}

TEST(Xchange, uuids_tell_things_apart_and_stay) {
    const auto uuid = [](std::initializer_list<std::string_view> parts) {
        return uuid_of(std::vector<std::string_view>(parts));
    };
    EXPECT_EQ(uuid({"a", "bc"}), uuid({"a", "bc"}));
    EXPECT_NE(uuid({"a", "bc"}), uuid({"ab", "c"}));
    EXPECT_NE(uuid({"a"}), uuid({"b"}));
    const std::string one = uuid({"a"});
    ASSERT_EQ(one.size(), 36u);
    EXPECT_EQ(one[8], '-');
    EXPECT_EQ(one[14], '8');
    EXPECT_NE(std::string("89ab").find(one[19]), std::string::npos);
}

} // namespace
} // namespace ghost::scene
