// SPDX-License-Identifier: Apache-2.0
// The model between window and engine: the request goes out whole, news come in, every change of the look
// comes back.
#include "show/show.h"
#include "support/test_window.h"
#include "ui/actions/programmer_actions.h"

#include <QDir>

#include <random>

namespace ghost::ui {
namespace {

TEST(AppModel, news_of_another_thread_arrive_in_the_window) {
    Bench bench;
    int opened = 0;
    QObject::connect(&bench.app, &AppModel::opened_show, [&] { ++opened; });
    EXPECT_EQ(bench.app.show(), nullptr);
    bench.open();
    EXPECT_EQ(opened, 1);
    ASSERT_NE(bench.app.show(), nullptr);
    EXPECT_EQ(bench.app.show()->fixtures.size(), 4u);
    EXPECT_EQ(bench.app.rig().fixtures.size(), 4u);
}

TEST(AppModel, a_show_of_the_working_directory_gets_its_folder) {
    QTemporaryDir place;
    const QString before = QDir::currentPath();
    QDir::setCurrent(place.path());
    ASSERT_TRUE(QFile("tour.mvr").open(QIODevice::WriteOnly));
    Bench bench;
    bench.app.open("tour.mvr");
    EXPECT_EQ(bench.app.request().show, "./tour.mvr");
    bench.app.open("another");
    EXPECT_EQ(bench.app.request().show, "another") << "no file: it is said by this name";
    QDir::setCurrent(before);
}

TEST(AppModel, the_newest_request_is_whole) {
    Bench bench;
    bench.open();
    bench.app.select({1, 2});
    change_selected(bench.app, "intensity", ProgrammerStep::intensity,
                    [](fixture::Programmer& programmer) { programmer.intensity = 0.5f; });
    bench.app.change_request([](ViewRequest& request) { request.black_out = true; });
    const auto request = bench.link.request.take();
    ASSERT_TRUE(request);
    EXPECT_TRUE(request->black_out);
    EXPECT_EQ(request->explained, 1u);
    EXPECT_EQ(request->look.fixtures.size(), 2u);
    EXPECT_EQ(request->look.fixtures.at(2).intensity, 0.5f);
    EXPECT_FALSE(bench.link.request.take());
}

TEST(AppModel, another_show_forgets_what_was_done_to_the_one_before) {
    Bench bench;
    bench.open();
    bench.app.select({3});
    change_selected(bench.app, "zoom", ProgrammerStep::zoom,
                    [](fixture::Programmer& programmer) { programmer.zoom_deg = 10; });
    bench.open();
    EXPECT_TRUE(bench.app.look().is_empty());
    EXPECT_TRUE(bench.app.selection().empty());
    EXPECT_FALSE(bench.app.undo_stack().canUndo());
    bench.app.select({2, 99});
    EXPECT_EQ(bench.app.selection(), std::set<std::size_t>{2}); // there is no 99
}

TEST(AppModel, another_show_is_as_bright_as_it_is) {
    Bench bench;
    bench.open();
    bench.app.change_request([](ViewRequest& request) { request.master = 0.25f; });
    bench.open();
    EXPECT_EQ(bench.app.request().master, 1);
}

// Take on the page of a plot, and "Make a show of it": to whoever sees it that is the same stage.
TEST(AppModel, a_show_that_is_made_of_the_plot_that_is_open_keeps_what_hands_hold) {
    Bench bench;
    const auto put = [&](Opened opened, bool is_turned, bool is_plot) {
        auto show = std::make_shared<scene::Show>(*opened.show);
        for (std::size_t i = 0; i < show->fixtures.size(); ++i)
            show->fixtures[i].uuid = "uuid " + show->fixtures[i].name;
        if (is_turned) {
            std::reverse(show->fixtures.begin(), show->fixtures.end());
            show->fixtures.erase(show->fixtures.begin() + 1); // Lamp 3
            show->fixtures.back().name = "Front 1";           // Lamp 1
            std::swap(opened.objects[0], opened.objects[1]);
            std::swap(opened.objects[0].instance, opened.objects[1].instance);
        }
        if (is_plot) show->file = show->plot_file = "tour.mvr";
        opened.show = show;
        opened.opens = bench.app.request().opens;
        bench.link.opened.put(std::move(opened));
        bench.link.on_news();
        settle();
    };
    bench.app.open("tour.mvr");
    put(four_lamps(), false, true);
    Look look;
    for (std::size_t i = 0; i < 4; ++i) look.fixtures[i].intensity = 0.25f * static_cast<float>(i + 1);
    look.shown[1] = false;
    look.scene.smoke = 2.0f;
    bench.app.set_look(look, "by hand");
    bench.app.select({0, 2, 3});
    QString said;
    QObject::connect(&bench.app, &AppModel::failed, [&](const QString& words) { said = words; });
    bench.app.open_made_of_plot("tour");
    put(four_lamps(), true, false);
    EXPECT_EQ(said, "Not in the show any more, with what hands held of it: 'Lamp 3'");
    const Look& now = bench.app.look();
    ASSERT_EQ(now.fixtures.size(), 3u) << "all but the one that is gone";
    EXPECT_EQ(now.fixtures.at(0).intensity, 1.0f);
    EXPECT_EQ(now.fixtures.at(1).intensity, 0.5f);
    EXPECT_EQ(now.fixtures.at(2).intensity, 0.25f);
    EXPECT_EQ(now.shown, (std::map<std::size_t, bool>{{0, false}}));
    EXPECT_EQ(now.scene.smoke, 2.0f);
    EXPECT_EQ(bench.app.selection(), (std::set<std::size_t>{0, 2}));
    EXPECT_EQ(bench.app.request().look, now);
    EXPECT_EQ(bench.app.request().explained, 0u);
    bench.app.open("another");
    put(four_lamps(), false, false);
    EXPECT_TRUE(bench.app.look().is_empty());
    EXPECT_TRUE(bench.app.selection().empty());
}

// Taken from the network while one works by hand.
TEST(AppModel, a_newer_plot_of_the_show_keeps_what_hands_hold) {
    Bench bench;
    bench.open();
    Look look;
    for (std::size_t i = 0; i < 4; ++i) look.fixtures[i].intensity = 0.25f * static_cast<float>(i + 1);
    bench.app.set_look(look, "by hand");
    bench.app.select({0, 3});
    Opened newer = four_lamps();
    auto show = std::make_shared<scene::Show>(*newer.show);
    show->fixtures.erase(show->fixtures.begin() + 1);
    newer.show = show;
    newer.again = true;
    newer.opens = bench.app.request().opens;
    bench.link.opened.put(std::move(newer));
    bench.link.on_news();
    settle();
    ASSERT_EQ(bench.app.look().fixtures.size(), 3u);
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 0.25f);
    EXPECT_EQ(bench.app.look().fixtures.at(1).intensity, 0.75f);
    EXPECT_EQ(bench.app.look().fixtures.at(2).intensity, 1.0f);
    EXPECT_EQ(bench.app.selection(), (std::set<std::size_t>{0, 2}));
    EXPECT_EQ(bench.app.request().look, bench.app.look());
}

TEST(AppModel, a_slider_is_one_step_and_different_things_are_two) {
    Bench bench;
    bench.open();
    bench.app.select({0});
    for (int i = 1; i <= 10; ++i)
        change_selected(
            bench.app, "intensity", ProgrammerStep::intensity,
            [&](fixture::Programmer& programmer) { programmer.intensity = 0.1f * static_cast<float>(i); });
    change_selected(bench.app, "pan", ProgrammerStep::pan,
                    [](fixture::Programmer& programmer) { programmer.pan_deg = 20; });
    EXPECT_EQ(bench.app.undo_stack().count(), 2);
    bench.app.undo_stack().undo();
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 1.0f);
    EXPECT_FALSE(bench.app.look().fixtures.at(0).pan_deg);
    bench.app.undo_stack().undo();
    EXPECT_TRUE(bench.app.look().is_empty());
}

