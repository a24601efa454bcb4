// A program that was built without OpenCL opens no accelerator.

#ifndef IDIOPHONE_HAS_OPENCL

#include <stdexcept>

#include "idiophone/foundation/accelerator/background_read.hpp"
#include "idiophone/foundation/accelerator/kernel.hpp"

namespace idiophone::accelerator {

namespace {

[[noreturn]] void refuse() {
  throw std::runtime_error(
      "accelerator: this program was built without OpenCL; install ocl-icd-opencl-dev and build it again");
}

}  // namespace

Accelerator::Accelerator(const std::string& /*wish*/, int /*turn*/) {
  refuse();
}

// There is no accelerator that these could be called with.

void Accelerator::flush() {
  refuse();
}

Memory::Memory(Accelerator& accelerator, std::size_t /*bytes*/) : accelerator_(&accelerator), number_(0) {
  refuse();
}

void Memory::write(std::size_t /*first*/, std::span<const std::byte> /*bytes*/) {
  refuse();
}

void Memory::read(std::size_t /*first*/, std::span<std::byte> /*bytes*/) const {
  refuse();
}

MemoryRead::MemoryRead(Accelerator& accelerator, std::size_t bytes) : accelerator_(&accelerator), length_(bytes) {
  refuse();
}

MemoryRead::~MemoryRead() = default;

void MemoryRead::begin(const Memory& /*from*/) {
  refuse();
}

void MemoryRead::finish() {
  refuse();
}

Program::Program(Accelerator& accelerator, const std::string& /*source*/) : accelerator_(&accelerator) {
  refuse();
}

Kernel::Kernel(const Program& program, const char* /*name*/) : accelerator_(&program.accelerator()) {
  refuse();
}

void Kernel::set(unsigned /*place*/, std::size_t /*bytes*/, const void* /*value*/, std::uint64_t /*memory*/) {
  refuse();
}

void Kernel::begin(const Range& /*range*/) {
  refuse();
}

}  // namespace idiophone::accelerator

#endif
