// SPDX-License-Identifier: Apache-2.0
// The cue list: one cue after the other, what follows by itself, edits that are undone to the same bytes.
#include "show_folder/load_show.h"
#include "support/test_desk.h"
#include "ui/actions/cue_list.h"
#include "ui/panels/cue_panel.h"

namespace ghost::ui {
namespace {

const std::string kCues = R"(
[[cue]] # the beginning
name = "Dark"
look = "Blue"
follow_s = 0.3

[[cue]]
name = "Solo"
camera = "front"
notes = "when she turns round"
)";
const std::string kLooks = R"([[look]]
name = "Blue"
[[look.fixture]]
name = "Lamp 1"
intensity = 0.25
)";

struct CueDesk : Desk {
    CueDesk() {
        EXPECT_TRUE(write_file_atomic(file, kShow + kCues).ok());
        EXPECT_TRUE(write_file_atomic(file.parent_path() / "looks.toml", kLooks).ok());
        open();
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const scene::Cue& cue : cues.all()) all.push_back(cue.name);
        return all;
    }
    Looks looks{app};
    CueList cues{app, document, looks};
};

TEST(CueList, go_recalls_the_look_and_what_follows_goes_by_itself) {
    CueDesk desk;
    EXPECT_EQ(desk.names(), (std::vector<std::string>{"Dark", "Solo"}));
    EXPECT_NE(desk.cues.back().error().text().find("first cue"), std::string::npos);
    ASSERT_TRUE(desk.cues.go().ok());
    EXPECT_EQ(desk.cues.current(), 0u);
    EXPECT_EQ(desk.app.look().fixtures.at(0).intensity, 0.25f);
    EXPECT_GE(desk.cues.follows_in_s(), 0);
    wait_ms(600);
    EXPECT_EQ(desk.cues.current(), 1u) << "it followed";
    EXPECT_LT(desk.cues.follows_in_s(), 0);
    EXPECT_EQ(desk.app.camera().name, "front");
    EXPECT_NE(desk.cues.go().error().text().find("last cue"), std::string::npos);
    ASSERT_TRUE(desk.cues.back().ok());
    EXPECT_EQ(desk.cues.current(), 0u);
}

TEST(CueList, who_goes_back_or_to_a_cue_by_hand_stands_there) {
    CueDesk desk;
    ASSERT_TRUE(desk.cues.go().ok());
    ASSERT_TRUE(desk.cues.go().ok());
    ASSERT_TRUE(desk.cues.back().ok());
    EXPECT_LT(desk.cues.follows_in_s(), 0);
    wait_ms(600); // the cue follows after 0.3 s
    EXPECT_EQ(desk.cues.current(), 0u) << "it followed again";
    ASSERT_TRUE(desk.cues.call(0).ok());
    wait_ms(600);
    EXPECT_EQ(desk.cues.current(), 0u) << "a cue that was chosen followed";
    ASSERT_TRUE(desk.cues.go().ok()) << "go goes on from there";
    EXPECT_EQ(desk.cues.current(), 1u);
}

// Going back while the next one is about to come by itself: it does not come.
TEST(CueList, back_ends_what_was_about_to_follow) {
    CueDesk desk;
    ASSERT_TRUE(desk.cues.set(1, "follow", "0.3").ok());
    desk.follow();
    ASSERT_TRUE(desk.cues.add("Last", "Blue").ok());
    desk.follow();
    ASSERT_TRUE(desk.cues.go().ok());
    ASSERT_TRUE(desk.cues.go().ok());
    EXPECT_GE(desk.cues.follows_in_s(), 0);
    ASSERT_TRUE(desk.cues.back().ok());
    wait_ms(600);
    EXPECT_EQ(desk.cues.current(), 0u);
}

