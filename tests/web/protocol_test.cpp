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
    EXPECT_TRUE(std::get<WantPictures>(*say(R"({"type":"pictures","on":true})")).on);
}

TEST(Protocol, another_view_than_the_windows_is_watched) {
    const auto stored = say(R"({"type":"watch","width":640,"calm":false,"camera":"house","probe":[0.25,1]})");
    ASSERT_TRUE(stored.ok());
    EXPECT_EQ(std::get<Watch>(*stored).camera, "house");
    EXPECT_EQ(std::get<Watch>(*stored).probe, glm::vec2(0.25f, 1.0f));
    const auto own = say(R"({"type":"watch","width":640,"calm":false,"own":{"position_m":[1,-2,3.5],
                            "target_m":[0,0,1],"fov_y_deg":40}})");
    ASSERT_TRUE(own.ok());
    ASSERT_TRUE(std::get<Watch>(*own).own.has_value());
    EXPECT_EQ(std::get<Watch>(*own).own->position_m, glm::vec3(1, -2, 3.5f));
    EXPECT_EQ(std::get<Watch>(*own).own->fov_y_deg, 40);
    const auto is_refused = [](const std::string& more) {
        return !say(R"({"type":"watch","width":640,"calm":false,)" + more + "}").ok();
    };
    for (const char* bad :
         {R"("camera":"")", R"("camera":7)", R"("camera":"a\nb")", R"("probe":[0])", R"("probe":[0,1.1])",
          R"("probe":[0,"1"])", R"("own":{})", R"("own":[])",
          R"("own":{"position_m":[0,0,0],"target_m":[0,0,0],"fov_y_deg":40})",
          R"("own":{"position_m":[0,0,1e9],"target_m":[0,0,0],"fov_y_deg":40})",
          R"("own":{"position_m":[0,0,1],"target_m":[0,0,0,0],"fov_y_deg":40})",
          R"("own":{"position_m":[0,0,1],"target_m":[0,0,null],"fov_y_deg":40})",
          R"("own":{"position_m":[0,0,1],"target_m":[0,0,0],"fov_y_deg":180})",
          R"("own":{"position_m":[0,0,1],"target_m":[0,0,0]})",
          R"("camera":"house","own":{"position_m":[0,0,1],"target_m":[0,0,0],"fov_y_deg":40})"})
        EXPECT_TRUE(is_refused(bad)) << bad;
    EXPECT_TRUE(is_refused(R"("camera":")" + std::string(kMostArgumentBytes + 1, 'a') + "\""));
}

TEST(Protocol, what_is_to_be_done_is_read_for_those_who_may) {
    const auto order = [](const std::string& text, bool may = true) {
        return read_message(Opcode::text,
                            Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), may);
    };
    const auto look = order(R"({"type":"do","n":7,"what":"look","args":["Verse",2.5,true]})");
    ASSERT_TRUE(look.ok());
    const Do& what = std::get<Do>(*look);
    EXPECT_EQ(what.n, 7u);
    EXPECT_EQ(what.command.what, "look");
    ASSERT_EQ(what.command.arguments.size(), 3u);
    EXPECT_EQ(std::get<std::string>(what.command.arguments[0]), "Verse");
    EXPECT_EQ(std::get<double>(what.command.arguments[1]), 2.5);
    EXPECT_TRUE(std::get<bool>(what.command.arguments[2]));
    for (const std::string bad :
         {R"({"type":"do"})", R"({"type":"do","n":1,"args":[]})", R"({"type":"do","n":1,"what":"cue"})",
          R"({"type":"do","n":0,"what":"cue","args":[]})",
          R"({"type":"do","n":2147483648,"what":"cue","args":[]})",
          R"({"type":"do","n":1,"what":"","args":[]})", R"({"type":"do","n":1,"what":7,"args":[]})",
          R"({"type":"do","n":1,"what":"cue","args":{}})",
          R"({"type":"do","n":1,"what":"cue","args":[null]})",
          R"({"type":"do","n":1,"what":"cue","args":[[1]]})",
          R"({"type":"do","n":1,"what":"cue","args":[{"a":1}]})",
          R"({"type":"do","n":1,"what":"cue","args":[1e30]})",
          R"({"type":"do","n":1,"what":"cue","args":["\u0000"]})",
          R"({"type":"do","n":1,"what":"cue","args":[1,1,1,1,1,1,1,1,1]})"}) {
        EXPECT_FALSE(order(bad).ok()) << bad;
        const auto unread = order(bad, false);
        ASSERT_TRUE(unread.ok()) << bad;
        EXPECT_TRUE(std::holds_alternative<Unread>(*unread)) << bad;
    }
    EXPECT_FALSE(
        order(R"({"type":"do","n":1,"what":"look","args":[")" + std::string(257, 'a') + "\"]}").ok());
    EXPECT_FALSE(order(R"({"type":"do","n":1,"what":")" + std::string(33, 'a') + R"(","args":[]})").ok());
    EXPECT_FALSE(order(R"({"type":"do","n":1,"what":"cue","args":[[[[[[[[[1]]]]]]]]]})", false).ok())
        << "depth comes first";
}

