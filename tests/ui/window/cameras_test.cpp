// SPDX-License-Identifier: Apache-2.0
// Cameras of the show in the window: one that is kept gets its name there, others get another one or go.
#include "support/test_window.h"
#include "ui/widgets/toast.h"
#include "ui/window/window.h"

#include "disk/files.h"
#include "show_file/show_toml.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPointer>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include <filesystem>

namespace ghost::ui {
namespace {

struct Cameras {
    explicit Cameras(const std::string& cameras =
                         "[[camera]]\nname = \"front\"\n[[camera]]\nname = \"side\"\n"
                         "position_m = [-10, 0, 3]\ntarget_m = [0, 0, 2]\n") {
        const std::string text = "[show]\n" + cameras +
                                 "[[fixture]]\nname = \"Lamp 1\"\ngdtf = \"lamp.gdtf\"\n[[cue]]\nname = "
                                 "\"Verse\"\ncamera = \"front\"\n";
        file = std::filesystem::path(folder.path().toStdString()) / "show.toml";
        EXPECT_TRUE(write_file_atomic(file, text).ok());
        window.show();
        Report report;
        auto parsed = scene::parse_show(text, file, report);
        EXPECT_TRUE(parsed.ok());
        if (parsed->show.cameras.empty()) parsed->show.cameras = four_lamps().show->cameras; // made
        Opened opened;
        opened.show = std::make_shared<const scene::Show>(std::move(parsed->show));
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    std::string error_of(const QString& line) {
        const Result<void> done = window.actions().run(line);
        return done.ok() ? "" : done.error().text();
    }
    std::vector<std::string> names() {
        std::vector<std::string> all;
        for (const scene::Camera& one : window.app().show()->cameras) all.push_back(one.name);
        return all;
    }
    std::string saved() {
        EXPECT_EQ(error_of("save"), "");
        return *read_text_file(file, 1 << 20);
    }
    Toast& toast() { return *window.findChild<Toast*>(); }
    QListWidget& strip() {
        for (QListWidget* const one : window.findChildren<QListWidget*>())
            if (one->accessibleName() == "Cameras") return *one;
        ADD_FAILURE();
        return *window.findChild<QListWidget*>();
    }

    QTemporaryDir folder;
    std::filesystem::path file;
    Link link;
    Window window{link, {.remembers = false, .width = 1000, .height = 700}};
};
void press(QWidget& widget, int key) {
    for (const QEvent::Type type : {QEvent::ShortcutOverride, QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(type, key, Qt::NoModifier);
        QCoreApplication::sendEvent(&widget, &event);
    }
    settle();
}
using Names = std::vector<std::string>;

TEST(Camera, one_that_is_kept_gets_its_name_where_it_is_said) {
    Cameras in;
    ASSERT_EQ(in.error_of("keep-camera"), "");
    ASSERT_EQ(in.names(), (Names{"front", "side", "Camera 3"}));
    auto* const name = in.toast().findChild<QToolButton*>("name");
    ASSERT_TRUE(name && name->isVisible());
    name->click();
    auto* const field = in.toast().findChild<QLineEdit*>();
    ASSERT_TRUE(field->isVisible());
    EXPECT_EQ(field->text(), "Camera 3");
    field->setText("side"); // another one's
    press(*field, Qt::Key_Return);
    EXPECT_TRUE(field->isVisible()) << "it asks on";
    EXPECT_TRUE(in.toast().words().contains("another camera is called 'side'"))
        << in.toast().words().toStdString();
    field->setText("Balcony");
    press(*field, Qt::Key_Return);
    EXPECT_EQ(in.names(), (Names{"front", "side", "Balcony"}));
    EXPECT_FALSE(field->isVisible());
    EXPECT_EQ(in.toast().words(), "Camera 'Camera 3' renamed 'Balcony'");
    EXPECT_EQ(in.error_of("undo"), "");
    EXPECT_EQ(in.names().back(), "Camera 3");
}

TEST(Camera, esc_leaves_the_name_and_the_selection) {
    Cameras in;
    ASSERT_EQ(in.error_of("select \"Lamp 1\""), "");
    ASSERT_EQ(in.error_of("keep-camera"), "");
    in.toast().findChild<QToolButton*>("name")->click();
    auto* const field = in.toast().findChild<QLineEdit*>();
    field->setText("x");
    press(*field, Qt::Key_Escape);
    EXPECT_FALSE(in.toast().isVisible());
    EXPECT_EQ(in.names().back(), "Camera 3");
    EXPECT_EQ(in.window.app().selection().size(), 1u);
}

TEST(Camera, another_name_is_written_with_what_names_it_and_undone) {
    Cameras in;
    ASSERT_EQ(in.error_of("camera-rename front Balcony"), "");
    EXPECT_EQ(in.names(), (Names{"Balcony", "side"}));
    EXPECT_EQ(in.window.app().show()->cues[0].camera, "Balcony");
    EXPECT_NE(in.saved().find("camera = \"Balcony\""), std::string::npos);
    ASSERT_EQ(in.error_of("undo"), "");
    EXPECT_EQ(in.names(), (Names{"front", "side"}));
    EXPECT_EQ(in.window.app().show()->cues[0].camera, "front");
    EXPECT_NE(in.error_of("camera-rename 2 front").find("another camera is called 'front'"),
              std::string::npos);
    EXPECT_NE(in.error_of("camera-rename 2 a/b").find("is no name"), std::string::npos);
    EXPECT_NE(in.error_of("camera-rename fron x").find("did you mean"), std::string::npos);
    EXPECT_NE(in.error_of("camera-rename").find("needs a camera and its new name"), std::string::npos);
}

TEST(Camera, one_goes_unless_it_is_named_or_the_last) {
    Cameras in;
    EXPECT_NE(in.error_of("camera-remove front").find("cue 'Verse' goes to it"), std::string::npos);
    ASSERT_EQ(in.error_of("camera-remove side"), "");
    EXPECT_EQ(in.names(), (Names{"front"}));
    EXPECT_EQ(in.saved().find("\"side\""), std::string::npos);
    EXPECT_NE(in.error_of("camera-remove front").find("is the last one of the show"), std::string::npos);
    ASSERT_EQ(in.error_of("undo"), "");
    EXPECT_EQ(in.names(), (Names{"front", "side"}));
    // Where the picture stands.
    ASSERT_EQ(in.error_of("fly 1 0 0"), "");
    EXPECT_NE(in.error_of("camera-remove").find("stands at no camera of the show"), std::string::npos);
}

TEST(Camera, those_that_were_made_for_a_show_are_not_its_own) {
    Cameras in("");
    for (const char* const line : {"camera-rename 1 x", "camera-remove 2"})
        EXPECT_NE(in.error_of(line).find("is made from where the fixtures hang"), std::string::npos) << line;
}

TEST(Camera, the_first_that_is_kept_leaves_those_that_were_made) {
    Cameras in("");
    ASSERT_EQ(in.error_of("keep-camera Balcony"), "");
    EXPECT_EQ(in.names(), (Names{"front", "side", "Balcony"}));
    EXPECT_EQ(in.error_of("camera-rename side Wing"), "") << "they are its own now";
    EXPECT_EQ(in.window.app().undo_stack().count(), 2);
    ASSERT_EQ(in.error_of("undo"), "");
    ASSERT_EQ(in.error_of("undo"), "");
    EXPECT_EQ(in.saved().find("[[camera]]"), std::string::npos);
}

TEST(Exposure, keys_go_on_from_what_the_picture_has_found) {
    Cameras in;
    AppModel& app = in.window.app();
    Picture picture;
    picture.image = std::make_shared<image::Image8>(16, 9, 4);
    picture.camera = app.camera();
    picture.ev100 = 1.5f;
    for (const auto& [key, ev100] : {std::pair{"brighter", 1.0f}, {"darker", 2.0f}}) {
        app.set_exposure(6, true);
        in.link.picture.put(Picture(picture));
        in.link.on_news();
        settle();
        ASSERT_EQ(in.error_of(key), "");
        EXPECT_EQ(app.camera().ev100, ev100) << key;
        EXPECT_FALSE(app.camera().auto_exposure);
    }
    ASSERT_EQ(in.error_of("brighter"), "");
    EXPECT_EQ(app.camera().ev100, 1.5f) << "by hand from what the hand has";
}

TEST(Camera, the_strip_renames_and_removes) {
    Cameras in;
    ASSERT_EQ(in.error_of("camera-strip on"), "");
    settle();
    QListWidget& strip = in.strip();
    strip.item(1)->setText("Wing");
    settle();
    EXPECT_EQ(in.names(), (Names{"front", "Wing"}));
    ASSERT_EQ(strip.count(), 2);
    strip.item(1)->setText("front"); // refused
    settle();
    EXPECT_EQ(strip.item(1)->text(), "Wing");
    strip.setCurrentRow(1);
    Q_EMIT strip.customContextMenuRequested(strip.visualItemRect(strip.item(1)).center());
    settle();
    auto* const menu = strip.findChild<QMenu*>("context");
    ASSERT_TRUE(menu);
    for (QAction* const one : menu->actions())
        if (one->text() == "Remove") one->trigger();
    EXPECT_EQ(in.names(), (Names{"front"}));
    menu->close();
}

TEST(Camera, who_types_its_name_in_the_strip_goes_on_while_an_edit_is_read) {
    Cameras in;
    ASSERT_EQ(in.error_of("camera-strip on"), "");
    settle();
    QListWidget& strip = in.strip();
    strip.setCurrentRow(1);
    strip.editItem(strip.item(1));
    const QPointer<QLineEdit> field = strip.findChild<QLineEdit*>();
    ASSERT_TRUE(field && field->isVisible());
    field->setText("Wing");
    Opened opened = in.window.app().opened();
    opened.is_edit = true;
    in.link.opened.put(std::move(opened));
    in.link.on_news();
    settle();
    ASSERT_EQ(in.error_of("fly 1 0 0"), ""); // the picture stands at none of them
    auto image = std::make_shared<image::Image8>(16, 9, 4);
    in.link.camera_pictures.put({{"front", image}, {"side", image}});
    in.link.on_news();
    settle();
    ASSERT_TRUE(field && field->isVisible());
    EXPECT_EQ(field->text(), "Wing");
    press(*field, Qt::Key_Return);
    EXPECT_EQ(in.names(), (Names{"front", "Wing"}));
}

} // namespace
} // namespace ghost::ui
