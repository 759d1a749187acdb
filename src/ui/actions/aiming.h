#pragma once
// SPDX-License-Identifier: Apache-2.0
// Aiming the selected heads by hand at a point of the stage: their pan and tilt, one step of the undo list. A
// head that does not reach so far turns as far as it goes. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace ghost::ui {

// at_m: of the world. spread_m: the heads, from left to right as the house sees them, point at as many places
// in a row of that length, the point in its middle; below 0: crossed. How many do not reach. Error: nothing
// is selected that turns both ways.
Result<int> aim_selected(AppModel& app, const glm::vec3& at_m, float spread_m = 0);

// Likewise at what the picture shows at a place, (0, 0) its top left corner, as soon as the engine says what
// that is. Nothing is there: it is said, and nothing turns.
class Aiming : public QObject {
    Q_OBJECT
public:
    // actions: where it is said what cannot be.
    Aiming(AppModel& app, Actions& actions, QObject* parent);
    Result<void> aim_through(const glm::vec2& place, float spread_m = 0);

private:
    void take_picked();
    void say(const Result<int>& beyond);

    AppModel& app_;
    Actions& actions_;
    std::uint64_t number_ = 0;       // of the pick that is waited for; 0: none
    std::vector<std::string> heads_; // that shall be aimed, from left to right
    float spread_m_ = 0;
};

// "aim X Y Z [SPREAD_M]", "aim-through X Y [SPREAD_M]".
void add_aim_actions(Actions& actions, AppModel& app, Aiming& aiming);

} // namespace ghost::ui
