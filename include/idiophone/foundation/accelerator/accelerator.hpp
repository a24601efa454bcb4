#pragma once
// Devices that compute beside the processor: graphics cards, and others that OpenCL knows.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace idiophone::accelerator {

/// An object of OpenCL, released with its last owner.
using Handle = std::shared_ptr<void>;

/// A device, and the queue of what it has been told to do. It does one thing after the other.
class Accelerator {
 public:
  /// @param wish  `gpu` for a graphics card, the number of a device among all, or a part of its name
  /// @param turn  where several fit, which of them, from 0 on; after the last one comes the first one again
  /// @throws std::runtime_error if none fits, with the names of all; and in a program without OpenCL
  explicit Accelerator(const std::string& wish, int turn = 0);

  /// Of the device and of its driver.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Whether it computes in double precision. Not all graphics cards do.
  [[nodiscard]] bool has_doubles() const { return has_doubles_; }

  /// Makes it begin with what it has been told to do. Without this, drivers may wait for more.
  void flush();

  // For arrays and kernels:
  [[nodiscard]] void* device() const { return device_; }
  [[nodiscard]] void* context() const { return context_.get(); }
  [[nodiscard]] void* queue() const { return queue_.get(); }
  /// The number of one more array. OpenCL reuses the handles of arrays that are gone.
  [[nodiscard]] std::uint64_t next_array_number() { return ++arrays_; }
  /// Keeps what the device still has to read.
  /// @param arrived  an event
  void keep(Handle arrived, std::vector<std::byte> bytes);

 private:
  /// What is on its way to the device.
  struct Parcel {
    Handle arrived;
    std::vector<std::byte> bytes;
  };

  void* device_ = nullptr;
  std::string name_;
  bool has_doubles_ = false;
  Handle context_, queue_;
  std::uint64_t arrays_ = 0;
  std::deque<Parcel> on_the_way_;  // oldest first
};

}  // namespace idiophone::accelerator