TEST(AppModel, a_slider_that_goes_on_for_something_else_is_another_step) {
    Bench bench;
    bench.open();
    const auto set_intensity = [&](float intensity) {
        change_selected(bench.app, "intensity", ProgrammerStep::intensity,
                        [&](fixture::Programmer& programmer) { programmer.intensity = intensity; });
    };
    bench.app.select({0});
    set_intensity(0.5f);
    set_intensity(0.8f);
    bench.app.select({1});
    set_intensity(0.6f);
    set_intensity(0.7f);
    EXPECT_EQ(bench.app.undo_stack().count(), 2);
    bench.app.undo_stack().undo();
    EXPECT_FALSE(bench.app.look().fixtures.contains(1));
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 0.8f) << "that of another head stays";
    const auto set_scene = [&](const QString& text, std::optional<float> SceneLook::*value, float number) {
        change_scene(bench.app, text, ProgrammerStep::scene,
                     [&](SceneLook& scene) { scene.*value = number; });
    };
    set_scene("smoke", &SceneLook::smoke, 2);
    set_scene("smoke", &SceneLook::smoke, 3);
    set_scene("even light", &SceneLook::ambient_lux, 5);
    EXPECT_EQ(bench.app.undo_stack().count(), 3);
    bench.app.undo_stack().undo();
    EXPECT_EQ(bench.app.look().scene.smoke, 3.0f) << "the even light alone";
    const auto set_surface = [&](std::size_t object, float specular) {
        bench.app.mark(object);
        Look look = bench.app.look();
        look.surfaces[object].specular = specular;
        bench.app.set_look(std::move(look), "specular", static_cast<int>(ProgrammerStep::surface));
    };
    set_surface(0, 0.25f);
    set_surface(1, 0.75f);
    bench.app.undo_stack().undo();
    EXPECT_EQ(bench.app.look().surfaces.at(0).specular, 0.25f) << "that of the other object";
}

