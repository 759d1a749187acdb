// SPDX-License-Identifier: Apache-2.0
// Sorts the samples of every pixel of the G-buffer into fragments (passes/passes.h): the main one where the pixel is, the
// others together behind the picture, those of a tile next to each other. Also the picture without lights, and
// the bounds of the tiles. A workgroup is a tile. Tiles may be gathered again one by one: they keep their room for extra fragments
// if it is large enough, and get a new one at the end otherwise.
// With SINGLE defined a pixel has one sample, so that its fragment is all there is.
#include "shared/push.h"
#include "shared/brdf.h"
#include "shared/haze.h"
#include "shared/g_buffer.h"
#include "common/bounds.glsl"

#ifdef SINGLE
#define SAMPLED sampler2DArray
#define FETCH(image, at, sample) texelFetch(image, ivec3(at, 0), 0)
const int kOfPixel = 1;
#else
#define SAMPLED sampler2DMS
#define FETCH(image, at, sample) texelFetch(image, at, sample)
const int kOfPixel = int(kSamples);
#endif

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0, scalar) uniform ViewBlock { View view; };
layout(binding = 1) uniform SAMPLED depths;
layout(binding = 2) uniform SAMPLED bases;     // base colour, roughness
layout(binding = 3) uniform SAMPLED normals;   // octahedral normal, slope of the depth
layout(binding = 4) uniform SAMPLED emissions; // emission, specular
layout(binding = 5) uniform SAMPLED metals;
layout(binding = 6, rgba32f) writeonly uniform image2DArray places;
layout(binding = 7, rgba16f) writeonly uniform image2DArray diffuse;
layout(binding = 8, rgba16f) writeonly uniform image2DArray specular;
layout(binding = 9, rgba16f) writeonly uniform image2DArray shown_normals;
layout(binding = 10, rgba16f) writeonly uniform image2DArray base;
layout(binding = 11, scalar) writeonly buffer TileBounds { vec4 tile_bounds[]; };
layout(binding = 12, scalar) buffer Rooms { TileRoom rooms[]; };
layout(binding = 13, scalar) readonly buffer TileList { uint tile_list[]; };
// With several samples only:
layout(binding = 14, rg32ui) writeonly uniform uimage2DArray edges;
layout(binding = 15, scalar) buffer Counts { GatherCounts counts; };
layout(binding = 16, scalar) buffer BlockList { BlockListHead block_head; uint block_list[]; };
layout(push_constant, scalar) uniform Push { GatherPush p; };

// Vulkan's standard locations; (0, 0) is the pixel's upper left corner.
#ifdef SINGLE
const vec2 kSampleAt[kOfPixel] = vec2[kOfPixel](vec2(0.5));
#else
const vec2 kSampleAt[kOfPixel] = vec2[kOfPixel](vec2(0.375, 0.125), vec2(0.875, 0.375), vec2(0.125, 0.625), vec2(0.625, 0.875));
#endif

vec3 ray_at(vec2 pixel) {
    return view.forward + view.right * (2.0 * pixel.x / float(view.width) - 1.0) + view.up * (1.0 - 2.0 * pixel.y / float(view.height));
}

vec3 from_octahedral(vec2 at) {
    vec3 n = vec3(at, 1.0 - abs(at.x) - abs(at.y));
    float inward = max(-n.z, 0.0);
    n.xy += vec2(n.x < 0.0 ? inward : -inward, n.y < 0.0 ? inward : -inward);
    return normalize(n);
}

const float kWorkEven = 0.25; // of the work light: that comes from everywhere

// Where the rest of the work light comes from: over the viewer's left shoulder, so that shapes have sides.
vec3 work_lamp() { return normalize(-normalize(view.forward) + 0.55 * normalize(view.up) - 0.4 * normalize(view.right)); }

// Of the plane whose depth has this slope at a point of the picture, towards the viewer.
vec3 facet_of(vec2 slope, vec2 pixel) {
    vec2 size = vec2(view.width, view.height);
    vec2 ndc = vec2(2.0 * pixel.x / size.x - 1.0, 1.0 - 2.0 * pixel.y / size.y);
    vec2 along = vec2(slope.x, -slope.y) * size * 0.5;
    vec3 n = view.forward * (1.0 - dot(ndc, along)) + view.right * (along.x / dot(view.right, view.right)) +
             view.up * (along.y / dot(view.up, view.up));
    return -n / max(length(n), 1e-20);
}

