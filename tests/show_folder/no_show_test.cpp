// SPDX-License-Identifier: Apache-2.0
// What is opened and is no show at all: nobody is told to mend a line of a song.
#include "show_folder/load_show.h"

#include "disk/files.h"
#include "support/test_folder.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

std::string error_of(const std::filesystem::path& path) {
    Report report;
    const auto show = load_show(path, false, report);
    return show.ok() ? "" : show.error().what;
}

TEST(NoShow, what_can_be_opened_is_said_of_what_cannot) {
    const TestFolder own;
    const std::filesystem::path& folder = own.path;
    const auto put = [&](const char* name, const std::string& text) {
        EXPECT_TRUE(write_file_atomic(folder / name, text).ok());
        return folder / name;
    };
    const std::string can_be = "a folder with a show.toml, a show.toml, or a plot (.mvr) can be opened";
    for (const std::string& file : {std::string("ID3\x04\0\xFF\xFB\x90", 8), std::string("Dear all,\n"),
                                    std::string(std::size_t{64} << 20, 'x')})
        EXPECT_NE(error_of(put("song.mp3", file)).find(can_be), std::string::npos) << file.substr(0, 10);
    // What is meant as one is read as one, whatever it is called.
    EXPECT_EQ(error_of(put("show.toml", "[show\n")).find("is not TOML"), 0u);
    EXPECT_EQ(error_of(put("tour.bak", "[show]\nname = \"a\n")).find("is not TOML"), 0u);
    EXPECT_EQ(error_of(put("tour.old", "[show]\nname = \"a\"\n")), "");
    // What a full disk left is no show, and what has no size, as files of the system, neither.
    EXPECT_EQ(error_of(put("show.toml", "")), "is empty: there is no show in it");
    EXPECT_EQ(error_of(folder), "is empty: there is no show in it");
    EXPECT_EQ(error_of(put("show.toml", " \n\n")), "is empty: there is no show in it");
    EXPECT_NE(error_of(put("tour.txt", "")).find(can_be), std::string::npos);
    EXPECT_NE(error_of(put("list.txt", "[[camera]]\nname = \"a\"\n")).find(can_be), std::string::npos);
    EXPECT_EQ(error_of(folder / "nothing.mp3").find(can_be), std::string::npos) << "it is not there";
}

} // namespace
} // namespace ghost::scene
