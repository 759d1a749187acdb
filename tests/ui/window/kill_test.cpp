// SPDX-License-Identifier: Apache-2.0
// A window that is killed while a person edits and saves: the show opens, and at most the last second is
// lost. The window is this program again, as a process of its own.
#include "support/test_desk.h"

#include <QElapsedTimer>
#include <QProcess>

#include <cstdio>
#include <random>

namespace ghost::ui {
namespace {

constexpr int kKills = 50;
constexpr int kMostLost_ms = 1000;

// Edit number k calls the first lamp "N k".
int newest_edit(const std::string& text) {
    Report report;
    const auto parsed = scene::parse_show(text, "show.toml", report);
    if (!parsed.ok() || parsed->show.fixtures.size() != 3) return -1;
    const std::string& name = parsed->show.fixtures[0].name;
    return name.starts_with("N ") ? std::stoi(name.substr(2)) : 0;
}

// The child: says "edited K MS" and "saved K MS" until it is killed.
TEST(Killed, DISABLED_edits_and_saves) {
    Desk desk(qEnvironmentVariable("GHOST_KILL_FOLDER").toStdString());
    desk.open();
    if (desk.document.has_draft()) {
        ASSERT_TRUE(desk.document.take_draft().ok());
        desk.follow();
    }
    QElapsedTimer clock;
    clock.start();
    for (int k = newest_edit(desk.document.text()) + 1; clock.elapsed() < 60000; ++k) {
        desk.app.select({0});
        ASSERT_TRUE(desk.edit.rename(QString("N %1").arg(k)).ok());
        desk.follow();
        std::printf("edited %d %lld\n", k, static_cast<long long>(clock.elapsed()));
        if (k % 7 == 0) {
            ASSERT_TRUE(desk.document.save(false).ok());
            std::printf("saved %d %lld\n", k, static_cast<long long>(clock.elapsed()));
        }
        std::fflush(stdout);
        if (k % 11 == 0) wait_ms(200); // a person thinks
        settle();
    }
}

TEST(Killed, at_any_moment_the_show_opens_and_a_second_is_lost_at_most) {
    QTemporaryDir place, left_behind; // by those that are killed
    std::mt19937 random(11);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("GHOST_KILL_FOLDER", place.path());
    environment.insert("TMPDIR", left_behind.path());
    int edits = 0, saves = 0;
    for (int kill = 0; kill < kKills; ++kill) {
        QProcess window;
        window.setProcessEnvironment(environment);
        window.start(QCoreApplication::applicationFilePath(),
                     {"--gtest_also_run_disabled_tests", "--gtest_filter=Killed.DISABLED_edits_and_saves"});
        ASSERT_TRUE(window.waitForStarted());
        QByteArray said;
        QElapsedTimer clock;
        clock.start();
        while (!said.contains("edited") && clock.elapsed() < 30000 && window.waitForReadyRead(30000))
            said += window.readAllStandardOutput();
        ASSERT_TRUE(said.contains("edited")) << said.toStdString();
        wait_ms(static_cast<int>(random() % 1200));
        window.kill();
        window.waitForFinished();
        said += window.readAllStandardOutput();

        std::vector<std::pair<int, long>> edited;
        int saved = 0;
        for (const QByteArray& line : said.split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            if (words.size() != 3) continue;
            if (words[0] == "edited") edited.emplace_back(words[1].toInt(), words[2].toLong());
            if (words[0] != "saved") continue;
            saved = words[1].toInt();
            ++saves;
        }
        ASSERT_FALSE(edited.empty());
        edits += static_cast<int>(edited.size());
        const int in_file =
            newest_edit(*read_text_file(fs::path(place.path().toStdString()) / "show.toml", 1 << 20));
        ASSERT_GE(in_file, saved) << "show.toml is whole, and what was said to be saved is";
        int newest = in_file;
        const fs::path draft = fs::path(place.path().toStdString()) / ".ghost" / "draft.toml";
        if (fs::exists(draft)) {
            const int in_draft = newest_edit(*read_text_file(draft, 1 << 20));
            ASSERT_GE(in_draft, 0) << "the draft is whole";
            newest = std::max(newest, in_draft);
        }
        for (const auto& [number, at_ms] : edited)
            ASSERT_TRUE(newest >= number || at_ms >= edited.back().second - kMostLost_ms)
                << number << " is lost";
    }
    EXPECT_GT(edits, kKills);
    EXPECT_GT(saves, 0);
}

} // namespace
} // namespace ghost::ui
