// SPDX-License-Identifier: Apache-2.0
// A show file that somebody else writes, and what comes in the place of a show: hands stay on their heads,
// looks go with the names, and what cannot be taken asks.
#include "support/test_desk.h"

#include "ui/actions/show_actions.h"
#include "ui/model/looks.h"
#include "ui/window/window.h"

#include <QDir>

namespace ghost::ui {
namespace {

const std::string kFirst = R"([[fixture]]
name = "New"
gdtf = "lamp.gdtf"
address = 101

)";

// Before all of them, so that each has another number.
std::string with_one_before(const std::string& text) {
    const std::size_t at = text.find("[[fixture]]");
    return text.substr(0, at) + kFirst + text.substr(at);
}

void hold_last(Desk& desk) {
    Look look;
    look.fixtures[2].intensity = 0.5f;
    look.solo = {2};
    desk.app.set_look(look, "by hand");
    desk.app.select({2});
}

void expect_on_fourth(const Desk& desk) {
    const Look& look = desk.app.look();
    EXPECT_FALSE(look.fixtures.contains(2));
    ASSERT_TRUE(look.fixtures.contains(3));
    EXPECT_EQ(look.fixtures.at(3).intensity, 0.5f);
    EXPECT_EQ(look.solo, std::set<std::size_t>{3});
    EXPECT_EQ(desk.app.selection(), std::set<std::size_t>{3});
}

TEST(Outside, hands_stay_on_their_heads_where_an_editor_puts_one_before_them) {
    Desk desk;
    desk.open();
    hold_last(desk);
    const std::string text = with_one_before(kShow);
    ASSERT_TRUE(write_file_atomic(desk.file, text).ok());
    ASSERT_TRUE(desk.document.reload().ok());
    expect_on_fourth(desk);
    desk.follow();
    expect_on_fourth(desk);
    desk.app.undo_stack().undo();
    desk.follow();
    EXPECT_TRUE(desk.app.look().fixtures.contains(2));
    EXPECT_EQ(desk.app.selection(), std::set<std::size_t>{2});
}

TEST(Outside, what_hands_held_of_a_head_that_is_gone_is_said) {
    Desk desk;
    desk.open();
    hold_last(desk);
    QString said;
    QObject::connect(&desk.app, &AppModel::failed, [&](const QString& words) { said = words; });
    ASSERT_TRUE(write_file_atomic(desk.file, kShow.substr(0, kShow.rfind("[[fixture]]"))).ok());
    ASSERT_TRUE(desk.document.reload().ok());
    EXPECT_TRUE(desk.app.look().fixtures.empty());
    EXPECT_EQ(said, "Not in the show any more, with what hands held of it: 'Lamp 3'");
}

TEST(Outside, hands_of_a_window_that_reads_stay_on_their_heads) {
    QTemporaryDir place;
    Desk first(place.path().toStdString()), second(place.path().toStdString());
    first.open();
    second.open();
    ASSERT_TRUE(second.document.is_read_only());
    hold_last(second);
    ASSERT_TRUE(write_file_atomic(first.file, with_one_before(kShow)).ok());
    for (int i = 0; i < 100 && second.app.show()->fixtures.size() < 4; ++i) wait_ms(20);
    expect_on_fourth(second);
}

TEST(Outside, hands_stay_on_their_heads_where_changes_of_an_earlier_time_are_taken) {
    QTemporaryDir place;
    {
        Desk desk(place.path().toStdString());
        desk.open();
        ASSERT_TRUE(desk.document.edit("added", {with_one_before(kShow), {}, {}}).ok());
    }
    Desk desk(place.path().toStdString());
    desk.open();
    ASSERT_TRUE(desk.document.has_draft());
    hold_last(desk);
    ASSERT_TRUE(desk.document.take_draft().ok());
    expect_on_fourth(desk);
}

// A disk of another machine, of which no watcher hears: saving is what finds it.
TEST(Outside, saving_over_what_another_program_wrote_asks_at_once) {
    Desk desk;
    desk.open();
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.rename("Mine").ok());
    QStringList asked;
    QObject::connect(&desk.document, &ShowDocument::found_changed_outside,
                     [&](const QString& words) { asked << words; });
    ASSERT_TRUE(write_file_atomic(desk.file, kShow + "[haze]\npreset = \"fog\"\n").ok());
    ASSERT_FALSE(desk.document.save(false).ok());
    EXPECT_EQ(asked.size(), 1);
    EXPECT_TRUE(desk.document.waits_for_answer());
    ASSERT_FALSE(desk.document.save(false).ok());
    ASSERT_TRUE(desk.document.save(true).ok());
    EXPECT_FALSE(desk.document.waits_for_answer());
}

