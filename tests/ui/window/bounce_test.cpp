// SPDX-License-Identifier: Apache-2.0
// Bounced light in the window: its level is an edit of the show that comes back byte for byte, the row says
// what the engine says, and its button gives up the making of links and begins it again.
#include "support/test_desk.h"

#include "ui/panels/air_panel.h"
#include "ui/picture/private/chips.h"

namespace ghost::ui {
namespace {

struct Bounce : Desk {
    Bounce() {
        open();
        add_bounce_actions(actions, app, document);
    }
    std::string complaint(const QString& line) {
        const Result<void> done = actions.run(line);
        return done.ok() ? "" : done.error().text();
    }
    void say(const BounceNow& now) {
        link.bounce.put(BounceNow(now));
        link.on_news();
        settle();
    }

    QWidget widget;
    Actions actions{widget};
};

TEST(BounceRow, its_level_is_an_edit_of_the_show) {
    Bounce desk;
    ASSERT_EQ(desk.complaint("bounce normal"), "");
    EXPECT_EQ(desk.app.show()->bounce, scene::BounceDetail::normal)
        << "the window does not wait for the engine";
    EXPECT_EQ(desk.document.text(), kShow + "\n[light]\nbounce = \"normal\"\n");
    ASSERT_EQ(desk.complaint("bounce fine"), "");
    EXPECT_EQ(desk.app.undo_stack().count(), 2);
    EXPECT_NE(desk.complaint("bounce normel").find("did you mean 'normal'"), std::string::npos);
    EXPECT_NE(desk.complaint("bounce"), "");
    EXPECT_EQ(desk.app.undo_stack().count(), 2);
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_EQ(desk.on_disk(), desk.document.text());
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.app.show()->bounce, scene::BounceDetail::normal);
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow);
}

TEST(BounceRow, it_says_what_it_costs_and_how_far_links_are) {
    Bounce desk;
    AirPanel panel(desk.app, desk.document, desk.actions, nullptr);
    auto* row = panel.findChild<BounceRow*>();
    auto* detail = row->findChild<QComboBox*>();
    auto* bar = row->findChild<QProgressBar*>();
    auto* button = row->findChild<QPushButton*>();
    const auto said = [&] {
        QStringList all;
        for (const QLabel* label : row->findChildren<QLabel*>()) all << label->text();
        return all.join(" | ");
    };
    const auto chips = [&] {
        QStringList all;
        for (const Chip& chip : chips_of(desk.app)) all << chip.text;
        return all.join(" | ");
    };
    EXPECT_TRUE(bar->isHidden());
    EXPECT_TRUE(button->isHidden());
    detail->setCurrentIndex(2);
    Q_EMIT detail->activated(2);
    EXPECT_EQ(desk.app.show()->bounce, scene::BounceDetail::normal);
    EXPECT_EQ(detail->currentText(), "normal");

    desk.say({.state = BounceNow::State::makes_links,
              .detail = scene::BounceDetail::normal,
              .made_share = 0.4,
              .left_s = 11.2});
    EXPECT_TRUE(said().contains("links are being made, 40 %, 12 s left")) << said().toStdString();
    EXPECT_TRUE(chips().contains("bounced light: links are being made, 40 %, 12 s left"));
    EXPECT_FALSE(bar->isHidden());
    EXPECT_EQ(bar->value(), 400);
    EXPECT_EQ(button->text(), "Cancel");
    button->click();
    EXPECT_TRUE(desk.app.request().stops_bounce);

    desk.say({.state = BounceNow::State::stopped, .detail = scene::BounceDetail::normal});
    EXPECT_TRUE(bar->isHidden());
    EXPECT_TRUE(said().contains("no light bounces"));
    EXPECT_FALSE(chips().contains("bounced light"));
    EXPECT_EQ(button->text(), "Make them");
    button->click();
    EXPECT_FALSE(desk.app.request().stops_bounce);

    // Another level makes them, too; so does the same one, chosen once more.
    ASSERT_EQ(desk.complaint("cancel-bounce"), "");
    EXPECT_TRUE(desk.app.request().stops_bounce);
    ASSERT_EQ(desk.complaint("bounce normal"), "");
    EXPECT_FALSE(desk.app.request().stops_bounce);

    desk.say({.state = BounceNow::State::bounces,
              .detail = scene::BounceDetail::normal,
              .solve_ms = 7.94,
              .draw_ms = 1.23});
    EXPECT_TRUE(said().contains("solved in 7.9 ms beside the picture, drawn in 1.2 ms of it"))
        << said().toStdString();
    EXPECT_TRUE(button->isHidden());
    desk.say({.state = BounceNow::State::failed, .detail = scene::BounceDetail::normal});
    EXPECT_TRUE(said().contains("Messages say why"));
    desk.say({.detail = scene::BounceDetail::off, .is_of_command_line = true});
    EXPECT_TRUE(said().contains("off, by --bounce of the command line")) << said().toStdString();
    EXPECT_EQ(detail->currentText(), "normal") << "the show's";

    // What was cancelled for one show says nothing of the next.
    ASSERT_EQ(desk.complaint("cancel-bounce"), "");
    desk.answer(kShow, false);
    EXPECT_FALSE(desk.app.request().stops_bounce);
    EXPECT_EQ(detail->currentText(), "off");
}

} // namespace
} // namespace ghost::ui