TEST(AppModel, a_fade_goes_on_through_an_edit_that_leaves_the_heads_as_they_are) {
    Bench bench;
    bench.open();
    bench.app.select({0});
    Look look;
    look.fixtures[0].intensity = 1.0f;
    bench.app.fade_to(look, "look", 60);
    ASSERT_TRUE(bench.app.fades());
    scene::Show with_note = *bench.app.show();
    with_note.cues.emplace_back().name = "Verse";
    const auto edit = [&](const scene::Show& show, const Look& now) {
        bench.app.put_edit(std::make_shared<const std::string>("text"), show, now, {0});
    };
    float most = 0;
    QObject::connect(&bench.app, &AppModel::request_changed, [&] {
        const auto found = bench.app.request().look.fixtures.find(0);
        if (found != bench.app.request().look.fixtures.end())
            most = std::max(most, found->second.intensity.value_or(0));
    });
    edit(with_note, bench.app.look());
    EXPECT_TRUE(bench.app.fades());
    EXPECT_LT(most, 0.5f) << "nor is its end asked for in between";
    EXPECT_EQ(bench.app.look(), look);
    scene::Show with_one_less = with_note;
    with_one_less.fixtures.pop_back();
    edit(with_one_less, bench.app.look());
    EXPECT_FALSE(bench.app.fades());
    EXPECT_EQ(bench.app.request().look.fixtures.at(0).intensity, 1.0f);
}

// A plot's next version beside the show, and any file that it names.
TEST(AppModel, files_that_are_others_are_read_again_and_hands_stay_on_their_heads) {
    Bench bench;
    bench.open();
    Look look;
    look.fixtures[2].intensity = 0.5f;
    look.solo = {2};
    look.shown[1] = false;
    look.surfaces[1].specular = 1.0f;
    bench.app.set_look(look, "by hand");
    bench.app.select({2});
    bench.app.mark(1);
    const auto text = std::make_shared<const std::string>("the same");
    const std::uint64_t opens = bench.app.request().opens;
    bench.app.read_again(text);
    EXPECT_EQ(bench.app.request().text, text);
    EXPECT_EQ(bench.app.request().opens, opens) << "camera and recording stay";
    Opened next = four_lamps();
    auto show = std::make_shared<scene::Show>(*next.show);
    scene::PatchedFixture added;
    added.name = "Before all of them";
    show->fixtures.insert(show->fixtures.begin(), added);
    next.show = show;
    next.objects = {{"New", 0, 0}, {"Floor", 1, 1}, {"Wall", 2, 2}};
    next.materials = {{}, next.materials[0], next.materials[1]};
    next.is_edit = true;
    next.text = text;
    bench.link.opened.put(std::move(next));
    bench.link.on_news();
    settle();
    Look now;
    now.fixtures[3].intensity = 0.5f;
    now.solo = {3};
    now.shown[2] = false;
    now.surfaces[2].specular = 1.0f;
    EXPECT_EQ(bench.app.look(), now);
    EXPECT_EQ(bench.app.request().look.fixtures.at(3).intensity, 0.5f);
    EXPECT_EQ(bench.app.selection(), std::set<std::size_t>{3});
    EXPECT_EQ(bench.app.marked(), 2u);
    EXPECT_FALSE(bench.app.undo_stack().canUndo()) << "steps count the heads as they were";
}

// An object keeps its mark by name: number 1 of another model is another thing.
TEST(AppModel, a_chosen_object_is_chosen_in_another_stage_where_that_has_it) {
    Bench bench;
    bench.open();
    bench.app.mark(1);
    const auto take = [&](const std::vector<Object>& objects) {
        Opened next = bench.app.opened();
        next.objects = objects;
        next.is_edit = true;
        bench.link.opened.put(std::move(next));
        bench.link.on_news();
        settle();
    };
    take({{"Wall", 0, 0}, {"Floor", 1, 1}});
    EXPECT_EQ(bench.app.marked(), 0u);
    take({{"Curtain", 0, 0}, {"Sofa", 1, 1}});
    EXPECT_EQ(bench.app.marked(), std::nullopt);
}

