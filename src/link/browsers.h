#pragma once
// SPDX-License-Identifier: Apache-2.0
// What passes between browsers and those who draw: commands of who may control, the looks and the pictures of
// them, and side views, pictures from other cameras than the window's. Plain values; metres, degrees,
// seconds. Any thread.

#include "image/image.h"
#include "show/camera.h"
#include "show/looks.h"

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ghost::ui {

inline constexpr std::size_t kMostCommands = 64; // on their way, of all who control
inline constexpr std::size_t kMostSideViews = 2;

// As a remote control says it by OSC: "cue" with "Verse" is /ghostlight/cue "Verse".
struct Command {
    std::uint64_t number = 0; // its answer has the same
    std::string what;
    std::vector<std::variant<double, bool, std::string>> arguments;
};
struct CommandAnswer {
    std::uint64_t number = 0;
    std::string refused; // why nothing was done; empty: it is done
};

// A remote control wants that look.
struct LookCall {
    std::string name;
    double seconds = -1; // of the fade; below 0: those of the look
};

struct LooksNow {
    std::shared_ptr<const std::vector<scene::StoredLook>> looks; // null: none
    std::string current;                                         // name; empty: none of them
};

// A small picture of something that has a name: a camera of the show as it saw it when the picture rested
// last, a look as the first camera would see it.
struct NamedPicture {
    std::string name;
    std::shared_ptr<const image::Image8> image;
};

// A picture from elsewhere, beside the one of the request.
struct SideView {
    std::uint64_t number = 0;       // of who asks; another camera is another number
    scene::Camera camera;           // its size is not looked at
    std::optional<glm::vec2> probe; // what is measured there; (0, 0) is the top left corner
};
struct SideMeasure {
    glm::vec2 place{0};
    float cd_m2 = 0;  // that the camera sees there
    bool hit = false; // a surface; what follows is of it
    float lux = 0;
    float distance_m = 0;
    std::string object;
};
struct SidePicture {
    std::uint64_t number = 0; // of the view
    std::shared_ptr<const image::Image8> image;
    float ev100 = 0;
    bool is_still = false; // renewed now and then while the lamps move, and whole when they rest
    std::optional<SideMeasure> measure;
};

} // namespace ghost::ui
