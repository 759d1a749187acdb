// SPDX-License-Identifier: Apache-2.0
// The studio between window and engine: wishes go out whole, news come in, every change of the look comes
// back.
#include "support/test_window.h"
#include "ui/actions/hand.h"

#include <random>

namespace ghost::ui {
namespace {

TEST(Studio, news_of_another_thread_arrive_in_the_window) {
    Bench bench;
    int opened = 0;
    QObject::connect(&bench.studio, &Studio::opened_show, [&] { ++opened; });
    EXPECT_EQ(bench.studio.show(), nullptr);
    bench.open();
    EXPECT_EQ(opened, 1);
    ASSERT_NE(bench.studio.show(), nullptr);
    EXPECT_EQ(bench.studio.show()->fixtures.size(), 4u);
    EXPECT_EQ(bench.studio.rig().fixtures.size(), 4u);
}

TEST(Studio, the_newest_wish_is_whole) {
    Bench bench;
    bench.open();
    bench.studio.select({1, 2});
    change_selected(bench.studio, "intensity", Hand::intensity,
                    [](fixture::Manual& manual) { manual.intensity = 0.5f; });
    bench.studio.wish([](Wishes& wishes) { wishes.black_out = true; });
    const auto wishes = bench.link.wishes.take();
    ASSERT_TRUE(wishes);
    EXPECT_TRUE(wishes->black_out);
    EXPECT_EQ(wishes->explained, 1u);
    EXPECT_EQ(wishes->look.fixtures.size(), 2u);
    EXPECT_EQ(wishes->look.fixtures.at(2).intensity, 0.5f);
    EXPECT_FALSE(bench.link.wishes.take());
}

TEST(Studio, another_show_forgets_what_was_done_to_the_one_before) {
    Bench bench;
    bench.open();
    bench.studio.select({3});
    change_selected(bench.studio, "zoom", Hand::zoom, [](fixture::Manual& manual) { manual.zoom_deg = 10; });
    bench.open();
    EXPECT_TRUE(bench.studio.look().is_empty());
    EXPECT_TRUE(bench.studio.selection().empty());
    EXPECT_FALSE(bench.studio.undo_stack().canUndo());
    bench.studio.select({2, 99});
    EXPECT_EQ(bench.studio.selection(), std::set<std::size_t>{2}); // there is no 99
}

TEST(Studio, a_slider_is_one_step_and_different_things_are_two) {
    Bench bench;
    bench.open();
    bench.studio.select({0});
    for (int i = 1; i <= 10; ++i)
        change_selected(bench.studio, "intensity", Hand::intensity,
                        [&](fixture::Manual& manual) { manual.intensity = 0.1f * static_cast<float>(i); });
    change_selected(bench.studio, "pan", Hand::pan, [](fixture::Manual& manual) { manual.pan_deg = 20; });
    EXPECT_EQ(bench.studio.undo_stack().count(), 2);
    bench.studio.undo_stack().undo();
    EXPECT_EQ(bench.studio.look().fixtures.at(0).intensity, 1.0f);
    EXPECT_FALSE(bench.studio.look().fixtures.at(0).pan_deg);
    bench.studio.undo_stack().undo();
    EXPECT_TRUE(bench.studio.look().is_empty());
}

TEST(Studio, releasing_leaves_nothing_behind) {
    Bench bench;
    bench.open();
    bench.studio.select({0, 1});
    change_selected(bench.studio, "tilt", Hand::tilt, [](fixture::Manual& manual) { manual.tilt_deg = 5; });
    change_selected(bench.studio, "release", Hand::step, [](fixture::Manual& manual) { manual = {}; });
    EXPECT_TRUE(bench.studio.look().is_empty());
}

// Any changes, undos and redos: all undone is the beginning, all redone is the end.
TEST(Studio, any_sequence_comes_back_to_the_same_look) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Bench bench;
        bench.open();
        std::mt19937 random(seed);
        const auto below = [&](std::uint32_t count) { return random() % count; };
        for (int step = 0; step < 200; ++step) {
            Look look = bench.studio.look();
            const float value = static_cast<float>(below(100)) / 100.0f;
            fixture::Manual& manual = look.fixtures[below(4)];
            switch (below(8)) {
            case 0:
                manual.intensity = value;
                break;
            case 1:
                manual.colour = glm::vec3(value, 1, 0);
                break;
            case 2:
                manual = {};
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
                bench.studio.undo_stack().undo();
                continue;
            default:
                bench.studio.undo_stack().redo();
                continue;
            }
            bench.studio.set_look(look, "change", static_cast<int>(below(4)));
        }
        const Look end = bench.studio.look();
        while (bench.studio.undo_stack().canUndo()) bench.studio.undo_stack().undo();
        EXPECT_TRUE(bench.studio.look().is_empty()) << "seed " << seed;
        // Redo goes to the last look that was made, which is the end unless the walk ended with undos.
        while (bench.studio.undo_stack().canRedo()) bench.studio.undo_stack().redo();
        const Look last = bench.studio.look();
        while (bench.studio.undo_stack().canUndo() && bench.studio.look() != end)
            bench.studio.undo_stack().undo();
        EXPECT_EQ(bench.studio.look(), end) << "seed " << seed;
        while (bench.studio.undo_stack().canRedo()) bench.studio.undo_stack().redo();
        EXPECT_EQ(bench.studio.look(), last) << "seed " << seed;
    }
}

TEST(Studio, a_travel_ends_at_the_camera_and_a_hand_ends_a_travel) {
    Bench bench;
    bench.open();
    bench.studio.set_size(320, 180);
    const scene::Camera side = bench.studio.show()->cameras[1];
    bench.studio.travel_to(side);
    EXPECT_TRUE(bench.studio.travels());
    while (bench.studio.travels()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_EQ(bench.studio.camera().position_m, side.position_m);
    EXPECT_EQ(bench.studio.camera().width, 320); // of the window, not of the show
    bench.studio.travel_to(bench.studio.show()->cameras[0]);
    bench.studio.set_camera(bench.studio.camera());
    EXPECT_FALSE(bench.studio.travels());
}

} // namespace
} // namespace ghost::ui
