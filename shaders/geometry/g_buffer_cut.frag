#version 460
// SPDX-License-Identifier: Apache-2.0
// Masked and blended surfaces of the G-buffer.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#define CUT
#include "common/g_buffer.glsl"
