// SPDX-License-Identifier: Apache-2.0
// Cameras get other names and go; who names them follows, and all else stays byte for byte.
#include "show_file/camera_edit.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

const std::string kWithCameras = R"([show] # a comment
[[camera]] # from the house
name = "front"
fov_y_deg = 40

[[camera]]
name = "side"

[[cue]]
name = "One"
camera = "front" # stays

[[cue]]
name = "Two"
camera = "side"

[[tracker]]
id = 3
camera = "front"

[[mover]]
name = "Crane"
cameras = ["front", "fr*"]
)";

std::vector<Camera> two_cameras() {
    std::vector<Camera> two(2);
    two[0].name = "front";
    two[1].name = "side";
    return two;
}

std::string with_other(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(CameraEdit, another_name_is_that_of_cues_trackers_and_movers_too) {
    const Result<std::string> text = rename_camera(kWithCameras, two_cameras(), 0, "Balcony");
    ASSERT_TRUE(text.ok()) << text.error().text();
    std::string expected = with_other(kWithCameras, "name = \"front\"", "name = \"Balcony\"");
    expected = with_other(expected, "camera = \"front\" # stays", "camera = \"Balcony\" # stays");
    expected = with_other(expected, "camera = \"front\"\n", "camera = \"Balcony\"\n");
    expected = with_other(expected, "[\"front\", \"fr*\"]", "[\"Balcony\"]"); // the pattern fits none now
    EXPECT_EQ(*text, expected);
}

TEST(CameraEdit, one_goes_and_the_rest_stays) {
    const Result<std::string> text = remove_camera(kWithCameras, two_cameras(), 1);
    ASSERT_TRUE(text.ok()) << text.error().text();
    EXPECT_EQ(*text, with_other(kWithCameras, "[[camera]]\nname = \"side\"\n\n", ""));
}

TEST(CameraEdit, what_the_file_does_not_have_is_refused) {
    const Result<std::string> made = rename_camera("[show]\n", two_cameras(), 0, "x");
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().text().find("is made from where the fixtures hang"), std::string::npos);
    EXPECT_FALSE(remove_camera("[show]\n", two_cameras(), 0).ok());
    const Result<std::string> damaged = remove_camera("[[camera]]\nname = \"front\"\n", two_cameras(), 0);
    ASSERT_FALSE(damaged.ok());
    EXPECT_NE(damaged.error().text().find("cannot be read"), std::string::npos);
    EXPECT_FALSE(rename_camera(kWithCameras, two_cameras(), 2, "x").ok());
}

TEST(CameraEdit, those_that_were_made_are_written_where_the_file_has_none) {
    const Result<std::string> text = own_cameras("[show]\n", two_cameras());
    ASSERT_TRUE(text.ok()) << text.error().text();
    EXPECT_NE(text->find("name = \"front\""), std::string::npos) << *text;
    EXPECT_LT(text->find("name = \"front\""), text->find("name = \"side\"")) << *text;
    const Result<std::string> again = own_cameras(kWithCameras, two_cameras());
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(*again, kWithCameras);
}

} // namespace
} // namespace ghost::scene
