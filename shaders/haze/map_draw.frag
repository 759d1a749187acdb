#version 460
// SPDX-License-Identifier: Apache-2.0
// Opaque surfaces in a distance map: their depth is all.

void main() {}
