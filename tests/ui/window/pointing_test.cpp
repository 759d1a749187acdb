// SPDX-License-Identifier: Apache-2.0
// Fixtures and the mouse in the picture: heads aimed at a place, lamps dragged along what they hang under,
// bodies that are clicked, names that do not lie on each other.
#include "support/must.h"
#include "support/test_picture.h"
#include "ui/actions/aiming.h"
#include "ui/model/lamp_drag.h"
#include "ui/picture/fixture_labels.h"

#include "fixture_files/gdtf/gdtf.h"
#include "show/camera_moves.h"
#include "show/show.h"

#include <QImage>

namespace ghost::ui {
namespace {

// Four heads that turn, 4 m above the stage.
struct Heads : Bench {
    Heads() {
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        const fixture::LoadedType spot = must(fixture::load_gdtf(
            std::filesystem::path(GHOST_SOURCE_DIR) / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"));
        for (scene::PatchedFixture& fixture : show->fixtures)
            fixture.type = std::make_shared<fixture::Type>(spot.type);
        show->fixtures[3].rotation_deg = {180, 0, 30}; // stands
        opened.show = std::move(show);
        link.opened.put(std::move(opened));
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    // Where the beam of a head goes that was turned so.
    glm::vec3 direction(std::size_t index) const {
        const fixture::Programmer& programmer = app.look().fixtures.at(index);
        const float pan = glm::radians(*programmer.pan_deg), tilt = glm::radians(*programmer.tilt_deg);
        const glm::vec3 own(-std::sin(pan) * std::sin(tilt), std::cos(pan) * std::sin(tilt), -std::cos(tilt));
        return glm::mat3(scene::fixture_to_world(app.show()->fixtures[index], 0)) * own;
    }
};

TEST(Aim, every_head_points_at_the_place) {
    Heads heads;
    EXPECT_FALSE(aim_selected(heads.app, {0, 0, 0}).ok()) << "nothing is selected";
    heads.app.select({0, 1, 2, 3});
    const glm::vec3 at_m(1, 2.5f, 0.5f);
    const Result<int> beyond = aim_selected(heads.app, at_m);
    ASSERT_TRUE(beyond.ok()) << beyond.error().text();
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 way = glm::normalize(at_m - heads.app.show()->fixtures[i].position_m);
        EXPECT_GT(glm::dot(heads.direction(i), way), 0.99999f) << i;
    }
    heads.app.undo_stack().undo();
    EXPECT_TRUE(heads.app.look().fixtures.empty()) << "one step";
}

TEST(Aim, a_head_that_a_mover_has_turned_points_there_all_the_same) {
    Heads heads;
    RigNow rig = four_lit();
    const glm::mat3 quarter(glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0), glm::vec3(0, 0, 1)); // about Z
    rig.fixtures[0].turned = quarter;
    heads.link.rig.put(rig);
    heads.link.on_news();
    settle();
    heads.app.select({0, 1});
    const glm::vec3 at_m(1, 2.5f, 0.5f);
    ASSERT_TRUE(aim_selected(heads.app, at_m).ok());
    const auto way = [&](std::size_t index) {
        return glm::normalize(at_m - heads.app.rig().fixtures[index].light_m);
    };
    EXPECT_GT(glm::dot(quarter * heads.direction(0), way(0)), 0.99999f);
    EXPECT_GT(glm::dot(heads.direction(1), way(1)), 0.99999f);
}

TEST(Aim, a_spread_gives_each_its_own_place_in_their_order) {
    Heads heads;
    heads.app.select({0, 1, 2});
    ASSERT_TRUE(aim_selected(heads.app, {0, 0, 0}, -6).ok());
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 at_m(3 - 3 * static_cast<float>(i), 0, 0); // crossed
        const glm::vec3 way = glm::normalize(at_m - heads.app.show()->fixtures[i].position_m);
        EXPECT_GT(glm::dot(heads.direction(i), way), 0.99999f) << i;
    }
}

TEST(Aim, who_does_not_turn_is_named_and_who_does_not_reach_counted) {
    Bench lamps;
    lamps.open();
    lamps.app.select({0});
    EXPECT_EQ(aim_selected(lamps.app, {0, 0, 0}).error().what, "nothing that is selected turns both ways");
    Heads heads;
    heads.app.select({0});
    const Result<int> beyond = aim_selected(heads.app, {-3, 0, 10}); // straight up, behind its own base
    ASSERT_TRUE(beyond.ok());
    EXPECT_EQ(*beyond, 1);
    EXPECT_LT(std::abs(*heads.app.look().fixtures.at(0).tilt_deg), 179);
}

TEST(Aim, through_the_picture_as_soon_as_the_engine_says_what_is_there) {
    Heads heads;
    QWidget widget;
    Actions actions(widget);
    std::string said;
    actions.complain = [&](const Error& error) { said = error.text(); };
    Aiming aiming(heads.app, actions, nullptr);
    heads.app.select({1});
    EXPECT_FALSE(aiming.aim_through({0.5f, 0.5f}).ok()) << "no picture";
    scene::Camera camera = heads.app.camera();
    camera.width = 320;
    camera.height = 180;
    heads.show_picture(camera);
    ASSERT_TRUE(aiming.aim_through({0.5f, 0.5f}).ok());
    const Pick pick = heads.app.request().pick;
    EXPECT_EQ(pick.from_m, camera.position_m);
    EXPECT_NEAR(glm::distance(pick.way, glm::vec3(0, 1, 0)), 0, 1e-5f);
    heads.link.picked.put({pick.number - 1, true, {9, 9, 9}, std::nullopt, "of an older request"});
    heads.link.on_news();
    settle();
    EXPECT_TRUE(heads.app.look().fixtures.empty());
    heads.link.picked.put({pick.number, true, {0, 3, 2}, std::nullopt, "wall"});
    heads.link.on_news();
    settle();
    ASSERT_EQ(heads.app.look().fixtures.size(), 1u);
    EXPECT_EQ(said, "");
    ASSERT_TRUE(aiming.aim_through({0.5f, 0}).ok());
    heads.link.picked.put({heads.app.request().pick.number, false, {}, std::nullopt, ""});
    heads.link.on_news();
    settle();
    EXPECT_EQ(said, "there is nothing but air to aim at");
}

TEST(Aim, a_late_answer_turns_the_heads_that_it_was_asked_for) {
    Heads heads;
    QWidget widget;
    Actions actions(widget);
    Aiming aiming(heads.app, actions, nullptr);
    heads.app.select({1});
    scene::Camera camera = heads.app.camera();
    camera.width = 320;
    camera.height = 180;
    heads.show_picture(camera);
    ASSERT_TRUE(aiming.aim_through({0.5f, 0.5f}).ok());
    heads.app.select({2});
    heads.link.picked.put({heads.app.request().pick.number, true, {0, 3, 2}, std::nullopt, "wall"});
    heads.link.on_news();
    settle();
    ASSERT_EQ(heads.app.look().fixtures.size(), 1u);
    EXPECT_TRUE(heads.app.look().fixtures.contains(1));
}

std::vector<Object> truss() {
    Object truss;
    truss.name = "truss_mid";
    truss.bar = scene::Bar{{-4, 0, 4.2f}, {4, 0, 4.2f}, 0.4f, 0.4f};
    return {truss};
}

LampDrag drag_at(const glm::vec3& place_m) {
    return LampDrag(place_m, place_m, truss());
}

TEST(LampDrag, goes_along_its_truss_to_its_end_and_on_the_level_without_one) {
    const glm::vec3 hung_m(-1, 0, 4), free_m(-1, 3, 4);
    const LampDrag hung = drag_at(hung_m), free = drag_at(free_m);
    const glm::vec3 eye(0, -10, 2);
    const auto towards = [&](const glm::vec3& at) { return glm::normalize(at - eye); };
    const auto hung_by = [&](const glm::vec3& at, bool upright) {
        return hung.by_m(eye, towards(hung_m), towards(at), upright);
    };
    EXPECT_NEAR(glm::distance(hung_by({1.234f, 0, 4}, false), {2.23f, 0, 0}), 0, 0.011f);
    EXPECT_EQ(hung_by({90, 0, 4}, false), glm::vec3(5, 0, 0)) << "its end";
    EXPECT_EQ(hung.words({2, 0, 0}), "2.00 m along truss_mid");
    EXPECT_NEAR(glm::distance(free.by_m(eye, towards(free_m), towards({1, 5, 4}), false), {2, 2, 0}), 0,
                0.02f);
    EXPECT_EQ(free.words({3, 4, 0}), "5.00 m");
    EXPECT_NEAR(glm::distance(hung_by({-1, 0, 5.5f}, true), {0, 0, 1.5f}), 0, 0.02f);
    EXPECT_EQ(hung.words({0, 0, -1.5f}), "1.50 m down");
    EXPECT_EQ(free.by_m(eye, towards(free_m), {0, 1, 0}, false), glm::vec3(0)) << "never meets the level";
    const glm::vec3 far = glm::normalize(glm::vec3(0, 1, 0.021f));
    EXPECT_LE(glm::length(free.by_m(eye, towards(free_m), far, false)), 100.1f);
}

TEST(LampDrag, takes_others_along_as_far_as_all_of_them_hang) {
    const glm::vec3 place_m(-1, 0, 4), eye(0, -10, 2);
    LampDrag drag = drag_at(place_m);
    drag.take_along(drag_at({2.5f, 0, 4}));
    drag.take_along(drag_at({3, 7, 4})); // hangs under nothing
    const auto by = [&](const glm::vec3& from, const glm::vec3& to) {
        return drag.by_m(eye, glm::normalize(from - eye), glm::normalize(to - eye), false);
    };
    EXPECT_EQ(by(place_m, {90, 0, 4}), glm::vec3(1.5f, 0, 0));
    EXPECT_EQ(by(place_m, {-90, 0, 4}), glm::vec3(-3, 0, 0));
    EXPECT_EQ(by({-1.7f, 0, 4}, {90, 0, 4}), glm::vec3(1.5f, 0, 0)) << "taken hold of beside its lens";
}

TEST(LampDrag, from_one_end_of_a_truss_it_goes_to_the_other_and_not_beyond) {
    std::vector<Object> whole = truss();
    whole[0].bar = scene::Bar{{-8.0076f, 0, 4.2f}, {8.0076f, 0, 4.2f}, 0.4f, 0.4f};
    const glm::vec3 eye(0, -10, 2);
    glm::vec3 place_m(0, 0, 4.2f);
    for (const float side : {-90.0f, 90.0f, -90.0f, 90.0f}) {
        const LampDrag drag(place_m, place_m, whole);
        place_m += drag.by_m(eye, glm::normalize(place_m - eye),
                             glm::normalize(glm::vec3(side, 0, 4.2f) - eye), false);
        EXPECT_NEAR(std::abs(place_m.x), 8, 0.02f);
        EXPECT_LE(std::abs(place_m.x), 8.0077f) << "on it";
    }
    // As the version before left them.
    const LampDrag past({-8.01f, 0, 4.2f}, {-8.01f, 0, 4.2f}, whole);
    const glm::vec3 by = past.by_m(eye, glm::normalize(glm::vec3(-8.01f, 0, 4.2f) - eye),
                                   glm::normalize(glm::vec3(90, 0, 4.2f) - eye), false);
    EXPECT_NEAR(by.x, 16.01f, 0.011f);
}

TEST(LampDrag, a_head_whose_lens_is_far_below_its_truss_still_hangs_there) {
    const glm::vec3 lens_m(-1, 0.4f, 3.3f), eye(0, -10, 2);
    const LampDrag drag(lens_m, {-1, 0, 4.2f}, truss());
    const glm::vec3 by =
        drag.by_m(eye, glm::normalize(lens_m - eye), glm::normalize(glm::vec3(90, 0, 4) - eye), false);
    EXPECT_EQ(by, glm::vec3(5, 0, 0));
}

TEST(Pointing, a_body_far_from_its_lamp_is_selected_when_the_engine_says_whose_it_is) {
    Watched seen;
    seen.bench.app.select({0});
    seen.click({160, 150});
    EXPECT_TRUE(seen.bench.app.selection().empty());
    const std::uint64_t number = seen.bench.app.request().pick.number;
    ASSERT_GT(number, 0u);
    seen.bench.link.picked.put({number, true, {0, 0, 1}, std::size_t{2}, "Lamp 3 yoke"});
    seen.bench.link.on_news();
    settle();
    EXPECT_EQ(seen.bench.app.selection(), std::set<std::size_t>{2});
    seen.click({160, 150}, Qt::ControlModifier);
    seen.bench.link.picked.put({seen.bench.app.request().pick.number, true, {}, std::size_t{1}, ""});
    seen.bench.link.on_news();
    settle();
    EXPECT_EQ(seen.bench.app.selection(), (std::set<std::size_t>{1, 2}));
}

TEST(Pointing, a_late_answer_to_a_click_leaves_what_was_selected_meanwhile) {
    Watched seen;
    seen.click({160, 150});
    seen.bench.app.select({0, 3});
    seen.bench.link.picked.put(
        {seen.bench.app.request().pick.number, true, {0, 0, 1}, std::size_t{2}, "Lamp 3 yoke"});
    seen.bench.link.on_news();
    settle();
    EXPECT_EQ(seen.bench.app.selection(), (std::set<std::size_t>{0, 3}));
}

TEST(Pointing, a_drag_of_a_selected_lamp_moves_it_and_of_another_the_camera) {
    Watched seen;
    std::vector<glm::vec3> moves;
    seen.view.on_move = [&](const glm::vec3& by_m) { moves.push_back(by_m); };
    const scene::Camera before = seen.bench.app.camera();
    seen.bench.app.select({1, 2});
    seen.drag(seen.lamp(1), seen.lamp(1) + QPointF(30, 0), Qt::LeftButton);
    ASSERT_EQ(moves.size(), 1u);
    EXPECT_GT(moves[0].x, 0.2f);
    EXPECT_EQ(moves[0].z, 0);
    EXPECT_EQ(seen.bench.app.camera().position_m, before.position_m);
    seen.drag(seen.lamp(0), seen.lamp(0) + QPointF(30, 0), Qt::LeftButton);
    EXPECT_EQ(moves.size(), 1u);
    EXPECT_NE(seen.bench.app.camera().position_m, before.position_m);
}

// Each edit is heard of twice: at once, and when the engine has read it, perhaps in the next drag.
TEST(Pointing, a_drag_goes_on_while_the_edit_before_it_is_read) {
    for (const bool is_gone : {false, true}) {
        Watched seen;
        int moves = 0;
        seen.view.on_move = [&](const glm::vec3&) { ++moves; };
        seen.bench.app.select({3});
        const QPointF from = seen.lamp(3), to = from - QPointF(30, 0);
        seen.mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
        seen.mouse(QEvent::MouseMove, (from + to) / 2, Qt::LeftButton);
        Opened opened = seen.bench.app.opened();
        opened.is_edit = true;
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->fixtures[0].position_m.y = 2; // what the edit was about
        if (is_gone) show->fixtures.pop_back();
        opened.show = show;
        seen.bench.link.opened.put(std::move(opened));
        seen.bench.link.on_news();
        settle();
        seen.mouse(QEvent::MouseMove, to, Qt::LeftButton);
        seen.mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton);
        EXPECT_EQ(moves, is_gone ? 0 : 1);
    }
}

TEST(Pointing, shift_and_a_click_aims_and_selects_nothing) {
    Watched seen;
    std::vector<glm::vec2> places;
    seen.view.on_aim = [&](const glm::vec2& place) { places.push_back(place); };
    seen.bench.app.select({1});
    seen.click({240, 45}, Qt::ShiftModifier);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].x, 0.75f, 0.01f);
    EXPECT_NEAR(places[0].y, 0.25f, 0.01f);
    EXPECT_EQ(seen.bench.app.selection(), std::set<std::size_t>{1});
}

