// SPDX-License-Identifier: Apache-2.0
// Two windows on one show: one edits, the other reads and may take over; nothing that was not saved is lost.
// And what saving does where the show file is a link, or cannot be read.
#include "support/test_desk.h"

#include "ui/model/looks.h"

#include <QDir>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sys/resource.h>

namespace ghost::ui {
namespace {

constexpr int kUntilKept_ms = 700, kUntilSeen_ms = 1300;

void rename_first(Desk& desk, const QString& name) {
    desk.app.select({0});
    const Result<void> renamed = desk.edit.rename(name);
    ASSERT_TRUE(renamed.ok()) << renamed.error().text();
    desk.follow();
}

// Texts of what a window kept that another one took over.
std::vector<std::string> kept_aside(const Desk& desk) {
    std::vector<std::string> texts;
    for (const auto& entry : fs::directory_iterator(fs::path(desk.folder) / ".ghost"))
        if (entry.path().filename().string().starts_with("draft-"))
            texts.push_back(*read_text_file(entry.path(), 1 << 20));
    return texts;
}

TEST(TwoWindows, the_second_is_told_who_has_the_show_and_loses_no_draft) {
    QTemporaryDir place;
    Desk first(place.path().toStdString());
    first.open();
    rename_first(first, "Mine");
    wait_ms(kUntilKept_ms);
    const fs::path draft = fs::path(first.folder) / ".ghost" / "draft.toml";
    ASSERT_TRUE(fs::exists(draft));
    {
        Desk second(place.path().toStdString());
        QString held;
        QObject::connect(&second.document, &ShowDocument::found_held,
                         [&](const QString& words) { held = words; });
        second.open();
        EXPECT_TRUE(held.contains(QString("process %1 on ").arg(QCoreApplication::applicationPid())))
            << held.toStdString();
        EXPECT_TRUE(second.document.is_read_only());
        second.app.select({0});
        const Result<void> renamed = second.edit.rename("Theirs");
        ASSERT_FALSE(renamed.ok());
        EXPECT_NE(renamed.error().text().find("is open in another window: process "), std::string::npos);
        EXPECT_FALSE(second.document.save(false).ok());
        EXPECT_FALSE(second.document.has_draft());
        wait_ms(kUntilKept_ms);
    }
    EXPECT_TRUE(fs::exists(draft)) << "the window that only read has closed";
    ASSERT_TRUE(first.document.save(false).ok());
    EXPECT_NE(first.on_disk().find("Mine"), std::string::npos);
}

TEST(TwoWindows, who_is_taken_over_keeps_what_it_had_not_saved) {
    QTemporaryDir place;
    Desk first(place.path().toStdString()), second(place.path().toStdString());
    first.open();
    rename_first(first, "Mine");
    wait_ms(kUntilKept_ms);
    second.open();
    ASSERT_TRUE(second.document.take_over().ok());
    EXPECT_FALSE(second.document.is_read_only());
    EXPECT_TRUE(second.document.has_draft()) << "what the first one had not saved is offered";
    QString held;
    QObject::connect(&first.document, &ShowDocument::found_held, [&](const QString& words) { held = words; });
    wait_ms(kUntilSeen_ms);
    EXPECT_TRUE(held.contains("took this show over")) << held.toStdString();
    EXPECT_TRUE(first.document.is_read_only());
    EXPECT_FALSE(first.document.save(false).ok());
    ASSERT_EQ(kept_aside(first).size(), 1u);
    EXPECT_NE(kept_aside(first)[0].find("Mine"), std::string::npos);

    ASSERT_TRUE(second.document.drop_draft().ok());
    rename_first(second, "Theirs");
    ASSERT_TRUE(second.document.save(false).ok());
    EXPECT_EQ(first.document.text(), kept_aside(first)[0]) << "it stays in sight";
    QTemporaryDir elsewhere;
    EXPECT_TRUE(first.document.save_copy(fs::path(elsewhere.path().toStdString()) / "mine.toml").ok());
}

TEST(TwoWindows, who_is_taken_over_steps_back_into_nothing_and_writes_no_looks) {
    QTemporaryDir place;
    Desk first(place.path().toStdString()), second(place.path().toStdString());
    Looks looks(first.app);
    looks.may_write = [&] { return first.document.check_ours(); };
    QStringList said;
    QObject::connect(&first.app, &AppModel::failed, [&](const QString& words) { said << words; });
    first.open();
    rename_first(first, "Mine");
    Look look;
    look.fixtures[0].intensity = 0.5f;
    first.app.set_look(look, "by hand");
    ASSERT_TRUE(looks.store("Mine").ok());
    second.open();
    ASSERT_TRUE(second.document.take_over().ok());
    wait_ms(kUntilSeen_ms);
    ASSERT_TRUE(first.document.is_read_only());
    EXPECT_FALSE(first.app.undo_stack().canUndo());
    const fs::path file = fs::path(first.folder) / "looks.toml";
    const std::string before = *read_text_file(file, 1 << 20);
    const Result<void> stored = looks.store("More");
    ASSERT_FALSE(stored.ok());
    EXPECT_NE(stored.error().text().find("is open in another window"), std::string::npos);
    EXPECT_FALSE(looks.rename("Mine", "Other").ok());
    EXPECT_FALSE(looks.remove("Mine").ok());
    EXPECT_TRUE(looks.recall("Mine", 0).ok()) << "which writes nothing";
    EXPECT_EQ(*read_text_file(file, 1 << 20), before);
    // Of what the other one stores it shows each step, and takes none back.
    ASSERT_TRUE(write_file_atomic(file, std::string("[[look]]\nname = \"Theirs\"\n")).ok());
    for (int i = 0; i < 200 && looks.all()[0].name != "Theirs"; ++i) wait_ms(25);
    ASSERT_EQ(looks.all()[0].name, "Theirs");
    said.clear();
    first.app.undo_stack().undo();
    EXPECT_NE(read_text_file(file, 1 << 20)->find("Theirs"), std::string::npos);
    EXPECT_TRUE(said.join(' ').contains("is open in another window")) << said.join(' ').toStdString();
}

TEST(TwoWindows, who_reads_follows_and_edits_when_the_other_one_closed) {
    QTemporaryDir place;
    auto first = std::make_unique<Desk>(place.path().toStdString());
    first->open();
    Desk second(place.path().toStdString());
    second.open();
    rename_first(*first, "Saved");
    ASSERT_TRUE(first->document.save(false).ok());
    wait_ms(kUntilKept_ms);
    EXPECT_NE(second.document.text().find("Saved"), std::string::npos);
    rename_first(*first, "Not saved");
    first.reset();
    wait_ms(kUntilSeen_ms);
    EXPECT_FALSE(second.document.is_read_only());
    EXPECT_TRUE(second.document.has_draft());
    EXPECT_TRUE(second.document.take_draft().ok());
    EXPECT_NE(second.document.text().find("Not saved"), std::string::npos);
}

TEST(Saving, a_linked_show_file_stays_a_link_and_keeps_its_permissions) {
    QTemporaryDir place;
    const fs::path folder = place.path().toStdString(), target = folder / "tour.toml";
    ASSERT_TRUE(write_file_atomic(target, kShow).ok());
    fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("tour.toml", folder / "show.toml");
    Desk desk(folder.string());
    desk.open();
    rename_first(desk, "Mine");
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_TRUE(fs::is_symlink(folder / "show.toml"));
    EXPECT_NE(read_text_file(target, 1 << 20)->find("Mine"), std::string::npos);
    EXPECT_EQ(fs::status(target).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(Saving, nothing_is_written_through_a_link_out_of_the_folder) {
    QTemporaryDir place, elsewhere;
    const fs::path folder = place.path().toStdString(),
                   target = fs::path(elsewhere.path().toStdString()) / "a";
    ASSERT_TRUE(write_file_atomic(target, kShow).ok());
    fs::create_symlink(target, folder / "show.toml");
    Desk desk(folder.string());
    desk.open();
    rename_first(desk, "Mine");
    const Result<void> saved = desk.document.save(false);
    ASSERT_FALSE(saved.ok());
    EXPECT_NE(saved.error().text().find("show.toml: is a link to"), std::string::npos)
        << saved.error().text();
    EXPECT_EQ(*read_text_file(target, 1 << 20), kShow);
}

TEST(Saving, a_file_that_cannot_be_read_is_not_taken_for_unchanged) {
    Desk desk;
    desk.open();
    rename_first(desk, "Mine");
    const std::string large(std::size_t{17} << 20, '#');
    ASSERT_TRUE(write_file_atomic(desk.file, large).ok());
    const Result<void> saved = desk.document.save(false);
    ASSERT_FALSE(saved.ok());
    EXPECT_NE(saved.error().text().find("nobody can say whether another program changed it"),
              std::string::npos)
        << saved.error().text();
    EXPECT_EQ(fs::file_size(desk.file), large.size());
    EXPECT_TRUE(desk.document.save(true).ok());
}

TEST(Saving, more_than_can_be_read_again_is_neither_taken_nor_written) {
    Desk desk;
    desk.open();
    const auto padded = [&](std::size_t bytes) {
        std::string text = desk.document.text() + "# ";
        text.resize(bytes - 1, '.');
        return ShowDocument::Edit{text + "\n", desk.app.look(), desk.app.selection()};
    };
    const Result<void> refused = desk.document.edit("too much", padded(scene::kMaxShowBytes + 1));
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(
        refused.error().text().find("show.toml: would be 16777217 bytes, and no more than 16777216 are"),
        std::string::npos)
        << refused.error().text();
    EXPECT_FALSE(desk.document.is_changed());
    ASSERT_TRUE(desk.document.edit("as much as goes", padded(scene::kMaxShowBytes)).ok());
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_TRUE(read_text_file(desk.file, scene::kMaxShowBytes).ok()) << "as it is read at the next start";
    EXPECT_FALSE(desk.document.waits_for_answer());
}

TEST(Drafts, shows_in_one_folder_have_their_own) {
    QTemporaryDir place;
    scene::Show show;
    show.folder = place.path().toStdString();
    show.file = show.folder / "show.toml";
    scene::Show tuesday = show;
    tuesday.file = show.folder / "tuesday.toml";
    ASSERT_TRUE(Drafts(tuesday).write("new of tuesday", "tuesday").ok());
    EXPECT_FALSE(Drafts(show).find("monday").has_value());
    ASSERT_TRUE(Drafts(show).write("new of monday", "monday").ok());
    Drafts(show).remove();
    const auto found = Drafts(tuesday).find("tuesday");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->text, "new of tuesday");
}

TEST(Drafts, one_is_offered_up_to_the_limit_of_a_show_file) {
    QTemporaryDir place;
    scene::Show show;
    show.folder = place.path().toStdString();
    show.file = show.folder / "show.toml";
    const Drafts drafts(show);
    const fs::path file = show.folder / ".ghost" / "draft.toml";
    ASSERT_TRUE(drafts.write(std::string(scene::kMaxShowBytes, '#'), "saved").ok());
    const auto longest = drafts.find("saved");
    ASSERT_TRUE(longest.has_value());
    EXPECT_EQ(longest->text.size(), scene::kMaxShowBytes);
    ASSERT_TRUE(drafts.write(std::string(scene::kMaxShowBytes + 1, '#'), "saved").ok());
    EXPECT_FALSE(drafts.find("saved").has_value()) << "no edit would take it";
    fs::resize_file(file, scene::kMaxShowBytes + 129);
    testing::internal::CaptureStderr();
    EXPECT_FALSE(drafts.find("saved").has_value());
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("draft.toml: is 16777345 bytes, more than the limit of 16777344"), std::string::npos)
        << said;
    EXPECT_TRUE(fs::exists(file)) << "it is left where it is";
}

// The place beside the show takes nothing while this lives, as a stick after a fault; what is there stays.
class BesideIsLost {
public:
    explicit BesideIsLost(fs::path beside) : beside_(std::move(beside)) {
        fs::rename(beside_, away());
        EXPECT_TRUE(write_file_atomic(beside_, "full").ok());
    }
    ~BesideIsLost() {
        fs::remove(beside_);
        fs::rename(away(), beside_);
    }

private:
    fs::path away() const { return beside_.parent_path() / "away"; }
    fs::path beside_;
};

TEST(Drafts, the_newest_of_two_places_is_offered) {
    const QTemporaryDir home, place;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    scene::Show show;
    show.folder = place.path().toStdString();
    show.file = show.folder / "show.toml";
    const fs::path file = show.folder / ".ghost" / "draft.toml";
    const Drafts drafts(show);
    qunsetenv("XDG_DATA_HOME");
    ASSERT_TRUE(drafts.write("of ten", "saved").ok());
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::minutes(30));
    {
        const BesideIsLost lost(show.folder / ".ghost");
        ASSERT_TRUE(drafts.write("of half past", "saved").ok());
    }
    ASSERT_TRUE(fs::exists(file));
    auto found = drafts.find("saved");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->text, "of half past");
    found = drafts.find("another show's");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->text, "of half past") << "where both are of another text";

    // One of another show, whose disk was at the same place.
    ASSERT_TRUE(drafts.write("of ten", "saved").ok());
    {
        const BesideIsLost lost(show.folder / ".ghost");
        ASSERT_TRUE(drafts.write("of a stranger", "another show's").ok());
    }
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::minutes(30));
    found = drafts.find("saved");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->text, "of ten");
    EXPECT_TRUE(found->of_this);
    drafts.remove();
    EXPECT_FALSE(drafts.find("saved").has_value());
}

