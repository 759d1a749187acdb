#version 460
// SPDX-License-Identifier: Apache-2.0
// Lists per tile the lights whose cone can meet the tile's bundle of camera rays. Conservative: the cone is widened by the
// radius of the bundle at its far end (a cone moved back by r / sin holds all points within r of it), and only the ray
// through the middle is tested.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/beam.h"

layout(local_size_x = 64) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1, scalar) uniform LightBlock { Light lights[kLightsPerDispatch]; };
layout(binding = 2, scalar) readonly buffer TileFar { float tile_far[]; };  // distance of the farthest fragment
layout(binding = 3, scalar) writeonly buffer TileMask { uint tile_mask[]; }; // kMaskWords words a tile, a bit a light
layout(push_constant, scalar) uniform Push { CullPush p; };

vec3 gobo_sample(uint layer, vec2 gate, float blur) { return vec3(1.0); }

void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= p.tiles_x * p.tiles_y) return;
    vec2 size = vec2(view.width, view.height);
    vec2 low = vec2(tile % p.tiles_x, tile / p.tiles_x) * vec2(kTileWidth, kTileHeight);
    vec2 middle = low + 0.5 * vec2(kTileWidth, kTileHeight);
    vec2 ndc = vec2(2.0 * middle.x / size.x - 1.0, 1.0 - 2.0 * middle.y / size.y);
    vec3 ray = view.forward + view.right * ndc.x + view.up * ndc.y;
    float ray_length = length(ray);
    vec3 dir = ray / ray_length;
    float far = tile_far[tile];
    // Half the tile's diagonal as seen along the ray.
    float spread = length(view.right * (float(kTileWidth) / size.x) + view.up * (float(kTileHeight) / size.y)) / ray_length;
    float radius = far * spread * 1.05 + 1e-3;

    for (uint word = 0u; word < kMaskWords; ++word) {
        uint mask = 0u;
        uint end = min(p.light_count, (word + 1u) * 32u);
        for (uint i = word * 32u; i < end; ++i) {
            Light light = lights[i];
            float k = light.tan_field * light.cut_radius;
            float back = radius * sqrt(1.0 + k * k) / k;
            vec3 q = to_gate(light, view.eye_m - light.position_m);
            q.z += back;
            vec2 part = clip_to_cone(q, to_gate(light, dir), k, far + radius);
            bool lit = max(light.intensity_cd.x, max(light.intensity_cd.y, light.intensity_cd.z)) > 0.0;
            mask |= part.y > part.x && lit ? 1u << (i & 31u) : 0u;
        }
        tile_mask[tile * kMaskWords + word] = mask;
    }
}
