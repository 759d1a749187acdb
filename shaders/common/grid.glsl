// SPDX-License-Identifier: Apache-2.0
// A light's haze on a grid over (row of its fan, h = tan(phi / 2)): along a row, from ray to ray, it is smooth but at edges of shadows and
// ends, so that every 16th ray is enough; across rows lies all detail. A node holds what a ray gathers without the factors that a pixel
// knows (ray_scale), and in alpha how far its columns are from a straight line; an end, a shadow's edge or a lens is far. What is not known
// well enough goes into a list and is drawn ray by ray. Epipolar sampling (Engelhardt, Dachsbacher 2010) with a test of its own.
// Who includes this has the push constants p: GridPush.

const float kGridScale = 32.0; // half floats: values neither too small nor too large
const float kUnknown = 1e4;    // doubt of a node that was not filled

const float kEndDoubt = 0.1; // fraction that a ray's end may be off those beside it

// Column 0..1 of a tangent, and back.
float grid_column(float h) {
    float even = (h - p.grid.near_h) * p.grid.per_h;
    return even * (1.0 + p.grid.bend) / (1.0 + p.grid.bend * even);
}

float grid_tangent(float column) {
    return p.grid.near_h + column / (1.0 + p.grid.bend - p.grid.bend * column) / p.grid.per_h;
}

// A camera ray beside a light's fan: where in its row it ends.
struct GridRay {
    float row;   // of the fan
    float sine;  // of the angle from the pole
    float h;
    float half_chord;
    float end;   // place along the chord, above 1: behind the beam
    bool hit;
};

GridRay grid_ray(Light light, Fan fan, vec3 dir, float far) {
    vec2 aside = vec2(dot(dir, fan.beam.along), dot(dir, fan.beam.across));
    float cosine = dot(dir, fan.beam.pole);
    float sine = max(length(aside), kLeastSine);
    vec2 meridian = aside / sine;
    float row = fan_row(fan.beam, meridian.x, meridian.y);
    vec4 chord = fan_chord(fan.beam, meridian);
    vec4 tangent = fan_tangent(fan.beam, chord, vec2(cosine, sine));
    float eye_z = fan.beam.eye_m * fan.beam.cos_axis;
    float fall = dot(dir, light.axis_w);
    fall = abs(fall) < 1e-6 ? 1e-6 : fall;
    float lens_t = (light.lens_m - eye_z) / fall;
    float t0 = fall > 0.0 ? max(lens_t, 0.0) : 0.0;
    float t1 = fall > 0.0 ? far : min(far, lens_t);
    float u0 = max(fan_tangent_at(tangent, t0), -chord.w);
    float u1 = min((tangent.x + t1 * tangent.y) / max(tangent.z + t1 * tangent.w, 1e-6), chord.w);
    float end = 0.5 + 0.5 * u1 / max(chord.w, 1e-9);
    return GridRay(row, sine, sine / max(1.0 - cosine, 1e-6), chord.w, end, u1 > u0 && t1 > t0 && abs(row) <= 1.0);
}
