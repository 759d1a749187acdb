// SPDX-License-Identifier: Apache-2.0
// Films of a plot's archive on the disk: as many as a show has media, once for all versions, gone when no
// plot needs them.
#include "plots/private/plot_media.h"
#include "support/plot_files.h"

namespace ghost::scene {
namespace {

std::string screen(int number, const std::string& value, const std::string& type = "File") {
    return "<VideoScreen uuid=\"" + uuid(number) + "\" name=\"Screen " + std::to_string(number) + "\">" +
           matrix(kIdentity + "{1000,2000,3000}") +
           "<Geometries><Geometry3D fileName=\"Sail.glb\"/></Geometries><Sources><Source type=\"" + type +
           "\">" + value + "</Source></Sources></VideoScreen>\n";
}

std::size_t files_below(const fs::path& folder) {
    std::size_t count = 0;
    if (fs::exists(folder))
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            count += entry.path().extension() == ".mp4";
    return count;
}

std::string write_plot(const fs::path& path, int films, const std::string& of) {
    std::string screens;
    Members members;
    for (int k = 0; k < films; ++k) {
        const std::string name = "film" + std::to_string(k) + ".mp4";
        screens += screen(40 + k, name);
        members.push_back({name, of + std::to_string(k)});
    }
    write_mvr(path, small_xml(screens), members);
    Report report;
    opened(path, report);
    return messages_of(report);
}

TEST(PlotMedia, NoMoreFilmsAreUnpackedThanAShowHasMedia) {
    const fs::path folder = scratch("media_cap");
    const std::string said = write_plot(folder / "plot.mvr", static_cast<int>(kMaxMedia) + 20, "film ");
    EXPECT_NE(said.find("more than 64 media in one show"), std::string::npos) << said;
    EXPECT_EQ(files_below(folder / ".ghost"), kMaxMedia);
}

TEST(PlotMedia, WhatIsUnpackedHasAnEnd) {
    const fs::path folder = scratch("media_end");
    std::string screens;
    Members members;
    for (int k = 0; k < 3; ++k) {
        const std::string name = "film" + std::to_string(k) + ".mp4";
        screens += screen(40 + k, name);
        members.push_back({name, std::string(1000, static_cast<char>('a' + k))});
    }
    write_mvr(folder / "plot.mvr", small_xml(screens), members);
    Report report;
    const Show show = opened(folder / "plot.mvr", report);
    EXPECT_EQ(files_below(folder / ".ghost"), 3u) << messages_of(report);
    fs::remove_all(folder / ".ghost");
    Report said;
    unpack_media(show, said, 2500);
    EXPECT_EQ(files_below(folder / ".ghost"), 2u);
    EXPECT_TRUE(says(said, {"film2.mp4", "500 are allowed"})) << messages_of(said);
    unpack_media(show, said, 2500); // those that are there count
    EXPECT_EQ(files_below(folder / ".ghost"), 2u);
}

TEST(PlotMedia, VersionsOfAPlotShareTheirFilms) {
    const fs::path folder = scratch("media_share");
    write_plot(folder / "one.mvr", 3, "film ");
    write_plot(folder / "two.mvr", 3, "film ");
    EXPECT_EQ(files_below(folder / ".ghost"), 3u);
}

TEST(PlotMedia, WhatNoPlotNeedsAnyMoreIsRemoved) {
    const fs::path folder = scratch("media_clean");
    write_plot(folder / "one.mvr", 3, "old ");
    write_plot(folder / "two.mvr", 2, "old ");
    write_plot(folder / "one.mvr", 3, "new "); // the plot has come again
    EXPECT_EQ(files_below(folder / ".ghost"), 5u) << "two.mvr needs its own still";
    const fs::path own = folder / ".ghost" / "media" / "holiday.mp4";
    const fs::path link = folder / ".ghost" / "media" / "0123abcd-link.mp4";
    std::ofstream(own) << "not ours";
    fs::create_symlink("holiday.mp4", link);
    fs::remove(folder / "two.mvr");
    write_plot(folder / "one.mvr", 3, "new ");
    EXPECT_EQ(files_below(folder / ".ghost"), 5u) << "three films, and two files that we did not write";
    EXPECT_TRUE(fs::exists(own) && fs::is_symlink(link));
}

// Which the user has to allow before it is opened (video/capture_consent.h).
TEST(PlotMedia, ACaptureDeviceIsOneOfThisMachinesDevicesOrATestCard) {
    Report report;
    const auto media_of = [&](const std::string& device) {
        return opened_xml("media_device", small_xml(screen(40, device, "CaptureDevice")), report).media.at(0);
    };
    const Media camera = media_of("/dev/video0");
    EXPECT_EQ(camera.kind, MediaKind::camera);
    EXPECT_EQ(camera.file, fs::path("/dev/video0"));
    EXPECT_TRUE(report.messages.empty()) << messages_of(report);
    for (const std::string foreign : {"/dev/../etc/passwd", "/home/x", "film.mp4"}) {
        EXPECT_EQ(media_of(foreign).kind, MediaKind::card) << foreign;
        EXPECT_TRUE(says(report, {"capture device '" + foreign + "'", "a test card is shown"}))
            << messages_of(report);
    }
}

TEST(PlotMedia, NothingIsUnpackedThroughALink) {
    const fs::path folder = scratch("media_link");
    fs::create_directories(folder / "elsewhere");
    fs::create_directory_symlink("elsewhere", folder / ".ghost");
    const std::string said = write_plot(folder / "plot.mvr", 1, "film ");
    EXPECT_NE(said.find("is a link"), std::string::npos) << said;
    EXPECT_TRUE(fs::is_empty(folder / "elsewhere"));
}

} // namespace
} // namespace ghost::scene
