#version 460
// SPDX-License-Identifier: Apache-2.0
// Surfaces of a free camera: every fragment of the G-buffer shows its material under the beam, behind the shadow of the light's
// distance map. Laid out as surface.comp.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/air.h"
#define DISTANCE_MAPS 8
#define SLIDES 13
#include "gobo_texture.glsl"
#include "octahedral_map.glsl"
#include "shared/beam.h"
#include "shared/brdf.h"
#include "shared/g_buffer.h"
#include "shared/haze.h"

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 1, scalar) uniform ViewBlock { View view; };
layout(binding = 2, scalar) uniform LightBlock { Light lights[kLightsPerChunk]; };
layout(binding = 3, scalar) readonly buffer Masks { uint mask_of[]; };
layout(binding = 4, scalar) readonly buffer Lists { uint list[]; };
layout(binding = 5, rgba32f) readonly uniform image2DArray places;
layout(binding = 6, rgba16f) uniform image2DArray drawn;
layout(binding = 7, rgba16f) readonly uniform image2DArray diffuse; // Brdf::diffuse, alpha
layout(binding = 9, rgba16f) readonly uniform image2DArray specular; // Brdf::f0, f90
layout(binding = 10, rgba16f) readonly uniform image2DArray normals; // and the facet's, packed
layout(binding = 11, scalar) uniform AirBlock { Air air; };
layout(binding = 12) uniform sampler2DArray nearest_maps; // render/distance_images.h
layout(push_constant, scalar) uniform Push { RelightPush p; };
layout(constant_id = 1) const bool kSingle = false; // a batch is one light
layout(constant_id = 2) const bool kShadows = true;
layout(constant_id = 3) const bool kIlluminance = false; // lux on the surface, instead of what the eye sees of it

struct Fragment {
    vec3 position_m;
    vec3 normal;
    vec3 facet;
    vec3 to_eye;
    float area_m2; // that the pixel shows
    Brdf brdf;
};

// Share of the light that reaches a place: a box over the map, as wide as the penumbra that a lens of this size throws from
// what is in the way (Fernando 2005), 1 to 3 texels of every, every 2nd, 4th or 8th one, by what is nearest around there. Each
// texel is compared with the plane of the facet, so that a slanted surface does not shadow itself; what is nearer than kBias in
// front of that plane does not count.
const float kBias_m = 0.02;
const float kBias = 0.004;      // of the distance, more
const float kDiscToBox = 0.86; // a box this much narrower than the disc's penumbra rises as fast from 10 to 90 %

// Full width of the penumbra as the light sees it.
float penumbra_rad(Light light, float blocker_m, float distance_m) {
    return kDiscToBox * 2.0 * light.disc_radius_m * max(distance_m - blocker_m, 0.0) / max(blocker_m * distance_m, 1e-4);
}

int stride_for(float penumbra_texels) {
    return penumbra_texels <= 3.0 ? 1 : (penumbra_texels <= 6.0 ? 2 : (penumbra_texels <= 12.0 ? 4 : 8));
}

float lit_share(Light light, Fragment f, vec3 from_map, float distance_m, bool wanted) {
    int size = textureSize(distance_maps, 0).x;
    int cells = textureSize(nearest_maps, 0).x;
    vec2 map_place = octahedral_from(from_map);
    float per_rad = 1.0 / texel_rad(from_map / distance_m, size);
    float nearest_m =
        texelFetch(nearest_maps, ivec3(min(ivec2(map_place * float(cells)), cells - 1), int(max(light.map, 1u)) - 1), 0).x;
    float bias = kBias_m + kBias * distance_m;
    float plane = dot(f.facet, from_map);
    float facing = abs(plane) > 0.02 * distance_m ? 1.0 / plane : 0.0;
    int stride = stride_for(penumbra_rad(light, nearest_m, distance_m) * per_rad);
    vec2 inside = vec2(0.0);
    uint nearer = 0u; // a bit for each texel
    float penumbra_texels = 0.0;
    // What is nearest around there may not be what throws this shadow: then once more, as finely as that needs.
    int passes = 2;
    for (int pass = 0; pass < passes; ++pass) {
        vec2 place = map_place * (float(size) / float(stride));
        ivec2 corner = ivec2(floor(place - 1.5));
        inside = place - vec2(corner);
        nearer = 0u;
        float blocker_m = 0.0;
        // Where nothing shines anyway one row has to do.
        for (int row = 0; row < (wanted ? 4 : 1); ++row)
            for (int column = 0; column < 4; ++column) {
                ivec2 at = (corner + ivec2(column, row)) * stride + stride / 2;
                float map_m = map_texel(light.map, at, size);
                // Where this texel's ray meets the plane of the facet.
                vec3 ray = direction_from_octahedral((vec2(at) + 0.5) / float(size));
                float inverse = dot(f.facet, ray) * facing;
                float plane_m = inverse > 0.5 / distance_m ? 1.0 / inverse : distance_m;
                bool blocks = map_m < plane_m - bias;
                nearer |= blocks ? 1u << (4 * row + column) : 0u;
                blocker_m += blocks ? map_m : 0.0;
            }
        blocker_m = blocker_m / max(float(bitCount(nearer)), 1.0);
        penumbra_texels = nearer == 0u ? 0.0 : penumbra_rad(light, blocker_m, distance_m) * per_rad;
        int finer = min(stride_for(penumbra_texels), stride);
        passes = wanted && finer < stride ? passes : 1;
        stride = pass + 1 < passes ? finer : stride;
    }
    float half_width = 0.5 * clamp(penumbra_texels / float(stride), 1.0, 3.0);
    const vec4 cell = vec4(0.0, 1.0, 2.0, 3.0);
    vec4 across = max(min(cell + 1.0, inside.x + half_width) - max(cell, inside.x - half_width), 0.0);
    vec4 down = max(min(cell + 1.0, inside.y + half_width) - max(cell, inside.y - half_width), 0.0);
    float dark = 0.0;
    for (int row = 0; row < 4; ++row)
        dark += down[row] * dot(across, vec4(uvec4(nearer) >> uvec4(4 * row, 4 * row + 1, 4 * row + 2, 4 * row + 3) & 1u));
    float weights = dot(across, vec4(1.0)) * dot(down, vec4(1.0));
    return light.map == 0u ? 1.0 : 1.0 - dark / max(weights, 1e-6);
}

