// SPDX-License-Identifier: Apache-2.0
// Shows on drives that do not answer.
#include "support/test_window.h"
#include "ui/model/disk_look.h"
#include "ui/window/recent_shows.h"

#include <QSettings>

#include <chrono>
#include <future>

namespace ghost::ui {
namespace {

using namespace std::chrono_literals;

// A server that was switched off, until it is told to answer.
struct Drive {
    std::promise<void> comes_back;
    std::shared_future<void> is_back{comes_back.get_future().share()};
    RecentShows::IsThere is_there = [back = is_back](const std::filesystem::path& file) {
        back.wait_for(5s);
        return file.filename() == "kept.toml";
    };
};

class RecentShowsTest : public ::testing::Test {
protected:
    RecentShowsTest() {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
        QSettings settings;
        settings.beginWriteArray("recent shows", 2);
        for (const auto& [index, path] : {std::pair{0, "/far/gone.toml"}, {1, "/far/kept.toml"}}) {
            settings.setArrayIndex(index);
            settings.setValue("path", path);
            settings.setValue("name", "Tour");
        }
        settings.endArray();
    }

    QTemporaryDir home;
    Link link;
    AppModel app{link};
};

TEST_F(RecentShowsTest, a_drive_that_does_not_answer_holds_nothing) {
    Drive drive;
    RecentShows recent(app, true, drive.is_there);
    int changes = 0;
    QObject::connect(&recent, &RecentShows::changed, [&] { ++changes; });
    EXPECT_EQ(recent.all().size(), 2u) << "nobody knows yet";
    wait_ms(100);
    EXPECT_EQ(recent.all().size(), 2u);
    drive.comes_back.set_value();
    for (int tries = 0; tries < 100 && changes == 0; ++tries) wait_ms(20);
    EXPECT_EQ(changes, 1);
    ASSERT_EQ(recent.all().size(), 1u);
    EXPECT_EQ(recent.all().front().path, "/far/kept.toml");
}

TEST_F(RecentShowsTest, an_answer_that_comes_after_the_window_went_is_nobodys) {
    Drive drive;
    { const RecentShows recent(app, true, drive.is_there); }
    drive.comes_back.set_value();
    wait_ms(100);
}

// As the open show's disk is looked at each second: what hangs is neither waited for nor asked again.
TEST(DiskLook, a_question_that_hangs_is_asked_once_and_left_behind_by_another_show) {
    Drive drive;
    DiskLook disk;
    int hung = 0, answered = 0;
    const auto asks = [&](int& count) {
        return [back = drive.is_back, &count]() -> DiskLook::Then {
            back.wait_for(5s);
            return [&count] { ++count; };
        };
    };
    EXPECT_TRUE(disk.ask(asks(hung)));
    EXPECT_FALSE(disk.ask(asks(hung)));
    wait_ms(100);
    EXPECT_EQ(hung, 0);
    disk.forget();
    EXPECT_TRUE(disk.ask(asks(answered)));
    drive.comes_back.set_value();
    for (int tries = 0; tries < 100 && answered == 0; ++tries) wait_ms(20);
    wait_ms(100);
    EXPECT_EQ(answered, 1);
    EXPECT_EQ(hung, 0);
    EXPECT_TRUE(disk.ask(asks(answered))) << "the next look";
}

} // namespace
} // namespace ghost::ui
