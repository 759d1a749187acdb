// SPDX-License-Identifier: Apache-2.0
// The page of a plot in the window: it goes when its numbers of fixtures are no longer true, and a plot that
// cannot be read again is on it.
#include "support/must.h"
#include "support/mvr_files.h"
#include "support/test_window.h"
#include "ui/panels/plot_panel.h"
#include "ui/window/window.h"

#include <QLabel>
#include <QStatusBar>
#include <QToolBar>
#include <QTreeWidget>

namespace ghost::ui {
namespace {

struct PlotWindow {
    explicit PlotWindow(Opened opened) : window(link, {.remembers = false, .width = 900, .height = 600}) {
        window.show();
        settle();
        link.opened.put(std::move(opened));
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    PlotPanel& panel() { return *window.findChild<PlotPanel*>(); }
    bool comes() {
        for (int i = 0; i < 100 && !panel().isEnabled(); ++i) wait_ms(50);
        return panel().isEnabled();
    }

    Link link;
    Window window;
};

TEST(PlotPageInWindow, goes_when_an_edit_changes_the_number_of_fixtures_and_comes_again) {
    PlotWindow in(four_lamps());
    ASSERT_TRUE(in.comes());
    AppModel& app = in.window.app();
    const auto text = std::make_shared<const std::string>();
    scene::Show same = *app.show();
    app.put_edit(text, same, app.look(), {});
    EXPECT_TRUE(in.panel().isEnabled());
    same.fixtures.pop_back();
    app.put_edit(text, same, app.look(), {});
    EXPECT_FALSE(in.panel().isEnabled());
    ASSERT_TRUE(in.comes());
    const QTreeWidget* const tree = in.panel().findChild<QTreeWidget*>();
    EXPECT_FALSE(tree->findItems("3 fixtures of", Qt::MatchStartsWith | Qt::MatchRecursive).isEmpty());
    EXPECT_EQ(in.panel().findChild<QLabel*>()->textFormat(), Qt::PlainText);
}

// Where an edit needs a show a button makes it, as Take on the page does.
TEST(PlotAlone, an_edit_offers_to_make_a_show_of_it) {
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->file = show->plot_file = "nowhere/nothing.mvr";
    opened.show = show;
    PlotWindow in(std::move(opened));
    auto* const notice = in.window.findChild<QToolBar*>("notice");
    EXPECT_FALSE(notice->isVisible()) << "nothing was edited";
    for (const char* const line : {"keep-camera", "duplicate", "hang", "cue-add"}) {
        in.window.app().select({0});
        EXPECT_FALSE(in.window.actions().run(line).ok());
        ASSERT_TRUE(notice->isVisible()) << line;
        EXPECT_TRUE(notice->findChild<QLabel*>()->text().contains("A show that is made of it")) << line;
        QAction* make = nullptr;
        for (QAction* const one : notice->actions())
            if (one->text() == "Make a show of it") make = one;
        ASSERT_TRUE(make);
        make->trigger();
        EXPECT_FALSE(notice->isVisible()) << "it is on its way";
        EXPECT_TRUE(in.window.statusBar()->currentMessage().contains("nothing.mvr: no such file"))
            << in.window.statusBar()->currentMessage().toStdString();
    }
}

TEST(PlotPageInWindow, says_that_the_plot_cannot_be_read_again) {
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->plot = std::make_shared<scene::LoadedPlot>(must(scene::load_description(scene::small_xml(""))));
    show->plot_file = "nowhere/nothing.mvr";
    opened.show = show;
    PlotWindow in(std::move(opened));
    ASSERT_TRUE(in.comes());
    const QTreeWidget* const tree = in.panel().findChild<QTreeWidget*>();
    EXPECT_FALSE(tree->findItems("Missing", Qt::MatchStartsWith).isEmpty());
}

} // namespace
} // namespace ghost::ui
