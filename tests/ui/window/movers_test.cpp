// SPDX-License-Identifier: Apache-2.0
// Movers under a hand: a truss put on hoists, its address, dragged by its handles between its end stops,
// driven by keys, the outline of where it goes, and looks that keep it.
#include "support/test_desk.h"
#include "support/test_picture.h"

#include "ui/actions/hang_edit.h"
#include "ui/actions/programmer_actions.h"
#include "ui/model/look_fade.h"
#include "ui/model/looks.h"
#include "ui/panel_parts/mover_box.h"

#include <QLineEdit>
#include <QPointer>

namespace ghost::ui {
namespace {

// A truss of two pieces under which lamps 1 and 3 hang, one behind it, and a wall.
struct TrussDesk : Desk {
    TrussDesk() {
        open();
        add_hang_action(actions, app, document);
        put_objects(false);
    }
    // Again after each edit, for the engine of a Desk knows no stage.
    void put_objects(bool is_edit) {
        Opened opened = app.opened();
        opened.is_edit = is_edit;
        const auto add = [&](const char* name, const scene::Bar& bar) {
            Object object;
            object.name = name;
            object.instance = opened.objects.size();
            object.bar = bar;
            opened.objects.push_back(object);
        };
        add("front 1", {{-5, 0, 4.2f}, {0, 0, 4.2f}, 0.4f, 0.4f});
        add("front 2", {{0, 0, 4.2f}, {5, 0, 4.2f}, 0.4f, 0.4f});
        add("back", {{-4, 8, 5.5f}, {4, 8, 5.5f}, 0.4f, 0.4f});
        add("wall", {{-6, 3, 0}, {6, 3, 0}, 5, 4});
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    std::string complaint(const QString& line) {
        const Result<void> done = actions.run(line);
        follow();
        return done.ok() ? "" : done.error().text();
    }

    QWidget widget;
    Actions actions{widget};
};

TEST(Movers, a_truss_flies_on_two_hoists_with_what_hangs_under_it) {
    TrussDesk desk;
    ASSERT_EQ(desk.complaint("fly-on-hoists \"front 1\""), "");
    ASSERT_EQ(desk.app.show()->movers.size(), 1u) << desk.document.text();
    const scene::Mover& truss = desk.app.show()->movers[0];
    EXPECT_EQ(truss.name, "front 1");
    EXPECT_EQ(truss.objects, (std::vector<std::string>{"front 1", "front 2"}));
    EXPECT_EQ(truss.fixtures, (std::vector<std::string>{"Lamp 1", "Lamp 3"}));
    ASSERT_EQ(truss.axes.size(), 2u);
    EXPECT_EQ(truss.axes[0].name, "left");
    EXPECT_EQ(truss.axes[0].point_m, glm::vec3(-2.93f, 0, 4.6f))
        << "a fifth of 10 m from its end, on its top";
    EXPECT_EQ(truss.axes[0].low, -3.2f) << "a metre above the floor";
    ASSERT_EQ(truss.axes[1].levels.size(), 2u);
    EXPECT_EQ(truss.axes[1].levels[0].channel, 51)
        << "behind 48 channels of lamps, and two of the other hoist";
    desk.put_objects(true);
    ASSERT_EQ(desk.complaint("fly-on-hoists back"), "");
    EXPECT_EQ(desk.app.show()->movers[1].axes[0].levels[0].channel, 53) << "behind the other truss";
    desk.app.undo_stack().undo();
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow);
}

TEST(Movers, what_is_hung_copied_or_dropped_under_a_truss_that_flies_goes_with_it) {
    TrussDesk desk;
    ASSERT_TRUE(desk.actions.run("fly-on-hoists \"front 1\"").ok());
    const auto carried = [&] { return desk.app.show()->movers.at(0).fixtures; };
    using Carried = std::vector<std::string>;
    ASSERT_EQ(carried(), (Carried{"Lamp 1", "Lamp 3"}));
    const std::string flies = desk.document.text();
    desk.app.select({1});
    ASSERT_TRUE(desk.actions.run("hang \"front 2\"").ok());
    EXPECT_EQ(carried(), (Carried{"Lamp 1", "Lamp 3", "Lamp 2"}));
    desk.app.select({0});
    ASSERT_TRUE(desk.actions.run("hang back").ok());
    EXPECT_EQ(carried(), (Carried{"Lamp 3", "Lamp 2"})) << "it hangs elsewhere now";
    ASSERT_TRUE(desk.edit.duplicate({1, 0, 0}).ok());
    EXPECT_EQ(carried(), (Carried{"Lamp 3", "Lamp 2"})) << "a copy of one that does not fly";
    desk.app.select({2}); // Lamp 2
    ASSERT_TRUE(desk.edit.duplicate({1, 0, 0}).ok());
    EXPECT_EQ(carried(), (Carried{"Lamp 3", "Lamp 2", "Lamp 5"}));
    const fs::path file = fs::path(GHOST_SOURCE_DIR) / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf";
    ASSERT_TRUE(desk.edit.add(file, at(-4, 0, 4.2f)).ok());
    EXPECT_EQ(carried().size(), 4u);
    ASSERT_TRUE(desk.edit.add(file, at(-4, 4, 4.2f)).ok());
    EXPECT_EQ(carried().size(), 4u) << "one in the air";
    for (int step = 0; step < 6; ++step) desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), flies);
}