TEST(Wipe, keeps_what_was_seen_left_of_a_line_that_is_dragged) {
    Watched seen;
    ASSERT_TRUE(seen.view.begin_wipe(0.5).ok());
    scene::Camera camera = seen.bench.app.picture().camera;
    Picture green;
    auto image = std::make_shared<image::Image8>(camera.width, camera.height, 4);
    for (std::size_t i = 0; i < image->samples.size(); i += 4) image->samples[i + 1] = 200;
    green.image = image;
    green.camera = camera;
    seen.bench.link.picture.put(std::move(green));
    seen.bench.link.on_news();
    settle();
    const auto colour_at = [&](int x) { return seen.view.grab().toImage().pixelColor(x, 120); };
    EXPECT_GT(colour_at(100).red(), 150);
    EXPECT_GT(colour_at(220).green(), 150);
    const scene::Camera before = seen.bench.app.camera();
    seen.drag({161, 90}, {260, 90}, Qt::LeftButton);
    EXPECT_EQ(seen.bench.app.camera().position_m, before.position_m);
    EXPECT_NEAR(seen.view.wipe().share(), 260.0 / 320, 0.01);
    EXPECT_GT(colour_at(220).red(), 150);
    seen.view.end_wipe();
    EXPECT_GT(colour_at(100).green(), 150);
}

TEST(Labels, lie_beside_each_other_or_are_left_out) {
    QImage image(400, 300, QImage::Format_RGB32);
    QPainter painter(&image);
    FixtureLabels labels(painter, QRectF(0, 0, 400, 300));
    int painted = 0;
    for (int k = 0; k < 20; ++k)
        painted += labels.paint({200.0 + k, 150}, {"Wash " + QString::number(k)}, Qt::white) ? 1 : 0;
    EXPECT_GE(painted, 3);
    EXPECT_LE(painted, 6);
    EXPECT_FALSE(labels.paint({-50, -50}, {"outside"}, Qt::white));
    EXPECT_TRUE(labels.paint({60, 280}, {"elsewhere"}, Qt::white));
}

} // namespace
} // namespace ghost::ui
