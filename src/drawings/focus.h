#pragma once
// SPDX-License-Identifier: Apache-2.0
// Focus charts: for each lamp its place, where its beam goes, what it hits there and its pool on that floor,
// from what the fixtures do at one moment. World metres, full angles in degrees. A beam that hits no floor,
// or whose angle nobody says, has no pool. Pure, any thread.

#include "base/report.h"
#include "base/result.h"
#include "book/paper.h"
#include "fixture/state.h"
#include "print/paper_size.h"

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;

struct FocusHit {
    float distance_m = 0;
    glm::vec3 normal{0, 0, 1}; // towards the lamp
    std::string what;          // name of the object
    bool is_bar = false;       // a truss or a pipe
};
// Lenses stand in what carries them, or so near that it is the model that is hit and no aim.
inline constexpr float kAtLens_m = 0.5f;

// What a ray from there meets first. Nothing: nothing.
using FindHit = std::function<std::optional<FocusHit>(const glm::vec3& from_m, const glm::vec3& way)>;

struct FocusLamp {
    std::string name, number, position, unit, focus_point;
    glm::vec3 place_m{0}; // of the fixture
    glm::vec3 lens_m{0};
    glm::vec3 way{0, 0, -1};
    float pan_deg = 0, tilt_deg = 0;
    bool has_axes = false;
    bool is_rotation_known = true;                  // false: nobody says how it is turned
    bool is_pan_known = true, is_tilt_known = true; // false: its file gives no range, and one was assumed
    float angle_deg = 0;                            // field, of what the iris leaves
    bool is_angle_known = true;                     // false: its file says none, and has been given one
    bool is_looked_past = false;                    // a truss or pipe at its lens
    float light_percent = 0;
    std::optional<FocusHit> hit;
    bool is_on_floor = false;
    std::vector<glm::dvec2> pool_m; // its edge on that floor, round the way
    bool is_pool_whole = true;      // false: a part of its edge reaches no floor

    bool is_aim_known() const { return is_rotation_known && is_pan_known && is_tilt_known; }
    glm::vec3 aim_m() const { return lens_m + (hit ? hit->distance_m : 0.0f) * way; }
};

struct FocusChart {
    std::string show;
    std::string moment; // a sentence
    PrintStyle style;
    bool has_stage = false;           // false: what a beam hits is not known
    std::vector<FocusLamp> lamps;     // as they hang
    std::vector<std::string> unknown; // sentences
};

// states: one for each fixture. find: null where there is no stage: then a beam ends on z = 0. moved: from
// where the show hangs each fixture to where it is (Rig::moved); empty: no mover carries any.
FocusChart focus_of(const Show& show, std::span<const fixture::State> states, const FindHit& find,
                    const PrintStyle& style, const std::string& moment,
                    std::span<const glm::mat4> moved = {});
PaperTable table_of(const FocusChart& chart); // "focus"
// Ten lamps on a page. report: gets what they say of letters that no font has. Error: no memory.
Result<std::string> pdf_of(const FocusChart& chart, PaperSize paper, Report& report);

// "1.75 m left" of the centre line, "3 m up-stage" of the set line; on it "0 m".
std::string across_text(const PrintStyle& style, double x_m);
std::string along_text(const PrintStyle& style, double y_m);

} // namespace ghost::scene