TEST(CueList, edits_keep_comments_and_are_undone_to_the_same_bytes) {
    CueDesk desk;
    const std::string before = desk.document.text();
    ASSERT_TRUE(desk.cues.set(0, "fade", "2.5").ok());
    desk.follow();
    EXPECT_EQ(desk.cues.all()[0].fade_s, 2.5f);
    EXPECT_NE(desk.document.text().find("# the beginning"), std::string::npos);
    ASSERT_TRUE(desk.cues.set(0, "number", "47.5").ok());
    desk.follow();
    ASSERT_TRUE(desk.cues.set(0, "page", "12").ok());
    desk.follow();
    EXPECT_EQ(desk.cues.all()[0].number, "47.5");
    EXPECT_EQ(desk.cues.all()[0].page, "12");
    EXPECT_NE(desk.document.text().find("number = \"47.5\""), std::string::npos);
    ASSERT_TRUE(desk.cues.move(1, -1).ok());
    desk.follow();
    EXPECT_EQ(desk.names(), (std::vector<std::string>{"Solo", "Dark"}));
    ASSERT_TRUE(desk.cues.add("", "Blue").ok());
    desk.follow();
    EXPECT_EQ(desk.names(), (std::vector<std::string>{"Solo", "Dark", "Blue"}));
    ASSERT_TRUE(desk.cues.remove(0).ok());
    desk.follow();
    EXPECT_EQ(desk.names(), (std::vector<std::string>{"Dark", "Blue"}));
    while (desk.app.undo_stack().canUndo()) desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), before);
}

TEST(CueList, what_a_cue_cannot_be_is_refused_in_words) {
    CueDesk desk;
    const auto error = [&](std::size_t index, const char* what, const char* words) {
        const Result<void> done = desk.cues.set(index, what, words);
        return done.ok() ? std::string() : done.error().text();
    };
    EXPECT_NE(error(0, "name", "Solo").find("another cue is called 'Solo'"), std::string::npos);
    EXPECT_NE(error(0, "look", "Blu").find("did you mean 'Blue'"), std::string::npos);
    EXPECT_NE(error(0, "fade", "4000").find("from 0 to 3600"), std::string::npos);
    EXPECT_NE(error(0, "follow", "soon").find("is no number of seconds"), std::string::npos);
    EXPECT_NE(error(0, "look", "").find("needs a look, a camera or a place"), std::string::npos);
    EXPECT_NE(error(0, "colour", "1").find("is none of name, number, look"), std::string::npos);
    EXPECT_NE(error(7, "name", "x").find("no cue number 8"), std::string::npos);
}

TEST(CueList, with_the_recording_cues_come_by_at_their_seconds) {
    CueDesk desk;
    ASSERT_TRUE(desk.cues.set(1, "at", "10").ok());
    desk.follow();
    desk.cues.set_follows_recording(true);
    const auto play = [&](double at_s) {
        RigNow rig = four_lit();
        rig.recording_s = 60;
        rig.at_s = at_s;
        desk.link.rig.put(std::move(rig));
        desk.link.on_news();
        settle();
    };
    play(9.9);
    EXPECT_FALSE(desk.cues.current());
    const std::uint64_t seeks = desk.app.request().transport.seeks;
    play(10.02);
    EXPECT_EQ(desk.cues.current(), 1u);
    EXPECT_EQ(desk.app.request().transport.seeks, seeks) << "it is there already";
}

// Five of one look, called up to the third.
struct FiveCues : Desk {
    FiveCues() {
        std::string text = kShow;
        for (const char* const name : {"A", "B", "C", "D", "E"})
            text += std::string("[[cue]]\nname = \"") + name + "\"\nlook = \"Blue\"\n";
        EXPECT_TRUE(write_file_atomic(file, text).ok());
        EXPECT_TRUE(write_file_atomic(file.parent_path() / "looks.toml", kLooks).ok());
        open();
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(cues.go().ok());
        (void)link.cue.take();
    }
    std::string called() const { return cues.current() ? cues.all()[*cues.current()].name : ""; }
    std::string next() const {
        const std::size_t place = cues.current() ? *cues.current() + 1 : 0;
        return place < cues.all().size() ? cues.all()[place].name : "";
    }
    Looks looks{app};
    CueList cues{app, document, looks};
};

