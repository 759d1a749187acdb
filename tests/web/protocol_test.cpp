// SPDX-License-Identifier: Apache-2.0
#include "json_xml_toml/json.h"
#include "show/show.h"
#include "web/protocol.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace ghost::web {
namespace {

using Buffer = std::vector<std::uint8_t>;

Result<ToServer> say(const std::string& text) {
    return read_message(Opcode::text, Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

nlohmann::json read(const std::string& text) {
    auto json = read_json(text, "answer");
    EXPECT_TRUE(json.ok()) << text;
    return json.ok() ? *json : nlohmann::json();
}

TEST(Protocol, what_a_page_says_is_understood) {
    const auto painted = read_message(Opcode::binary, Buffer{1, 0x78, 0x56, 0x34, 0x12});
    ASSERT_TRUE(painted.ok());
    EXPECT_EQ(std::get<Painted>(*painted).number, 0x12345678u);
    const auto watch = say(R"({"type":"watch","width":854,"calm":true})");
    ASSERT_TRUE(watch.ok());
    EXPECT_EQ(std::get<Watch>(*watch).width, 854);
    EXPECT_TRUE(std::get<Watch>(*watch).calm);
    EXPECT_TRUE(std::get<WantLevels>(*say(R"({"type":"levels","on":true})")).on);
    EXPECT_EQ(std::get<Explain>(*say(R"({"type":"explain","fixture":7})")).fixture, 7u);
    EXPECT_EQ(std::get<Ping>(*say(R"({"type":"ping","t":1.5})")).t, 1.5);
}

TEST(Protocol, what_it_must_not_say_is_refused) {
    for (const char* bad : {"",
                            "{",
                            "[]",
                            "1",
                            "\"watch\"",
                            "{}",
                            R"({"type":1})",
                            R"({"type":"do","what":"cue"})",
                            R"({"type":"watch"})",
                            R"({"type":"watch","width":0,"calm":false})",
                            R"({"type":"watch","width":4097,"calm":false})",
                            R"({"type":"watch","width":1.5,"calm":false})",
                            R"({"type":"watch","width":-1,"calm":false})",
                            R"({"type":"watch","width":18446744073709551615,"calm":false})",
                            R"({"type":"watch","width":800,"calm":1})",
                            R"({"type":"watch","width":800})",
                            R"({"type":"explain","fixture":-1})",
                            R"({"type":"explain","fixture":1e30})",
                            R"({"type":"explain","fixture":"1"})",
                            R"({"type":"ping","t":1e999})",
                            R"({"type":"ping","t":null})",
                            R"({"type":"levels","on":"yes"})",
                            R"({"type":"levels","type":"levels","on":true})",
                            "{\"type\":\"ping\",\"t\":1,\"\xff\":1}",
                            R"({"type":"ping","t":1,"deep":[[[[[[[[[1]]]]]]]]]})"})
        EXPECT_FALSE(say(bad).ok()) << bad;
    EXPECT_FALSE(say(R"({"type":"ping","t":1,"more":")" + std::string(kMostMessageBytes, 'a') + "\"}").ok());
    const Buffer whole{1, 1, 0, 0, 0};
    for (std::size_t cut = 0; cut < whole.size(); ++cut)
        EXPECT_FALSE(read_message(Opcode::binary, Bytes(whole).first(cut)).ok()) << cut;
    EXPECT_FALSE(read_message(Opcode::binary, Buffer{1, 1, 0, 0, 0, 0}).ok());
    EXPECT_FALSE(read_message(Opcode::binary, Buffer{2, 1, 0, 0, 0}).ok());
}

TEST(Protocol, a_picture_by_its_bytes) {
    const PictureHead head{.number = 0x01020304,
                           .drawn_ms = 1.0,
                           .desk_ms = 2.0f,
                           .ev100 = -1.0f,
                           .width = 0x1234,
                           .height = 0x0102,
                           .coarse = true,
                           .baked = false,
                           .at_rest = true,
                           .false_colours = false};
    EXPECT_EQ(picture_message(head, Buffer{0xFF, 0xD8}),
              (Buffer{1, 5, 0,    0, 4, 3,    2,    1,    0,    0, 0, 0, 0, 0, 0xF0, 0x3F, 0,
                      0, 0, 0x40, 0, 0, 0x80, 0xBF, 0x34, 0x12, 2, 1, 0, 0, 0, 0,    0xFF, 0xD8}));
}

TEST(Protocol, levels_by_their_bytes) {
    std::vector<ui::FixtureNow> fixtures(2);
    fixtures[0].candela = 1.0f;
    fixtures[0].colour = {1.0f, 0.5f, std::numeric_limits<float>::quiet_NaN()};
    fixtures[0].dimmer = 2.0f;
    const Buffer bytes = levels_message(0x0102, 1.0, fixtures);
    EXPECT_EQ(bytes, (Buffer{2, 0, 2,    1,    2,   0,   0, 0,   0, 0, 0, 0, 0, 0, 0xF0, 0x3F,
                             0, 0, 0x80, 0x3F, 255, 128, 0, 255, 0, 0, 0, 0, 0, 0, 0,    0}));
}

TEST(Protocol, a_show_in_names_and_a_state_in_figures) {
    auto show = std::make_shared<scene::Show>();
    show->name = "<script>alert(1)</script>";
    scene::PatchedFixture one;
    one.name = "broken \xff name";
    one.universe = 3;
    one.address = 17;
    show->fixtures.push_back(one);
    one.address = 0;
    show->fixtures.push_back(one);
    scene::Cue cue;
    cue.name = "Second";
    cue.at_s = 5;
    show->cues.push_back(cue);
    cue.name = "First";
    cue.at_s = 1;
    show->cues.push_back(cue);
    ui::Opened opened;
    opened.show = show;
    const nlohmann::json said = read(show_text(9, opened));
    EXPECT_EQ(said["version"], 9);
    EXPECT_EQ(said["name"], show->name);
    EXPECT_EQ(said["fixtures"][0]["patch"], "3.17");
    EXPECT_EQ(said["fixtures"][1]["patch"], "");
    EXPECT_EQ(said["fixtures"][0]["name"], "broken \xEF\xBF\xBD name");

    ui::RigNow rig;
    rig.fixtures.resize(2);
    rig.fixtures[1].candela = 1000;
    rig.recording_s = 10;
    rig.at_s = 5.5;
    StateNow now;
    now.rig = &rig;
    now.show = show.get();
    now.lookers.push_back({"10.0.0.7", 3, 25, 1280});
    nlohmann::json state = read(state_text(now));
    EXPECT_EQ(state["source"], "recording");
    EXPECT_EQ(state["cue"], "Second");
    EXPECT_EQ(state["shining"], 1);
    EXPECT_EQ(state["viewers"][0]["from"], "10.0.0.7");
    EXPECT_FALSE(state.contains("desk"));
    rig.at_s = 4;
    EXPECT_EQ(read(state_text(now))["cue"], "First");
    rig.from_desk = true;
    EXPECT_FALSE(read(state_text(now)).contains("cue")) << "the desk has cues of its own";
}

TEST(Protocol, of_many_messages_the_newest_are_told) {
    std::vector<Message> messages(kMostMessagesShown + 3);
    messages.back() = {Severity::error, "show.toml:3", "something"};
    const nlohmann::json said = read(messages_text(messages));
    EXPECT_EQ(said["messages"].size(), kMostMessagesShown);
    EXPECT_EQ(said["more"], 3);
    EXPECT_EQ(said["messages"].back()["where"], "show.toml:3");
    EXPECT_EQ(said["messages"].back()["severity"], "error");
    EXPECT_EQ(read(messages_text({}))["more"], 0);
}

TEST(Protocol, figures_that_are_none_are_null) {
    EXPECT_TRUE(read(pong_text(1.5, std::nan("")))["now_ms"].is_null());
    EXPECT_EQ(read(pong_text(1.5, 2))["t"], 1.5);
}

} // namespace
} // namespace ghost::web