vec3 shown(Light light, Fragment f, Haze haze) {
    vec3 from_light = f.position_m - light.position_m;
    float distance2 = max(dot(from_light, from_light), 1e-4);
    float distance_m = sqrt(distance2);
    vec3 q = to_gate(light, from_light);
    float facing = -dot(f.facet, from_light) / distance_m;
    // It comes from the lens, not from the apex behind it; a cell of a bar is a bit beside the place where the map was made.
    vec3 from_map = from_light + light.off_map_m;
    vec3 to_light = -from_map / max(length(from_map), 0.01);
    // The beam's mean over the fragment: a blur as wide as that is in the gate. (Shadows as wide as the fragment gain .1 dB, but
    // their relative error grows by up to 9 %.)
    float width_m = sqrt(f.area_m2 * max(facing, 0.0));
    float z = max(q.z, 1e-4);
    float per_m = 1.0 / (z * light.tan_field);
    Focus focus = beam_focus(light, z);
    focus.least = 0.5 * width_m * per_m;
    vec3 beam_cd = q.z > max(light.lens_m, 1e-4) ? light.intensity_cd * beam_gate(light, q.xy * per_m, focus) : vec3(0.0);
    vec3 light_cd = beam_cd *
                    (haze_transmittance(haze, way_from_lens_m(light, q)) * attenuation_factor(air.attenuation, distance_m) / distance2);
    // The facet is kept to 2 degrees, the normal exactly.
    vec3 value = light_cd * (kIlluminance ? vec3(max(dot(f.normal, to_light), 0.0)) : brdf_times_cosine(f.brdf, f.normal, f.to_eye, to_light));
    value = dot(f.facet, to_light) > 0.0 ? value : vec3(0.0);
    if (kShadows)
        value *= lit_share(light, f, from_map, max(length(from_map), 0.01), max(max(value.r, value.g), value.b) > 0.0);
    return value;
}

void main() {
    uvec2 size = uvec2(view.width, view.height);
    uint tile = list[p.batch * (2u * p.tiles + p.blocks) + p.tiles + gl_WorkGroupID.x];
    uvec2 pixel = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    uint extra = (tile - p.tiles) * kTilePixels + gl_LocalInvocationIndex;
    bool is_extra = tile >= p.tiles;
    bool inside = is_extra || (pixel.x < size.x && pixel.y < size.y);
    pixel = is_extra ? uvec2(extra % size.x, size.y + extra / size.x) : min(pixel, size - 1u);
    ivec3 at = ivec3(pixel, 0);
    Haze haze = view.haze;
    vec4 place = imageLoad(places, at);
    vec4 normal = imageLoad(normals, at);
    vec4 layer = imageLoad(diffuse, at);
    vec4 mirror = imageLoad(specular, at);
    Fragment f;
    f.position_m = place.xyz;
    f.normal = normal.xyz;
    f.facet = unpack_facet(normal.w);
    float eye_m = max(length(view.eye_m - place.xyz), 1e-4);
    f.to_eye = (view.eye_m - place.xyz) / eye_m;
    float pixel_m = 2.0 * length(view.right) / float(view.width) * eye_m;
    // Seen at a low angle it is long and narrow: a round blur twice as wide as it is narrow keeps what runs along it.
    f.area_m2 = place.w * pixel_m * pixel_m / max(dot(f.facet, f.to_eye), 0.25);
    f.brdf = Brdf(layer.rgb, layer.a, mirror.rgb, mirror.a);

    vec3 sum = vec3(0.0);
    if (kSingle) {
        sum = shown(lights[p.batch], f, haze);
    } else {
        uint words = (p.light_count + 31u) / 32u;
        for (uint word = 0u; word < words; ++word) {
            uint mask = mask_of[tile * kMaskWords + word];
            while (mask != 0u) {
                sum += shown(lights[word * 32u + uint(findLSB(mask))], f, haze);
                mask &= mask - 1u;
            }
        }
    }
    // What no fragment fills may hold anything.
    sum = place.w > 0.0 ? sum * (place.w * (kIlluminance ? 1.0 : haze_transmittance(haze, eye_m))) : vec3(0.0);
    if (inside)
        imageStore(drawn, at, light_to_store(imageLoad(drawn, at) + vec4(sum, 0.0)));
}