#ifndef SINGLE
shared uint first_extra;
shared uint first_edge;
shared uint has_room;
// Places that nothing fills: from, to, from, to.
shared uvec4 spare_extras;
shared uvec4 spare_edges;

// A block may be listed several times: once for each tile of the list that it belongs to.
void list_blocks(uint first, uint count) {
    for (uint block = first / kTilePixels; block * kTilePixels < first + count; ++block)
        block_list[atomicAdd(block_head.groups[0], 1u)] = block;
}

// Where the extra fragments of a pixel go, one after the other, and its edge with them; every invocation of the tile calls it.
uint find_room(uint tile, ivec2 at, uint extras) {
    uvec2 size = uvec2(view.width, view.height);
    // Extras in the low half, edges in the high half.
    uvec2 sums = sum_of_group(extras | (extras > 0u ? 0x10000u : 0u));
    if (gl_LocalInvocationIndex == 0u) {
        uint all = sums.y & 0xffffu;
        uint edge_count = sums.y >> 16;
        TileRoom old = TileRoom(0u, 0u, 0u, 0u);
        if (p.listed != 0u) old = rooms[tile];
        TileRoom own = old;
        has_room = 1u;
        bool moves = all > old.extras || edge_count > old.edges;
        if (moves) {
            own.extras = all + (p.listed != 0u ? kSpareRoom : 0u);
            own.edges = edge_count + (p.listed != 0u ? kSpareRoom : 0u);
            own.first_extra = atomicAdd(counts.extras, own.extras);
            // What once found no room left never finds any again, so the places taken are without gaps.
            has_room = own.first_extra + own.extras <= p.capacity ? 1u : 0u;
            if (has_room == 1u) {
                own.first_edge = atomicAdd(counts.edges, own.edges);
                has_room = own.first_edge + own.edges <= size.x * size.y ? 1u : 0u;
            }
            if (has_room == 1u) {
                atomicMax(counts.used, own.first_extra + own.extras);
                atomicMax(counts.groups[0], (own.first_extra + own.extras + kTilePixels - 1u) / kTilePixels);
            } else {
                own = TileRoom(0u, 0u, 0u, 0u);
                atomicAdd(counts.dropped, edge_count);
            }
        }
        rooms[tile] = own;
        if (p.listed != 0u) {
            if (own.extras > 0u) list_blocks(own.first_extra, own.extras);
            if (moves && old.extras > 0u) list_blocks(old.first_extra, old.extras);
        }
        first_extra = own.first_extra;
        first_edge = own.first_edge;
        uint filled = has_room == 1u ? all : 0u;
        uint filled_edges = has_room == 1u ? edge_count : 0u;
        spare_extras = uvec4(own.first_extra + filled, own.first_extra + own.extras, old.first_extra, old.first_extra + (moves ? old.extras : 0u));
        spare_edges = uvec4(own.first_edge + filled_edges, own.first_edge + own.edges, old.first_edge, old.first_edge + (moves ? old.edges : 0u));
    }
    barrier();
    for (uint k = spare_extras.x + gl_LocalInvocationIndex; k < spare_extras.y; k += kTilePixels)
        imageStore(places, ivec3(k % size.x, size.y + k / size.x, 0), vec4(0.0, 0.0, 0.0, -1.0));
    for (uint k = spare_extras.z + gl_LocalInvocationIndex; k < spare_extras.w; k += kTilePixels)
        imageStore(places, ivec3(k % size.x, size.y + k / size.x, 0), vec4(0.0, 0.0, 0.0, -1.0));
    for (uint k = spare_edges.x + gl_LocalInvocationIndex; k < spare_edges.y; k += kTilePixels)
        imageStore(edges, ivec3(k % size.x, k / size.x, 0), uvec4(0u));
    for (uint k = spare_edges.z + gl_LocalInvocationIndex; k < spare_edges.w; k += kTilePixels)
        imageStore(edges, ivec3(k % size.x, k / size.x, 0), uvec4(0u));
    uint extra = first_extra + (sums.x & 0xffffu);
    if (has_room == 1u && extras > 0u) {
        uint edge = first_edge + (sums.x >> 16);
        imageStore(edges, ivec3(edge % size.x, edge / size.x, 0), uvec4(uint(at.y) * size.x + uint(at.x), extra * 4u + extras, 0u, 0u));
    }
    return extra;
}
#endif

