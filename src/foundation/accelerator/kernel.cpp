#include "idiophone/foundation/accelerator/kernel.hpp"

#ifdef IDIOPHONE_HAS_OPENCL

#include <algorithm>
#include <cstring>

#include "opencl.hpp"

namespace idiophone::accelerator {

namespace {

/// Calls in a group, in one line and in a box: a few times what graphics cards do at once.
constexpr Range line = {128, 1, 1}, box = {16, 8, 1};

std::string compiler_messages(cl_program program, cl_device_id device) {
  std::size_t length = 0;
  clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &length);
  std::string text(length, '\0');
  clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, length, text.data(), nullptr);
  text.resize(std::min(text.find('\0'), text.size()));  // it ends with one
  return text;
}

}  // namespace

Program::Program(Accelerator& accelerator, const std::string& source) : accelerator_(&accelerator) {
  const char* text = source.c_str();
  cl_int status = CL_SUCCESS;
  cl_program program =
      clCreateProgramWithSource(static_cast<cl_context>(accelerator.context()), 1, &text, nullptr, &status);
  require_success(status, "make a program");
  program_ = owned(program, &clReleaseProgram);
  auto* const device = static_cast<cl_device_id>(accelerator.device());
  if (clBuildProgram(program, 1, &device, "-cl-std=CL1.2 -cl-denorms-are-zero", nullptr, nullptr) != CL_SUCCESS) {
    throw std::runtime_error("accelerator: could not compile for " + accelerator.name() + ":\n" +
                             compiler_messages(program, device));
  }
}

Kernel::Kernel(const Program& program, const char* name) : accelerator_(&program.accelerator()) {
  cl_int status = CL_SUCCESS;
  kernel_ = owned(clCreateKernel(static_cast<cl_program>(program.handle()), name, &status), &clReleaseKernel);
  require_success(status, "find a kernel");
}

void Kernel::set(unsigned place, std::size_t bytes, const void* value, std::uint64_t memory) {
  Argument given{.bytes = bytes, .memory = memory};
  std::memcpy(given.value.data(), value, bytes);
  arguments_.resize(std::max<std::size_t>(arguments_.size(), place + 1));
  if (arguments_[place] == given) {
    return;
  }
  require_success(clSetKernelArg(static_cast<cl_kernel>(kernel_.get()), place, bytes, value), "set an argument");
  arguments_[place] = given;
}

void Kernel::begin(const Range& range) {
  if (std::ranges::find(range, 0UL) != range.end()) {
    return;
  }
  const Range& group = range[1] * range[2] == 1 ? line : box;
  Range calls = range;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    calls.at(axis) = (range.at(axis) + group.at(axis) - 1) / group.at(axis) * group.at(axis);
  }
  require_success(clEnqueueNDRangeKernel(static_cast<cl_command_queue>(accelerator_->queue()),
                                         static_cast<cl_kernel>(kernel_.get()), 3, nullptr, calls.data(), group.data(),
                                         0, nullptr, nullptr),
                  "start a kernel");
}

}  // namespace idiophone::accelerator

#endif
