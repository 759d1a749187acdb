// SPDX-License-Identifier: Apache-2.0
// What a workgroup of kTilePixels has in common: a box, a sphere, a sum. Every invocation must call these.
#extension GL_KHR_shader_subgroup_arithmetic : require

shared vec4 shared_low[kTilePixels]; // one per subgroup
shared vec4 shared_high[kTilePixels];
shared uint shared_sum[kTilePixels];

struct Box {
    vec3 low;
    vec3 high;
    float far_m;
};

const float kNowhere = 1e30;

Box box_of_group(Box own) {
    vec3 low = subgroupMin(own.low);
    vec3 high = subgroupMax(own.high);
    float far_m = subgroupMax(own.far_m);
    if (subgroupElect()) {
        shared_low[gl_SubgroupID] = vec4(low, 0.0);
        shared_high[gl_SubgroupID] = vec4(high, far_m);
    }
    barrier();
    Box all = own;
    for (uint k = 0u; k < gl_NumSubgroups; ++k) {
        all.low = min(all.low, shared_low[k].xyz);
        all.high = max(all.high, shared_high[k].xyz);
        all.far_m = max(all.far_m, shared_high[k].w);
    }
    barrier();
    return all;
}

float most_of_group(float own) {
    float most = subgroupMax(own);
    if (subgroupElect()) shared_low[gl_SubgroupID].x = most;
    barrier();
    for (uint k = 0u; k < gl_NumSubgroups; ++k) most = max(most, shared_low[k].x);
    barrier();
    return most;
}

// x: sum over the invocations before this one, y: over all.
uvec2 sum_of_group(uint own) {
    uint before = subgroupExclusiveAdd(own);
    uint all = subgroupAdd(own);
    if (subgroupElect()) shared_sum[gl_SubgroupID] = all;
    barrier();
    all = 0u;
    for (uint k = 0u; k < gl_NumSubgroups; ++k) {
        before += k < gl_SubgroupID ? shared_sum[k] : 0u;
        all += shared_sum[k];
    }
    barrier();
    return uvec2(before, all);
}
