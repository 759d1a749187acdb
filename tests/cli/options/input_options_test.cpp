// SPDX-License-Identifier: Apache-2.0
#include "cli/options/input_options.h"
#include "live/inputs/joined_universes.h"
#include "show_folder/load_show.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

using Numbers = std::vector<std::uint16_t>;

TEST(ParseUniverses, numbers_and_ranges) {
    EXPECT_EQ(*parse_universes(""), Numbers{});
    EXPECT_EQ(*parse_universes("7"), Numbers{7});
    EXPECT_EQ(*parse_universes("1-4,7"), (Numbers{1, 2, 3, 4, 7}));
    EXPECT_EQ(*parse_universes("9,2-3,3,1"), (Numbers{1, 2, 3, 9}));
    EXPECT_EQ(*parse_universes("63999"), Numbers{63999});
    EXPECT_EQ(parse_universes("1-4096")->size(), 4096u);
}

TEST(ParseUniverses, what_is_wrong_is_said) {
    for (const char* text : {"0", "64000", "4-2", "1,", ",1", "a", "1-", "-1", "1 2", "1-4097",
                             "1-4000,5000-6000", "99999999999"}) {
        const auto result = parse_universes(text);
        ASSERT_FALSE(result.ok()) << text;
        EXPECT_EQ(result.error().where, "--universes");
        EXPECT_NE(result.error().what.find(text), std::string::npos);
    }
}

TEST(LossPolicy, hold_black_or_seconds) {
    using namespace std::chrono_literals;
    EXPECT_FALSE(parse_loss_policy("hold")->black_after.has_value());
    EXPECT_EQ(parse_loss_policy("black")->black_after, std::chrono::nanoseconds(0));
    EXPECT_EQ(parse_loss_policy("2.5")->black_after, std::chrono::nanoseconds(2500ms));
    for (const char* text : {"", "-1", "10s", "dark", "nan", "inf", "1e9"}) {
        const auto result = parse_loss_policy(text);
        ASSERT_FALSE(result.ok()) << text;
        EXPECT_EQ(result.error().where, "--on-loss");
    }
}

TEST(ReceiverOptions, loss_and_artnet_merge) {
    InputOptions input;
    EXPECT_FALSE(receiver_options(input)->loss.black_after.has_value());
    EXPECT_FALSE(receiver_options(input)->artnet_ltp);
    input.on_loss = "3";
    input.artnet_merge = "ltp";
    EXPECT_TRUE(receiver_options(input)->loss.black_after.has_value());
    EXPECT_TRUE(receiver_options(input)->artnet_ltp);
}

TEST(ParseUsbPorts, universes_count_on_from_the_one_before) {
    const auto ports = parse_usb_ports({"/dev/ttyUSB0", "/dev/ttyUSB1=7", "auto"});
    ASSERT_TRUE(ports.ok()) << ports.error().text();
    ASSERT_EQ(ports->size(), 3u);
    EXPECT_EQ((*ports)[0].path, "/dev/ttyUSB0");
    EXPECT_EQ((*ports)[0].universe, 1);
    EXPECT_EQ((*ports)[1].path, "/dev/ttyUSB1");
    EXPECT_EQ((*ports)[1].universe, 7);
    EXPECT_EQ((*ports)[2].path, "auto");
    EXPECT_EQ((*ports)[2].universe, 8);
    for (const char* text :
         {"", "ttyUSB0", "/dev/ttyUSB0=", "/dev/ttyUSB0=0", "/dev/ttyUSB0=64000", "auto=x"})
        EXPECT_FALSE(parse_usb_ports({text}).ok()) << text;
    EXPECT_FALSE(parse_usb_ports({"auto", "auto=4"}).ok());
    EXPECT_FALSE(parse_usb_ports({"/dev/a=63999", "/dev/b"}).ok());
}