TEST(Movers, the_address_is_set_by_name_and_in_the_panel) {
    TrussDesk desk;
    ASSERT_EQ(desk.complaint("fly-on-hoists \"front 1\""), "");
    MoverBox box(desk.app, nullptr);
    QObject::connect(&box, &MoverBox::asks_for, [&](const QString& line) { desk.complaint(line); });
    desk.answer(desk.document.text(), true);
    auto* const address = box.findChild<QLineEdit*>();
    ASSERT_NE(address, nullptr);
    EXPECT_EQ(address->text(), "1.049") << "as lists have it";
    address->setText("2.101");
    Q_EMIT address->editingFinished();
    EXPECT_EQ(desk.app.show()->movers[0].axes[1].levels[0].universe, 2);
    EXPECT_EQ(desk.app.show()->movers[0].axes[1].levels[0].channel, 103);
    EXPECT_EQ(desk.complaint("mover-address \"front 1\" 3.1 24"), "");
    EXPECT_EQ(desk.app.show()->movers[0].axes[1].levels.size(), 3u);
    EXPECT_NE(desk.complaint("mover-address \"front 1\" 3.512").find("would end at channel 515"),
              std::string::npos);
    EXPECT_NE(desk.complaint("mover-address \"front 1\" here").find("universe"), std::string::npos);
    EXPECT_NE(desk.complaint("mover-address frond 1.1").find("the show has no mover 'frond'"),
              std::string::npos);
    EXPECT_NE(desk.complaint("mover-address \"front 1\" 1.1 12").find("none of 8, 16 and 24"),
              std::string::npos);
}

// Each edit is heard of twice: at once, and when the engine has read it.
TEST(Movers, who_types_an_address_or_drags_a_slider_goes_on_while_an_edit_is_read) {
    TrussDesk desk;
    MoverBox box(desk.app, nullptr);
    ASSERT_EQ(desk.complaint("fly-on-hoists \"front 1\""), "");
    const QPointer<QLineEdit> address = box.findChild<QLineEdit*>();
    const QPointer<ValueRow> row = box.findChild<ValueRow*>();
    ASSERT_TRUE(address && row);
    address->setText("2.10");
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.set_address({3, 1}).ok());
    desk.follow();
    settle();
    ASSERT_TRUE(address && row) << "they are the same";
    EXPECT_FALSE(address->isHidden());
    EXPECT_EQ(address->text(), "2.10");
    address->setText("1.049");
    EXPECT_EQ(desk.complaint("mover-address \"front 1\" 2.201"), "");
    EXPECT_EQ(address->text(), "2.201") << "what nobody types follows";
}

TEST(Movers, what_is_no_truss_or_flies_already_stays) {
    TrussDesk desk;
    EXPECT_NE(desk.complaint("fly-on-hoists wall").find("no hoists hold it"), std::string::npos);
    EXPECT_NE(desk.complaint("fly-on-hoists").find("no object of the stage is chosen"), std::string::npos);
    EXPECT_EQ(desk.document.text(), kShow);
}

