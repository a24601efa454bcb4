#pragma once
// States of ghosts by messages: at the start, and in each step where a modal body has nodes that are ghosts elsewhere,
// because such a node does not move by its velocity times the step.

#include <petscsf.h>

#include "idiophone/foundation/parallel/datatype.hpp"
#include "velocity_exchange.hpp"

namespace idiophone::motion {

class StateExchange : public VelocityExchange {
 public:
  /// @param exchange  see ghost_exchange; it must live as long as this object
  StateExchange(const mesh::Part& part, PetscSF exchange);

  /// Nothing: the displacements are not known yet.
  void send(std::span<const solid::NodeState> /*state*/) override {}
  void receive(std::span<solid::NodeState> state) override;
  [[nodiscard]] bool has_displacements() const override { return true; }
  [[nodiscard]] bool is_slow() const override { return false; }

 private:
  PetscSF exchange_;
  parallel::Datatype type_;  ///< of a NodeState
  Index owned_nodes_;
};

}  // namespace idiophone::motion
