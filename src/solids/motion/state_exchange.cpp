#include "state_exchange.hpp"

#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::motion {

using parallel::petsc;

StateExchange::StateExchange(const mesh::Part& part, PetscSF exchange)
    : exchange_(exchange),
      type_(sizeof(solid::NodeState) / sizeof(double), MPI_DOUBLE),
      owned_nodes_(part.owned_nodes) {}

void StateExchange::receive(std::span<solid::NodeState> state) {
  solid::NodeState* ghosts = state.data() + owned_nodes_;
  petsc(PetscSFBcastBegin(exchange_, type_.get(), state.data(), ghosts, MPI_REPLACE));
  petsc(PetscSFBcastEnd(exchange_, type_.get(), state.data(), ghosts, MPI_REPLACE));
}

}  // namespace idiophone::motion
