#pragma once
// The steps of a field on the processor.

#include "field_state.hpp"
#include "field_steps.hpp"

namespace idiophone::waves {

/// Changes the state itself.
class ProcessorSteps : public FieldSteps {
 public:
  /// @param state     divided by boxes_from_faces(); must outlive this object, as must `exchange`
  /// @param exchange  of its nodes
  ProcessorSteps(FieldState& state, FaceExchange& exchange) : state_(state), exchange_(exchange) {}

  void step(std::span<const float> sources) override;
  void step(const SurfaceSources& sources, const VelocityHistory& velocities, int step) override;
  void forecast(std::span<float> pressures) override;
  void save() override {}
  void load() override {}
  [[nodiscard]] float pressure(Index cell) const override { return state_.pressure[cell]; }
  void set_pressure(Index cell, float pressure) override { state_.pressure[cell] = pressure; }
  [[nodiscard]] std::unique_ptr<PressureProbe> probe(std::vector<Index> cells) const override;

 private:
  /// What a node's neighbours add to its rate in a step, Pa.
  [[nodiscard]] float inflow(Index node) const;
  void update_node_rates(std::span<const float> sources);
  void advance_plane(int z);
  void advance_nodes();

  FieldState& state_;
  FaceExchange& exchange_;
  std::vector<float> change_;      // [nodes] of their pressures in a step with losses, Pa
  std::vector<float> velocities_;  // [triangles] what velocities change in a step, Pa
  std::vector<float> sources_;     // [nodes] what they add to the rates, Pa per step
};

}  // namespace idiophone::waves
