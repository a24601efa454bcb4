#pragma once
// Numbers that come from an accelerator while the processor does something else.

#include "idiophone/foundation/accelerator/array.hpp"

namespace idiophone::accelerator {

/// Bytes that come from an accelerator. They arrive in memory of the processor that stays in place, so that the device
/// can write to it directly.
class MemoryRead {
 public:
  /// The accelerator must outlive this object.
  /// @throws std::runtime_error if there is not enough memory
  MemoryRead(Accelerator& accelerator, std::size_t bytes);
  /// Waits for what is on its way.
  ~MemoryRead();
  MemoryRead(const MemoryRead&) = delete;
  MemoryRead& operator=(const MemoryRead&) = delete;
  MemoryRead(MemoryRead&&) = delete;
  MemoryRead& operator=(MemoryRead&&) = delete;

  /// Reads when all that the accelerator was told before is done. Does not wait, but makes it begin.
  void begin(const Memory& from);
  /// Waits until all bytes are here.
  void finish();

  /// The bytes, after finish() and until begin().
  [[nodiscard]] const void* bytes() const { return bytes_; }

 private:
  Accelerator* accelerator_;
  std::size_t length_;
  Handle memory_;
  void* bytes_ = nullptr;
  Handle arrived_;  ///< an event, while bytes are on their way
};

/// The first numbers of an array.
template <class T>
class BackgroundRead {
 public:
  /// @param length  how many numbers
  BackgroundRead(Accelerator& accelerator, std::size_t length)
      : read_(accelerator, length * sizeof(T)), length_(length) {}

  /// As MemoryRead does.
  /// @param from  at least as long
  void begin(const Array<T>& from) { read_.begin(from.memory()); }
  /// Waits.
  /// @return the numbers, which stay until begin()
  [[nodiscard]] std::span<const T> finish() {
    read_.finish();
    return {static_cast<const T*>(read_.bytes()), length_};
  }

 private:
  MemoryRead read_;
  std::size_t length_;
};

}  // namespace idiophone::accelerator