void main() {
    uvec2 size = uvec2(view.width, view.height);
    uint tile = gl_WorkGroupID.y * p.tiles_x + gl_WorkGroupID.x;
    if (p.listed != 0u) tile = tile_list[gl_WorkGroupID.x];
    uvec2 pixel = uvec2(tile % p.tiles_x, tile / p.tiles_x) * uvec2(kTileWidth, kTileHeight) + gl_LocalInvocationID.xy;
    bool inside = all(lessThan(pixel, size));
    ivec2 at = ivec2(min(pixel, size - 1u));

    float depth[kOfPixel];
    vec4 tilt[kOfPixel];
    vec3 normal[kOfPixel];
    vec3 place[kOfPixel];
    int owner[kOfPixel]; // the first sample of the same fragment; -1: no surface
    Box box = Box(vec3(kNowhere), vec3(-kNowhere), 0.0);
    for (int s = 0; s < kOfPixel; ++s) {
        depth[s] = FETCH(depths, at, s).x;
        tilt[s] = FETCH(normals, at, s);
        normal[s] = from_octahedral(tilt[s].xy);
        bool live = inside && depth[s] > kNear_m / kFarthest_m;
        vec3 way = ray_at(vec2(at) + kSampleAt[s]) * (kNear_m / max(depth[s], kNear_m / kFarthest_m));
        place[s] = view.eye_m + way;
        owner[s] = live ? s : -1;
        box.low = min(box.low, live ? place[s] : vec3(kNowhere));
        box.high = max(box.high, live ? place[s] : vec3(-kNowhere));
        box.far_m = max(box.far_m, live ? length(way) : (inside ? view.far_m : 0.0));
    }
    for (int s = 1; s < kOfPixel; ++s)
        for (int r = 0; r < s; ++r) {
            float ratio = depth[s] / max(depth[r], 1e-12);
            vec2 slope = tilt[r].zw;
            float off_plane = abs(ratio - 1.0 - dot(slope, kSampleAt[s] - kSampleAt[r]));
            bool same = dot(normal[r], normal[s]) > kNormalCosine &&
                        off_plane < kPlanePixels * sqrt(p.pixel_m * p.pixel_m + dot(slope, slope)) &&
                        abs(ratio - 1.0) < kDepthPixels * p.pixel_m * max(ratio, 1.0);
            owner[s] = owner[s] == s && owner[r] == r && same ? r : owner[s];
        }
    // Fragments by number: 0 has most samples, the others follow as they come.
    int most = 0;
    int main_owner = -1;
    int count = 0;
    for (int r = 0; r < kOfPixel; ++r) {
        int samples = 0;
        for (int s = r; s < kOfPixel; ++s) samples += owner[s] == r ? 1 : 0;
        main_owner = samples > most ? r : main_owner;
        most = max(most, samples);
        count += samples > 0 ? 1 : 0;
    }
    int number[kOfPixel];
    for (int s = 0; s < kOfPixel; ++s) {
        number[s] = owner[s] == main_owner ? 0 : 1;
        for (int r = 0; r < kOfPixel; ++r)
            number[s] += owner[s] != main_owner && r < owner[s] && owner[r] == r && r != main_owner ? 1 : 0;
        number[s] = owner[s] < 0 ? -1 : number[s];
    }

    uint extras = uint(max(count - 1, 0));
    uint extra = 0u; // place of the first of these
#ifdef SINGLE
    if (gl_LocalInvocationIndex == 0u) rooms[tile] = TileRoom(0u, 0u, 0u, 0u);
#else
    extra = find_room(tile, at, extras);
    // The main fragment stands for all of them.
    if (has_room == 0u)
        for (int s = 0; s < kOfPixel; ++s) number[s] = owner[s] < 0 ? -1 : (number[s] == 0 ? 0 : 4);
    count = has_room == 0u ? min(count, 1) : count;
#endif

    vec3 unlit = vec3(0.0);
    for (int k = 0; k < count; ++k) {
        vec3 mean_place = vec3(0.0);
        vec3 mean_normal = vec3(0.0);
        vec3 emission = vec3(0.0);
        vec2 slope = vec2(0.0);
        vec4 mean_diffuse = vec4(0.0);
        vec4 mean_specular = vec4(0.0);
        float samples = 0.0;
        float covered = 0.0;
        for (int s = 0; s < kOfPixel; ++s) {
            float weight = number[s] == k ? 1.0 : 0.0;
            vec4 base_colour = FETCH(bases, at, s);
            vec4 emitted = FETCH(emissions, at, s);
            Brdf brdf = brdf_of(base_colour.rgb, base_colour.a, FETCH(metals, at, s).x, emitted.a);
            samples += weight;
            covered += number[s] == k || number[s] == 4 ? 1.0 / float(kOfPixel) : 0.0;
            mean_place += weight * (place[s] - view.eye_m);
            mean_normal += weight * normal[s];
            emission += weight * emitted.rgb;
            slope += weight * tilt[s].zw;
            mean_diffuse += weight * vec4(brdf.diffuse, brdf.alpha);
            mean_specular += weight * vec4(brdf.f0, brdf.f90);
        }
        float fraction = 1.0 / max(samples, 1.0);
        vec3 way = mean_place * fraction;
        float away_m = max(length(way), 1e-6);
        vec3 shown = mean_normal / max(length(mean_normal), 1e-6);
        Brdf brdf = Brdf(mean_diffuse.rgb * fraction, mean_diffuse.a * fraction, mean_specular.rgb * fraction, mean_specular.a * fraction);
        // Of the work light no highlight: it shall show shapes, not itself.
        vec3 work = p.work_lux * (kWorkEven + (1.0 - kWorkEven) * max(dot(shown, work_lamp()), 0.0)) * brdf.diffuse;
        vec3 light = (p.ambient * brdf_albedo(brdf, abs(dot(shown, way)) / away_m) + work) * (1.0 / kPi) + emission * fraction;
        unlit += light * (covered * haze_transmittance(view.haze, away_m));
        uint index = extra + uint(max(k - 1, 0));
        ivec3 to = k == 0 ? ivec3(at, 0) : ivec3(index % size.x, size.y + index / size.x, 0);
        imageStore(places, to, vec4(view.eye_m + way, covered));
        imageStore(diffuse, to, vec4(brdf.diffuse, brdf.alpha));
        imageStore(specular, to, vec4(brdf.f0, brdf.f90));
        imageStore(shown_normals, to, pack_normals(shown, facet_of(slope * fraction, vec2(at) + 0.5)));
    }
    if (inside && count == 0) {
        imageStore(places, ivec3(at, 0), vec4(0.0, 0.0, 0.0, -1.0));
        imageStore(diffuse, ivec3(at, 0), vec4(0.0));
        imageStore(specular, ivec3(at, 0), vec4(0.0));
        imageStore(shown_normals, ivec3(at, 0), vec4(0.0));
    }
    if (inside) imageStore(base, ivec3(at, 0), light_to_store(vec4(unlit, 0.0)));

    box = box_of_group(box);
    vec3 centre = box.low.x <= box.high.x ? (box.low + box.high) * 0.5 : vec3(0.0);
    float radius = -1.0;
    for (int s = 0; s < kOfPixel; ++s) radius = max(radius, owner[s] >= 0 ? length(place[s] - centre) : -1.0);
    radius = most_of_group(radius);
    if (gl_LocalInvocationIndex == 0u) {
        tile_bounds[tile * 2u] = vec4(centre, radius);
        tile_bounds[tile * 2u + 1u] = vec4(box.far_m, 0.0, 0.0, 0.0);
    }
}
