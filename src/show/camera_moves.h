#pragma once
// SPDX-License-Identifier: Apache-2.0
// How a camera moves: between two cameras, and by hand as in every 3D program. Metres, radians, Z up; a
// camera never turns over its head. Where a point of the world stands in the picture. Pure.

#include "show/camera.h"

#include <glm/glm.hpp>
#include <optional>

namespace ghost::scene {

// The way of a camera between two others: smooth start and stop, share 0..1.
Camera camera_between(const Camera& from, const Camera& to, float share);

// Around what it looks at: positive turns the stage to the right, and down. From over the floor not below it,
// where all is black.
Camera orbited(const Camera& camera, float around_rad, float up_rad);
// About itself: positive looks to the left, and up.
Camera turned(const Camera& camera, float left_rad, float up_rad);
// Eye and target sideways, by shares of the picture's height at the target.
Camera panned(const Camera& camera, float right_share, float up_share);
// Towards the target until the distance is that times as long; at least kNearest_m.
Camera dollied(const Camera& camera, float factor);
// Eye and target together: right, forward on the level, up.
Camera flown(const Camera& camera, const glm::vec3& way_m);
// The way of looking stays; the ball fills the smaller side of the picture.
Camera focused(const Camera& camera, const glm::vec3& centre_m, float radius_m);

// With the field of view that shows all of a frame of that shape, which is as high as the camera's own field
// of view, and more above and below where the picture is less wide than the frame. A frame without pixels:
// the camera as it is.
Camera with_frame(const Camera& camera, const glm::ivec2& frame);
// How much of the picture's height such a frame has.
float share_of_frame(const Camera& camera, const glm::ivec2& frame);

inline constexpr float kNearest_m = 0.2f;

// Place in the picture: (0, 0) is the top left corner, (1, 1) the bottom right one.
struct InPicture {
    glm::vec2 at{0};
    float depth_m = 0; // along the way of looking
};
// Nothing behind the camera. The picture has the shape of camera.width and height.
std::optional<InPicture> project(const Camera& camera, const glm::vec3& point_m);
// Unit vector: the way from the eye through that place of the picture.
glm::vec3 way_through(const Camera& camera, const glm::vec2& place);
// The place of the floor, at height 0, that a way from the eye (unit vector) meets; where it meets none, or
// one far behind what the camera looks at: below or above the place of that way that is as far away.
glm::vec3 floor_along(const Camera& camera, const glm::vec3& way);

} // namespace ghost::scene
