#pragma once
// What an accelerator computes: functions in OpenCL C 1.2, each called for many numbers at once.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "idiophone/foundation/accelerator/array.hpp"

namespace idiophone::accelerator {

/// How many calls, along each axis.
using Range = std::array<std::size_t, 3>;

/// Functions that were compiled for an accelerator.
class Program {
 public:
  /// Numbers below 1e-38 count as 0. The accelerator must outlive this object.
  /// @throws std::runtime_error with the compiler's messages
  Program(Accelerator& accelerator, const std::string& source);

  [[nodiscard]] Accelerator& accelerator() const { return *accelerator_; }
  [[nodiscard]] void* handle() const { return program_.get(); }

 private:
  Accelerator* accelerator_;
  Handle program_;
};

/// One of these functions. It is called in groups, so it must do nothing for numbers beyond the range.
class Kernel {
 public:
  Kernel(const Program& program, const char* name);

  /// Begins when all that the accelerator was told before is done; does not wait. An empty range is left out.
  /// @param arguments  arrays of this accelerator, and numbers and structures of the types that the function takes
  template <class... Arguments>
  void operator()(const Range& range, const Arguments&... arguments) {
    unsigned place = 0;
    (set(place++, arguments), ...);
    begin(range);
  }

 private:
  /// As OpenCL knows it.
  struct Argument {
    std::array<std::byte, 80> value{};  ///< a number, a structure of numbers or a handle
    std::size_t bytes = 0;
    std::uint64_t memory = 0;  ///< of the handle
    bool operator==(const Argument&) const = default;
  };

  template <class T>
  void set(unsigned place, const Array<T>& array) {
    void* const handle = array.memory().handle();
    set(place, sizeof(handle), &handle, array.memory().number());
  }
  template <class T>
  void set(unsigned place, const T& value) {
    static_assert(std::is_same_v<T, int> || std::is_same_v<T, float> || std::is_same_v<T, double> ||
                  (std::is_class_v<T> && std::is_trivially_copyable_v<T>));
    static_assert(sizeof(T) <= sizeof(Argument::value));
    set(place, sizeof(T), &value, 0);
  }
  /// @param memory  that the value is the handle of; 0: it is a number
  void set(unsigned place, std::size_t bytes, const void* value, std::uint64_t memory);
  void begin(const Range& range);

  Accelerator* accelerator_;
  Handle kernel_;
  std::vector<Argument> arguments_;  // most are the same in each step
};

}  // namespace idiophone::accelerator