// A camera at (0, -10, 2) that looks along Y, 320x180 pixels.
struct Flying : Watched {
    Flying() {
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        scene::Mover& truss = show->movers.emplace_back();
        truss.name = "Truss";
        truss.kind = scene::MoverKind::hoists;
        for (const float x_m : {-2.0f, 2.0f}) {
            scene::MoverAxis& hoist = truss.axes.emplace_back();
            hoist.name = x_m < 0 ? "left" : "right";
            hoist.point_m = {x_m, 0, 4};
            hoist.low = -3;
        }
        for (scene::PatchedFixture& fixture : show->fixtures) fixture.mover = 0;
        opened.show = show;
        Object object;
        object.name = "Truss";
        object.centre_m = {0, 0, 4};
        object.half_size_m = {3, 0.2f, 0.2f};
        object.mover = 0;
        opened.objects = {object};
        bench.link.opened.put(std::move(opened));
        bench.link.on_news();
        settle();
        scene::Camera camera = bench.app.show()->cameras.front();
        camera.width = 320;
        camera.height = 180;
        bench.show_picture(camera);
        is_at({0, 0}, {0, 0});
    }
    void is_at(const std::vector<float>& values, const std::vector<float>& goals) {
        RigNow rig = four_lit();
        rig.movers = {{values, goals, {0, 0}}};
        bench.link.rig.put(std::move(rig));
        bench.link.on_news();
        settle();
    }
    QPointF at(const glm::vec3& place_m) {
        return *to_widget(QRectF(0, 0, 320, 180), bench.app.picture().camera, place_m);
    }
    std::vector<float> by_hand() {
        const auto found = bench.app.look().movers.find(0);
        return found == bench.app.look().movers.end() ? std::vector<float>{} : found->second;
    }
    // Pixels that are not the red of the picture.
    int marked() {
        const QImage seen = view.grab().toImage();
        int count = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) count += qGreen(seen.pixel(x, y)) > 60 ? 1 : 0;
        return count;
    }
};

TEST(Movers, a_handle_drags_its_hoist_along_its_way_and_stops_at_the_end_stop) {
    Flying stage;
    stage.drag(stage.at({-2, 0, 4}), stage.at({-2, 0, 3}), Qt::LeftButton);
    ASSERT_EQ(stage.by_hand().size(), 2u);
    EXPECT_NEAR(stage.by_hand()[0], -1, 0.06f);
    EXPECT_EQ(stage.by_hand()[1], 0);
    stage.drag(stage.at({2, 0, 4}), stage.at({2, 0, -1}), Qt::LeftButton);
    EXPECT_EQ(stage.by_hand()[1], -3) << "the end stop";
    stage.bench.app.undo_stack().undo();
    stage.bench.app.undo_stack().undo();
    EXPECT_TRUE(stage.by_hand().empty());
    stage.view.overlays.movers = false;
    const scene::Camera before = stage.bench.app.camera();
    stage.drag(stage.at({-2, 0, 4}), stage.at({-2, 0, 3}), Qt::LeftButton);
    EXPECT_TRUE(stage.by_hand().empty()) << "what is not seen is not dragged";
    EXPECT_FALSE(before.position_m == stage.bench.app.camera().position_m) << "the camera is";
}

TEST(Movers, words_of_a_turn_have_the_sign_of_degrees) {
    scene::Show show;
    scene::MoverAxis& turn = show.movers.emplace_back().axes.emplace_back();
    turn.name = "turn";
    turn.is_angle = true;
    turn.low = -90;
    turn.high = 180;
    EXPECT_EQ(value_words(show, {0, 0}, 30), QString::fromUtf8("turn 30.0\u00b0 of -90.0 to 180.0"));
}

