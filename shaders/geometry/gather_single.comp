#version 460
// SPDX-License-Identifier: Apache-2.0
// Of the one sample of a pixel.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#define SINGLE
#include "common/gather.glsl"
