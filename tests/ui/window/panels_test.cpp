// SPDX-License-Identifier: Apache-2.0
// The panels in the window: what needs a show before there is one, tabs that are whole, what stays where it
// is, panels that are torn off and put back.
#include "support/test_window.h"
#include "ui/language/language.h"
#include "ui/window/window.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QTableWidget>

namespace ghost::ui {
namespace {

struct Panels {
    explicit Panels(int width = 1366, int height = 768)
        : window(link, {.remembers = false, .width = width, .height = height}) {
        window.show();
        settle();
    }
    void open() {
        link.opened.put(four_lamps());
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    QDockWidget& panel(const char* name) { return *window.findChild<QDockWidget*>(name); }
    void choose(const QString& line) {
        const Result<void> done = window.actions().run(line);
        EXPECT_TRUE(done.ok()) << done.error().text();
        settle();
    }
    QPushButton* button(const char* panel_name, const QString& text) {
        for (QPushButton* const one : panel(panel_name).findChildren<QPushButton*>())
            if (one->text() == text) return one;
        ADD_FAILURE() << text.toStdString();
        return nullptr;
    }

    Link link;
    Window window;
};

TEST(Panels, have_their_sizes_again_after_full_screen) {
    Panels in;
    in.open();
    in.choose("panel-programmer on");
    QDockWidget &list = in.panel("fixtures"), &below = in.panel("programmer");
    in.window.resizeDocks({&list, &below}, {230, 360}, Qt::Vertical); // as by hand
    settle();
    const QSize of_list = list.size(), of_below = below.size();
    for (int k = 0; k < 3; ++k) {
        in.choose("full-screen on");
        in.choose("full-screen off");
        settle();
        EXPECT_EQ(list.size(), of_list) << k;
        EXPECT_EQ(below.size(), of_below) << k;
    }
}

TEST(FirstScreen, what_needs_a_show_cannot_be_pressed_before_there_is_one) {
    Panels in;
    for (const char* const name :
         {"fixtures", "values", "programmer", "scene", "looks", "export", "air", "cues", "plot"}) {
        in.choose(QString("panel-%1 on").arg(name));
        for (const QAbstractButton* const one : in.panel(name).widget()->findChildren<QAbstractButton*>())
            EXPECT_FALSE(one->isVisible() && one->isEnabled()) << name << ": " << one->text().toStdString();
    }
    in.open();
    in.choose("panel-export on");
    EXPECT_TRUE(in.button("export", "Bake")->isEnabled());
    in.choose("panel-looks on");
    EXPECT_TRUE(in.button("looks", "Store what is seen")->isEnabled());
}

TEST(Tabs, every_name_is_whole_at_the_usual_widths) {
    for (const int width : {1366, 1920, 2560}) {
        Panels in(width, 768);
        in.open();
        int seen = 0;
        for (const QTabBar* const bar : in.window.findChildren<QTabBar*>()) {
            if (!bar->isVisible()) continue;
            for (int tab = 0; tab < bar->count(); ++tab) {
                if (!bar->isTabVisible(tab)) continue;
                ++seen;
                const QRect place = bar->tabRect(tab);
                const std::string what = std::to_string(width) + " " + bar->tabText(tab).toStdString();
                EXPECT_GE(place.left(), 0) << what;
                EXPECT_LT(place.right(), bar->width()) << what;
                EXPECT_GE(place.width(), bar->fontMetrics().horizontalAdvance(bar->tabText(tab))) << what;
            }
        }
        EXPECT_GE(seen, 4) << width;
    }
}

TEST(Columns, nothing_of_a_panel_is_cut_at_its_right_at_the_usual_sizes) {
    for (const QSize size : {QSize(1366, 768), QSize(1920, 1080), QSize(2560, 1440)}) {
        Panels in(size.width(), size.height());
        in.open();
        in.choose("select *");
        for (const char* const name :
             {"values", "programmer", "scene", "looks", "air", "cues", "plot", "export"}) {
            in.choose(QString("panel-%1 on").arg(name));
            for (const QScrollArea* const area : in.panel(name).findChildren<QScrollArea*>()) {
                if (!area->isVisible()) continue;
                EXPECT_LE(area->widget()->width(), area->viewport()->width())
                    << name << " at " << size.width();
            }
        }
    }
}

TEST(LookPanel, buttons_stay_where_they_are_whatever_is_selected) {
    for (const char* const words : {"en", "de"}) {
        set_language(words);
        Panels in;
        in.open();
        in.choose("panel-looks on");
        std::vector<QPushButton*> buttons;
        for (QPushButton* const one : in.panel("looks").findChildren<QPushButton*>())
            if (one->isVisible()) buttons.push_back(one);
        ASSERT_GE(buttons.size(), 5u);
        const auto places = [&] {
            std::vector<QRect> all;
            for (const QPushButton* const one : buttons)
                all.emplace_back(one->mapTo(&in.window, QPoint()), one->size());
            return all;
        };
        const std::vector<QRect> before = places();
        in.choose("select \"Lamp 1\"");
        EXPECT_EQ(places(), before) << words << ", one selected";
        in.choose("select-all");
        in.choose("intensity 0.5");
        EXPECT_EQ(places(), before) << words << ", set by hand";
        in.choose("solo");
        EXPECT_EQ(places(), before) << words << ", solo";
        in.choose("gel #ff8000");
        in.choose("lamp 0.5 3200");
        EXPECT_EQ(places(), before) << words << ", a gel and a lamp";
        in.choose("select-none");
        EXPECT_EQ(places(), before) << words << ", none selected";
    }
    set_language("en");
}

TEST(CuePanel, without_a_cue_there_is_none_to_go_to) {
    Panels in;
    in.open();
    in.choose("panel-cues on");
    for (const char* const text : {"Go", "Back", "Go to this", "Remove", "Up", "Down"})
        EXPECT_FALSE(in.button("cues", text)->isEnabled()) << text;
    EXPECT_TRUE(in.button("cues", "Add")->isEnabled());
}

TEST(TearOff, a_panel_that_is_torn_off_does_not_cover_its_place) {
    for (const char* const name : {"fixtures", "programmer"}) {
        Panels in(1280, 900);
        in.window.resize(1366, 800);
        in.open();
        in.choose(QString("panel-%1 on").arg(name));
        QDockWidget& panel = in.panel(name);
        const QRect docked(panel.mapToGlobal(QPoint()), panel.size());
        panel.setFloating(true);
        wait_ms(150);
        const QRect place = panel.geometry();
        EXPECT_GE((place.topLeft() - docked.topLeft()).manhattanLength(), 40) << name;
        EXPECT_TRUE(panel.screen()->availableGeometry().contains(place)) << name;
        panel.move(300, 200); // where a hand puts it, it stays
        wait_ms(150);
        EXPECT_EQ(panel.pos(), QPoint(300, 200));
    }
}

TEST(TearOff, a_panel_is_as_large_as_what_is_in_it_needs) {
    Panels in(1280, 900);
    in.window.resize(1366, 800);
    in.open();
    in.choose("panel-cues on");
    QDockWidget& panel = in.panel("cues");
    const QSize docked = panel.size();
    panel.setFloating(true);
    wait_ms(150);
    const auto* const table = panel.findChild<QTableWidget*>();
    EXPECT_GE(table->viewport()->width(), table->horizontalHeader()->length()) << "all columns are seen";
    EXPECT_GE(table->viewport()->height(), 6 * table->verticalHeader()->defaultSectionSize());
    EXPECT_GT(panel.width(), docked.width());
    EXPECT_TRUE(panel.screen()->availableGeometry().contains(panel.geometry()));
}

TEST(TearOff, panels_that_are_put_back_are_the_front_ones_of_their_tabs) {
    Panels in;
    in.open();
    in.choose("panel-values on");
    QDockWidget& panel = in.panel("values");
    panel.setFloating(true);
    wait_ms(150);
    in.choose("panel-programmer on");
    in.choose("panels-dock");
    wait_ms(50);
    EXPECT_FALSE(panel.isFloating());
    EXPECT_FALSE(panel.visibleRegion().isEmpty()) << "it lies behind another one's tab";
    EXPECT_TRUE(in.panel("programmer").visibleRegion().isEmpty());
}

} // namespace
} // namespace ghost::ui
