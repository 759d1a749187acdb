// SPDX-License-Identifier: Apache-2.0
// Drawings as gobos: black keeps light out, what is not drawn lets it through; areas against the geometry.
#include "fixture_files/common/gobo_drawing.h"

#include "disk/files.h"
#include "fixture_files/common/svg_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

namespace ghost::fixture {
namespace {

GoboDrawing drawn(const std::string& inside, const std::string& box = "0 0 100 100") {
    const std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + box + "\">" + inside + "</svg>";
    const Result<GoboDrawing> drawing =
        draw_gobo({reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size()}, "test.svg");
    EXPECT_TRUE(drawing.ok()) << drawing.error().text();
    return drawing.ok() ? *drawing : GoboDrawing{};
}

// Share of the whole square that is dark.
double dark(const GoboDrawing& drawing) {
    double sum = 0.0;
    for (std::size_t i = 0; i < drawing.picture.samples.size(); i += 4)
        sum += 1.0 - drawing.picture.samples[i + 1] / 255.0;
    return sum / static_cast<double>(drawing.picture.samples.size() / 4);
}

int green_at(const GoboDrawing& drawing, double x, double y) { // shares of the side
    return drawing.picture.at(static_cast<int>(x * kGoboDrawing_px),
                              static_cast<int>(y * kGoboDrawing_px))[1];
}

TEST(gobo_drawing, what_is_not_drawn_passes_within_the_disc) {
    const GoboDrawing empty = drawn("");
    EXPECT_EQ(empty.picture.width, kGoboDrawing_px);
    EXPECT_EQ(dark(empty), 0.0);
    EXPECT_EQ(empty.picture.at(128, 128)[3], 255);
    EXPECT_EQ(empty.picture.at(2, 2)[3], 0) << "outside of the disc";
}

TEST(gobo_drawing, areas_of_shapes) {
    EXPECT_NEAR(dark(drawn("<path d='M10 20h50v30h-50z'/>")), 0.15, 1e-3);
    EXPECT_NEAR(dark(drawn("<rect x='10' y='20' width='50' height='30'/>")), 0.15, 1e-3);
    EXPECT_NEAR(dark(drawn("<circle cx='50' cy='50' r='30'/>")), std::numbers::pi * 0.09, 2e-3);
    EXPECT_NEAR(dark(drawn("<polygon points='0,0 100,0 0,100'/>")), 0.5, 2e-3);
    // Four arcs, absolute and relative, with flags that stand close.
    EXPECT_NEAR(dark(drawn("<path d='M20 50A30 30 0 0150 20a30 30 0 1 1-30 30z'/>")), std::numbers::pi * 0.09,
                2e-3);
    // Cubics that make a circle (kappa), with the smooth short form.
    EXPECT_NEAR(
        dark(drawn(
            "<path d='M50 20c16.568 0 30 13.432 30 30S66.568 80 50 80 20 66.568 20 50 33.432 20 50 20z'/>")),
        std::numbers::pi * 0.09, 2e-3);
    // A parabola over its chord: two thirds of base times height.
    EXPECT_NEAR(dark(drawn("<path d='M0 50Q50-50 100 50z'/>")), 2.0 / 3.0 * 0.5, 2e-3);
    EXPECT_NEAR(dark(drawn("<path d='M10 50H90' fill='none' stroke='#000' stroke-width='10'/>")), 0.08, 1e-3);
}

TEST(gobo_drawing, rules_colours_groups_and_clips) {
    const std::string ring = "d='M10 10h80v80h-80z M30 30h40v40h-40z'";
    EXPECT_NEAR(dark(drawn("<path " + ring + "/>")), 0.64, 2e-3) << "both turn the same way";
    EXPECT_NEAR(dark(drawn("<path fill-rule='evenodd' " + ring + "/>")), 0.48, 2e-3);
    EXPECT_NEAR(dark(drawn("<path style='fill-rule:evenodd;fill:#211e1e' " + ring + "/>")), 0.48, 2e-3);
    EXPECT_NEAR(dark(drawn("<path d='M10 10h80v80h-80z M30 30v40h40v-40z'/>")), 0.48, 2e-3);
    const GoboDrawing red =
        drawn("<g fill='red'><path d='M0 0h100v100H0z'/><path fill='#fff' d='M40 40h20v20h-20z'/></g>");
    EXPECT_EQ(green_at(red, 0.1, 0.5), 0);
    EXPECT_EQ(red.picture.at(50, 128)[0], 255);
    EXPECT_EQ(green_at(red, 0.5, 0.5), 255);
    // Half the size, to the right and down; the last transform acts first.
    const GoboDrawing moved =
        drawn("<g transform='translate(50 50) scale(.5)'><rect width='100' height='100'/></g>");
    EXPECT_NEAR(dark(moved), 0.25, 1e-3);
    EXPECT_EQ(green_at(moved, 0.75, 0.75), 0);
    EXPECT_EQ(green_at(moved, 0.25, 0.25), 255);
    const GoboDrawing turned =
        drawn("<rect transform='rotate(90 50 50)' x='0' y='0' width='100' height='10'/>");
    EXPECT_EQ(green_at(turned, 0.95, 0.5), 0);
    EXPECT_EQ(green_at(turned, 0.5, 0.05), 255);
    EXPECT_NEAR(dark(drawn("<g clip-path='url(#a)'><rect width='100' height='100'/></g>"
                           "<clipPath id='a'><path d='M0 0h50v100H0z'/></clipPath>")),
                0.5, 1e-3);
    // A drawing that is not square stands in the middle.
    EXPECT_NEAR(dark(drawn("<rect x='5' y='5' width='200' height='100'/>", "5 5 200 100")), 0.5, 1e-3);
}

TEST(gobo_drawing, what_is_not_drawn_is_said) {
    EXPECT_EQ(drawn("<title>Leaf</title><metadata/><defs/>").problem, "");
    EXPECT_NE(drawn("<text>Leaf</text>").problem.find("'text' is not drawn"), std::string::npos);
    const GoboDrawing faulty = drawn("<path d='M10 20h50v30h-50z Lx'/>");
    EXPECT_NE(faulty.problem.find("faulty"), std::string::npos);
    EXPECT_NEAR(dark(faulty), 0.15, 1e-3) << "as far as it goes";
    const std::string no_xml = "<svg><path";
    EXPECT_FALSE(draw_gobo({reinterpret_cast<const std::uint8_t*>(no_xml.data()), no_xml.size()}, "x").ok());
    const std::string other = "<html/>";
    EXPECT_FALSE(draw_gobo({reinterpret_cast<const std::uint8_t*>(other.data()), other.size()}, "x").ok());
}

TEST(gobo_drawing, hostile_drawings_cost_little) {
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "<g transform='scale(1e30)'>";
    deep += "<path d='M0 0h1'/>";
    for (int i = 0; i < 100000; ++i) deep += "</g>";
    EXPECT_NE(drawn(deep).problem.find("deep"), std::string::npos);
    std::string many;
    for (int i = 0; i < 20000; ++i) many += "<rect width='1' height='1'/>";
    EXPECT_NE(drawn(many).problem.find("2000 shapes"), std::string::npos);
    std::string points = "<path stroke='red' stroke-width='90' d='M0 0";
    for (int i = 0; i < 150000; ++i) points += i % 2 ? "L100 0" : "L0 100";
    EXPECT_NE(drawn(points + "'/>").problem.find("too many long strokes"), std::string::npos);
    for (int i = 0; i < 150000; ++i) points += "L1 1";
    EXPECT_NE(drawn(points + "'/>").problem, "");
    // Groups of a clip that is not there, and of one of many shapes: each is looked for and drawn again.
    for (const std::size_t shapes : {0u, 30000u}) {
        std::string clips = "<clipPath id='c'>";
        for (std::size_t i = 0; i < shapes; ++i) clips += "<rect width='1' height='1'/>";
        clips += "</clipPath>";
        for (int i = 0; i < 100000; ++i)
            clips += i % 2 ? "<g clip-path='url(#c)'/>" : "<g clip-path='url(#d)'/>";
        EXPECT_NE(drawn(clips).problem.find("20000 elements"), std::string::npos) << shapes;
    }
    for (const char* data : {"M nan 0 L inf 1e99", "M1e5 1e5A1e5 1e-30 7 1 1 5 5z", "L 1 1",
                             "M0 0A0 0 0 0 0 1 1T9 9S1 1 2 2", "Mz"})
        drawn("<path transform='matrix(1e30 1e30 1e30 1e30 1e38 1e38) scale(1e30)' stroke='#000' d='" +
              std::string(data) + "'/>");
}

TEST(gobo_drawing, all_installed_drawings) {
    const std::filesystem::path folder = "/usr/share/qlcplus/gobos";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "qlcplus-data is not installed";
    int drawings = 0;
    int odd = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".svg") continue;
        ++drawings;
        const auto bytes = read_file(entry.path(), 16u << 20);
        ASSERT_TRUE(bytes.ok());
        const Result<GoboDrawing> drawing = draw_gobo(*bytes, entry.path().string());
        ASSERT_TRUE(drawing.ok()) << drawing.error().text();
        EXPECT_EQ(drawing->problem, "") << entry.path();
        double light = 0.0;
        double disc = 0.0;
        for (std::size_t i = 0; i < drawing->picture.samples.size(); i += 4) {
            light += drawing->picture.samples[i + 1] * drawing->picture.samples[i + 3] / 255.0;
            disc += drawing->picture.samples[i + 3];
        }
        const double passed = light / disc;
        if (passed < 0.01 || passed > 0.97) {
            ++odd;
            std::printf("  %s passes %.3f\n", entry.path().filename().string().c_str(), passed);
        }
    }
    std::printf("  %d drawings, %d of them nearly dark or nearly open\n", drawings, odd);
    EXPECT_GT(drawings, 500);
    EXPECT_EQ(odd, 0);
}

} // namespace
} // namespace ghost::fixture