TEST(CueList, the_called_one_stays_it_where_others_are_removed_moved_or_added) {
    FiveCues desk;
    ASSERT_EQ(desk.called(), "C");
    ASSERT_TRUE(desk.cues.remove(0).ok());
    EXPECT_EQ(desk.called(), "C") << "before the engine has it";
    desk.follow();
    EXPECT_EQ(desk.called(), "C");
    EXPECT_EQ(desk.next(), "D");
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.called(), "C");
    ASSERT_TRUE(desk.cues.move(2, -1).ok());
    EXPECT_EQ(desk.called(), "C");
    EXPECT_EQ(desk.next(), "B");
    desk.app.undo_stack().undo();
    ASSERT_TRUE(desk.cues.move(3, -1).ok()); // its neighbour
    EXPECT_EQ(desk.called(), "C");
    EXPECT_EQ(desk.next(), "E");
}

TEST(CueList, where_the_called_one_is_removed_go_goes_to_what_was_behind_it) {
    FiveCues desk;
    ASSERT_TRUE(desk.cues.remove(2).ok());
    desk.follow();
    EXPECT_EQ(desk.called(), "B");
    EXPECT_EQ(desk.next(), "D");
    EXPECT_EQ(desk.link.cue.take(), "B") << "a tablet's go is that, too";
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.called(), "C") << "it is on stage";
    ASSERT_TRUE(desk.cues.call(0).ok());
    ASSERT_TRUE(desk.cues.remove(0).ok());
    EXPECT_EQ(desk.called(), "");
    EXPECT_EQ(desk.next(), "B");
}

TEST(CueList, the_called_one_keeps_its_place_under_another_name) {
    FiveCues desk;
    ASSERT_TRUE(desk.cues.set(2, "name", "Chorus").ok());
    desk.follow();
    EXPECT_EQ(desk.called(), "Chorus");
    EXPECT_EQ(desk.link.cue.take(), "Chorus");
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.called(), "C");
    EXPECT_EQ(desk.link.cue.take(), "C");
}

TEST(CueList, another_show_follows_no_recording_and_is_in_no_cue) {
    FiveCues desk;
    desk.cues.set_follows_recording(true);
    desk.open();
    EXPECT_EQ(desk.called(), "");
    EXPECT_FALSE(desk.cues.follows_recording());
}

// A look that another program took away: the camera is taken, and the list goes on.
TEST(CueList, a_cue_that_lacks_its_look_does_what_it_can_and_holds_up_nobody) {
    CueDesk desk;
    ASSERT_TRUE(desk.cues.set(0, "camera", "front").ok());
    desk.follow();
    ASSERT_TRUE(write_file_atomic(desk.file.parent_path() / "looks.toml", "").ok());
    wait_ms(300);
    ASSERT_TRUE(desk.looks.all().empty());
    scene::Camera elsewhere = desk.app.camera();
    elsewhere.name = "elsewhere";
    desk.app.set_camera(elsewhere);
    const Result<void> done = desk.cues.go();
    ASSERT_FALSE(done.ok());
    EXPECT_NE(done.error().text().find("Blue"), std::string::npos) << done.error().text();
    EXPECT_EQ(desk.cues.current(), 0u);
    EXPECT_EQ(desk.app.camera().name, "front");
    EXPECT_TRUE(desk.cues.go().ok());
    EXPECT_EQ(desk.cues.current(), 1u);
}

TEST(CueList, a_look_that_cues_recall_is_not_removed_and_its_new_name_is_theirs) {
    CueDesk desk;
    QObject::connect(&desk.looks, &Looks::renamed, [&](const QString& name, const QString& to) {
        EXPECT_TRUE(desk.cues.rename_look(name.toStdString(), to.toStdString()).ok());
    });
    const Result<void> removed = desk.looks.remove("Blue");
    ASSERT_FALSE(removed.ok());
    EXPECT_NE(removed.error().text().find("cue 'Dark' recalls it"), std::string::npos);
    const std::string before = desk.document.text();
    const int steps = desk.app.undo_stack().count();
    ASSERT_TRUE(desk.looks.rename("Blue", "Deep blue").ok());
    desk.follow();
    EXPECT_EQ(desk.cues.all()[0].look, "Deep blue");
    EXPECT_EQ(desk.app.undo_stack().count(), steps + 1) << "one step";
    EXPECT_TRUE(desk.cues.go().ok());
    desk.app.undo_stack().undo(); // the recall
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), before);
    EXPECT_EQ(desk.looks.all()[0].name, "Blue");
    desk.app.undo_stack().redo();
    EXPECT_EQ(desk.cues.all()[0].look, "Deep blue");
    EXPECT_EQ(desk.looks.all()[0].name, "Deep blue");
}

