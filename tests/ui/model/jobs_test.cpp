// SPDX-License-Identifier: Apache-2.0
// Work in the background, with a script in the place of the program: progress is read, one comes after the
// other, what fails says why, what is cancelled ends.
#include "support/test_window.h"
#include "ui/model/jobs.h"

#include "base/progress.h"
#include "disk/files.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <vector>

namespace ghost::ui {
namespace {

struct Workshop {
    // script: of a shell; $3 and on are the arguments of the job.
    explicit Workshop(const std::string& script) {
        program = folder.filePath("program");
        EXPECT_TRUE(write_file_atomic(program.toStdString(), "#!/bin/sh\n" + script).ok());
        QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        jobs = std::make_unique<Jobs>(program);
        QObject::connect(jobs.get(), &Jobs::ended, [this](const Job& job) { ended.push_back(job); });
        QObject::connect(jobs.get(), &Jobs::changed, [this] {
            for (const Job& job : jobs->all())
                if (job.state == Job::State::runs) shares.push_back(job.share);
        });
    }
    void wait() {
        QElapsedTimer clock;
        clock.start();
        while (jobs->is_busy() && clock.elapsed() < 60000)
            QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
        EXPECT_FALSE(jobs->is_busy());
    }

    QTemporaryDir folder;
    QString program;
    std::vector<Job> ended;
    std::vector<double> shares;
    std::unique_ptr<Jobs> jobs;
};

TEST(Jobs, a_line_of_progress_is_read_as_it_is_printed) {
    for (const double share : {0.0, 0.42, 1.0}) {
        const auto read =
            progress_of(QString::fromStdString(progress_line("baking", share, 10, "foh: 3 of 8")));
        ASSERT_TRUE(read) << share;
        EXPECT_NEAR(read->share, share, 0.011);
        EXPECT_EQ(read->doing, "baking: foh: 3 of 8");
        EXPECT_EQ(read->left.isEmpty(), share == 0.0);
    }
    EXPECT_FALSE(progress_of("warning: 42 % of something"));
    EXPECT_FALSE(progress_of(""));
}

TEST(Jobs, progress_comes_while_it_runs_and_the_end_is_said) {
    Workshop shop("for p in ' 10' ' 55' ' 90'; do echo \"baking $p % [####                ] 0:05 left  "
                  "foh\"; sleep 0.1; done\n");
    shop.jobs->start("Bake", {"bake"});
    shop.wait();
    ASSERT_EQ(shop.ended.size(), 1u);
    EXPECT_EQ(shop.ended[0].state, Job::State::done);
    EXPECT_EQ(shop.ended[0].share, 1.0);
    EXPECT_EQ(shop.ended[0].doing, "baking: foh");
    EXPECT_TRUE(std::find(shop.shares.begin(), shop.shares.end(), 0.55) != shop.shares.end());
}

TEST(Jobs, warnings_and_errors_are_its_remarks) {
    Workshop shop("i=0; while [ $i -lt 120 ]; do echo \"warning: a.gdtf: fault $i\"; i=$((i + 1)); done; "
                  "echo 'error: no room'; echo 'wrote paper: 9 tables'\n");
    shop.jobs->start("Paper", {"paper"});
    shop.wait();
    ASSERT_EQ(shop.ended.size(), 1u);
    EXPECT_EQ(shop.ended[0].remark_count, 121);
    EXPECT_EQ(shop.ended[0].remarks.size(), 100);
    EXPECT_EQ(shop.ended[0].remarks.first(), "a.gdtf: fault 0");
}

// A fixture file with a fault is no reason to call a picture that lies there failed.
TEST(Jobs, what_is_made_of_a_show_that_lacks_something_is_done_and_says_what) {
    Workshop shop("echo 'warning: x.gdtf: no such wheel'; echo 'error: s.toml: " +
                  std::string(kMadeButMissing) + "'; exit $3");
    shop.jobs->start("Still a.png", {"1"});
    shop.jobs->start("Still b.png", {"2"});
    shop.wait();
    ASSERT_EQ(shop.ended.size(), 2u);
    EXPECT_EQ(shop.ended[0].state, Job::State::done);
    EXPECT_EQ(outcome_words(shop.ended[0]).toStdString(),
              "done. The show lacks something: x.gdtf: no such wheel");
    EXPECT_EQ(shop.ended[1].state, Job::State::failed);
}

TEST(Jobs, what_fails_says_its_last_words_and_the_next_one_begins) {
    Workshop shop("if [ $3 = bad ]; then echo 'error: no such camera'; exit 1; fi; echo fine > \"$4\"\n");
    const QString file = shop.folder.filePath("out");
    shop.jobs->start("Bad", {"bad"});
    shop.jobs->start("Good", {"good", file});
    EXPECT_EQ(shop.jobs->all()[1].state, Job::State::waits);
    shop.wait();
    ASSERT_EQ(shop.ended.size(), 2u);
    EXPECT_EQ(shop.ended[0].state, Job::State::failed);
    EXPECT_EQ(shop.ended[0].last_said, "error: no such camera");
    EXPECT_EQ(shop.ended[1].state, Job::State::done);
    EXPECT_TRUE(QFile::exists(file));
}

TEST(Jobs, cancelling_ends_what_runs_and_what_waits) {
    Workshop shop("exec sleep 100\n");
    const int first = shop.jobs->start("First", {"x"});
    shop.jobs->start("Second", {"y"});
    for (int i = 0; i < 20; ++i) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    shop.jobs->cancel_all();
    shop.jobs->cancel(first); // twice does no harm
    shop.wait();
    for (const Job& job : shop.jobs->all()) EXPECT_EQ(job.state, Job::State::cancelled);
    ASSERT_EQ(shop.ended.size(), 2u) << "also of the one that had not begun";
    EXPECT_EQ(shop.ended[0].title, "Second");
    EXPECT_EQ(shop.ended[0].state, Job::State::cancelled);
    shop.jobs->forget_finished();
    EXPECT_TRUE(shop.jobs->all().empty());
}

TEST(Jobs, who_goes_waits_for_what_tidies_up) {
    Workshop shop("trap 'sleep 4; echo tidy > \"$3\"; exit 1' TERM; echo 'warning: begun'; while :; do sleep "
                  "0.1; done\n");
    const QString file = shop.folder.filePath("tidied");
    shop.jobs->start("Book", {file});
    QElapsedTimer clock;
    clock.start();
    while (shop.jobs->all()[0].remark_count == 0 && clock.elapsed() < 20000)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    shop.jobs.reset();
    EXPECT_TRUE(QFile::exists(file));
}

TEST(Jobs, what_is_killed_leaves_no_hidden_folder) {
    Workshop shop("mkdir \"$(dirname \"$5\")/.book.part$$_1\"; kill -9 $$\n");
    const QDir folder(shop.folder.path());
    ASSERT_TRUE(folder.mkdir(".other.part999999999_1"));
    shop.jobs->start("Book", {"book", "-o", folder.filePath("book")});
    shop.wait();
    ASSERT_EQ(shop.ended.size(), 1u);
    EXPECT_EQ(shop.ended[0].state, Job::State::failed);
    EXPECT_EQ(folder.entryList({".*.part*"}, QDir::Dirs | QDir::Hidden),
              QStringList{".other.part999999999_1"});
}

TEST(Jobs, a_program_that_is_not_there_is_a_failure) {
    Jobs jobs("/nonexistent/ghostlight");
    jobs.start("Nothing", {"bake"});
    QElapsedTimer clock;
    clock.start();
    while (jobs.is_busy() && clock.elapsed() < 20000)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    EXPECT_EQ(jobs.all()[0].state, Job::State::failed);
    EXPECT_FALSE(jobs.all()[0].last_said.isEmpty());
}

} // namespace
} // namespace ghost::ui
