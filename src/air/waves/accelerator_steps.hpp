#pragma once
// The steps of a field on an accelerator.

#include <optional>
#include <utility>

#include "accelerator_layers.hpp"
#include "accelerator_nodes.hpp"
#include "accelerator_sources.hpp"
#include "field_steps.hpp"

namespace idiophone::waves {

/// All arrays stay on the accelerator. What goes there is the velocities of the surfaces, once in an audio sample, or
/// what they add to the nodes in each step. With several ranks, the pressures at the faces of the subdomain come back
/// in each step, and those of the ghost cells go there.
class AcceleratorSteps final : public FieldSteps {
 public:
  /// @param state     with the whole subdomain as one box; must outlive this object, as must the others
  /// @param exchange  of its nodes
  AcceleratorSteps(accelerator::Accelerator& accelerator, FieldState& state, FaceExchange& exchange);

  void step(std::span<const float> sources) override;
  void step(const SurfaceSources& sources, const VelocityHistory& velocities, int step) override;
  void forecast(std::span<float> pressures) override;
  void save() override;
  void load() override;
  [[nodiscard]] float pressure(Index cell) const override;
  void set_pressure(Index cell, float pressure) override;
  [[nodiscard]] std::unique_ptr<PressureProbe> probe(std::vector<Index> cells) const override;

 private:
  /// Places in [cells, then nodes], and what is there.
  struct Faces {
    Faces(accelerator::Accelerator& accelerator, std::vector<Index> places);

    std::vector<Index> places;
    std::vector<float> values;
    accelerator::Array<Index> places_there;
    accelerator::Array<float> values_there;
  };
  /// @throws std::runtime_error if they did not fit into the memory of the accelerator
  [[nodiscard]] AcceleratorNodes& nodes();
  /// @param place  of the first node in `sources`
  void advance(const accelerator::Array<float>& sources, int place);
  void exchange_faces(accelerator::Array<float>& pressure);

  accelerator::Accelerator& accelerator_;
  mutable WaveKernels kernels_;  // a call changes the arguments that a kernel keeps
  FieldState& state_;
  FaceExchange& exchange_;
  AcceleratorLayers layers_;
  accelerator::Array<float> rate_;                // [cells]
  accelerator::Array<float> pressure_, pending_;  // [cells, then nodes] now; those that the next step writes
  std::optional<AcceleratorVelocities> velocities_;
  std::optional<AcceleratorNodes> nodes_;
  std::optional<AcceleratorSources> sources_;
  std::optional<accelerator::Array<float>> given_sources_;  // [nodes] by the processor
  std::optional<Faces> own_faces_, ghost_faces_;
};

}  // namespace idiophone::waves