TEST(Drafts, the_last_one_stays_where_both_places_are_full) {
    const QTemporaryDir home, place;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    scene::Show show;
    show.folder = place.path().toStdString();
    show.file = show.folder / "show.toml";
    const Drafts drafts(show);
    qunsetenv("XDG_DATA_HOME");
    ASSERT_TRUE(drafts.write("the last one", "saved").ok());
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit full{1000, before.rlim_max};
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    const Result<void> kept = drafts.write(std::string(5000, '#'), "saved");
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(kept.ok());
    const auto found = drafts.find("saved");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->text, "the last one");
}

TEST(Drafts, one_behind_a_link_is_neither_taken_nor_removed) {
    QTemporaryDir place, elsewhere;
    const fs::path folder = place.path().toStdString(), other = elsewhere.path().toStdString();
    ASSERT_TRUE(write_file_atomic(other / "draft.toml", std::string_view("another show's")).ok());
    fs::create_directory_symlink(other, folder / ".ghost");
    {
        Desk desk(folder.string());
        desk.open();
        EXPECT_FALSE(desk.document.has_draft());
        rename_first(desk, "Mine");
        wait_ms(kUntilKept_ms);
        ASSERT_TRUE(desk.document.save(false).ok());
    }
    EXPECT_EQ(*read_text_file(other / "draft.toml", 1000), "another show's");
    EXPECT_EQ(std::distance(fs::directory_iterator(other), fs::directory_iterator()), 1);
}

} // namespace
} // namespace ghost::ui
