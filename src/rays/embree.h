#pragma once
// SPDX-License-Identifier: Apache-2.0
// Embree 3 (Debian 12) and Embree 4 (Debian 13), which moved what a ray asks for from the context into
// arguments of each call: the calls that the tracer makes, under one name. Lanes of packets: those whose
// `valid` is -1. A filter finds the context in its arguments. From any thread.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace ghost::bake::embree {

#if RTC_VERSION_MAJOR >= 4

using Context = RTCRayQueryContext;

inline void begin(Context& context) {
    rtcInitRayQueryContext(&context);
}

inline void intersect1(RTCScene scene, Context& context, RTCRayHit& hit) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &hit, &arguments);
}

// Rays near each other.
inline void intersect8(const int* valid, RTCScene scene, Context& context, RTCRayHit8& hits) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect8(valid, scene, &hits, &arguments);
}

inline void occluded8(const int* valid, RTCScene scene, Context& context, RTCRay8& rays) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    rtcOccluded8(valid, scene, &rays, &arguments);
}

#else

using Context = RTCIntersectContext;

inline void begin(Context& context) {
    rtcInitIntersectContext(&context);
}

inline void intersect1(RTCScene scene, Context& context, RTCRayHit& hit) {
    rtcIntersect1(scene, &context, &hit);
}

// Rays near each other.
inline void intersect8(const int* valid, RTCScene scene, Context& context, RTCRayHit8& hits) {
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid, scene, &context, &hits);
}

inline void occluded8(const int* valid, RTCScene scene, Context& context, RTCRay8& rays) {
    rtcOccluded8(valid, scene, &context, &rays);
}

#endif

} // namespace ghost::bake::embree