TEST(Outside, looks_go_back_to_the_names_that_the_file_has) {
    Desk desk;
    Looks looks(desk.app);
    QObject::connect(&desk.document, &ShowDocument::fixtures_renamed, &looks, &Looks::rename_fixtures);
    desk.open();
    hold_last(desk);
    ASSERT_TRUE(looks.store("Verse").ok());
    ASSERT_TRUE(desk.edit.rename("Front").ok());
    desk.follow();
    const auto name_in_looks = [&] { return looks.all().front().fixtures.begin()->first; };
    ASSERT_EQ(name_in_looks(), "Front");
    const int steps = desk.app.undo_stack().count();
    ASSERT_TRUE(write_file_atomic(desk.file, kShow + "# another program\n").ok());
    ASSERT_TRUE(desk.document.reload().ok());
    EXPECT_EQ(desk.app.undo_stack().count(), steps + 1);
    EXPECT_EQ(name_in_looks(), "Lamp 3");
    EXPECT_TRUE(desk.app.look().fixtures.contains(2)) << "and so do hands";
    desk.follow();
    ASSERT_TRUE(looks.recall("Verse", 0).ok());
    EXPECT_EQ(desk.app.look().fixtures.at(2).intensity, 0.5f);
    desk.app.undo_stack().undo();
    EXPECT_EQ(name_in_looks(), "Front");
}

TEST(Patch, another_mode_lets_go_of_the_levels_of_the_one_before) {
    Desk desk;
    desk.open();
    Look look;
    for (const std::size_t index : {0, 1}) {
        look.fixtures[index].levels.assign(16, 200);
        look.fixtures[index].pan_deg = 30.0f;
    }
    look.fixtures[2].levels.assign(16, 100);
    desk.app.set_look(look, "as it shines");
    desk.app.select({0, 2});
    ASSERT_TRUE(desk.edit.set_mode("Short").ok());
    EXPECT_TRUE(desk.app.look().fixtures.at(0).levels.empty());
    EXPECT_EQ(desk.app.look().fixtures.at(0).pan_deg, 30.0f);
    EXPECT_EQ(desk.app.look().fixtures.at(1).levels.size(), 16u) << "that of another head stays";
    EXPECT_FALSE(desk.app.look().fixtures.contains(2)) << "nothing else was held of it";
    desk.follow();
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.app.look(), look);
    ASSERT_TRUE(desk.edit.set_mode("Standard").ok());
    EXPECT_EQ(desk.app.look(), look) << "the mode that it has";
}

// The show that is open is the one that the plot belongs to: it is read again where it is.
TEST(ImportPlot, the_next_version_is_seen_in_the_show_that_is_open) {
    QTemporaryDir place;
    const QString plot = place.filePath("tour.mvr");
    ASSERT_TRUE(write_file_atomic(plot.toStdString(), std::string("a plot")).ok());
    ASSERT_TRUE(QDir(place.path()).mkdir("tour"));
    const std::string folder = place.filePath("tour").toStdString();
    const std::string text = "[show]\nplot = \"tour.mvr\"\n" + kShow.substr(kShow.find("[[camera]]"));
    ASSERT_TRUE(write_file_atomic(fs::path(folder) / "show.toml", text).ok());
    ASSERT_TRUE(write_file_atomic(fs::path(folder) / "tour.mvr", std::string("a plot")).ok());
    Desk desk(folder);
    desk.app.open(folder);
    desk.open();
    Opened opened = desk.app.opened();
    opened.opens = desk.app.request().opens;
    desk.link.opened.put(std::move(opened));
    desk.link.on_news();
    settle();
    ASSERT_FALSE(desk.app.show()->plot_file.empty());
    const std::uint64_t opens = desk.app.request().opens;
    Jobs& jobs = desk.app.jobs();
    jobs.start("Before it", {"--gtest_filter=-*"}); // the program is this one
    ASSERT_TRUE(import_plot(desk.app, desk.document, plot).ok());
    Job import = jobs.all().back();
    ASSERT_EQ(import.state, Job::State::waits);
    import.state = Job::State::done;
    Q_EMIT jobs.ended(import);
    jobs.cancel(import.number);
    ASSERT_TRUE(desk.app.request().text) << "nothing is read";
    EXPECT_EQ(*desk.app.request().text, text);
    EXPECT_EQ(desk.app.request().opens, opens);
    EXPECT_FALSE(desk.document.is_changed());
    while (jobs.is_busy()) wait_ms(20);
}

struct Received {
    explicit Received(const char* plot_file) {
        window.show();
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->plot_file = plot_file;
        opened.show = show;
        link.opened.put(std::move(opened));
        link.plot.put({1, "inbox/tour.mvr", "Desk", ""});
        link.on_news();
        settle();
        EXPECT_TRUE(window.actions().run("take-plot").ok());
    }
    const ViewRequest& request() { return window.app().request(); }

    Link link;
    Window window{link, {.remembers = false, .width = 900, .height = 600}};
};

TEST(TakePlot, it_is_merged_into_a_show_with_a_plot_and_opened_where_there_is_none) {
    EXPECT_EQ(Received("test/tour.mvr").request().take_plot, 1u);
    Received without("");
    EXPECT_EQ(without.request().take_plot, 0u);
    EXPECT_EQ(without.request().show, "inbox/tour.mvr");
    EXPECT_TRUE(without.window.app().is_opening());
}

} // namespace
} // namespace ghost::ui
