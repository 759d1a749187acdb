// SPDX-License-Identifier: Apache-2.0
// Haze, wind and hazers in the window: each edit is in the text of the show and comes back byte for byte, a
// slider that moves is one step, and the panel shows what the show has.
#include "support/test_desk.h"

#include "ui/panels/air_panel.h"

namespace ghost::ui {
namespace {

struct Air : Desk {
    Air() {
        open();
        add_air_actions(actions, app, document);
    }
    const scene::Show& show() const { return *app.show(); }
    std::string complaint(const QString& line) {
        const Result<void> done = actions.run(line);
        return done.ok() ? "" : done.error().text();
    }

    QWidget widget;
    Actions actions{widget};
    AirEdit air{app, document};
};

TEST(Air, hazers_are_added_moved_removed_and_undone) {
    Air air;
    ASSERT_EQ(air.complaint("add-hazer 1 2 0.5"), "");
    ASSERT_EQ(air.complaint("add-hazer -1 2 0.5"), "");
    ASSERT_EQ(air.complaint("hazer 2 place -3 2 0.5"), "");
    ASSERT_EQ(air.complaint("hazer 2 rate 8"), "");
    air.follow();
    ASSERT_EQ(air.show().hazers.size(), 2u);
    EXPECT_EQ(air.show().hazers[1].position_m, glm::vec3(-3, 2, 0.5f));
    EXPECT_EQ(air.show().hazers[1].rate, 8);
    ASSERT_EQ(air.complaint("remove-hazer 1"), "");
    ASSERT_EQ(air.show().hazers.size(), 1u) << "the window does not wait for the engine";
    EXPECT_EQ(air.show().hazers[0].rate, 8);
    ASSERT_TRUE(air.document.save(false).ok());
    EXPECT_EQ(air.on_disk(), air.document.text());
    for (int i = 0; i < 5; ++i) air.app.undo_stack().undo();
    EXPECT_EQ(air.document.text(), kShow);
    EXPECT_TRUE(air.show().hazers.empty());
    EXPECT_FALSE(air.app.undo_stack().canUndo());
}

TEST(Air, what_is_not_saved_lies_in_the_draft) {
    Air air;
    ASSERT_EQ(air.complaint("wind 1.5 0 0"), "");
    wait_ms(800);
    const auto draft = read_text_file(fs::path(air.folder) / ".ghost" / "draft.toml", 1 << 20);
    ASSERT_TRUE(draft.ok());
    EXPECT_NE(draft->find("wind_m_s = [1.5, 0, 0]"), std::string::npos) << *draft;
}

TEST(Air, a_slider_that_moves_is_one_step) {
    Air air;
    for (const float x : {0.1f, 0.2f, 0.3f}) ASSERT_TRUE(air.air.set_wind({x, 0, 0}).ok());
    ASSERT_TRUE(air.air.set_clouds(0.5f).ok());
    EXPECT_EQ(air.app.undo_stack().count(), 2) << "another one is a step of its own";
    EXPECT_EQ(air.show().haze.wind_m_s.x, 0.3f);
    air.app.undo_stack().undo();
    air.app.undo_stack().undo();
    EXPECT_EQ(air.document.text(), kShow);
    // A step of the look between two of the show is never taken for one of them.
    ASSERT_TRUE(air.air.set_clouds(0.5f).ok());
    Look look;
    look.scene.smoke = 2.0f;
    air.app.set_look(look, "smoke", 1);
    look.scene.smoke = 3.0f;
    air.app.set_look(look, "smoke", 1);
    EXPECT_EQ(air.app.undo_stack().count(), 2);
}

TEST(Air, what_is_no_air_is_said_and_not_done) {
    Air air;
    EXPECT_NE(air.complaint("haze fogg").find("did you mean 'fog'"), std::string::npos);
    EXPECT_NE(air.complaint("haze 11"), "");
    EXPECT_NE(air.complaint("wind 21 0 0"), "");
    EXPECT_NE(air.complaint("wind 1 0"), "");
    EXPECT_NE(air.complaint("clouds 2"), "");
    EXPECT_NE(air.complaint("hazer 1 rate 1").find("the show has 0"), std::string::npos);
    EXPECT_NE(air.complaint("remove-hazer x"), "");
    EXPECT_EQ(air.document.text(), kShow);
    ASSERT_EQ(air.complaint("add-hazer 0 0 0"), "");
    EXPECT_NE(air.complaint("hazer 1 direction 0 0 0").find("no length"), std::string::npos);
    EXPECT_NE(air.complaint("hazer 1 rate 1 2").find("expected 1 number"), std::string::npos);
    EXPECT_NE(air.complaint("hazer 1 colour red").find("expected place"), std::string::npos);
    EXPECT_EQ(air.app.undo_stack().count(), 1);
}

TEST(Air, the_panel_shows_the_show_and_its_cells_edit_it) {
    Air air;
    AirPanel panel(air.app, air.document, air.actions, nullptr);
    std::string said;
    panel.complain = [&](const Error& error) { said = error.text(); };
    ASSERT_EQ(air.complaint("haze \"heavy haze\""), "");
    ASSERT_EQ(air.complaint("add-hazer 1 2 0.5"), "");
    auto* haze = panel.findChild<QComboBox*>();
    EXPECT_TRUE(haze->currentText().startsWith("heavy haze")) << haze->currentText().toStdString();
    ASSERT_EQ(air.complaint("haze 0.033"), "");
    EXPECT_EQ(haze->currentText(), "0.033 per metre");
    auto* table = panel.findChild<QTableWidget*>();
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 0)->text(), "1 2 0.5");
    table->item(0, 0)->setText("4 5 0");
    EXPECT_EQ(air.show().hazers[0].position_m, glm::vec3(4, 5, 0));
    ASSERT_EQ(air.complaint("hazer 1 place 123.456 5 0.5"), "");
    EXPECT_EQ(table->item(0, 0)->text(), "123.456 5 0.5") << "all digits";
    table->item(0, 0)->setText("123.456 5 0");
    EXPECT_NE(air.document.text().find("position_m = [123.456, 5, 0]"), std::string::npos)
        << air.document.text();
    table->item(0, 2)->setText("much");
    EXPECT_NE(said, "");
    EXPECT_EQ(table->item(0, 2)->text(), "3") << "what it is comes back";
    // Wind by its speed and where it goes.
    const auto field = [&](const QString& name) -> QDoubleSpinBox* {
        for (auto* one : panel.findChildren<QDoubleSpinBox*>())
            if (one->accessibleName() == name) return one;
        return nullptr;
    };
    field("Wind towards")->setValue(90);
    field("Wind")->setValue(2);
    EXPECT_NEAR(air.show().haze.wind_m_s.x, 0, 1e-6);
    EXPECT_EQ(air.show().haze.wind_m_s.y, 2);
    EXPECT_EQ(field("Wind")->value(), 2);
    EXPECT_EQ(field("Wind towards")->value(), 90);
    ASSERT_EQ(air.complaint("wind -1 0 0"), "");
    EXPECT_EQ(field("Wind towards")->value(), 180);
    ASSERT_EQ(air.complaint("remove-hazer 1"), "");
    EXPECT_EQ(table->rowCount(), 0);
}

} // namespace
} // namespace ghost::ui
