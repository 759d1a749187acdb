// SPDX-License-Identifier: Apache-2.0
// What a workgroup of kTilePixels has in common: a box, a sphere, a sum. Every invocation must call these.
// Loads from shared memory are one lane after the other on lavapipe, so a lane reads what its own number says
// and not all of them.
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
    for (uint k = gl_SubgroupInvocationID; k < gl_NumSubgroups; k += gl_SubgroupSize) {
        vec4 other_high = shared_high[k];
        low = min(low, shared_low[k].xyz);
        high = max(high, other_high.xyz);
        far_m = max(far_m, other_high.w);
    }
    barrier();
    return Box(subgroupMin(low), subgroupMax(high), subgroupMax(far_m));
}

float most_of_group(float own) {
    float most = subgroupMax(own);
    if (subgroupElect()) shared_low[gl_SubgroupID].x = most;
    barrier();
    for (uint k = gl_SubgroupInvocationID; k < gl_NumSubgroups; k += gl_SubgroupSize) most = max(most, shared_low[k].x);
    barrier();
    return subgroupMax(most);
}

// x: sum over the invocations before this one, y: over all.
uvec2 sum_of_group(uint own) {
    uint before = subgroupExclusiveAdd(own);
    uint all = subgroupAdd(own);
    if (subgroupElect()) shared_sum[gl_SubgroupID] = all;
    barrier();
    uint earlier = 0u;
    all = 0u;
    for (uint k = gl_SubgroupInvocationID; k < gl_NumSubgroups; k += gl_SubgroupSize) {
        uint sum = shared_sum[k];
        earlier += k < gl_SubgroupID ? sum : 0u;
        all += sum;
    }
    barrier();
    return uvec2(before + subgroupAdd(earlier), subgroupAdd(all));
}
