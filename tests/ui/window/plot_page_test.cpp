// SPDX-License-Identifier: Apache-2.0
// The page of a plot in the window: it goes when its numbers of fixtures are no longer true, and a plot that
// cannot be read again is on it.
#include "support/must.h"
#include "support/mvr_files.h"
#include "support/test_window.h"
#include "ui/panels/plot_panel.h"
#include "ui/window/window.h"

#include <QLabel>
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
