// SPDX-License-Identifier: Apache-2.0
// Any sequence of what a person can undo, of all kinds in turn, comes back to the same bytes and the same
// look, and forth again.
#include "support/test_desk.h"

#include "ui/actions/air_edit.h"
#include "ui/actions/hang_edit.h"
#include "ui/actions/programmer_actions.h"
#include "ui/model/looks.h"

#include <random>

namespace ghost::ui {
namespace {

struct WholeDesk : Desk {
    WholeDesk() { open(); }

    struct State {
        std::string text;
        Look look;
        std::string looks;
        bool operator==(const State&) const = default;
    };
    State state() const { return {document.text(), app.look(), scene::text_of(looks.all())}; }

    void choose(std::mt19937& random) {
        std::set<std::size_t> chosen;
        for (std::size_t i = 0; i < app.show()->fixtures.size(); ++i)
            if (random() % 2) chosen.insert(i);
        app.select(chosen);
    }
    void edit_patch(std::mt19937& random) {
        const std::size_t count = app.show()->fixtures.size();
        switch (random() % 6) {
        case 0:
            (void)edit.set_address(
                {1 + static_cast<int>(random() % 4), 1 + static_cast<int>(random() % 400)});
            break;
        case 1:
            (void)edit.move_by({0.25f, 0, -1});
            break;
        case 2:
            if (count < 12) (void)edit.duplicate({1, 0, 0});
            break;
        case 3:
            if (app.selection().size() < count) (void)edit.remove();
            break;
        case 4:
            (void)edit.set_positions("Hang",
                                     std::vector<glm::vec3>(count, {1, 2, static_cast<float>(random() % 9)}));
            break;
        default:
            (void)edit.keep_camera("");
        }
    }
    void edit_air(std::mt19937& random) {
        const auto number = static_cast<float>(random() % 8);
        switch (random() % 4) {
        case 0:
            (void)air.set_wind({number / 4, 0, 0});
            break;
        case 1:
            (void)air.set_clouds(number / 8);
            break;
        case 2:
            (void)air.add_hazer({number, 0, 0});
            break;
        default:
            (void)air.remove_hazer(0);
        }
    }
    void set_by_hand(std::mt19937& random) {
        const auto number = static_cast<float>(random() % 8) / 8;
        switch (random() % 4) {
        case 0:
            change_selected(app, "intensity", ProgrammerStep::intensity,
                            [&](fixture::Programmer& programmer) { programmer.intensity = number; });
            break;
        case 1:
            change_scene(app, "smoke", ProgrammerStep::scene,
                         [&](SceneLook& scene) { scene.smoke = number; });
            break;
        case 2:
            app.set_look({}, "release all");
            break;
        default: {
            Look look = app.look();
            look.solo = app.selection();
            app.set_look(std::move(look), "solo");
        }
        }
    }
    void edit_looks(std::mt19937& random) {
        const std::string name = "Look " + std::to_string(random() % 3);
        switch (random() % 4) {
        case 0:
            (void)looks.store(name);
            break;
        case 1:
            (void)looks.recall(name, 0);
            break;
        case 2:
            (void)looks.remove(name);
            break;
        default:
            (void)looks.set_fade(name, static_cast<double>(random() % 5));
        }
    }

    AirEdit air{app, document};
    Looks looks{app};
};

TEST(Undo, any_sequence_of_any_kind_comes_back_and_forth) {
    std::mt19937 random(7);
    std::size_t steps = 0;
    for (int round = 0; round < 30; ++round) {
        WholeDesk desk;
        QUndoStack& stack = desk.app.undo_stack();
        std::vector<WholeDesk::State> states{desk.state()};
        for (int step = 0; step < 40; ++step) {
            desk.choose(random);
            switch (random() % 4) {
            case 0:
                desk.edit_patch(random);
                break;
            case 1:
                desk.edit_air(random);
                break;
            case 2:
                desk.set_by_hand(random);
                break;
            default:
                desk.edit_looks(random);
            }
            desk.follow();
            // What follows closely on its like is one step with it.
            const auto count = static_cast<std::size_t>(stack.count()) + 1;
            ASSERT_LE(count, states.size() + 1);
            states.resize(count);
            states.back() = desk.state();
        }
        steps += states.size() - 1;
        for (std::size_t i = states.size() - 1; i > 0; --i) {
            ASSERT_EQ(desk.state(), states[i]) << "round " << round << ", step " << i;
            stack.undo();
            if (random() % 3 == 0) desk.follow(); // the engine is not asked to hurry
        }
        ASSERT_EQ(desk.state(), states.front());
        ASSERT_EQ(desk.document.text(), kShow);
        while (stack.canRedo()) stack.redo();
        ASSERT_EQ(desk.state(), states.back());
        ASSERT_TRUE(desk.document.save(false).ok());
        ASSERT_EQ(desk.on_disk(), states.back().text);
    }
    EXPECT_GT(steps, 500u);
}

} // namespace
} // namespace ghost::ui
