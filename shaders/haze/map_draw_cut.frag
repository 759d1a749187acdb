#version 460
// SPDX-License-Identifier: Apache-2.0
// Masked and blended surfaces in a distance map: what lets light through is not there, as rays/tracer.cpp has it.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/g_buffer.h"

layout(constant_id = 0) const uint kAlpha = kMask;
layout(constant_id = 1) const uint kTextures = 0u;
layout(location = 0) in vec2 uv;
layout(binding = 0) uniform sampler2DArray base_texture;
layout(binding = 1, scalar) uniform Material { MeshMaterial p; };

void main() {
    float alpha = p.alpha;
    if ((kTextures & kBaseTexture) != 0u) alpha *= textureLod(base_texture, vec3(uv, 0.0), 0.0).a;
    if (!(kAlpha == kMask ? alpha >= p.alpha_cutoff : alpha > 0.5)) discard;
}
