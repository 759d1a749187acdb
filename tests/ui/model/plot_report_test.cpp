// SPDX-License-Identifier: Apache-2.0
// Which fixture files are looked at to stand in for one that a plot lacks.
#include "ui/model/plot_report.h"

#include "support/plot_files.h"
#include "support/test_window.h"

namespace ghost::ui {
namespace {

namespace fs = std::filesystem;

TEST(PlotReport, looks_at_two_thousand_fixture_files_to_stand_in_and_no_more) {
    constexpr std::size_t kMost = 2000;
    const fs::path folder = scene::scratch("stand_ins"), library = folder / "library";
    fs::create_directory(library);
    fs::copy(fs::path(GHOST_SOURCE_DIR) / "assets/fixtures/Ghostlight@LED_Par.gdtf", library);
    std::ofstream(folder / "tour.mvr", std::ios::binary) << [] {
        const auto bytes =
            scene::mvr_bytes(scene::small_xml("<Fixture uuid=\"" + scene::uuid(1) +
                                              "\" name=\"Lost\"><GDTFSpec>Lost.gdtf</GDTFSpec></Fixture>"));
        return std::string(bytes.begin(), bytes.end());
    }();
    for (std::size_t k = 0; k + 1 < kMost; ++k) std::ofstream(folder / ("a" + std::to_string(k) + ".gdtf"));
    Report said;
    Opened opened;
    opened.show = std::make_shared<scene::Show>(scene::opened(folder / "tour.mvr", said));
    for (const bool is_one_more : {false, true}) {
        if (is_one_more) std::ofstream(folder / "z.gdtf");
        Bench bench;
        PlotReport report(bench.app, library);
        bench.link.opened.put(opened);
        bench.link.on_news();
        for (int i = 0; i < 600 && !report.page(); ++i) wait_ms(50);
        ASSERT_TRUE(report.page());
        ASSERT_EQ(report.page()->lightless.size(), 1u);
        EXPECT_EQ(report.page()->lightless[0].wanted, "Lost.gdtf");
        EXPECT_EQ(report.page()->lightless[0].stand_ins.size(), is_one_more ? 0u : 1u);
    }
}

} // namespace
} // namespace ghost::ui
