#version 460
// SPDX-License-Identifier: Apache-2.0
// A sum of kept images, each with its weight: the additions of the light tree (Screen Space Re-Rendering, section 3). An invocation is two
// pixels side by side, which a kept image holds as six halves in one texel: without a GPU a load costs as much for two.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/push.h"
#include "shared/coarse.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, rgba16f) readonly uniform image2DArray base;  // the picture without lights
layout(binding = 1, rgba16f) readonly uniform image2DArray drawn; // lights drawn just now: layer 0 surfaces, layer 1 haze
layout(binding = 2, rgba32ui) uniform uimage2DArray kept;
layout(binding = 3, scalar) readonly buffer TileList { uint tile_list[]; };
layout(binding = 4, scalar) uniform Addends { Addend addends[kMostAddends]; };
layout(binding = 5, rgba16f) writeonly uniform image2DArray frame;
layout(binding = 6, rgba32ui) uniform uimage2DArray coarse; // instead of the frame (shared/coarse.h)
layout(push_constant, scalar) uniform Push { SumPush p; };
// Haze was sampled at the corners of the pixels, not in their middle.
layout(constant_id = 0) const bool kCorners = false;
// Light at half the size: a texel is one point, its surface and its haze.
layout(constant_id = 1) const bool kCoarse = false;
// What is added to what: constants, for without a GPU both sides of a branch are run.
layout(constant_id = 2) const uint kParts = 0u;    // of kSumToFrame ..
layout(constant_id = 3) const uint kAddends = 0u;  // so many; kManyAddends: as p says
const bool kToFrame = (kParts & kSumToFrame) != 0u;
const bool kBase = (kParts & kSumBase) != 0u;
const bool kDrawn = (kParts & kSumDrawn) != 0u;

struct Pair {
    vec3 left, right;
};

Pair unpack(uvec4 packed_pair) {
    vec2 a = unpackHalf2x16(packed_pair.x), b = unpackHalf2x16(packed_pair.y), c = unpackHalf2x16(packed_pair.z);
    return Pair(vec3(a, b.x), vec3(b.y, c));
}

void add(ivec2 pair, Addend addend, inout Pair sum) {
    Pair image = unpack(imageLoad(kept, ivec3(pair, addend.layer)));
    sum.left += addend.weight * image.left;
    sum.right += addend.weight * image.right;
}

vec3 new_light(ivec2 at, ivec2 last) {
    vec3 sum = imageLoad(drawn, ivec3(at, 0)).rgb;
    if (!kCorners) return sum + imageLoad(drawn, ivec3(at, 1)).rgb;
    // Every corner of a 2x2 block has its own offset along the ray (interleaved sampling, Keller & Heidrich 2001): the mean of the four
    // corners has all offsets, everywhere, so hardly any noise is left.
    ivec2 next = min(at + 1, last);
    return sum + 0.25 * (imageLoad(drawn, ivec3(at, 1)) + imageLoad(drawn, ivec3(next.x, at.y, 1)) + imageLoad(drawn, ivec3(at.x, next.y, 1)) +
                         imageLoad(drawn, ivec3(next, 1))).rgb;
}

void main() {
    uvec2 tile = gl_WorkGroupID.xy;
    if (p.listed != 0u) {
        uint number = tile_list[kCoarse ? gl_WorkGroupID.x / 2u : gl_WorkGroupID.x];
        tile = uvec2(number % p.tiles_x, number / p.tiles_x);
        if (kCoarse) tile.x = 2u * tile.x + (gl_WorkGroupID.x & 1u);
    }
    ivec2 pair = ivec2(tile * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy);
    ivec2 at = kCoarse ? pair : ivec2(2 * pair.x, pair.y), last = (kCoarse ? imageSize(coarse).xy : imageSize(base).xy) - 1;
    if (any(greaterThan(at, last))) return;
    ivec2 right = ivec2(min(at.x + 1, last.x), at.y);
    Pair sum = Pair(vec3(0.0), vec3(0.0));
    if (kBase && !kCoarse) sum = Pair(imageLoad(base, ivec3(at, 0)).rgb, imageLoad(base, ivec3(right, 0)).rgb);
    if (kDrawn && kCoarse) {
        sum = Pair(imageLoad(drawn, ivec3(at, 0)).rgb, imageLoad(drawn, ivec3(at, 1)).rgb);
    } else if (kDrawn) {
        sum.left += new_light(at, last);
        sum.right += new_light(right, last);
    }
    if (kAddends == kManyAddends)
        for (uint k = 0u; k < p.addend_count; ++k) add(pair, addends[k], sum);
    // Not in a loop: a value at a constant index is loaded once, not for every lane.
    if (kAddends > 0u && kAddends < kManyAddends) add(pair, addends[0], sum);
    if (kAddends > 1u && kAddends < kManyAddends) add(pair, addends[1], sum);
    if (kAddends > 2u && kAddends < kManyAddends) add(pair, addends[2], sum);
    if (kAddends > 3u && kAddends < kManyAddends) add(pair, addends[3], sum);
    if (kAddends > 4u && kAddends < kManyAddends) add(pair, addends[4], sum);
    if (kAddends > 5u && kAddends < kManyAddends) add(pair, addends[5], sum);
    if (kAddends > 6u && kAddends < kManyAddends) add(pair, addends[6], sum);
    if (kAddends > 7u && kAddends < kManyAddends) add(pair, addends[7], sum);
    if (kAddends > 8u && kAddends < kManyAddends) add(pair, addends[8], sum);
    if (kAddends > 9u && kAddends < kManyAddends) add(pair, addends[9], sum);
    if (kAddends > 10u && kAddends < kManyAddends) add(pair, addends[10], sum);
    if (kAddends > 11u && kAddends < kManyAddends) add(pair, addends[11], sum);
    if (kAddends > 12u && kAddends < kManyAddends) add(pair, addends[12], sum);
    if (kAddends > 13u && kAddends < kManyAddends) add(pair, addends[13], sum);
    if (kAddends > 14u && kAddends < kManyAddends) add(pair, addends[14], sum);
    if (kAddends > 15u && kAddends < kManyAddends) add(pair, addends[15], sum);
    if (kCoarse && kToFrame) sum.left *= uintBitsToFloat(imageLoad(coarse, ivec3(at, kCoarseWhite)).xyz);
    vec3 a = light_to_store(vec4(sum.left, 0.0)).rgb, b = light_to_store(vec4(sum.right, 0.0)).rgb;
    uvec4 packed_sum = uvec4(packHalf2x16(a.rg), packHalf2x16(vec2(a.b, b.r)), packHalf2x16(b.gb), 0u);
    if (kToFrame && kCoarse) {
        imageStore(coarse, ivec3(at, kCoarseLight), packed_sum);
    } else if (kToFrame) {
        imageStore(frame, ivec3(at, 0), vec4(a, 0.0));
        if (right.x > at.x) imageStore(frame, ivec3(right, 0), vec4(b, 0.0));
    } else {
        imageStore(kept, ivec3(pair, p.target), packed_sum);
    }
}
