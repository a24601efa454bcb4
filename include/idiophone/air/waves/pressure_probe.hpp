#pragma once
// Pressures of some cells.

#include <span>

#include "idiophone/foundation/types.hpp"

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

  /// Reads these cells from now on. To be called before begin(), or after finish().
  /// @param cells  at most as many as the probe was made with
  virtual void set_cells(std::span<const Index> cells) = 0;

  /// Takes the pressures of the present. Does not wait for an accelerator.
  virtual void begin() = 0;
  /// Waits for an accelerator.
  /// @return [cells] at the time of begin(), Pa. They stay until the next begin()
  [[nodiscard]] virtual std::span<const float> finish() = 0;

  /// Both.
  [[nodiscard]] std::span<const float> read() {
    begin();
    return finish();
  }
};

}  // namespace idiophone::waves
