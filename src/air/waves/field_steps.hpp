#pragma once
// Where the steps of a field are computed: on the processor, or on an accelerator.

#include <memory>
#include <span>
#include <vector>

#include "idiophone/air/waves/pressure_probe.hpp"
#include "idiophone/air/waves/surface_sources.hpp"
#include "idiophone/air/waves/velocity_history.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::waves {

/// Advances a FieldState, of which it can have a copy of its own.
class FieldSteps {
 public:
  FieldSteps() = default;
  virtual ~FieldSteps() = default;
  FieldSteps(const FieldSteps&) = delete;
  FieldSteps& operator=(const FieldSteps&) = delete;
  FieldSteps(FieldSteps&&) = delete;
  FieldSteps& operator=(FieldSteps&&) = delete;

  /// One step, as WaveField::step().
  virtual void step(std::span<const float> sources) = 0;
  virtual void step(const SurfaceSources& sources, const VelocityHistory& velocities, int step) = 0;
  /// As WaveField::forecast().
  virtual void forecast(std::span<float> pressures) = 0;

  /// Writes its copy to the state.
  virtual void save() = 0;
  /// Goes on from the state, whose surfaces may be other ones.
  virtual void load() = 0;

  /// As the functions of WaveField with these names.
  [[nodiscard]] virtual float pressure(Index cell) const = 0;
  virtual void set_pressure(Index cell, float pressure) = 0;
  [[nodiscard]] virtual std::unique_ptr<PressureProbe> probe(std::vector<Index> cells) const = 0;
};

}  // namespace idiophone::waves
