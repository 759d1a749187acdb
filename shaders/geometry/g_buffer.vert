#version 460
// SPDX-License-Identifier: Apache-2.0
// Places a mesh in front of the camera.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/g_buffer.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 tangent; // w: handedness
layout(location = 3) in vec2 uv;
layout(location = 0) centroid out vec3 out_normal; // of the front
layout(location = 1) centroid out vec4 out_tangent;
layout(location = 2) centroid out vec2 out_uv;
layout(location = 3) flat out uint out_mirrored;
layout(location = 4) flat out float out_glow;
layout(push_constant, scalar) uniform Push { MeshPush p; };
layout(constant_id = 1) const uint kTextures = 0u;

void main() {
    gl_Position = p.to_clip[0] * position.x + p.to_clip[1] * position.y + p.to_clip[2] * position.z + p.to_clip[3];
    // Normals turn with the cofactors of the matrix, which may scale unevenly.
    vec3 cx = cross(p.axis[1], p.axis[2]);
    vec3 cy = cross(p.axis[2], p.axis[0]);
    vec3 cz = cross(p.axis[0], p.axis[1]);
    float volume = dot(p.axis[0], cx);
    vec3 turned = (cx * normal.x + cy * normal.y + cz * normal.z) * sign(volume);
    // Unit per vertex, as the baker mixes them; clamped, so that a tiny scale does not vanish.
    out_normal = turned * inversesqrt(max(dot(turned, turned), 1e-36));
    out_tangent = vec4(0.0);
    out_uv = uv;
    if ((kTextures & kNormalTexture) != 0u)
        out_tangent = vec4(p.axis[0] * tangent.x + p.axis[1] * tangent.y + p.axis[2] * tangent.z, tangent.w * sign(volume));
    out_mirrored = volume < 0.0 ? 1u : 0u;
    out_glow = p.glow;
}