TEST(AppModel, a_show_that_fails_says_nothing_of_the_one_that_is_asked_for_now) {
    Bench bench;
    bench.open();
    int not_opened = 0;
    QStringList failures;
    QObject::connect(&bench.app, &AppModel::not_opened, [&] { ++not_opened; });
    QObject::connect(&bench.app, &AppModel::failed, [&](const QString& words) { failures << words; });
    const auto fail = [&](std::uint64_t opens) {
        bench.link.not_opened.put({Error{"is not TOML", "broken.toml"}, opens});
        bench.link.on_news();
        settle();
    };
    bench.app.open("broken.toml");
    const std::uint64_t broken = bench.app.request().opens;
    bench.app.open("tour");
    fail(broken);
    EXPECT_EQ(failures, QStringList{"broken.toml: is not TOML"});
    EXPECT_EQ(not_opened, 0);
    EXPECT_TRUE(bench.app.is_opening());
    EXPECT_FALSE(bench.app.open_error());
    fail(bench.app.request().opens);
    EXPECT_EQ(not_opened, 1);
    EXPECT_FALSE(bench.app.is_opening());
}

TEST(AppModel, what_a_received_plot_took_the_place_of_can_be_opened_again) {
    Bench bench;
    bench.app.open("venue.mvr");
    const auto put = [&](const char* file, bool again) {
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->file = show->plot_file = file;
        opened.show = show;
        opened.again = again;
        opened.opens = bench.app.request().opens;
        bench.link.opened.put(std::move(opened));
        bench.link.on_news();
        settle();
    };
    put("venue.mvr", false);
    const std::uint64_t opens = bench.app.request().opens;
    bench.app.open("venue.mvr");
    EXPECT_EQ(bench.app.request().opens, opens) << "it is open";
    put("inbox/tour.mvr", true);
    bench.app.open("venue.mvr");
    EXPECT_EQ(bench.app.request().opens, opens + 1);
}

TEST(AppModel, releasing_leaves_nothing_behind) {
    Bench bench;
    bench.open();
    bench.app.select({0, 1});
    change_selected(bench.app, "tilt", ProgrammerStep::tilt,
                    [](fixture::Programmer& programmer) { programmer.tilt_deg = 5; });
    change_selected(bench.app, "release", ProgrammerStep::step,
                    [](fixture::Programmer& programmer) { programmer = {}; });
    EXPECT_TRUE(bench.app.look().is_empty());
}

// Any changes, undos and redos: all undone is the beginning, all redone is the end.
TEST(AppModel, any_sequence_comes_back_to_the_same_look) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Bench bench;
        bench.open();
        std::mt19937 random(seed);
        const auto below = [&](std::uint32_t count) { return random() % count; };
        for (int step = 0; step < 200; ++step) {
            Look look = bench.app.look();
            const float value = static_cast<float>(below(100)) / 100.0f;
            fixture::Programmer& programmer = look.fixtures[below(4)];
            switch (below(8)) {
            case 0:
                programmer.intensity = value;
                break;
            case 1:
                programmer.colour = glm::vec3(value, 1, 0);
                break;
            case 2:
                programmer = {};
                break;
            case 3:
                look.scene.smoke = value;
                break;
            case 4:
                look.shown[below(2)] = below(2) == 0;
                break;
            case 5:
                look.surfaces[below(2)].specular = value;
                break;
            case 6:
                bench.app.undo_stack().undo();
                continue;
            default:
                bench.app.undo_stack().redo();
                continue;
            }
            bench.app.set_look(look, "change", static_cast<int>(below(4)));
        }
        const Look end = bench.app.look();
        while (bench.app.undo_stack().canUndo()) bench.app.undo_stack().undo();
        EXPECT_TRUE(bench.app.look().is_empty()) << "seed " << seed;
        // Redo goes to the last look that was made, which is the end unless the walk ended with undos.
        while (bench.app.undo_stack().canRedo()) bench.app.undo_stack().redo();
        const Look last = bench.app.look();
        while (bench.app.undo_stack().canUndo() && bench.app.look() != end) bench.app.undo_stack().undo();
        EXPECT_EQ(bench.app.look(), end) << "seed " << seed;
        while (bench.app.undo_stack().canRedo()) bench.app.undo_stack().redo();
        EXPECT_EQ(bench.app.look(), last) << "seed " << seed;
    }
}

TEST(AppModel, a_travel_ends_at_the_camera_and_a_hand_ends_a_travel) {
    Bench bench;
    bench.open();
    bench.app.set_size(320, 180);
    const scene::Camera side = bench.app.show()->cameras[1];
    bench.app.travel_to(side);
    EXPECT_TRUE(bench.app.travels());
    while (bench.app.travels()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_EQ(bench.app.camera().position_m, side.position_m);
    EXPECT_EQ(bench.app.camera().width, 320); // of the window, not of the show
    bench.app.travel_to(bench.app.show()->cameras[0]);
    bench.app.set_camera(bench.app.camera());
    EXPECT_FALSE(bench.app.travels());
}

} // namespace
} // namespace ghost::ui
