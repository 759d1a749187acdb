// SPDX-License-Identifier: Apache-2.0
// Actions of the whole window: it goes on while a file is read or written; cameras and the work light.
#include "show/show.h"
#include "support/test_window.h"
#include "ui/actions/script.h"
#include "ui/window/window.h"

#include <QTemporaryDir>

#include <filesystem>
#include <functional>
#include <utility>

namespace ghost::ui {
namespace {

struct FourLamps {
    FourLamps() {
        window.show();
        link.opened.put(four_lamps());
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    std::string error_of(const std::string& line) {
        const Result<void> done = window.actions().run(QString::fromStdString(line));
        return done.ok() ? "" : done.error().text();
    }
    const ViewRequest& request() { return window.app().request(); }

    Link link;
    Window window{link, {.remembers = false, .width = 640, .height = 400}};
};

TEST(WindowActions, the_window_goes_on_while_a_recording_is_read_or_a_picture_packed) {
    FourLamps opened;
    QTemporaryDir folder;
    Picture picture;
    picture.image = std::make_shared<image::Image8>(64, 36, 4);
    opened.link.picture.put(picture);
    opened.link.on_news();
    settle();
    bool goes_on = false;
    const auto meanwhile = [&](std::function<void()> f) {
        QMetaObject::invokeMethod(&opened.window, std::move(f), Qt::QueuedConnection);
    };
    meanwhile([&] { goes_on = true; });
    const std::string file = folder.filePath("now.png").toStdString();
    EXPECT_EQ(opened.error_of("save-picture \"" + file + "\""), "");
    EXPECT_TRUE(std::exchange(goes_on, false));
    EXPECT_TRUE(std::filesystem::exists(file));
    meanwhile([&] { goes_on = true; });
    EXPECT_NE(opened.error_of("play-file \"" + file + "\""), "");
    EXPECT_TRUE(goes_on);
    EXPECT_EQ(opened.request().recording, "") << "what is none stops nothing";
    const std::string recording = GHOST_SOURCE_DIR "/assets/demo/demo.show";
    meanwhile([&] { opened.window.app().open("/another/show.toml"); });
    EXPECT_NE(opened.error_of("play-file \"" + recording + "\"").find("another show was opened"),
              std::string::npos);
    EXPECT_EQ(opened.request().recording, "");
    EXPECT_EQ(opened.error_of("play-file \"" + recording + "\""), "");
    EXPECT_EQ(opened.request().recording, recording);
}

TEST(Script, one_that_is_gone_before_its_line_is_done_says_nothing) {
    FourLamps opened;
    Actions& actions = opened.window.actions();
    auto* const script = new Script(actions, opened.window.app(), nullptr);
    int answers = 0;
    script->on_line = [&](const Result<void>&) { ++answers; };
    actions.add({"hang-up",
                 "",
                 "hang-up",
                 "",
                 "",
                 [script](const QStringList&) -> Result<void> {
                     delete script; // as a socket that is closed does
                     return {};
                 },
                 {}});
    script->add("hang-up");
    wait_ms(100);
    EXPECT_EQ(answers, 0);
}

// A picture of measured light has no work light, whatever is asked for.
TEST(WindowActions, the_work_light_is_turned_on_and_off_while_light_is_measured) {
    FourLamps opened;
    EXPECT_EQ(opened.error_of("work-light"), "");
    EXPECT_EQ(opened.request().work_light, WorkLight::on);
    EXPECT_EQ(opened.error_of("false-colour luminance"), "");
    EXPECT_EQ(opened.error_of("work-light"), "");
    EXPECT_EQ(opened.request().work_light, WorkLight::off);
    EXPECT_EQ(opened.error_of("work-light"), "");
    EXPECT_EQ(opened.request().work_light, WorkLight::on);
}

// It is the engine that turns it on, in a picture that comes later.
TEST(WindowActions, the_entry_of_the_work_light_says_what_the_picture_shows) {
    FourLamps opened;
    for (const bool shines : {true, false, true}) {
        Picture picture;
        picture.has_work_light = shines;
        opened.link.picture.put(picture);
        opened.link.on_news();
        settle();
        EXPECT_EQ(opened.window.actions().item("work-light")->isChecked(), shines);
    }
}

TEST(WindowActions, a_camera_whose_name_is_a_number_beyond_them_is_found) {
    FourLamps opened;
    Opened news = opened.window.app().opened();
    auto show = std::make_shared<scene::Show>(*news.show);
    show->cameras.back().name = "7";
    show->cameras.back().position_m = {3, -7, 2};
    news.show = std::move(show);
    opened.link.opened.put(std::move(news));
    opened.link.on_news();
    settle();
    EXPECT_EQ(opened.error_of("camera 7"), "");
    for (int i = 0; i < 200 && opened.window.app().travels(); ++i) wait_ms(20);
    EXPECT_EQ(opened.window.app().camera().position_m, glm::vec3(3, -7, 2));
}

} // namespace
} // namespace ghost::ui
