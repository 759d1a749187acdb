// SPDX-License-Identifier: Apache-2.0
// What a beam that is narrower than two pixels sends to a surface: its light, shared out among the four pixels round its middle, so that
// a dot neither vanishes between pixels nor flickers as it moves.

// Square to the beam, candela over the square of the distance; below 0: the beam is wider. q: the surface's place in the gate; across,
// down: from there to what the next pixel shows, in the world.
float thin_dot_fraction(Light light, vec3 q, vec3 across, vec3 down) {
    mat2 to_gate = mat2(dot(across, light.axis_u), dot(across, light.axis_v), dot(down, light.axis_u), dot(down, light.axis_v));
    float area_m2 = abs(determinant(to_gate)); // of a pixel, seen along the beam
    float radius_m = q.z * light.tan_field * light.cut_radius;
    vec2 from_middle = abs(inverse(to_gate) * q.xy); // pixels
    vec2 tent = max(vec2(1.0) - from_middle, vec2(0.0));
    return radius_m * radius_m < area_m2 ? tent.x * tent.y / area_m2 : -1.0;
}

vec3 lumens_of(Light light) { return 4.0 * kPi * light.bounce_cd; }