TEST(Movers, a_camera_on_one_goes_on_from_where_it_is_carried_to) {
    Flying stage;
    AppModel& app = stage.bench.app;
    scene::Camera stored = app.show()->cameras.front();
    stored.mover = 0;
    scene::Camera carried = stored; // three metres up
    carried.position_m.z += 3;
    carried.target_m.z += 3;
    carried.width = 320;
    carried.height = 180;
    const auto go_there = [&] {
        app.cut_to(stored);
        stage.bench.show_picture(carried);
    };
    go_there();
    stage.drag({20, 160}, {60, 160}, Qt::LeftButton);
    EXPECT_NEAR(glm::distance(app.camera().target_m, carried.target_m), 0, 1e-4f) << "around what is seen";
    EXPECT_NEAR(app.camera().position_m.z, carried.position_m.z, 1e-4f);
    EXPECT_EQ(app.camera().width, 320);
    go_there();
    QWidget widget;
    Actions actions(widget);
    add_camera_actions(actions, app);
    ASSERT_TRUE(actions.run("fly 1 0 0").ok());
    EXPECT_NEAR(app.camera().position_m.x, carried.position_m.x + 1, 1e-4f);
    EXPECT_NEAR(app.camera().position_m.z, carried.position_m.z, 1e-4f);
    go_there();
    app.travel_to(app.show()->cameras[1], 60'000);
    wait_ms(60);
    EXPECT_NEAR(app.camera().position_m.z, carried.position_m.z, 0.1f) << "so does a flight";
}

TEST(Movers, a_drag_goes_on_while_an_edit_is_read) {
    Flying stage;
    const QPointF from = stage.at({-2, 0, 4}), to = stage.at({-2, 0, 3});
    stage.mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
    stage.mouse(QEvent::MouseMove, (from + to) / 2, Qt::LeftButton);
    Opened opened = stage.bench.app.opened();
    opened.is_edit = true;
    stage.bench.link.opened.put(opened);
    stage.bench.link.on_news();
    settle();
    stage.mouse(QEvent::MouseMove, to, Qt::LeftButton);
    ASSERT_FALSE(stage.by_hand().empty());
    EXPECT_NEAR(stage.by_hand().at(0), -1, 0.06f);
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->movers[0].name = "Another";
    opened.show = show;
    stage.bench.link.opened.put(opened);
    stage.bench.link.on_news();
    settle();
    stage.mouse(QEvent::MouseMove, from, Qt::LeftButton);
    EXPECT_TRUE(stage.by_hand().empty()) << "nobody has hold of a mover that is another";
    stage.mouse(QEvent::MouseButtonRelease, from, Qt::LeftButton);
}

TEST(Movers, a_ghost_is_where_the_truss_goes_until_it_is_there) {
    Flying stage;
    stage.view.overlays.movers = false;
    const int without = stage.marked();
    stage.view.overlays.movers = true;
    const int rests = stage.marked();
    EXPECT_GT(rests, without + 50) << "ways, end stops and handles";
    stage.is_at({-0.5f, -0.5f}, {-2, -2});
    const int goes = stage.marked();
    EXPECT_GT(goes, rests + 100);
    stage.is_at({-2, -2}, {-2, -2});
    EXPECT_LT(stage.marked(), rests + 80) << "it is there";
}

// Its ring, its cross, and what its lamps go along are where it is seen.
TEST(Movers, what_flies_is_dragged_where_it_is) {
    Flying stage;
    stage.view.overlays.movers = false; // no handle near
    Opened opened = stage.bench.app.opened();
    opened.is_edit = true;
    opened.objects[0].bar = scene::Bar{{-3, 0, 4.2f}, {3, 0, 4.2f}, 0.4f, 0.4f};
    stage.bench.link.opened.put(std::move(opened));
    RigNow rig = four_lit();
    for (FixtureNow& lamp : rig.fixtures) lamp.light_m.z -= 1;
    rig.movers = {{{-1, -1}, {-1, -1}, {0, 0}}};
    stage.bench.link.rig.put(std::move(rig));
    stage.bench.link.on_news();
    settle();
    std::optional<std::size_t> moved;
    stage.view.on_move_object = [&](std::size_t object, const glm::vec3&) { moved = object; };
    glm::vec3 by_m(0);
    stage.view.on_move = [&](const glm::vec3& so_far_m) { by_m = so_far_m; };
    stage.bench.app.select({1});
    stage.drag(stage.at({-1, 0, 3}), stage.at({-1, 0, 3}) + QPointF(20, -12), Qt::LeftButton);
    EXPECT_GT(by_m.x, 0.2f);
    EXPECT_EQ(by_m.y, 0) << "along its truss";
    EXPECT_EQ(by_m.z, 0);
    stage.bench.app.select({});
    stage.bench.app.mark(0);
    stage.drag(stage.at({0, 0, 3}), stage.at({0.5f, 0, 3}), Qt::LeftButton);
    EXPECT_EQ(moved, 0u);

    // Turned by a quarter: what goes to the right as it is seen goes up-stage where the model has it.
    opened = stage.bench.app.opened();
    auto show = std::make_shared<scene::Show>(*opened.show);
    scene::Mover& disc = show->movers[0];
    disc.kind = scene::MoverKind::revolve;
    disc.axes.resize(1);
    disc.axes[0].is_angle = true;
    opened.show = show;
    opened.objects[0].bar.reset();
    stage.bench.link.opened.put(opened);
    rig = four_lit();
    rig.movers = {{{-90}, {-90}, {0}}};
    stage.bench.link.rig.put(std::move(rig));
    stage.bench.link.on_news();
    settle();
    stage.bench.app.mark(std::nullopt);
    stage.bench.app.select({2});
    stage.drag(stage.lamp(2), stage.lamp(2) + QPointF(20, 0), Qt::LeftButton);
    EXPECT_NEAR(by_m.x, 0, 0.01f);
    EXPECT_GT(by_m.y, 0.2f);
}

TEST(Movers, keys_drive_what_carries_the_selection_all_hoists_alike) {
    Flying stage;
    QWidget widget;
    Actions actions(widget);
    add_programmer_actions(actions, stage.bench.app);
    EXPECT_FALSE(actions.run("mover-back").ok()) << "nothing is selected";
    stage.bench.app.select({1});
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(actions.run("mover-back").ok());
    EXPECT_NEAR(stage.by_hand()[0], -0.3f, 1e-5f);
    EXPECT_NEAR(stage.by_hand()[1], -0.3f, 1e-5f);
    for (int k = 0; k < 5; ++k) ASSERT_TRUE(actions.run("mover-on").ok());
    EXPECT_EQ(stage.by_hand()[0], 0) << "the end stop";
    ASSERT_TRUE(actions.run("motion commanded").ok());
    EXPECT_EQ(stage.bench.app.request().motion, fixture::Motion::as_commanded);
    ASSERT_TRUE(actions.run("motion").ok());
    EXPECT_EQ(stage.bench.app.request().motion, fixture::Motion::as_the_machine);
    EXPECT_FALSE(actions.run("motion slow").ok());
}

TEST(Movers, a_look_keeps_them_and_a_fade_goes_through_what_the_desk_asks_for) {
    QTemporaryDir folder;
    Flying stage;
    AppModel& app = stage.bench.app;
    Looks looks(app);
    Opened opened = app.opened();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->folder = folder.path().toStdString();
    opened.show = show;
    stage.bench.link.opened.put(std::move(opened));
    stage.bench.link.on_news();
    settle();
    drive_mover(app, 0, {-2, -1});
    ASSERT_TRUE(looks.store("Low").ok()) << "nothing else is set by hand";
    app.set_look({}, "release everything");
    EXPECT_TRUE(stage.by_hand().empty());
    ASSERT_TRUE(looks.recall("Low").ok());
    EXPECT_EQ(stage.by_hand(), (std::vector<float>{-2, -1}));
    EXPECT_EQ(looks.current(), "Low");
    drive_mover(app, 0, {-2, -1.5f});
    EXPECT_EQ(looks.current(), "") << "it was driven since";

    Look low;
    low.movers[0] = {-2, -1};
    RigNow now;
    now.movers = {{{-2, -2}, {-2, -2}, {-1, 0}}}; // held there; the desk asks for -1 and 0
    EXPECT_EQ(faded({}, low, *show, now, 0.5f).movers.at(0), (std::vector<float>{-1.5f, -0.5f}));
    EXPECT_EQ(faded(low, {}, *show, now, 0.25f).movers.at(0), (std::vector<float>{-1.75f, -0.75f}));
    EXPECT_TRUE(faded(low, {}, *show, now, 1).movers.empty());
}

} // namespace
} // namespace ghost::ui
