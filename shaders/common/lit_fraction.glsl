// SPDX-License-Identifier: Apache-2.0
// What fraction of its lens a light shows to a fragment, by its distance map. from_map: from where that was made. Who includes this has
// soft_shadow.glsl.

float lit_fraction(Light light, vec3 facet, vec3 from_map, bool wanted) {
    Receiver r;
    r.map = max(light.map, 1u);
    r.distance_m = max(length(from_map), 0.01);
    r.ray = from_map / r.distance_m;
    int size = textureSize(distance_maps, 0).x;
    r.texel_rad = texel_rad(r.ray, size);
    r.place = octahedral_from(from_map) * float(size);
    r.facet = facet;
    float plane = dot(facet, from_map);
    r.per_plane_m = abs(plane) > 0.02 * r.distance_m ? 1.0 / plane : 0.0;
    r.lens_m = light.disc_radius_m;
    return soft_shadow(r, wanted && light.map != 0u);
}
