#pragma once
// Velocities of ghosts by messages, as between several machines.

#include <petscsf.h>

#include <vector>

#include "idiophone/parallel/datatype.hpp"
#include "idiophone/parallel/petsc.hpp"
#include "velocity_exchange.hpp"

namespace idiophone::motion {

class MessageExchange : public VelocityExchange {
 public:
  /// Collective.
  /// @throws std::runtime_error where PETSc refuses an option
  MessageExchange(const mesh::Part& part, MPI_Comm communicator);

  void send(std::span<const solid::NodeState> state) override;
  void receive(std::span<solid::NodeState> state) override;

 private:
  parallel::Handle<PetscSF> exchange_;
  parallel::Datatype type_;      ///< of a Velocity
  std::vector<Index> sent_;      ///< owned nodes that are ghosts elsewhere
  std::vector<Velocity> owned_;  ///< [owned nodes] of which those of sent_ are used
  std::vector<Velocity> ghosts_;
};

}  // namespace idiophone::motion
