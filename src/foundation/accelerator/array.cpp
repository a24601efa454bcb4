#include "idiophone/foundation/accelerator/array.hpp"

#ifdef IDIOPHONE_HAS_OPENCL

#include <algorithm>

#include "opencl.hpp"

namespace idiophone::accelerator {

namespace {

cl_command_queue queue_of(const Accelerator& accelerator) {
  return static_cast<cl_command_queue>(accelerator.queue());
}

}  // namespace

Memory::Memory(Accelerator& accelerator, std::size_t bytes)
    : accelerator_(&accelerator), number_(accelerator.next_array_number()) {
  const std::size_t length = std::max<std::size_t>(bytes, 4);  // none may be empty
  cl_int status = CL_SUCCESS;
  cl_mem memory =
      clCreateBuffer(static_cast<cl_context>(accelerator.context()), CL_MEM_READ_WRITE, length, nullptr, &status);
  require_success(status, "make an array");
  memory_ = {memory, [queue = queue_of(accelerator)](void* one) {
               clFinish(queue);  // pocl 3.1 frees an array although kernels in the queue use it
               clReleaseMemObject(static_cast<cl_mem>(one));
             }};
  const cl_uint zero = 0;
  require_success(clEnqueueFillBuffer(queue_of(accelerator), memory, &zero, sizeof(zero), 0,
                                      length / sizeof(zero) * sizeof(zero), 0, nullptr, nullptr),
                  "fill an array");
}

void Memory::write(std::size_t first, std::span<const std::byte> bytes) {
  if (bytes.empty()) {
    return;
  }
  std::vector<std::byte> kept(bytes.begin(), bytes.end());
  cl_event arrived = nullptr;
  require_success(clEnqueueWriteBuffer(queue_of(*accelerator_), static_cast<cl_mem>(handle()), CL_FALSE, first,
                                       kept.size(), kept.data(), 0, nullptr, &arrived),
                  "write an array");
  accelerator_->keep(owned(arrived, &clReleaseEvent), std::move(kept));
}

void Memory::read(std::size_t first, std::span<std::byte> bytes) const {
  if (!bytes.empty()) {
    require_success(clEnqueueReadBuffer(queue_of(*accelerator_), static_cast<cl_mem>(handle()), CL_TRUE, first,
                                        bytes.size(), bytes.data(), 0, nullptr, nullptr),
                    "read an array");
  }
}

}  // namespace idiophone::accelerator

#endif
