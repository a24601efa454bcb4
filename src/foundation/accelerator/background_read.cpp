#include "idiophone/foundation/accelerator/background_read.hpp"

#ifdef IDIOPHONE_HAS_OPENCL

#include <algorithm>

#include "opencl.hpp"

namespace idiophone::accelerator {

MemoryRead::MemoryRead(Accelerator& accelerator, std::size_t bytes) : accelerator_(&accelerator), length_(bytes) {
  const std::size_t length = std::max<std::size_t>(bytes, 1);  // none may be empty
  auto* const queue = static_cast<cl_command_queue>(accelerator.queue());
  cl_int status = CL_SUCCESS;
  cl_mem memory = clCreateBuffer(static_cast<cl_context>(accelerator.context()),
                                 CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR, length, nullptr, &status);
  require_success(status, "make an array beside it");
  memory_ = owned(memory, &clReleaseMemObject);
  bytes_ =
      clEnqueueMapBuffer(queue, memory, CL_TRUE, CL_MAP_READ | CL_MAP_WRITE, 0, length, 0, nullptr, nullptr, &status);
  require_success(status, "use an array beside it");
}

MemoryRead::~MemoryRead() {
  auto* const queue = static_cast<cl_command_queue>(accelerator_->queue());
  clEnqueueUnmapMemObject(queue, static_cast<cl_mem>(memory_.get()), bytes_, 0, nullptr, nullptr);
  clFinish(queue);
}

void MemoryRead::begin(const Memory& from) {
  if (length_ == 0) {
    return;
  }
  auto* const queue = static_cast<cl_command_queue>(accelerator_->queue());
  cl_event arrived = nullptr;
  require_success(clEnqueueReadBuffer(queue, static_cast<cl_mem>(from.handle()), CL_FALSE, 0, length_, bytes_, 0,
                                      nullptr, &arrived),
                  "read an array");
  arrived_ = owned(arrived, &clReleaseEvent);
  accelerator_->flush();
}

void MemoryRead::finish() {
  if (auto* const arrived = static_cast<cl_event>(arrived_.get())) {
    require_success(clWaitForEvents(1, &arrived), "read an array");
    arrived_.reset();
  }
}

}  // namespace idiophone::accelerator

#endif
