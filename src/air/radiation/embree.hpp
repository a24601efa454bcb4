#pragma once
// Embree 3 and 4 alike: the one place that knows how they differ. CMake says which one is there (IDIOPHONE_EMBREE).

#if IDIOPHONE_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

namespace idiophone::radiation::embree {

#if IDIOPHONE_EMBREE == 3

using Context = RTCIntersectContext;  ///< of one ray; a filter gets a pointer to it

inline void initialise(Context& context) {
  rtcInitIntersectContext(&context);
}

/// Sets the ray's tfar to minus infinity if something blocks it.
inline void occlude(RTCScene scene, RTCRay& ray, Context& context) {
  rtcOccluded1(scene, &context, &ray);
}

#else

using Context = RTCRayQueryContext;

inline void initialise(Context& context) {
  rtcInitRayQueryContext(&context);
}

inline void occlude(RTCScene scene, RTCRay& ray, Context& context) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}

#endif

}  // namespace idiophone::radiation::embree
