// SPDX-License-Identifier: Apache-2.0
// The remote control's addresses, and packets through a socket on the loopback interface.
#include "live/inputs/remote_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <unistd.h>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

dmx::OscMessage message(const std::string& address, std::vector<dmx::OscArgument> arguments = {}) {
    return {address, std::move(arguments)};
}

TEST(Remote, each_address_does_what_it_says) {
    Remote remote({"house", "high"});
    EXPECT_TRUE(remote.apply(message("/ghostlight/master", {0.25})).ok());
    EXPECT_FLOAT_EQ(remote.request().light(), 0.25f);
    EXPECT_TRUE(remote.apply(message("/ghostlight/blackout")).ok());
    EXPECT_FLOAT_EQ(remote.request().light(), 0.0f);
    EXPECT_TRUE(remote.apply(message("/ghostlight/blackout", {0.0})).ok());
    EXPECT_FLOAT_EQ(remote.request().light(), 0.25f);
    EXPECT_TRUE(remote.apply(message("/ghostlight/blackout", {true})).ok());
    EXPECT_TRUE(remote.request().blackout);
    EXPECT_TRUE(remote.apply(message("/ghostlight/haze", {2.0})).ok());
    EXPECT_FLOAT_EQ(remote.request().haze, 2.0f);
    EXPECT_TRUE(remote.apply(message("/ghostlight/exposure", {4.5})).ok());
    EXPECT_FLOAT_EQ(remote.request().ev100.value(), 4.5f);
    EXPECT_TRUE(remote.apply(message("/ghostlight/exposure/auto")).ok());
    EXPECT_FALSE(remote.request().ev100.has_value());
    EXPECT_FALSE(remote.request().tone.has_value());
    EXPECT_TRUE(remote.apply(message("/ghostlight/tone", {std::string("aces")})).ok());
    EXPECT_EQ(remote.request().tone, image::Tone::aces);
    for (const std::vector<dmx::OscArgument>& wrong :
         {std::vector<dmx::OscArgument>{1.0}, {std::string("film")}})
        EXPECT_FALSE(remote.apply(message("/ghostlight/tone", wrong)).ok());
    EXPECT_EQ(remote.request().tone, image::Tone::aces);
    EXPECT_TRUE(remote.apply(message("/ghostlight/tone")).ok());
    EXPECT_FALSE(remote.request().tone.has_value());
}

TEST(Remote, cameras_by_name_and_number) {
    Remote remote({"house", "high"});
    EXPECT_FALSE(remote.request().camera.has_value());
    EXPECT_TRUE(remote.apply(message("/ghostlight/camera", {std::string("high"), 3.0})).ok());
    EXPECT_EQ(remote.request().camera->index, 1u);
    EXPECT_FLOAT_EQ(remote.request().camera->flight_s, 3.0f);
    EXPECT_TRUE(remote.apply(message("/ghostlight/camera", {1.0})).ok());
    EXPECT_EQ(remote.request().camera->index, 0u);
    EXPECT_FLOAT_EQ(remote.request().camera->flight_s, 0.0f);
    EXPECT_EQ(remote.request().calls, 2u);
    for (const std::vector<dmx::OscArgument>& wrong : {std::vector<dmx::OscArgument>{},
                                                       {0.0},
                                                       {1.5},
                                                       {3.0},
                                                       {std::string("nowhere")},
                                                       {1.0, -1.0},
                                                       {1.0, 1e9},
                                                       {std::monostate()}})
        EXPECT_FALSE(remote.apply(message("/ghostlight/camera", wrong)).ok());
    EXPECT_EQ(remote.request().calls, 2u);
}

