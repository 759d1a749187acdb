// SPDX-License-Identifier: Apache-2.0
// LED walls (docs/design/led-walls.md): a rectangle of emissive pixels that show a moving picture. What shines are the surfaces that lie on it,
// so that whatever stands before it hides it. What C++ and the shader share.
#ifndef GHOST_SHARED_LED_WALL_H
#define GHOST_SHARED_LED_WALL_H
#include "shared/types.h"

SHARED_BEGIN

struct LedWall {
    vec3 centre_m;
    uint layer;     // of the moving pictures, + 1
    vec3 right;     // dot(offset, right) is -1..1 across
    float depth_m;  // surfaces so far before or behind the rectangle are part of it
    vec3 up;
    uint moment;    // number of the picture: another one makes another wall
    vec3 normal;    // unit, to where it shines
    float texel_m;  // of the picture on the wall
    vec3 radiance;  // cd/m^2 of full white
    float pitch_m;  // of its LEDs
    vec2 scale;     // from -1..1 on the wall to -1..1 in the layer
    vec2 shown;     // where the picture ends: black beyond
};
SHARED_SIZE(LedWall, 96);

struct LedWallPush {
    LedWall wall;
    uint low_x; // pixels that it may cover
    uint low_y;
    uint high_x; // the last ones
    uint high_y;
    uint edges; // above 0: the extra fragments of so many edges instead
};
SHARED_SIZE(LedWallPush, 116);

// Place on the wall, -1..1; z: 1 where a point of the world is on it and the eye before it, else 0.
SHARED_FN vec3 place_on_wall(LedWall wall, vec3 point_m, vec3 eye_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec3 offset = point_m - wall.centre_m;
    vec2 at = vec2(dot(offset, wall.right), dot(offset, wall.up));
    bool on = abs(dot(offset, wall.normal)) <= wall.depth_m && abs(at.x) <= 1.0f && abs(at.y) <= 1.0f &&
              dot(eye_m - wall.centre_m, wall.normal) > 0.0f;
    return vec3(at.x, at.y, on ? 1.0f : 0.0f);
}

// Where on the wall a pixel of this width looks: LEDs that are larger than it are of one colour each, with a rim as wide as the pixel.
SHARED_FN vec2 led_place(LedWall wall, vec2 at, float pixel_m) {
#ifdef __cplusplus
    using namespace glm;
#endif
    vec2 leds = vec2(1.0f / (length(wall.right) * wall.pitch_m), 1.0f / (length(wall.up) * wall.pitch_m)); // half of their numbers
    vec2 q = at * leds - vec2(0.5f);
    vec2 low = floor(q);
    float rim = clamp(pixel_m / wall.pitch_m, 1e-3f, 1.0f);
    vec2 part = clamp((q - low - vec2(0.5f)) / rim + vec2(0.5f), vec2(0.0f), vec2(1.0f));
    return (low + part + vec2(0.5f)) / leds;
}

SHARED_END
#endif