// Cues at seconds, and a recording of a minute that plays.
struct PlayedCues : Desk {
    explicit PlayedCues(const std::string& seconds) {
        std::string text = kShow;
        int number = 0;
        for (const QString& at_s : QString::fromStdString(seconds).split(' '))
            text += "[[cue]]\nname = \"Cue " + std::to_string(++number) + "\"\nat_s = " + at_s.toStdString() +
                    "\ncamera = \"front\"\n";
        EXPECT_TRUE(write_file_atomic(file, text).ok());
        open();
        cues.set_follows_recording(true);
    }
    void play(double at_s) {
        RigNow rig = four_lit();
        rig.recording_s = 60;
        rig.at_s = at_s;
        rig.seeks = app.request().transport.seeks;
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
    Looks looks{app};
    CueList cues{app, document, looks};
};

TEST(CueList, one_at_the_beginning_comes_each_time_that_it_is_played) {
    PlayedCues desk("0.0 30.0");
    desk.play(0);
    EXPECT_FALSE(desk.cues.current()) << "nothing plays yet";
    desk.play(0.04);
    EXPECT_EQ(desk.cues.current(), 0u);
    desk.play(29.9);
    desk.play(30.1);
    EXPECT_EQ(desk.cues.current(), 1u);
    desk.play(59.9);
    desk.play(0.02);
    EXPECT_EQ(desk.cues.current(), 0u) << "it came round";
    desk.play(29.9);
    desk.play(30.1);
    desk.jump(0);
    desk.play(0);
    EXPECT_EQ(desk.cues.current(), 1u) << "it stands there";
    desk.play(0.04);
    EXPECT_EQ(desk.cues.current(), 0u) << "back to the start, and on";
}

TEST(CueList, one_at_the_beginning_of_a_loop_comes_in_each_round) {
    PlayedCues desk("12.0 14.0");
    desk.app.change_request([](ViewRequest& request) {
        request.transport.loop_from_s = 12;
        request.transport.loop_to_s = 16;
    });
    desk.play(13.9);
    desk.play(14.1);
    EXPECT_EQ(desk.cues.current(), 1u);
    desk.play(15.9);
    desk.play(12.1);
    EXPECT_EQ(desk.cues.current(), 0u);
    desk.play(13.9);
    desk.play(13.88); // time code that jitters
    EXPECT_EQ(desk.cues.current(), 0u);
}

TEST(CueList, all_that_stand_at_one_second_come) {
    PlayedCues desk("10.0 10.0 20.0");
    int called = 0;
    QObject::connect(&desk.cues, &CueList::changed, [&] { ++called; });
    desk.play(9.9);
    desk.play(10.1);
    EXPECT_EQ(called, 2);
    EXPECT_EQ(desk.cues.current(), 1u);
    desk.jump(40);
    desk.play(40.1);
    EXPECT_EQ(desk.cues.current(), 1u) << "what was jumped over does not come";
}

TEST(Cues, a_show_file_says_what_is_wrong_with_them) {
    QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("show.toml").toStdString();
    ASSERT_TRUE(write_file_atomic(file,
                                  "[show]\n[[camera]]\nname = \"front\"\n[[cue]]\nname = \"A\"\nlook = "
                                  "\"None\"\nfollow_s = -1\n[[cue]]\nname = \"B\"\nnotes = \"nowhere\"\n")
                    .ok());
    Report report;
    const auto show = scene::load_show(file, false, report);
    ASSERT_TRUE(show.ok());
    std::string all;
    for (const Message& message : report.messages) all += message.where + ": " + message.what + "\n";
    EXPECT_NE(all.find("show.toml:4: [[cue]] names look 'None'"), std::string::npos) << all;
    EXPECT_NE(all.find("follow_s"), std::string::npos) << all;
    EXPECT_NE(all.find("show.toml:8: [[cue]] at_s is missing"), std::string::npos) << all;
}

} // namespace
} // namespace ghost::ui
