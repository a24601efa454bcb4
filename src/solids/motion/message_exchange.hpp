#pragma once
// Velocities of ghosts by messages, as between several machines.

#include <petscsf.h>

#include <vector>

#include "idiophone/foundation/parallel/datatype.hpp"
#include "velocity_exchange.hpp"

namespace idiophone::motion {

class MessageExchange : public VelocityExchange {
 public:
  /// Collective.
  /// @param exchange  see ghost_exchange; it must live as long as this object
  MessageExchange(const mesh::Part& part, PetscSF exchange);

  void send(std::span<const solid::NodeState> state) override;
  void receive(std::span<solid::NodeState> state) override;
  [[nodiscard]] bool is_slow() const override { return true; }

 private:
  PetscSF exchange_;
  parallel::Datatype type_;      ///< of a Velocity
  std::vector<Index> sent_;      ///< owned nodes that are ghosts elsewhere
  std::vector<Velocity> owned_;  ///< [owned nodes] of which those of sent_ are used
  std::vector<Velocity> ghosts_;
};

}  // namespace idiophone::motion
