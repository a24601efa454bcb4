#pragma once
// OpenCL's functions, and what their answers mean.

#ifdef IDIOPHONE_HAS_OPENCL

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "idiophone/foundation/accelerator/accelerator.hpp"

namespace idiophone::accelerator {

/// @param action  what was done, e.g. "start a kernel"
/// @throws std::runtime_error if it did not succeed
inline void require_success(cl_int status, const char* action) {
  switch (status) {
    case CL_SUCCESS:
      return;
    case CL_MEM_OBJECT_ALLOCATION_FAILURE:
    case CL_OUT_OF_RESOURCES:
    case CL_INVALID_BUFFER_SIZE:
      throw std::runtime_error(
          fmt::format("accelerator: could not {}: its memory is too small (OpenCL error {}); let it compute less, or "
                      "use more of them",
                      action, status));
    default:
      throw std::runtime_error(fmt::format("accelerator: could not {} (OpenCL error {})", action, status));
  }
}

/// @param release  OpenCL's function for this kind of object
template <class Object>
Handle owned(Object object, cl_int (*release)(Object)) {
  return {object, [release](void* one) { release(static_cast<Object>(one)); }};
}

}  // namespace idiophone::accelerator

#endif
