// Embree 4; where there is only Embree 3, that by the names of 4, which has put the settings of a ray behind
// it.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#define RTCIntersectArguments RTCIntersectContext
#define RTCOccludedArguments RTCIntersectContext
#define rtcInitIntersectArguments rtcInitIntersectContext
#define rtcInitOccludedArguments rtcInitIntersectContext
#define RTC_RAY_QUERY_FLAG_COHERENT RTC_INTERSECT_CONTEXT_FLAG_COHERENT
#define rtcIntersect16(valid, scene, rays, with) rtcIntersect16(valid, scene, with, rays)
#define rtcOccluded16(valid, scene, rays, with) rtcOccluded16(valid, scene, with, rays)
#define rtcOccluded1(scene, ray, with) rtcOccluded1(scene, with, ray)
#endif
