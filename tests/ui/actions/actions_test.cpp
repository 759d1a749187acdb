// SPDX-License-Identifier: Apache-2.0
// The table of actions, through the window that fills it: lines of scripts do what they say, and every fault
// is a sentence.
#include "disk/files.h"
#include "show/show.h"
#include "support/test_window.h"
#include "ui/actions/script.h"
#include "ui/model/shortened.h"
#include "ui/panels/message_panel.h"
#include "ui/window/window.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QLocalSocket>
#include <QMenuBar>
#include <QMimeData>
#include <QRegularExpression>
#include <QSettings>
#include <QShortcutEvent>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QUrl>

#include <set>

namespace ghost::ui {
namespace {

struct Opened4 {
    Opened4() {
        window =
            std::make_unique<Window>(link, WindowOptions{.remembers = false, .width = 640, .height = 400});
        window->show();
        link.opened.put(four_lamps());
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    std::string error_of(const std::string& line) {
        const Result<void> done = window->actions().run(QString::fromStdString(line));
        return done.ok() ? "" : done.error().text();
    }
    const ViewRequest& request() { return window->app().request(); }

    Link link;
    std::unique_ptr<Window> window;
};

TEST(Actions, lines_are_split_at_blanks_and_quotes) {
    const auto words = split_line("  select \"Spot 1\"  Wash\t \"\" ");
    ASSERT_TRUE(words.ok());
    EXPECT_EQ(*words, (QStringList{"select", "Spot 1", "Wash", ""}));
    EXPECT_TRUE(split_line("")->isEmpty());
    EXPECT_FALSE(split_line("select \"Spot 1").ok());
}

TEST(Actions, whatever_is_typed_is_one_argument_with_its_quotes) {
    for (const char* const words : {"pipe 12\" left", "on \"Go!\"", "", "\"", "back\\slash", "at the end\\",
                                    "\\\"", "\\\\\" \\\\", "  "}) {
        const auto split = split_line("cue-set 1 notes " + quoted(words) + " x");
        ASSERT_TRUE(split.ok()) << words;
        EXPECT_EQ(*split, (QStringList{"cue-set", "1", "notes", words, "x"}));
    }
    const auto plain = split_line("open C:\\shows\\tour \\\"a\\\"");
    ASSERT_TRUE(plain.ok());
    EXPECT_EQ(*plain, (QStringList{"open", "C:\\shows\\tour", "\"a\""}));
}

TEST(Actions, a_word_behind_the_last_argument_is_none_that_is_left_out_in_silence) {
    Opened4 opened;
    EXPECT_EQ(opened.error_of("select *"), "");
    EXPECT_EQ(opened.error_of("intensity 0.5 0.7"), "intensity: '0.7' is a word too many: it takes NUMBER");
    EXPECT_TRUE(opened.request().look.is_empty());
    EXPECT_NE(opened.error_of("loop 1 2 3"), "");
    EXPECT_NE(opened.error_of("cancel-bounce maybe"), "");
    EXPECT_EQ(opened.error_of("select \"Lamp 1\" \"Lamp 2\" \"Lamp 3\""), "") << "as many as one likes";
}

TEST(Actions, record_is_a_switch_that_may_name_its_file) {
    Opened4 opened;
    EXPECT_EQ(opened.error_of("record on"), "");
    const std::string file = opened.request().record_to;
    EXPECT_TRUE(QString::fromStdString(file).endsWith(".ghostdmx")) << file;
    EXPECT_EQ(opened.error_of("record on"), "");
    EXPECT_EQ(opened.request().record_to, file);
    EXPECT_EQ(opened.error_of("record off"), "");
    EXPECT_EQ(opened.request().record_to, "");
    EXPECT_EQ(opened.error_of("record mine.ghostdmx"), "");
    EXPECT_EQ(opened.request().record_to, "mine.ghostdmx");
}

TEST(Actions, the_state_has_what_a_remote_control_holds) {
    Opened4 opened;
    QTemporaryDir folder;
    const auto held = [&] {
        const QString file = folder.filePath("state.json");
        EXPECT_EQ(opened.error_of("state " + quoted(file).toStdString()), "");
        const auto text = read_text_file(file.toStdString(), 1 << 20);
        EXPECT_TRUE(text.ok());
        return QJsonDocument::fromJson(QByteArray::fromStdString(*text)).object()["remote"].toObject();
    };
    EXPECT_TRUE(held().isEmpty());
    RigNow rig = four_lit();
    rig.remote = {.master = 0.5f, .black_out = true, .ev100 = 12.0f};
    opened.link.rig.put(std::move(rig));
    opened.link.on_news();
    settle();
    EXPECT_TRUE(held() == (QJsonObject{{"master", 0.5}, {"black_out", true}, {"ev100", 12.0}}));
}

// A dialog would wait for ever for a person who is not there.
TEST(Actions, what_asks_a_person_for_a_file_tells_a_script_to_name_it) {
    Opened4 opened;
    std::set<QString> asking;
    // They open a window of choices, in which nothing is waited for.
    const std::set<QString> choosing{"paperwork", "cue-book"};
    for (const Action& action : opened.window->actions().all()) {
        if (choosing.contains(action.name)) continue;
        EXPECT_EQ(action.text.endsWith("..."), !action.asks.title.isEmpty()) << action.name.toStdString();
        if (action.asks.title.isEmpty()) continue;
        asking.insert(action.name);
        EXPECT_EQ(opened.error_of(action.name.toStdString()),
                  action.name.toStdString() + ": it needs the name of a file");
    }
    EXPECT_EQ(asking, (std::set<QString>{"open", "play-file", "save-picture", "screenshot", "add-fixture",
                                         "add-model", "set-stage", "save-copy", "new", "import-plot",
                                         "save-as", "plot-text"}));
}

TEST(Actions, no_name_and_no_key_stands_twice_and_what_is_in_a_menu_has_words) {
    Opened4 opened;
    std::set<QString> names, keys;
    for (const Action& action : opened.window->actions().all()) {
        EXPECT_TRUE(names.insert(action.name).second) << action.name.toStdString();
        EXPECT_FALSE(action.name.contains(' ')) << action.name.toStdString();
        for (const QString& key : action.key.split("; ", Qt::SkipEmptyParts)) {
            EXPECT_TRUE(keys.insert(key).second) << key.toStdString() << " of " << action.name.toStdString();
            EXPECT_FALSE(QKeySequence(key).isEmpty()) << key.toStdString();
        }
        EXPECT_TRUE(action.menu.isEmpty() || !action.text.isEmpty()) << action.name.toStdString();
        EXPECT_TRUE(!action.menu.isEmpty() || action.key.isEmpty())
            << action.name.toStdString() << " has a key that nobody finds";
    }
    // They fly, in the picture.
    for (const char* const key : {"W", "A", "S", "D", "Q", "E"}) EXPECT_FALSE(keys.contains(key)) << key;
}

// Its list of lines, and no other place of it.
TEST(Actions, the_guide_lists_every_action_and_nothing_else) {
    const auto guide = read_text_file(GHOST_SOURCE_DIR "/docs/guide/window.md", 1 << 20);
    ASSERT_TRUE(guide.ok()) << guide.error().text();
    std::string list = guide->substr(guide->find("| about | lines |"));
    list.resize(list.find("\n\n"));
    std::set<QString> listed, known;
    for (std::size_t begin = 0; (begin = list.find('`', begin)) != std::string::npos;) {
        const std::size_t end = list.find('`', begin + 1);
        const QString words = QString::fromStdString(list.substr(begin + 1, end - begin - 1));
        begin = end + 1;
        // Examples of values begin with a capital letter, switches stand alone.
        if (words[0].isLower() && words != "on" && words != "off") listed.insert(words.section(' ', 0, 0));
    }
    // Entries of menus: "fps-30" is `fps` with its value.
    static const QRegularExpression kWithValue("^((fps|resolution|camera)-\\d+|tone-[a-z]+)$");
    Opened4 opened;
    for (const Action& action : opened.window->actions().all()) known.insert(action.name);
    for (const QString& name : known)
        EXPECT_TRUE(listed.contains(name) || kWithValue.match(name).hasMatch())
            << name.toStdString() << " is missing in docs/guide/window.md";
    // Of a window whose program can serve them, which this one cannot.
    static const QRegularExpression kOfBrowsers("^((in|panel)-)?browsers(-[a-z-]+)?$");
    for (const QString& name : listed)
        EXPECT_TRUE(known.contains(name) || kOfBrowsers.match(name).hasMatch())
            << name.toStdString() << " in docs/guide/window.md is no action";
}

TEST(Actions, the_tone_curve_is_chosen_by_name_and_by_key) {
    Opened4 opened;
    EXPECT_EQ(opened.request().tone, image::Tone::agx);
    EXPECT_EQ(opened.error_of("tone linear"), "");
    EXPECT_EQ(opened.request().tone, image::Tone::linear);
    EXPECT_TRUE(opened.window->actions().item("tone-linear")->isChecked());
    EXPECT_EQ(opened.error_of("tone"), "");
    EXPECT_EQ(opened.request().tone, image::Tone::agx) << "round at the end";
    EXPECT_FALSE(opened.window->actions().item("tone-linear")->isChecked());
    EXPECT_EQ(opened.error_of("tone-aces"), "");
    EXPECT_EQ(opened.request().tone, image::Tone::aces);
    EXPECT_NE(opened.error_of("tone film").find("agx, aces or linear"), std::string::npos);
    EXPECT_EQ(opened.request().tone, image::Tone::aces);
}

// As the layout is; --forget takes neither.
TEST(Actions, the_tone_curve_is_there_again_the_next_time) {
    QTemporaryDir home;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
    const auto tone_of = [](bool remembers) {
        Link link;
        Window window(link, WindowOptions{.remembers = remembers, .width = 640, .height = 400});
        return window.app().request().tone;
    };
    {
        Link link;
        Window window(link, WindowOptions{.width = 640, .height = 400});
        window.show();
        ASSERT_TRUE(window.actions().run("tone aces").ok());
        window.close();
    }
    EXPECT_EQ(tone_of(true), image::Tone::aces);
    EXPECT_EQ(tone_of(false), image::Tone::agx);
}

TEST(Actions, a_sentence_that_is_too_long_loses_folders_and_keeps_its_reason) {
    const QString sentence = "/home/me/shows/summer tour/show.toml:12: expected a number from 0 to 1";
    EXPECT_EQ(shortened(sentence, 200), sentence);
    const QString little = shortened(sentence, 50);
    EXPECT_TRUE(little.endsWith("show.toml:12: expected a number from 0 to 1")) << little.toStdString();
    EXPECT_LT(little.size(), sentence.size());
    EXPECT_EQ(shortened("/a/b/long/c/x.gdtf: 300 cd/m^2", 10), ".../c/x.gdtf: 300 cd/m^2");
    EXPECT_EQ(shortened("/home/me/tour/show.toml:38: no, nor /srv/shows/club/a.gdtf", 10),
              ".../tour/show.toml:38: no, nor .../club/a.gdtf")
        << "whose show.toml it is";
    EXPECT_EQ(shortened("nothing to leave out here", 3), "nothing to leave out here");
    EXPECT_EQ(shortened("", 0), "");
}

TEST(Actions, full_screen_is_the_picture_alone) {
    Opened4 opened;
    auto* transport = opened.window->findChild<QToolBar*>("transport");
    ASSERT_NE(transport, nullptr);
    EXPECT_TRUE(transport->isVisible());
    EXPECT_EQ(opened.error_of("full-screen"), "");
    EXPECT_FALSE(transport->isVisible());
    EXPECT_EQ(opened.error_of("full-screen"), "");
    EXPECT_TRUE(transport->isVisible());
}

TEST(Actions, selecting_among_no_fixtures_says_so) {
    Opened4 opened;
    EXPECT_NE(opened.error_of("select Nobody").find("no fixture is called 'Nobody'"), std::string::npos);
    EXPECT_NE(opened.error_of("select \"Lamp 1\" \"Lamp 1\"").find("no further fixture"), std::string::npos);
    Opened none = four_lamps();
    auto show = std::make_shared<scene::Show>(*none.show);
    show->fixtures.clear();
    none.show = show;
    opened.link.opened.put(std::move(none));
    opened.link.on_news();
    settle();
    EXPECT_NE(opened.error_of("select *").find("the show has no fixtures"), std::string::npos);
}

TEST(Actions, a_script_does_what_hands_do) {
    Opened4 opened;
    EXPECT_EQ(opened.error_of("select \"Lamp 2\" \"Lamp 4\""), "");
    EXPECT_EQ(opened.error_of("intensity 0.25"), "");
    EXPECT_EQ(opened.error_of("colour #ff0000"), "");
    EXPECT_EQ(opened.error_of("tilt -30"), "");
    EXPECT_EQ(opened.error_of("gobo 3"), "");
    const fixture::Programmer programmer = opened.request().look.fixtures.at(3);
    EXPECT_EQ(programmer.intensity, 0.25f);
    EXPECT_EQ(programmer.tilt_deg, -30.0f);
    EXPECT_EQ(programmer.gobo, 3);
    EXPECT_EQ(programmer.colour->x, 1.0f);
    EXPECT_LT(programmer.colour->z, 0.1f);
    EXPECT_EQ(opened.request().look.fixtures.size(), 2u);
    EXPECT_EQ(opened.error_of("smoke 2.5"), "");
    EXPECT_EQ(opened.request().look.scene.smoke, 2.5f);
    EXPECT_EQ(opened.error_of("attenuation 1 0.5 0"), "");
    EXPECT_EQ(opened.error_of("shadows off"), "");
    EXPECT_EQ(opened.request().look.scene.shadows, false);
    EXPECT_EQ(opened.error_of("object Wall off"), "");
    EXPECT_EQ(opened.request().look.shown.at(1), false);
    EXPECT_EQ(opened.error_of("surface wood specular 0.3"), "");
    EXPECT_EQ(opened.request().look.surfaces.at(0).specular, 0.3f);
    EXPECT_EQ(opened.error_of("samples 7"), "");
    EXPECT_EQ(opened.request().look.haze_samples, 7);
    EXPECT_EQ(opened.error_of("undo"), "");
    EXPECT_FALSE(opened.request().look.haze_samples);
    EXPECT_EQ(opened.error_of("redo"), "");
    EXPECT_EQ(opened.error_of("release-all"), "");
    EXPECT_TRUE(opened.request().look.is_empty());
    EXPECT_EQ(opened.error_of("undo"), "");
    EXPECT_EQ(opened.request().look.scene.smoke, 2.5f);
    EXPECT_EQ(opened.error_of("black-out"), "");
    EXPECT_TRUE(opened.request().black_out);
    EXPECT_EQ(opened.error_of("jump 12.5"), "");
    EXPECT_EQ(opened.request().transport.at_s, 12.5);
}

TEST(Actions, what_cannot_be_done_is_said_with_its_name) {
    Opened4 opened;
    EXPECT_EQ(opened.error_of("blackout"), "there is no action 'blackout', did you mean 'black-out'?");
    EXPECT_EQ(opened.error_of("intensity 0.5"), "intensity: no fixture is selected");
    EXPECT_EQ(opened.error_of("select Lamp\\ 9"), "select: no fixture is called 'Lamp\\'");
    EXPECT_EQ(opened.error_of("select *"), "");
    EXPECT_EQ(opened.error_of("intensity 1.5"), "intensity: '1.5' is no number from 0 to 1");
    EXPECT_EQ(opened.error_of("intensity nan"), "intensity: 'nan' is no number from 0 to 1");
    EXPECT_EQ(opened.error_of("intensity"), "intensity: it needs a number from 0 to 1");
    EXPECT_EQ(opened.error_of("colour brownish"), "colour: 'brownish' is no colour like #ff8000");
    EXPECT_EQ(opened.error_of("camera 7"), "camera: the show has 2 cameras, no number 7");
    EXPECT_NE(opened.error_of("camera fron").find("did you mean 'front'"), std::string::npos);
    EXPECT_EQ(opened.error_of("shadows maybe"), "shadows: 'maybe' is neither on nor off");
    EXPECT_EQ(opened.error_of("attenuation 0 0 0"), "attenuation: one of the factors must be above 0");
    EXPECT_EQ(opened.error_of("look 1 2 3 1 2 3"), "look: the camera stands at what it looks at");
    EXPECT_EQ(opened.error_of("redo"), "redo: there is nothing to redo");
    EXPECT_NE(opened.error_of("screenshot /no/such/folder/x.png"), "");
    EXPECT_NE(opened.error_of("select \"Lamp"), "");
    EXPECT_TRUE(opened.request().look.is_empty());
}

TEST(Actions, switches_take_on_and_off_and_nothing_else_is_taken_silently) {
    Opened4 opened;
    const auto is_on = [&](const QString& name) { return opened.window->actions().item(name)->isChecked(); };
    for (const char* const name : {"black-out", "figures", "names", "addresses", "aims", "marks"}) {
        SCOPED_TRACE(name);
        const std::string line = name;
        for (const bool on : {true, true, false, false, true}) {
            EXPECT_EQ(opened.error_of(line + (on ? " on" : " off")), "");
            EXPECT_EQ(is_on(name), on);
        }
        EXPECT_EQ(opened.error_of(line), "");
        EXPECT_FALSE(is_on(name)); // the other way round
        EXPECT_EQ(opened.error_of(line + " maybe"), line + ": 'maybe' is neither on nor off");
        EXPECT_EQ(opened.error_of(line + " on off"), line + ": 'on off' is neither on nor off");
        EXPECT_FALSE(is_on(name));
    }
    EXPECT_EQ(opened.error_of("see-all 7"), "see-all: takes no arguments, so what is '7'?");
}

// As Qt does it: who has the keys is asked whether it overrides a shortcut; if not, the shortcut comes, else
// the key.
void press(QWidget& asked, Qt::Key key, QAction& item, Qt::KeyboardModifiers with = Qt::NoModifier) {
    QKeyEvent override(QEvent::ShortcutOverride, key, with);
    override.ignore();
    QApplication::sendEvent(&asked, &override);
    if (override.isAccepted()) {
        QKeyEvent pressed(QEvent::KeyPress, key, with);
        QApplication::sendEvent(&asked, &pressed);
        settle();
        return;
    }
    QShortcutEvent shortcut(item.shortcut(), 0);
    QApplication::sendEvent(&item, &shortcut);
    settle();
}

TEST(Actions, keys_that_open_a_list_open_it_where_it_has_the_focus) {
    Opened4 opened;
    Actions& actions = opened.window->actions();
    QComboBox list(opened.window.get());
    list.addItems({"open", "gobo 1"});
    list.show();
    const bool played = opened.window->app().request().transport.playing;
    press(list, Qt::Key_Space, *actions.item("play"));
    EXPECT_EQ(opened.window->app().request().transport.playing, played);
    EXPECT_TRUE(list.view()->isVisible());
    list.hidePopup();
    settle();
    const std::size_t steps = static_cast<std::size_t>(opened.window->app().undo_stack().count());
    for (const Qt::Key key : {Qt::Key_Down, Qt::Key_Up})
        press(list, key, *actions.item("nudge-down-stage"), Qt::AltModifier);
    EXPECT_TRUE(list.view()->isVisible());
    EXPECT_EQ(static_cast<std::size_t>(opened.window->app().undo_stack().count()), steps);
    list.hidePopup();
    settle();
    press(*opened.window->centralWidget(), Qt::Key_Space, *actions.item("play"));
    EXPECT_NE(opened.window->app().request().transport.playing, played) << "elsewhere it is ours";
}

// It closes at the question already, so nothing is open any more when the shortcut comes.
TEST(Actions, a_key_that_closes_a_list_is_not_also_one_of_ours) {
    Opened4 opened;
    QAction& item = *opened.window->actions().item("select-none");
    QComboBox list(opened.window.get());
    list.addItems({"open", "gobo 1"});
    list.show();
    EXPECT_EQ(opened.error_of("select *"), "");
    list.showPopup();
    settle();
    ASSERT_TRUE(QApplication::activePopupWidget());
    press(*list.view(), Qt::Key_Escape, item);
    EXPECT_FALSE(QApplication::activePopupWidget());
    EXPECT_EQ(opened.window->app().selection().size(), 4u);
    press(*opened.window->centralWidget(), Qt::Key_Escape, item);
    EXPECT_TRUE(opened.window->app().selection().empty()) << "the next one is";
}

// A popup that is open keeps our keys away, but not what is chosen in a menu.
TEST(Actions, a_menu_does_what_is_chosen_in_it_and_keys_wait_while_one_is_open) {
    Opened4 opened;
    QAction* const item = opened.window->actions().item("names");
    QMenu* menu = nullptr;
    for (QAction* const title : opened.window->menuBar()->actions())
        if (title->menu() && title->menu()->actions().contains(item)) menu = title->menu();
    ASSERT_TRUE(menu);
    opened.window->show();
    const auto is_on = [&] { return opened.window->actions().item("names")->isChecked(); };
    const bool was_on = is_on();
    menu->popup({10, 10});
    settle();
    ASSERT_EQ(QApplication::activePopupWidget(), menu);
    press(*menu, Qt::Key_U, *opened.window->actions().item("addresses"));
    EXPECT_FALSE(opened.window->actions().item("addresses")->isChecked());
    menu->setActiveAction(item);
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QApplication::sendEvent(menu, &enter);
    settle();
    EXPECT_NE(is_on(), was_on);
    EXPECT_FALSE(QApplication::activePopupWidget());
}

TEST(Actions, a_script_waits_and_goes_on) {
    Opened4 opened;
    Script script(opened.window->actions(), opened.window->app(), nullptr);
    std::vector<std::string> answers;
    script.on_line = [&](const Result<void>& done) {
        answers.push_back(done.ok() ? "ok" : done.error().text());
    };
    for (const char* const line :
         {"# lamps", "", "wait opened", "select *", "wait 0.05", "intensity 1", "wait forever"})
        script.add(line);
    while (!script.is_done()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    ASSERT_EQ(answers.size(), 7u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(answers[i], "ok") << i;
    EXPECT_NE(answers[6].find("'forever' is no number of seconds"), std::string::npos) << answers[6];
    EXPECT_EQ(opened.request().look.fixtures.size(), 4u);
}

// The message that names two lamps is double clicked.
TEST(Actions, a_message_leads_to_what_it_is_about) {
    Opened4 opened;
    opened.link.messages.put(
        {{Severity::warning, "show.toml:12", "'Lamp 2' and 'Lamp 4' read channel 1.17"}});
    opened.link.on_news();
    settle();
    auto* list = opened.window->findChild<MessagePanel*>()->findChild<QTreeWidget*>();
    ASSERT_EQ(list->topLevelItemCount(), 1);
    Q_EMIT list->itemActivated(list->topLevelItem(0), 0);
    EXPECT_EQ(opened.window->app().selection(), (std::set<std::size_t>{1, 3}));
    EXPECT_TRUE(opened.window->app().travels());
}

// A panel behind another's tab comes to the front first; closing it there would be what nobody meant.
TEST(Actions, the_key_of_a_panel_behind_a_tab_brings_it_to_the_front) {
    Opened4 opened;
    const auto is_seen = [&](const char* name) {
        const auto* dock = opened.window->findChild<QDockWidget*>(name);
        return dock->isVisible() && !dock->visibleRegion().isEmpty();
    };
    opened.error_of("panel-programmer on");
    settle();
    ASSERT_TRUE(is_seen("programmer"));
    ASSERT_FALSE(is_seen("scene"));
    opened.error_of("panel-scene");
    settle();
    EXPECT_TRUE(is_seen("scene"));
    EXPECT_FALSE(is_seen("programmer"));
    opened.error_of("panel-scene");
    settle();
    EXPECT_FALSE(opened.window->findChild<QDockWidget*>("scene")->isVisible());
}

TEST(Actions, what_is_dropped_becomes_a_part_of_the_show_or_is_opened) {
    Opened4 opened;
    const auto drop = [&](const QString& file) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enters(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(opened.window.get(), &enters);
        QDropEvent event(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(opened.window.get(), &event);
        settle();
    };
    const std::string before = opened.request().show;
    // Neither can be read; neither is taken for a show.
    drop("/no/such/lamp.gdtf");
    drop("/no/such/club.glb");
    EXPECT_EQ(opened.request().show, before);
    drop("/no/such/tour/show.toml");
    EXPECT_EQ(opened.request().show, "/no/such/tour/show.toml");
}

// The show that is open is not the one that was asked for.
TEST(Actions, wait_opened_waits_for_the_show_that_was_asked_for) {
    Opened4 opened;
    Script script(opened.window->actions(), opened.window->app(), nullptr);
    std::vector<std::string> answers;
    script.on_line = [&](const Result<void>& done) {
        answers.push_back(done.ok() ? "ok" : done.error().text());
    };
    for (const char* const line : {"open other/show.toml", "wait opened"}) script.add(line);
    wait_ms(200);
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_FALSE(opened.window->app().is_settled());
    Opened news = four_lamps();
    news.opens = opened.request().opens;
    opened.link.opened.put(std::move(news));
    opened.link.on_news();
    wait_ms(100);
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(answers[1], "ok");

    for (const char* const line : {"open broken", "wait opened"}) script.add(line);
    wait_ms(100);
    opened.link.not_opened.put({Error{"is not TOML", "broken/show.toml:3"}, opened.request().opens});
    opened.link.on_news();
    wait_ms(100);
    ASSERT_EQ(answers.size(), 4u);
    EXPECT_NE(answers[3].find("broken/show.toml:3"), std::string::npos) << answers[3];
    // It was mended meanwhile: once more.
    const std::uint64_t opens = opened.request().opens;
    script.add("open broken");
    wait_ms(100);
    EXPECT_EQ(opened.request().opens, opens + 1);
    EXPECT_TRUE(opened.window->app().is_opening());
}

TEST(Actions, a_local_socket_takes_the_same_lines) {
    Opened4 opened;
    const QTemporaryDir folder;
    RemoteControl remote(opened.window->actions(), opened.window->app(), nullptr);
    const QString name = folder.filePath("socket");
    ASSERT_TRUE(remote.listen(name.toStdString().c_str()).ok());
    QLocalSocket socket;
    socket.connectToServer(name);
    ASSERT_TRUE(socket.waitForConnected(5000));
    socket.write("select \"Lamp 3\"\nnonsense\n");
    QByteArray answer;
    while (answer.count('\n') < 2) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        answer += socket.readAll();
    }
    EXPECT_EQ(answer, "ok\nerror: there is no action 'nonsense'\n");
    EXPECT_EQ(opened.window->app().selection(), std::set<std::size_t>{2});
}

} // namespace
} // namespace ghost::ui
