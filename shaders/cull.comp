#version 460
// SPDX-License-Identifier: Apache-2.0
// Lists per tile the lights whose cone can meet the tile's bundle of camera rays. Conservative: the cone is widened by the
// radius of the bundle at its far end (a cone moved back by r / sin holds all points within r of it), and only the ray
// through the middle is tested.
#extension GL_GOOGLE_include_directive : require
#include "shared/push.h"
#include "shared/beam.h"

layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { CullPush p; };

vec3 gobo_sample(uint layer, vec2 gate, float blur) { return vec3(1.0); }

void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= p.tiles_x * p.tiles_y) return;
    View view = p.view.view;
    vec2 size = vec2(view.width, view.height);
    vec2 low = vec2(tile % p.tiles_x, tile / p.tiles_x) * vec2(kTileWidth, kTileHeight);
    vec2 middle = low + 0.5 * vec2(kTileWidth, kTileHeight);
    vec2 ndc = vec2(2.0 * middle.x / size.x - 1.0, 1.0 - 2.0 * middle.y / size.y);
    vec3 ray = view.forward + view.right * ndc.x + view.up * ndc.y;
    float ray_length = length(ray);
    vec3 dir = ray / ray_length;
    float far = p.tile_far.at[tile];
    // Half the tile's diagonal as seen along the ray.
    float spread = length(view.right * (float(kTileWidth) / size.x) + view.up * (float(kTileHeight) / size.y)) / ray_length;
    float radius = far * spread * 1.05 + 1e-3;

    uint count = 0u;
    for (uint i = 0u; i < p.list_count; ++i) {
        uint index = p.list.at[i];
        Light light = p.lights.light[index];
        float k = light.tan_field * light.cut_radius;
        float back = radius * sqrt(1.0 + k * k) / k;
        vec3 q = to_gate(light, view.eye_m - light.position_m);
        q.z += back;
        vec2 part = clip_to_cone(q, to_gate(light, dir), k, far + radius);
        bool dark = max(light.intensity_cd.x, max(light.intensity_cd.y, light.intensity_cd.z)) <= 0.0;
        if (part.y > part.x && !dark) {
            p.tile_light.at[tile * p.list_count + count] = index;
            count++;
        }
    }
    p.tile_count.at[tile] = count;
}