TEST(Remote, cues_by_name_by_number_and_one_after_another) {
    const scene::Cue walk_in{.name = "Walk-in", .at_s = 0.0},
        solo{.name = "Solo", .at_s = 61.5, .camera = "high", .flight_s = 2},
        end{.name = "End", .camera = "house"};
    Remote remote({"house", "high"}, {walk_in, solo, end});
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue", {std::string("Solo")})).ok());
    EXPECT_EQ(remote.request().jumps, 1u);
    EXPECT_DOUBLE_EQ(remote.request().at_s, 61.5);
    EXPECT_EQ(remote.request().camera->index, 1u);
    EXPECT_FLOAT_EQ(remote.request().camera->flight_s, 2.0f);
    // The next one has a camera only; then there is none any more.
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/go")).ok());
    EXPECT_EQ(remote.request().jumps, 1u);
    EXPECT_EQ(remote.request().camera->index, 0u);
    EXPECT_EQ(remote.request().calls, 2u);
    EXPECT_FALSE(remote.apply(message("/ghostlight/cue/go", {1.0})).ok());
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/back")).ok());
    EXPECT_DOUBLE_EQ(remote.request().at_s, 61.5);
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/back", {0.0})).ok()) << "a button let go";
    EXPECT_DOUBLE_EQ(remote.request().at_s, 61.5);
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue", {1.0})).ok());
    EXPECT_DOUBLE_EQ(remote.request().at_s, 0.0);
    EXPECT_TRUE(remote.apply(message("/ghostlight/recording", {12.5})).ok());
    EXPECT_DOUBLE_EQ(remote.request().at_s, 12.5);
    const std::size_t jumps = remote.request().jumps;
    for (const char* address : {"/ghostlight/cue", "/ghostlight/recording"})
        EXPECT_FALSE(remote.apply(message(address)).ok());
    EXPECT_FALSE(remote.apply(message("/ghostlight/cue", {std::string("solo")})).ok());
    EXPECT_FALSE(remote.apply(message("/ghostlight/cue", {4.0})).ok());
    EXPECT_FALSE(remote.apply(message("/ghostlight/recording", {-1.0})).ok());
    EXPECT_EQ(remote.request().jumps, jumps);
    // "go" without a cue before it is the first one.
    Remote fresh({}, {solo});
    EXPECT_TRUE(fresh.apply(message("/ghostlight/cue/go")).ok());
    EXPECT_DOUBLE_EQ(fresh.request().at_s, 61.5);
    EXPECT_FALSE(fresh.request().camera.has_value()) << "the show has no such camera";
    EXPECT_FALSE(Remote({"house"}).apply(message("/ghostlight/cue/go")).ok());
}

TEST(Remote, a_cue_recalls_its_look_and_goes_on_from_wherever_the_show_is) {
    Remote remote({}, {{.name = "One", .look = "Verse"},
                       {.name = "Two", .look = "Dark", .fade_s = 2.5f},
                       {.name = "End", .at_s = 9}});
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/go")).ok());
    EXPECT_EQ(remote.request().look.name, "Verse");
    EXPECT_LT(remote.request().look.seconds, 0) << "those of the look";
    EXPECT_EQ(remote.request().cue, "One");
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/go")).ok());
    EXPECT_EQ(remote.request().look.name, "Dark");
    EXPECT_DOUBLE_EQ(remote.request().look.seconds, 2.5);
    EXPECT_EQ(remote.request().recalls, 2u);
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/go")).ok());
    EXPECT_EQ(remote.request().recalls, 2u) << "a cue without a look";
    EXPECT_EQ(remote.request().cues, 3u);
    remote.be_in("One"); // by the window
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/go")).ok());
    EXPECT_EQ(remote.request().cue, "Two");
    remote.be_in("");
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/go")).ok());
    EXPECT_EQ(remote.request().cue, "One");
}

TEST(Remote, an_edit_of_the_show_leaves_it_in_its_cue) {
    const scene::Cue one{.name = "One", .at_s = 1}, two{.name = "Two", .at_s = 2},
        three{.name = "Three", .at_s = 3}, four{.name = "Four", .at_s = 4};
    Remote remote({}, {one, two, three, four});
    const auto next = [&] {
        EXPECT_TRUE(remote.apply(message("/ghostlight/cue/go")).ok());
        return remote.request().cue;
    };
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue", {std::string("Two")})).ok());
    remote.know({"house"}, {one, two, three, four}); // an address was changed
    EXPECT_EQ(next(), "Three");
    remote.know({}, {three, one, two, four}); // it was moved
    EXPECT_EQ(next(), "One");
    remote.know({}, {three, two, four}); // it was removed
    EXPECT_EQ(next(), "Two");
    // The window knows a name of its edit before the show has it.
    const scene::Cue renamed{.name = "Second", .at_s = 2};
    remote.be_in("Second");
    EXPECT_EQ(next(), "Four");
    remote.be_in("Second");
    remote.know({}, {three, renamed, four});
    EXPECT_EQ(next(), "Four");
    EXPECT_TRUE(remote.apply(message("/ghostlight/cue/back")).ok());
    EXPECT_EQ(remote.request().cue, "Second");
    remote.begin({}, {one, two}); // another show
    EXPECT_EQ(next(), "One");
}

