#include "velocity_exchange.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "message_exchange.hpp"
#include "shared_exchange.hpp"
#include "state_exchange.hpp"

namespace idiophone::motion {

namespace {

bool is_one_machine(MPI_Comm communicator) {
  return parallel::size_of(parallel::RanksOfMachine(communicator).get()) == parallel::size_of(communicator);
}

}  // namespace

std::unique_ptr<VelocityExchange> velocity_exchange(const scene::Solids& solids, const mesh::Part& part,
                                                    PetscSF exchange, MPI_Comm communicator) {
  if (halo_of(solids) == Halo::states) {
    return std::make_unique<StateExchange>(part, exchange);
  }
  PetscBool by_messages = PETSC_FALSE;
  parallel::petsc(PetscOptionsHasName(nullptr, nullptr, "-ghosts_by_messages", &by_messages));
  if (by_messages == PETSC_FALSE && is_one_machine(communicator)) {
    return std::make_unique<SharedExchange>(part, communicator);
  }
  return std::make_unique<MessageExchange>(part, exchange);
}

}  // namespace idiophone::motion
