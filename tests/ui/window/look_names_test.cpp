// SPDX-License-Identifier: Apache-2.0
// A look that gets another name in the window keeps the cues that recall it.
#include "support/test_desk.h"
#include "ui/window/window.h"

namespace ghost::ui {
namespace {

TEST(LookNames, a_look_that_is_renamed_in_the_window_is_recalled_by_its_cues) {
    QTemporaryDir own;
    const fs::path file = fs::path(own.path().toStdString()) / "show.toml";
    const std::string text = kShow + "[[cue]]\nname = \"One\"\nlook = \"Look 3\"\n";
    ASSERT_TRUE(write_file_atomic(file, text).ok());
    ASSERT_TRUE(write_file_atomic(file.parent_path() / "looks.toml", "[[look]]\nname = \"Look 3\"\n").ok());
    Link link;
    Window window{link, {.remembers = false, .width = 1000, .height = 700}};
    Report report;
    auto parsed = scene::parse_show(text, file, report);
    ASSERT_TRUE(parsed.ok());
    Opened opened;
    opened.show = std::make_shared<const scene::Show>(std::move(parsed->show));
    link.opened.put(std::move(opened));
    link.on_news();
    settle();
    const auto error_of = [&](const QString& line) {
        const Result<void> done = window.actions().run(line);
        settle();
        return done.ok() ? std::string() : done.error().text();
    };
    EXPECT_EQ(error_of("look-rename \"Look 3\" Verse"), "");
    EXPECT_EQ(window.app().show()->cues.at(0).look, "Verse");
    EXPECT_EQ(error_of("cue-go"), "");
    EXPECT_NE(error_of("look-remove Verse").find("cue 'One' recalls it"), std::string::npos);
    EXPECT_EQ(error_of("undo"), "") << "one step, for the recall changed nothing";
    EXPECT_EQ(window.app().show()->cues.at(0).look, "Look 3");
    EXPECT_EQ(error_of("cue-go"), "cue-go: this was the last cue");
}

} // namespace
} // namespace ghost::ui
