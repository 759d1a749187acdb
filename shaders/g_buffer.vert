#version 460
// SPDX-License-Identifier: Apache-2.0
// Places a mesh in front of the camera. All positions are relative to the eye, so that nearness keeps its precision.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/g_buffer.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 tangent; // w: handedness
layout(location = 3) in vec2 uv;
layout(location = 4) in vec4 row_x; // of the instance's matrix, moved so that the eye is the origin
layout(location = 5) in vec4 row_y;
layout(location = 6) in vec4 row_z;
layout(location = 0) centroid out vec3 out_normal; // of the front
layout(location = 1) centroid out vec4 out_tangent;
layout(location = 2) centroid out vec2 out_uv;
layout(location = 3) flat out uint out_mirrored;
layout(push_constant, scalar) uniform Push { MeshPush p; };
layout(constant_id = 1) const uint kTextures = 0u;

void main() {
    vec4 at = vec4(position, 1.0);
    vec3 place = vec3(dot(row_x, at), dot(row_y, at), dot(row_z, at));
    gl_Position = p.to_clip[0] * place.x + p.to_clip[1] * place.y + p.to_clip[2] * place.z + p.to_clip[3];
    // Normals turn with the cofactors of the matrix, which may scale unevenly.
    vec3 cx = cross(row_y.xyz, row_z.xyz);
    vec3 cy = cross(row_z.xyz, row_x.xyz);
    vec3 cz = cross(row_x.xyz, row_y.xyz);
    float volume = dot(row_x.xyz, cx);
    vec3 turned = vec3(dot(cx, normal.xyz), dot(cy, normal.xyz), dot(cz, normal.xyz)) * sign(volume);
    // Unit per vertex, as the baker mixes them; clamped, so that a tiny scale does not vanish.
    out_normal = turned * inversesqrt(max(dot(turned, turned), 1e-36));
    out_tangent = vec4(0.0);
    out_uv = uv;
    if ((kTextures & kNormalTexture) != 0u)
        out_tangent = vec4(dot(row_x.xyz, tangent.xyz), dot(row_y.xyz, tangent.xyz), dot(row_z.xyz, tangent.xyz),
                           tangent.w * sign(volume));
    out_mirrored = volume < 0.0 ? 1u : 0u;
}
