#pragma once
// Pressures of some cells.

#include <span>

namespace idiophone::waves {

/// Cells whose pressures are read together.
class PressureProbe {
 public:
  PressureProbe() = default;
  virtual ~PressureProbe() = default;
  PressureProbe(const PressureProbe&) = delete;
  PressureProbe& operator=(const PressureProbe&) = delete;
  PressureProbe(PressureProbe&&) = delete;
  PressureProbe& operator=(PressureProbe&&) = delete;

  /// @param pressures  [cells] now, Pa
  virtual void read(std::span<float> pressures) = 0;
};

}  // namespace idiophone::waves