TEST(Remote, another_show_lets_go_of_light_air_exposure_and_tone) {
    Remote remote({"house"});
    for (const auto& [address, value] : {std::pair<const char*, dmx::OscArgument>{"/ghostlight/master", 0.25},
                                         {"/ghostlight/blackout", 1.0},
                                         {"/ghostlight/haze", 3.0},
                                         {"/ghostlight/exposure", 12.0}})
        EXPECT_TRUE(remote.apply(message(address, {value})).ok());
    EXPECT_TRUE(remote.apply(message("/ghostlight/tone", {std::string("linear")})).ok());
    remote.know({"house"}, {});
    EXPECT_EQ(remote.request().light(), 0) << "the same show, edited";
    remote.begin({"house"}, {});
    EXPECT_EQ(remote.request().light(), 1);
    EXPECT_EQ(remote.request().haze, 1);
    EXPECT_FALSE(remote.request().ev100);
    EXPECT_FALSE(remote.request().tone);
}

TEST(Remote, a_look_by_name_and_seconds) {
    Remote remote({"house"});
    EXPECT_TRUE(remote.apply(message("/ghostlight/look", {std::string("Verse")})).ok());
    EXPECT_EQ(remote.request().look.name, "Verse");
    EXPECT_LT(remote.request().look.seconds, 0) << "those of the look";
    EXPECT_EQ(remote.request().recalls, 1u);
    EXPECT_TRUE(remote.apply("look", {std::string("Verse"), 2.5}, "look").ok()) << "as a browser says it";
    EXPECT_DOUBLE_EQ(remote.request().look.seconds, 2.5);
    EXPECT_EQ(remote.request().recalls, 2u);
    for (const std::vector<dmx::OscArgument>& wrong : {std::vector<dmx::OscArgument>{},
                                                       {1.0},
                                                       {std::string()},
                                                       {std::string("Verse"), -1.0},
                                                       {std::string("Verse"), 1e9}})
        EXPECT_FALSE(remote.apply(message("/ghostlight/look", wrong)).ok());
    EXPECT_EQ(remote.request().recalls, 2u);
}

TEST(Remote, what_is_wrong_changes_nothing) {
    Remote remote({"house"});
    const double nan = std::nan("");
    for (const char* address : {"/ghostlight/master", "/ghostlight/haze", "/ghostlight/exposure"})
        for (const std::vector<dmx::OscArgument>& wrong :
             {std::vector<dmx::OscArgument>{}, {-100.0}, {1e30}, {nan}, {std::string("1")}})
            EXPECT_FALSE(remote.apply(message(address, wrong)).ok()) << address;
    for (const char* address :
         {"/", "/ghostlight", "/ghostlight/", "/ghostlight/master/x", "/other/master", "master"})
        EXPECT_FALSE(remote.apply(message(address, {0.5})).ok()) << address;
    EXPECT_FLOAT_EQ(remote.request().light(), 1.0f);
    EXPECT_FLOAT_EQ(remote.request().haze, 1.0f);
    EXPECT_FALSE(remote.request().ev100.has_value());
}

TEST(ParsePort, this_machine_alone_unless_an_address_is_given) {
    EXPECT_EQ(parse_port("9000", "--osc")->ipv4, 0x7F000001u);
    EXPECT_EQ(parse_port("9000", "--osc")->port, 9000);
    EXPECT_EQ(parse_port("0.0.0.0:7", "--osc")->ipv4, 0u);
    for (const char* text : {"", "0", "65536", "9000x", "here:9000", ":9000", "1.2.3:9000", "-1"})
        EXPECT_FALSE(parse_port(text, "--osc").ok()) << text;
}

TEST(RemoteInput, takes_packets_and_survives_others) {
    const auto port = static_cast<std::uint16_t>(22000 + getpid() % 20000);
    auto input = RemoteInput::open({0x7F000001, port});
    Remote remote({"house"});
    ASSERT_TRUE(input.ok()) << input.error().text();
    auto sender = dmx::UdpSocket::open(0x7F000001, 0, 65536);
    ASSERT_TRUE(sender.ok());
    const auto send = [&](std::string_view text) {
        const std::vector<std::uint8_t> bytes(text.begin(), text.end());
        ASSERT_TRUE((*sender)->send(bytes, 0x7F000001, port).ok());
    };
    using namespace std::string_view_literals;
    send("no OSC"sv);
    send("/ghostlight/master\0\0,f\0\0\x3f\0\0\0"sv);
    bool taken = false;
    for (int i = 0; i < 2000 && !taken; ++i) {
        (*input)->poll(remote, 0);
        taken = remote.request().master == 0.5f;
        if (!taken) std::this_thread::sleep_for(5ms);
    }
    EXPECT_TRUE(taken);
}

} // namespace
} // namespace ghost::app
