// SPDX-License-Identifier: Apache-2.0
// Menus, what the right button brings up, the first screen and what is said of things that show nothing else:
// in the window itself.
#include "show_folder/load_show.h"
#include "support/test_window.h"
#include "ui/actions/can_do.h"
#include "ui/actions/script.h"
#include "ui/window/window.h"

#include "disk/files.h"

#include <QDialog>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocalServer>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSettings>
#include <QTextBrowser>
#include <QToolButton>

#include <algorithm>
#include <filesystem>
#include <map>

namespace ghost::ui {
namespace {

struct InWindow {
    explicit InWindow(WindowOptions options = {.remembers = false, .width = 900, .height = 600})
        : window(link, options) {
        window.show();
        settle();
    }
    void open(Opened opened = four_lamps()) {
        link.opened.put(std::move(opened));
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    QMenu* menu(const QString& title) {
        for (QAction* const one : window.menuBar()->actions())
            if (QString(one->text()).remove('&') == title) return one->menu();
        return nullptr;
    }
    // As it is while the menu is open.
    std::map<QString, bool> enabled(const QString& title) {
        std::map<QString, bool> items;
        Q_EMIT menu(title)->aboutToShow();
        for (const Action& action : window.actions().all())
            if (const QAction* item = window.actions().item(action.name);
                menu(title)->actions().contains(item))
                items[action.name] = item->isEnabled();
        Q_EMIT menu(title)->aboutToHide();
        return items;
    }
    std::string error_of(const QString& line) {
        const Result<void> done = window.actions().run(line);
        return done.ok() ? "" : done.error().text();
    }
    QString toast() {
        const Toast* const toast = window.findChild<Toast*>();
        return toast->isVisible() ? toast->words() : QString();
    }

    Link link;
    Window window;
};

TEST(Menus, every_action_has_been_thought_of_where_it_is_said_what_can_be_done) {
    InWindow in;
    std::set<QString> listed = listed_actions();
    for (const Action& action : in.window.actions().all()) {
        static const QRegularExpression kWithItsValue("^(panel|language|tone|fps|resolution)-|^camera-\\d$");
        if (kWithItsValue.match(action.name).hasMatch() && action.name != "panels-dock") continue;
        EXPECT_TRUE(listed.erase(action.name))
            << action.name.toStdString() << " stands in no list of ui/actions/can_do.cpp";
    }
    for (const char* const name :
         {"browsers", "browsers-control", "browsers-new-token", "browsers-away", "in-browsers"})
        listed.erase(name); // where something serves them
    EXPECT_TRUE(listed.empty()) << listed.begin()->toStdString() << " is no action";
}

TEST(Menus, every_action_with_a_menu_stands_in_it_once_and_groups_are_parted) {
    InWindow in;
    for (const Action& action : in.window.actions().all()) {
        if (action.menu.isEmpty()) continue;
        SCOPED_TRACE(action.name.toStdString());
        ASSERT_TRUE(in.menu(action.menu));
        EXPECT_EQ(in.menu(action.menu)->actions().count(in.window.actions().item(action.name)), 1);
    }
    for (const char* const title : {"Show", "Edit", "View", "Camera", "Play"}) {
        const QList<QAction*> items = in.menu(title)->actions();
        EXPECT_GE(
            std::count_if(items.begin(), items.end(), [](const QAction* one) { return one->isSeparator(); }),
            2)
            << title;
        EXPECT_FALSE(items.first()->isSeparator() || items.last()->isSeparator()) << title;
    }
    EXPECT_EQ(in.menu("Show")->actions().last(), in.window.actions().item("quit"));
}

TEST(Menus, what_cannot_be_done_is_grey_while_the_menu_is_open_and_keys_still_say_why) {
    InWindow in;
    auto items = in.enabled("Edit");
    for (const char* const name : {"undo", "select-all", "release", "hang", "add-fixture"})
        EXPECT_FALSE(items.at(name)) << name;
    EXPECT_TRUE(in.enabled("Show").at("open"));
    EXPECT_TRUE(in.enabled("Show").at("new"));
    EXPECT_FALSE(in.enabled("Show").at("save"));
    in.open();
    items = in.enabled("Edit");
    EXPECT_TRUE(items.at("select-all"));
    EXPECT_FALSE(items.at("release"));
    EXPECT_FALSE(items.at("undo"));
    EXPECT_EQ(in.error_of("select *"), "");
    EXPECT_EQ(in.error_of("intensity 1"), "");
    items = in.enabled("Edit");
    EXPECT_TRUE(items.at("release"));
    EXPECT_TRUE(items.at("undo"));
    EXPECT_EQ(in.error_of("select-none"), "");
    EXPECT_FALSE(in.enabled("Edit").at("release"));
    EXPECT_TRUE(in.window.actions().item("release")->isEnabled()) << "its key says why it does nothing";
}

void click(QWidget* view, Qt::MouseButton button, const QPoint& press, const QPoint& release) {
    for (const auto& [type, at] : {std::pair{QEvent::MouseButtonPress, press},
                                   {QEvent::MouseMove, release},
                                   {QEvent::MouseButtonRelease, release}}) {
        QMouseEvent event(type, QPointF(at), QPointF(view->mapToGlobal(at)),
                          type == QEvent::MouseMove ? Qt::NoButton : button,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : button, Qt::NoModifier);
        QCoreApplication::sendEvent(view, &event);
    }
    settle();
}

TEST(ContextMenu, the_right_button_brings_one_up_where_it_was_not_dragged) {
    InWindow in;
    in.open();
    auto* const view = in.window.findChild<View*>();
    const auto menu = [&] { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); };
    click(view, Qt::RightButton, {50, 60}, {160, 90});
    EXPECT_FALSE(menu()) << "it looked around";
    click(view, Qt::RightButton, {50, 60}, {51, 60});
    ASSERT_TRUE(menu());
    EXPECT_TRUE(menu()->actions().contains(in.window.actions().item("select-all")));
    menu()->close();
    settle();
    EXPECT_EQ(in.error_of("select \"Lamp 2\""), "");
    click(view, Qt::RightButton, {50, 60}, {50, 60});
    ASSERT_TRUE(menu());
    for (const char* const name :
         {"select-similar", "hang", "focus", "release", "panel-values", "substitute"})
        EXPECT_TRUE(menu()->actions().contains(in.window.actions().item(name))) << name;
    menu()->close();
    settle();
}

QAction* entry(const QMenu* menu, const QString& text) {
    for (QAction* const one : menu->actions())
        if (one->text() == text) return one;
    return nullptr;
}

struct WithPicture : InWindow {
    WithPicture() {
        open();
        Picture picture;
        picture.image = std::make_shared<image::Image8>(320, 180, 4);
        picture.camera = window.app().camera();
        picture.camera.width = view->width();
        picture.camera.height = view->height();
        link.picture.put(std::move(picture));
        link.on_news();
        settle();
    }
    QMenu* menu_at(const QPoint& at) {
        click(view, Qt::RightButton, at, at);
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }
    void choose_at(const QPoint& at, const QString& text) {
        QMenu* const menu = menu_at(at);
        ASSERT_TRUE(menu && entry(menu, text)) << text.toStdString();
        entry(menu, text)->trigger();
        menu->close();
        settle();
    }
    void meet(bool hit, std::optional<std::size_t> fixture, const std::string& object) {
        link.picked.put({window.app().request().pick.number, hit, {0, 3, 2}, fixture, object});
        link.on_news();
        settle();
    }
    View* view = window.findChild<View*>();
};

TEST(ContextMenu, over_the_picture_heads_are_aimed_at_its_place_and_what_is_there_is_hidden) {
    WithPicture in;
    const QPoint low(in.view->width() / 2, in.view->height() * 3 / 4);
    ASSERT_TRUE(in.menu_at(low));
    ASSERT_TRUE(entry(in.menu_at(low), "Aim here"));
    EXPECT_FALSE(entry(in.menu_at(low), "Aim here")->isEnabled()) << "nothing is selected";
    in.menu_at(low)->close();
    in.choose_at(low, "Hide what is here");
    const Pick pick = in.window.app().request().pick;
    EXPECT_NEAR(pick.way.x, 0, 0.01f);
    EXPECT_LT(pick.way.z, -0.05f) << "below the middle";
    in.meet(true, std::nullopt, "Wall");
    EXPECT_EQ(in.window.app().look().shown, (std::map<std::size_t, bool>{{1, false}}));
    EXPECT_EQ(in.toast(), "'Wall' hidden");
    in.window.findChild<Toast*>()->findChild<QToolButton*>("undo")->click();
    EXPECT_TRUE(in.window.app().look().is_empty());
    in.choose_at(low, "Hide what is here");
    in.meet(true, 2, "Lamp 3");
    EXPECT_TRUE(in.window.app().look().is_empty()) << "a fixture stays";
    in.choose_at(low, "Hide what is here");
    in.meet(false, std::nullopt, "");
    EXPECT_TRUE(in.window.app().look().is_empty()) << "air";
}

TEST(ContextMenu, over_the_picture_it_is_explained_why_a_head_shines_or_not) {
    WithPicture in;
    EXPECT_EQ(in.error_of("panel-values off"), "");
    EXPECT_EQ(in.error_of("select \"Lamp 2\""), "");
    in.choose_at({50, 60}, "Explain why it shines or not");
    auto* const values = in.window.findChild<QDockWidget*>("values");
    EXPECT_TRUE(values->isVisible() && !values->visibleRegion().isEmpty());
}

TEST(KeySheet, says_what_the_mouse_does_with_heads) {
    InWindow in;
    EXPECT_EQ(in.error_of("shortcuts"), "");
    settle();
    const auto* const dialog = in.window.findChild<QDialog*>();
    ASSERT_TRUE(dialog && dialog->findChild<QTextBrowser*>());
    const QString sheet = dialog->findChild<QTextBrowser*>()->toPlainText();
    for (const char* const words : {"Shift+click", "drag of a selected lamp", "right click"})
        EXPECT_TRUE(sheet.contains(words)) << words;
}

TEST(KeySheet, finds_room_on_a_display_of_1080_lines) {
    InWindow in;
    in.open();
    EXPECT_EQ(in.error_of("shortcuts"), "");
    settle();
    auto* const sheet = in.window.findChild<QDialog*>();
    sheet->resize(1240, 880);
    settle();
    EXPECT_EQ(sheet->findChild<QTextBrowser*>()->verticalScrollBar()->maximum(), 0);
}

TEST(KeySheet, names_undo_and_redo_and_not_what_they_would_do_now) {
    InWindow in;
    in.open();
    EXPECT_EQ(in.error_of("select \"Lamp 1\""), "");
    EXPECT_EQ(in.error_of("intensity 0.5"), "");
    ASSERT_TRUE(in.window.actions().item("undo")->text().startsWith("Undo: "));
    EXPECT_EQ(in.error_of("shortcuts"), "");
    settle();
    EXPECT_FALSE(
        in.window.findChild<QDialog*>()->findChild<QTextBrowser*>()->toPlainText().contains("Undo: "));
}

// Of a list with one row, at that row.
QMenu* context_menu(QListWidget* list, Window& window, const char* panel) {
    auto* const dock = window.findChild<QDockWidget*>(panel);
    dock->show();
    dock->raise();
    settle();
    list->setCurrentRow(0);
    Q_EMIT list->customContextMenuRequested(list->visualItemRect(list->item(0)).center());
    settle();
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
}

void choose(QMenu* menu, const QString& text) {
    for (QAction* const one : menu->actions())
        if (one->text() == text) one->trigger();
    menu->close();
    settle();
}

QListWidget* list_called(Window& window, const QString& name) {
    for (QListWidget* const one : window.findChildren<QListWidget*>())
        if (one->accessibleName() == name) return one;
    return nullptr;
}

struct WithShow : InWindow {
    WithShow() {
        const std::string text =
            "[show]\nstage = \"none.glb\"\n[[camera]]\nname = \"front\"\n[[fixture]]\nname = "
            "\"Lamp 1\"\ngdtf = \"lamp.gdtf\"\naddress = 1\nposition_m = [0, 0, 4]\n";
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "show.toml";
        EXPECT_TRUE(write_file_atomic(file, text).ok());
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->file = file;
        show->folder = file.parent_path();
        opened.show = std::move(show);
        open(std::move(opened));
        EXPECT_EQ(error_of("select \"Lamp 1\""), "");
        EXPECT_EQ(error_of("colour #ff8000"), "");
    }
    QTemporaryDir folder;
};

TEST(ContextMenu, a_look_is_recalled_renamed_updated_removed_and_becomes_a_cue) {
    WithShow in;
    EXPECT_EQ(in.error_of("look-store Verse"), "");
    QListWidget* const list = list_called(in.window, "Looks");
    ASSERT_TRUE(list && list->count() == 1);
    QMenu* menu = context_menu(list, in.window, "looks");
    ASSERT_TRUE(menu);
    QStringList items;
    for (const QAction* const one : menu->actions())
        if (!one->isSeparator()) items << one->text();
    EXPECT_EQ(items,
              (QStringList{"Recall", "Add as a cue", "Rename", "Update with what hands set", "Remove"}));
    choose(menu, "Add as a cue");
    ASSERT_EQ(in.window.app().show()->cues.size(), 1u);
    EXPECT_EQ(in.window.app().show()->cues[0].look, "Verse");
    choose(context_menu(list, in.window, "looks"), "Rename");
    EXPECT_TRUE(list->isPersistentEditorOpen(list->item(0)) || list->findChild<QLineEdit*>())
        << "where it stands";
    choose(context_menu(list, in.window, "looks"), "Remove");
    EXPECT_EQ(list->count(), 1) << "a cue recalls it";
    EXPECT_EQ(in.error_of("cue-remove 1"), "");
    choose(context_menu(list, in.window, "looks"), "Remove");
    EXPECT_EQ(list->count(), 0);
    Q_EMIT list->customContextMenuRequested({5, 5});
    settle();
    EXPECT_FALSE(QApplication::activePopupWidget()) << "of nothing";
}

TEST(ContextMenu, a_palette_is_given_by_a_click_and_has_a_menu) {
    WithShow in;
    EXPECT_EQ(in.error_of("palette-store colour Amber"), "");
    QListWidget* const list = list_called(in.window, "Palettes");
    ASSERT_TRUE(list);
    EXPECT_EQ(list->count(), 0) << "positions are shown first";
    for (QToolButton* const one : list->parentWidget()->findChildren<QToolButton*>())
        if (one->text() == "Colour") one->click();
    ASSERT_EQ(list->count(), 1);
    EXPECT_FALSE(list->item(0)->icon().isNull()) << "its colour";
    EXPECT_EQ(in.error_of("release-all"), "");
    Q_EMIT list->itemClicked(list->item(0));
    settle();
    EXPECT_TRUE(in.window.app().look().fixtures.at(0).colour);
    list->item(0)->setText("Warm");
    settle();
    EXPECT_EQ(in.window.app().show()->palettes[0].name, "Warm");
    choose(context_menu(list, in.window, "programmer"), "Remove");
    EXPECT_EQ(list->count(), 0);
    EXPECT_EQ(in.error_of("undo"), "");
    EXPECT_EQ(list->count(), 1);
}

TEST(ContextMenu, all_of_a_type_are_selected) {
    InWindow in;
    in.open();
    EXPECT_EQ(in.error_of("select-similar"), "select-similar: no fixture is selected");
    EXPECT_EQ(in.error_of("select \"Lamp 2\""), "");
    EXPECT_EQ(in.error_of("select-similar"), "");
    EXPECT_EQ(in.window.app().selection().size(), 4u);
}

TEST(CameraStrip, has_the_pictures_that_came_and_a_click_goes_there) {
    InWindow in;
    in.open();
    QListWidget* const strip = list_called(in.window, "Cameras");
    ASSERT_TRUE(strip);
    EXPECT_FALSE(strip->isVisible()) << "the picture first";
    EXPECT_FALSE(in.window.app().request().wants_camera_pictures);
    EXPECT_EQ(in.error_of("camera-strip on"), "");
    settle();
    EXPECT_TRUE(strip->isVisible());
    EXPECT_TRUE(in.window.app().request().wants_camera_pictures);
    ASSERT_EQ(strip->count(), 2);
    EXPECT_EQ(strip->currentRow(), 0) << "where the picture is seen from";
    auto image = std::make_shared<image::Image8>(160, 90, 4);
    for (std::size_t i = 0; i < image->samples.size(); i += 4) image->samples[i] = 200; // red
    in.link.camera_pictures.put({{"side", image}, {"gone", image}});
    in.link.on_news();
    settle();
    const auto colour = [&](int row) {
        return strip->item(row)->icon().pixmap(strip->iconSize()).toImage().pixelColor(50, 30);
    };
    EXPECT_GT(colour(1).red(), 150);
    EXPECT_LT(colour(0).red(), 50) << "its own comes";
    Q_EMIT strip->itemClicked(strip->item(1));
    for (int i = 0; i < 200 && in.window.app().travels(); ++i) wait_ms(25);
    EXPECT_EQ(in.window.app().camera().position_m, in.window.app().show()->cameras[1].position_m);
    EXPECT_EQ(strip->currentRow(), 1);
    EXPECT_EQ(in.error_of("camera-strip off"), "");
    settle();
    EXPECT_FALSE(in.window.app().request().wants_camera_pictures) << "what is not seen is not made";
}

TEST(FirstScreen, three_ways_to_a_show_and_no_panels_until_one_is_there) {
    InWindow in({.demo = "assets/demo", .remembers = false, .width = 1366, .height = 768}); // has columns
    auto* const welcome = in.window.findChild<QWidget*>("welcome");
    ASSERT_TRUE(welcome);
    EXPECT_TRUE(welcome->isVisible());
    EXPECT_EQ(welcome->findChildren<QPushButton*>().size(), 3);
    for (const QDockWidget* const dock : in.window.findChildren<QDockWidget*>())
        EXPECT_FALSE(dock->isVisible()) << dock->objectName().toStdString();
    in.open();
    EXPECT_FALSE(welcome->isVisible());
    EXPECT_TRUE(in.window.findChild<QDockWidget*>("fixtures")->isVisible());
}

TEST(FirstScreen, shows_of_the_last_time_are_there_the_next_time_with_their_pictures) {
    QTemporaryDir home;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
    ASSERT_TRUE(qputenv("XDG_CACHE_HOME", home.path().toUtf8()));
    const QString file = home.filePath("tour/show.toml");
    ASSERT_TRUE(QDir().mkpath(home.filePath("tour")));
    ASSERT_TRUE(write_file_atomic(file.toStdString(), "[show]\n").ok());
    {
        InWindow in({.width = 900, .height = 600});
        Opened tour = four_lamps();
        auto show = std::make_shared<scene::Show>(*tour.show);
        show->file = file.toStdString();
        show->name = "Tour";
        tour.show = show;
        in.open(std::move(tour));
        Picture picture;
        const auto lit = std::make_shared<image::Image8>(64, 36, 4);
        std::fill(lit->samples.begin(), lit->samples.end(), std::uint8_t{200});
        for (const auto& image : {lit, std::make_shared<image::Image8>(64, 36, 4)}) {
            picture.image = image; // left in a black-out
            in.link.picture.put(picture);
            in.link.on_news();
            settle();
        }
    }
    InWindow in({.width = 900, .height = 600});
    auto* const list = in.window.findChild<QWidget*>("welcome")->findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 1);
    EXPECT_EQ(list->item(0)->text(), "Tour");
    const QImage kept(RecentShows(in.window.app(), true).all().front().picture);
    ASSERT_FALSE(kept.isNull());
    EXPECT_EQ(qRed(kept.pixel(kept.width() / 2, kept.height() / 2)), 200) << "as it was lit last";
    Q_EMIT list->itemActivated(list->item(0));
    EXPECT_EQ(in.window.app().request().show, file.toStdString());
    EXPECT_EQ(InWindow().window.findChild<QWidget*>("welcome")->findChild<QListWidget*>()->count(), 0)
        << "--forget";
    qunsetenv("XDG_CACHE_HOME");
}

TEST(NewShow, a_folder_with_a_stage_that_opens_and_nothing_that_is_there_is_overwritten) {
    QTemporaryDir home;
    InWindow in;
    const QString folder = home.filePath("My tour");
    EXPECT_EQ(in.error_of("new \"" + folder + "\""), "");
    EXPECT_EQ(in.window.app().request().show, folder.toStdString());
    Report report;
    const auto show = scene::load_show(folder.toStdString(), true, report);
    ASSERT_TRUE(show.ok()) << show.error().text();
    EXPECT_TRUE(report.messages.empty()) << report.messages.front().what;
    EXPECT_EQ(show->name, "My tour");
    EXPECT_EQ(show->stage.instances.size(), 2u);
    EXPECT_NE(in.error_of("new \"" + folder + "\"").find("is there already"), std::string::npos);
    EXPECT_NE(in.error_of("import-plot \"" + folder + "/show.toml\"").find("is no .mvr"), std::string::npos);
    EXPECT_NE(in.error_of("import-plot nothing.mvr").find("no such file"), std::string::npos);
}

TEST(Toast, what_shows_nothing_else_is_said_with_a_way_back) {
    InWindow in;
    in.open();
    EXPECT_EQ(in.toast(), "");
    EXPECT_EQ(in.error_of("select \"Lamp 1\""), "");
    EXPECT_EQ(in.error_of("intensity 0.5"), "");
    EXPECT_TRUE(in.toast().contains("By hand now: 1 fixture")) << in.toast().toStdString();
    auto* const undo = in.window.findChild<Toast*>()->findChild<QToolButton*>("undo");
    ASSERT_TRUE(undo->isVisible());
    undo->click();
    EXPECT_TRUE(in.window.app().look().is_empty());
    EXPECT_EQ(in.toast(), "");
    EXPECT_EQ(in.error_of("intensity 0.5"), "");
    EXPECT_NE(in.toast(), "");
    wait_ms(2300);
    EXPECT_EQ(in.toast(), "") << "two seconds";
}

TEST(Toast, it_says_what_was_done_and_to_what) {
    WithShow in;
    EXPECT_EQ(in.error_of("keep-camera Balcony"), "");
    EXPECT_EQ(in.toast(), "Camera 'Balcony' kept");
    EXPECT_EQ(in.error_of("add-fixture \"" GHOST_SOURCE_DIR "/assets/fixtures/Ghostlight@LED_Par.gdtf\""),
              "");
    const QString name = QString::fromStdString(in.window.app().show()->fixtures.back().name);
    EXPECT_EQ(in.toast(), QString("'%1' added").arg(name));
    EXPECT_EQ(in.error_of("cue-add Opener"), "");
    EXPECT_EQ(in.toast(), "Cue 'Opener' added");
    EXPECT_EQ(in.error_of("select \"Lamp 1\""), "");
    EXPECT_EQ(in.error_of("unpatch"), "");
    EXPECT_EQ(in.toast(), "1 fixture unpatched");
    EXPECT_EQ(in.error_of("duplicate"), "");
    EXPECT_EQ(in.toast(), "1 fixture duplicated");
    EXPECT_EQ(in.error_of("remove"), "");
    EXPECT_EQ(in.toast(), "1 fixture removed");
}

// It opens a panel, and the step before it is not its own.
TEST(Toast, what_made_no_step_does_not_say_that_of_another) {
    WithShow in;
    wait_ms(2300);
    EXPECT_EQ(in.toast(), "");
    EXPECT_EQ(in.error_of("substitute"), "");
    EXPECT_EQ(in.toast(), "");
}

// A choice for the show before says nothing of this one.
TEST(InputChoice, another_show_begins_with_the_automatic_one) {
    InWindow in;
    in.open();
    EXPECT_EQ(in.error_of("input-recording"), "");
    EXPECT_EQ(in.window.app().request().input, Input::recording);
    in.open();
    EXPECT_EQ(in.window.app().request().input, Input::automatic);
}

TEST(Begin, a_show_plays_from_where_its_file_says_wherever_it_lies) {
    Link link;
    Window window(link, WindowOptions{.remembers = false, .width = 900, .height = 600});
    const auto open = [&](double begin_s, bool again) {
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->begin_s = begin_s;
        opened.show = show;
        opened.again = again;
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
        return window.app().request().transport;
    };
    const Transport begun = open(12.5, false);
    EXPECT_EQ(begun.at_s, 12.5);
    EXPECT_EQ(begun.seeks, 1u);
    EXPECT_EQ(open(20, true), begun) << "it plays already";
    EXPECT_EQ(open(0, false), Transport()) << "another one, from its beginning";
}

TEST(Socket, one_that_cannot_be_made_says_why_and_what_a_killed_window_left_is_none) {
    InWindow in;
    QTemporaryDir folder;
    RemoteControl remote(in.window.actions(), in.window.app(), nullptr);
    const auto why_not = [&](const QString& name) {
        const Result<void> made = remote.listen(name);
        return made.ok() ? std::string() : made.error().text();
    };
    EXPECT_NE(why_not("/nowhere/at/all").find("there is no folder /nowhere/at"), std::string::npos)
        << why_not("/nowhere/at/all");
    EXPECT_NE(why_not(folder.filePath(QString(200, 'a'))).find("bytes, expected at most 107"),
              std::string::npos);
    const QString file = folder.filePath("notes.txt");
    ASSERT_TRUE(write_file_atomic(file.toStdString(), "mine").ok());
    EXPECT_NE(why_not(file).find("a file has that name"), std::string::npos) << why_not(file);
    EXPECT_EQ(*read_text_file(file.toStdString(), 100), "mine");
    const QString taken = folder.filePath("taken"), left = folder.filePath("left");
    {
        QLocalServer other;
        ASSERT_TRUE(other.listen(taken));
        EXPECT_NE(why_not(taken).find("another window listens there"), std::string::npos) << why_not(taken);
        std::filesystem::create_hard_link(taken.toStdString(), left.toStdString());
    }
    // A window that was killed leaves one behind that nobody serves.
    EXPECT_EQ(why_not(left), "");
}

TEST(Socket, a_folder_of_that_name_is_said) {
    InWindow in;
    QTemporaryDir folder;
    RemoteControl remote(in.window.actions(), in.window.app(), nullptr);
    const Result<void> made = remote.listen(folder.path());
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().text().find("is a folder; expected the name of a socket"), std::string::npos)
        << made.error().text();
}

} // namespace
} // namespace ghost::ui
