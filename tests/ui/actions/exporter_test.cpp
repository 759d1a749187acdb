// SPDX-License-Identifier: Apache-2.0
// Jobs of Export: of what moment they are, and with what exposure, where the engine has not taken a jump yet.
#include "disk/files.h"
#include "support/test_desk.h"
#include "ui/actions/export_actions.h"
#include "ui/actions/exporter.h"

#include <QWidget>

namespace ghost::ui {
namespace {

// The program of its jobs is this test, which has nothing to do then.
struct ExportDesk : Desk {
    ExportDesk() {
        EXPECT_TRUE(qputenv("GTEST_FILTER", "-*"));
        std::string text = kShow;
        text.insert(text.find("[[camera]]"), "recording = \"none.show\"\n");
        EXPECT_TRUE(write_file_atomic(file, text).ok());
        open();
        put_rig(0, 0);
    }
    ~ExportDesk() { qunsetenv("GTEST_FILTER"); }
    void put_rig(double at_s, std::uint64_t seeks) {
        RigNow rig;
        rig.fixtures.resize(3);
        rig.at_s = at_s;
        rig.seeks = seeks;
        rig.recording_s = 100;
        link.rig.put(std::move(rig));
        link.on_news();
        settle();
    }
    void jump(double at_s) {
        app.change_request([&](ViewRequest& request) {
            ++request.transport.seeks;
            request.transport.at_s = at_s;
        });
    }
    QStringList still() {
        const Result<int> job = exporter.render({.file = QString::fromStdString(folder) + "/still.png"});
        EXPECT_TRUE(job.ok()) << job.error().text();
        return job.ok() ? app.jobs().all().back().arguments : QStringList();
    }
    static QString after(const QStringList& words, const char* option) {
        const auto at = words.indexOf(option);
        return at < 0 ? QString() : words.value(at + 1);
    }
    Exporter exporter{app, document};
};

TEST(Exporter, a_still_is_of_the_moment_that_was_asked_for_last) {
    ExportDesk desk;
    desk.jump(55);
    EXPECT_EQ(desk.app.rig().at_s, 0) << "the engine is busy";
    EXPECT_EQ(desk.after(desk.still(), "--at"), "55");
    desk.put_rig(0, 0); // news of before
    EXPECT_EQ(desk.after(desk.still(), "--at"), "55");
    desk.put_rig(55.25, 1);
    EXPECT_EQ(desk.after(desk.still(), "--at"), "55.25") << "it plays on";
    desk.jump(130);
    EXPECT_EQ(desk.app.moment_s(), 30) << "it is played again and again";
}

TEST(Exporter, the_exposure_that_was_measured_before_a_jump_is_not_that_of_the_still) {
    ExportDesk desk;
    desk.app.set_exposure(6, true);
    EXPECT_EQ(desk.after(desk.still(), "--ev").toDouble(), 0);
    desk.jump(55);
    const QStringList words = desk.still();
    EXPECT_TRUE(words.contains("--auto-exposure"));
    EXPECT_FALSE(words.contains("--ev"));
    desk.app.set_exposure(6, false);
    EXPECT_EQ(desk.after(desk.still(), "--ev").toDouble(), 6);
}

TEST(Exporter, a_mover_that_a_hand_drives_stands_in_the_picture_where_it_does_in_the_window) {
    ExportDesk desk;
    auto show = std::make_shared<scene::Show>(*desk.app.show());
    show->recording.clear(); // so that nothing else is there to draw
    show->movers.emplace_back();
    show->movers.back().name = "Truss";
    Opened opened = desk.app.opened();
    opened.show = std::move(show);
    desk.link.opened.put(std::move(opened));
    desk.link.on_news();
    settle();
    Look look;
    look.movers[0] = {2.0f};
    desk.app.set_look(look, "mover");
    const QStringList words = desk.still();
    const auto looks = read_text_file(desk.after(words, "--looks").toStdString(), 1 << 20);
    ASSERT_TRUE(looks.ok()) << words.join(' ').toStdString();
    EXPECT_NE(looks->find("Truss"), std::string::npos) << *looks;
}

TEST(Exporter, a_film_is_of_the_chosen_camera_as_a_still_is) {
    ExportDesk desk;
    QWidget widget;
    Actions actions(widget);
    add_export_actions(actions, desk.app, desk.exporter);
    const QString file = quoted(QString::fromStdString(desk.folder) + "/film.mp4");
    const auto words_of = [&](const QString& line) {
        const Result<void> done = actions.run(line);
        EXPECT_TRUE(done.ok()) << done.error().text();
        return desk.app.jobs().all().back().arguments;
    };
    const QStringList of_camera = words_of("export-film " + file + " 1 2 25 front");
    EXPECT_EQ(desk.after(of_camera, "--view"), "front");
    EXPECT_FALSE(of_camera.contains("--eye"));
    EXPECT_TRUE(words_of("export-film " + file + " 1 2 25 640x360").contains("--eye"));
    const Result<void> wrong = actions.run("export-film " + file + " 1 2 25 nowhere");
    ASSERT_FALSE(wrong.ok());
    EXPECT_NE(wrong.error().text().find("nor a camera of the show"), std::string::npos);
}

} // namespace
} // namespace ghost::ui