TEST(Protocol, what_is_to_be_done_has_an_end) {
    const auto order = [](const std::string& what, std::size_t arguments) {
        std::string text = R"({"type":"do","n":1,"what":")" + what + R"(","args":[)";
        for (std::size_t k = 0; k < arguments; ++k) text += k > 0 ? ",1" : "1";
        text += "]}";
        return read_message(Opcode::text,
                            Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), true);
    };
    EXPECT_TRUE(order(std::string(kMostWordBytes, 'a'), kMostArguments).ok());
    EXPECT_FALSE(order(std::string(kMostWordBytes + 1, 'a'), 1).ok());
    EXPECT_FALSE(order("look", kMostArguments + 1).ok());
}

TEST(Protocol, what_it_must_not_say_is_refused) {
    for (const char* bad : {"",
                            "{",
                            "[]",
                            "1",
                            "\"watch\"",
                            "{}",
                            R"({"type":1})",
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

TEST(Protocol, a_still_of_a_side_view_and_a_small_picture_by_their_bytes) {
    const Buffer side =
        picture_message({.stream = 1, .number = 2, .width = 3, .height = 4, .still = true}, {});
    ASSERT_EQ(side.size(), 32u);
    EXPECT_EQ((Buffer{side.begin(), side.begin() + 8}), (Buffer{1, 16, 1, 0, 2, 0, 0, 0}));
    EXPECT_EQ(small_message(SmallKind::look, "Ab", Buffer{0xFF, 0xD8}),
              (Buffer{3, 1, 2, 0, 'A', 'b', 0xFF, 0xD8}));
}

TEST(Protocol, answers_and_looks_by_their_texts) {
    EXPECT_EQ(hello_text(Right::control), R"({"type":"hello","protocol":1,"right":"control"})");
    EXPECT_EQ(done_text(3), R"({"type":"done","n":3})");
    EXPECT_EQ(refused_text(3, "no <b>"), R"({"type":"refused","n":3,"why":"no <b>"})");
    EXPECT_EQ(bye_text("go"), R"({"type":"bye","why":"go"})");
    EXPECT_EQ(looks_text({}), R"({"type":"looks","current":"","looks":[]})");
    scene::StoredLook look;
    look.name = "<i>Verse</i>";
    look.fade_s = 2.5f;
    look.fixtures["Spot 1"].intensity = 1;
    const ui::LooksNow looks{std::make_shared<const std::vector<scene::StoredLook>>(1, look), look.name};
    EXPECT_EQ(
        looks_text(looks),
        R"({"type":"looks","current":"<i>Verse</i>","looks":[{"name":"<i>Verse</i>","fade_s":2.5,"fixtures":1}]})");
    EXPECT_EQ(read(measure_text({.place = {0.5f, 0.25f}, .cd_m2 = 2}))["cd_m2"], 2);
    EXPECT_FALSE(read(measure_text({.cd_m2 = 2, .hit = false, .lux = 9})).contains("lux"));
    EXPECT_EQ(read(measure_text({.hit = true, .lux = 9, .distance_m = 3, .object = "floor"}))["object"],
              "floor");
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
    one.is_place_known = one.is_address_known = false;
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
    EXPECT_EQ(said["fixtures"][0]["unsaid"], nlohmann::json::array());
    EXPECT_EQ(said["fixtures"][1]["unsaid"], (nlohmann::json{"place", "address"}));
    EXPECT_EQ(said["fixtures"][0]["name"], "broken \xEF\xBF\xBD name");

    ui::RigNow rig;
    rig.fixtures.resize(2);
    rig.fixtures[1].candela = 1000;
    rig.recording_s = 10;
    rig.at_s = 5.5;
    StateNow now;
    now.rig = &rig;
    now.cue = "Second";
    now.lookers.push_back({"10.0.0.7", 3, 25, 1280});
    nlohmann::json state = read(state_text(now));
    EXPECT_EQ(state["source"], "recording");
    EXPECT_EQ(state["cue"], "Second");
    EXPECT_EQ(state["shining"], 1);
    EXPECT_EQ(state["viewers"][0]["from"], "10.0.0.7");
    EXPECT_FALSE(state.contains("desk"));
    now.cue.clear();
    EXPECT_FALSE(read(state_text(now)).contains("cue"));
    rig.from_desk = true;
    EXPECT_EQ(read(state_text(now))["source"], "none") << "nothing is listened to";
    const dmx::Statistics network;
    now.network = &network;
    EXPECT_EQ(read(state_text(now))["source"], "desk");
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
