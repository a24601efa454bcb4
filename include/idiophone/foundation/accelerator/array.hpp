#pragma once
// Arrays in the memory of an accelerator.

#include <span>
#include <type_traits>

#include "idiophone/foundation/accelerator/accelerator.hpp"

namespace idiophone::accelerator {

/// Bytes in the memory of an accelerator.
class Memory {
 public:
  /// Zeros. The accelerator must outlive this object.
  /// @throws std::runtime_error if there is not enough memory
  Memory(Accelerator& accelerator, std::size_t bytes);

  /// Does not wait: the bytes are copied now, and arrive when what the accelerator was told before is done.
  void write(std::size_t first, std::span<const std::byte> bytes);
  /// Waits until all that the accelerator was told before is done.
  void read(std::size_t first, std::span<std::byte> bytes) const;

  [[nodiscard]] void* handle() const { return memory_.get(); }
  /// No other memory of the accelerator has this number, also none that is made when this one is gone.
  [[nodiscard]] std::uint64_t number() const { return number_; }

 private:
  Accelerator* accelerator_;
  std::uint64_t number_;
  Handle memory_;
};

/// Numbers, or plain structures of numbers.
template <class T>
class Array {
 public:
  static_assert(std::is_trivially_copyable_v<T>);

  /// Zeros.
  Array(Accelerator& accelerator, std::size_t length) : memory_(accelerator, length * sizeof(T)), length_(length) {}
  Array(Accelerator& accelerator, std::span<const T> values) : Array(accelerator, values.size()) { write(values); }

  [[nodiscard]] std::size_t size() const { return length_; }
  [[nodiscard]] const Memory& memory() const { return memory_; }

  /// As Memory does.
  /// @param first  the place of the first one here
  void write(std::span<const T> values, std::size_t first = 0) {
    memory_.write(first * sizeof(T), std::as_bytes(values));
  }
  void read(std::span<T> values, std::size_t first = 0) const {
    memory_.read(first * sizeof(T), std::as_writable_bytes(values));
  }

 private:
  Memory memory_;
  std::size_t length_;
};

}  // namespace idiophone::accelerator