TEST(ReceiverOptions, usb_alone) {
    InputOptions input;
    input.protocols = "none";
    EXPECT_FALSE(receiver_options(input).ok());
    input.usb = {"auto"};
    const auto options = receiver_options(input);
    ASSERT_TRUE(options.ok());
    EXPECT_FALSE(options->sacn || options->artnet);
    EXPECT_EQ(options->usb.size(), 1u);
}

TEST(ReceiverOptions, protocols) {
    InputOptions input;
    EXPECT_TRUE(receiver_options(input)->sacn);
    EXPECT_TRUE(receiver_options(input)->artnet);
    input.protocols = "artnet";
    input.universes = "3";
    input.no_poll_reply = true;
    const auto options = receiver_options(input);
    EXPECT_FALSE(options->sacn);
    EXPECT_TRUE(options->artnet);
    EXPECT_FALSE(options->answer_polls);
    EXPECT_EQ(options->universes, Numbers{3});
    input.universes = "x";
    EXPECT_FALSE(receiver_options(input).ok());
}

TEST(ReceiverOptions, one_port_for_two_protocols) {
    InputOptions input;
    input.sacn_port = input.artnet_port = 7000;
    ASSERT_FALSE(receiver_options(input).ok());
    EXPECT_NE(receiver_options(input).error().text().find("--sacn-port"), std::string::npos);
    input.protocols = "sacn";
    EXPECT_TRUE(receiver_options(input).ok());
}

TEST(ReceiverOptions, an_offset_that_reaches_none_of_the_universes) {
    InputOptions input;
    input.universes = "1-4,40000";
    EXPECT_TRUE(receiver_options(input).ok());
    for (const int offset : {-32768, 40001}) {
        input.artnet_offset = offset;
        ASSERT_FALSE(receiver_options(input).ok()) << offset;
        EXPECT_EQ(receiver_options(input).error().where, "--artnet-offset");
    }
    for (const int offset : {-32763, 0, 1, 4, 40000}) {
        input.artnet_offset = offset;
        EXPECT_TRUE(receiver_options(input).ok()) << offset;
    }
    input.artnet_offset = 50000;
    input.protocols = "sacn";
    EXPECT_TRUE(receiver_options(input).ok()) << "no Art-Net";
    input.protocols = "both";
    input.universes = "";
    EXPECT_TRUE(receiver_options(input).ok()) << "whatever arrives";
    input.artnet_offset = 1;
    input.universes = "40000";
    EXPECT_TRUE(receiver_options(input).ok()) << "of sACN only";
}

TEST(ReceiverOptions, time_code_by_midi_is_something_to_listen_to) {
    InputOptions input;
    input.protocols = "none";
    input.midi = "/dev/snd/midiC1D0";
    ASSERT_TRUE(receiver_options(input).ok());
    EXPECT_EQ(receiver_options(input)->midi, "/dev/snd/midiC1D0");
}

TEST(InputOptions, preview_of_all_or_of_some_universes) {
    InputOptions input;
    EXPECT_FALSE(receiver_options(input)->show_preview);
    input.preview_universes = "2-3";
    EXPECT_TRUE(receiver_options(input)->show_preview);
    EXPECT_EQ(receiver_options(input)->preview_universes, (Numbers{2, 3}));
    input.show_preview = true;
    EXPECT_TRUE(receiver_options(input)->preview_universes.empty());
    input.preview_universes = "0";
    EXPECT_EQ(receiver_options(input).error().where, "--preview-universes");
}

TEST(InputOptions, universes_of_a_show_and_those_asked_for) {
    Report report;
    const auto show = scene::load_show(std::string(GHOST_SOURCE_DIR) + "/assets/demo", false, report);
    ASSERT_TRUE(show.ok()) << show.error().text();
    const scene::PatchMap demo(*show);
    EXPECT_EQ(joined_universes({}, demo), Numbers{1});
    EXPECT_EQ(joined_universes({1, 4, 5}, demo), (Numbers{1, 4, 5}));
    EXPECT_EQ(joined_universes({}, scene::PatchMap()), Numbers{}) << "whatever arrives";
}

} // namespace
} // namespace ghost::app
