// SPDX-License-Identifier: Apache-2.0
// Save as: over what it writes, and what goes on under the other name.
#include "support/test_desk.h"
#include "ui/actions/programmer_actions.h"
#include "ui/actions/show_actions.h"

#include <QWidget>

namespace ghost::ui {
namespace {

struct SavingDesk : Desk {
    SavingDesk() {
        add_show_actions(actions, app, document, "", widget);
        app.open(file.string());
        answer_open(file);
    }
    // What the engine does with a wish to open another one.
    void answer_open(const fs::path& path) {
        file = path;
        Report report;
        auto parsed = scene::parse_show(on_disk(), file, report);
        ASSERT_TRUE(parsed.ok());
        Opened opened;
        opened.show = std::make_shared<const scene::Show>(std::move(parsed->show));
        opened.opens = app.request().opens;
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    std::string error_of(const QString& line) {
        const Result<void> done = actions.run(line);
        return done.ok() ? "" : done.error().text();
    }
    fs::path beside(const char* name) const { return fs::path(folder) / name; }

    QWidget widget;
    Actions actions{widget};
};

TEST(SaveAs, a_file_that_is_there_goes_only_where_somebody_says_so) {
    SavingDesk desk;
    ASSERT_TRUE(write_file_atomic(desk.beside("act2.toml"), "precious").ok());
    for (const char* const name : {"act2", "act2.toml"})
        EXPECT_NE(desk.error_of(QString("save-as ") + name).find("is there already"), std::string::npos);
    EXPECT_EQ(*read_text_file(desk.beside("act2.toml"), 100), "precious");
    EXPECT_NE(desk.error_of("save-as show").find("is the show file itself"), std::string::npos);
    EXPECT_EQ(desk.error_of("save-as act2 over"), "");
    EXPECT_EQ(*read_text_file(desk.beside("act2.toml"), 1 << 20), kShow);
}

TEST(SaveAs, hands_selection_camera_and_undo_go_on_and_the_old_name_has_no_draft) {
    SavingDesk desk;
    const fs::path old = desk.file;
    desk.app.select_in_order({2, 0});
    ASSERT_TRUE(desk.edit.rename("Front").ok());
    change_selected(desk.app, "intensity", ProgrammerStep::intensity,
                    [](fixture::Programmer& programmer) { programmer.intensity = 0.5f; });
    desk.app.change_request([](ViewRequest& request) {
        request.black_out = true;
        request.input = Input::recording;
    });
    wait_ms(700); // the draft is written
    const Look look = desk.app.look();
    const scene::Camera camera = desk.app.camera();
    const int steps = desk.app.undo_stack().count();
    ASSERT_EQ(desk.error_of("save-as act2"), "");
    desk.answer_open(desk.beside("act2.toml"));
    EXPECT_EQ(desk.app.look(), look);
    EXPECT_EQ(desk.app.request().look, look);
    EXPECT_EQ(desk.app.selected_in_order(), (std::vector<std::size_t>{2, 0}));
    EXPECT_EQ(desk.app.camera().position_m, camera.position_m);
    EXPECT_TRUE(desk.app.request().black_out);
    EXPECT_EQ(desk.app.request().input, Input::recording);
    EXPECT_EQ(desk.app.undo_stack().count(), steps);
    EXPECT_FALSE(desk.document.is_changed());
    while (desk.app.undo_stack().canUndo()) desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow);
    EXPECT_EQ(*read_text_file(old, 1 << 20), kShow);
    desk.app.open(old.string());
    desk.answer_open(old);
    EXPECT_FALSE(desk.document.has_draft());
    EXPECT_TRUE(desk.app.selection().empty()) << "another show";
}

TEST(SaveAs, the_file_before_gets_nothing_any_more_while_the_other_one_is_opened) {
    SavingDesk desk;
    const fs::path old = desk.file;
    ASSERT_EQ(desk.error_of("save-as act2"), "");
    desk.app.select({0});
    const Result<void> renamed = desk.edit.rename("Front");
    ASSERT_FALSE(renamed.ok());
    EXPECT_NE(renamed.error().text().find("is being opened under its new name"), std::string::npos)
        << renamed.error().text();
    EXPECT_FALSE(desk.document.save(false).ok());
    wait_ms(700);
    EXPECT_EQ(*read_text_file(old, 1 << 20), kShow);
    EXPECT_FALSE(fs::exists(desk.beside(".ghost") / "draft.toml"));
    desk.answer_open(desk.beside("act2.toml"));
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.rename("Front").ok());
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_NE(desk.on_disk(), kShow);
    EXPECT_EQ(*read_text_file(old, 1 << 20), kShow);
}

} // namespace
} // namespace ghost::ui
