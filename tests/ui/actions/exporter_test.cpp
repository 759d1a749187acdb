// SPDX-License-Identifier: Apache-2.0
// Jobs of Export: of what moment they are, and with what exposure, where the engine has not taken a jump yet.
#include "support/test_desk.h"
#include "ui/actions/exporter.h"

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

} // namespace
} // namespace ghost::ui
