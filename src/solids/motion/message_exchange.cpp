#include "message_exchange.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/petsc.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

std::vector<Index> nodes_with_ghosts(PetscSF exchange, Index owned) {
  const PetscInt* ghosts = nullptr;  // of each owned node
  petsc(PetscSFComputeDegreeBegin(exchange, &ghosts));
  petsc(PetscSFComputeDegreeEnd(exchange, &ghosts));
  std::vector<Index> nodes;
  for (Index node = 0; node < owned; ++node) {
    if (ghosts[node] > 0) {
      nodes.push_back(node);
    }
  }
  return nodes;
}

}  // namespace

MessageExchange::MessageExchange(const mesh::Part& part, PetscSF exchange)
    : exchange_(exchange),
      type_(3, MPI_DOUBLE),
      sent_(nodes_with_ghosts(exchange_, part.owned_nodes)),
      owned_(part.owned_nodes),
      ghosts_(part.ghost_rank.size()) {}

void MessageExchange::send(std::span<const solid::NodeState> state) {
  for (const Index node : sent_) {
    owned_[node] = std::to_array(state[node].velocity);
  }
  petsc(PetscSFBcastBegin(exchange_, type_.get(), owned_.data(), ghosts_.data(), MPI_REPLACE));
}

void MessageExchange::receive(std::span<solid::NodeState> state) {
  petsc(PetscSFBcastEnd(exchange_, type_.get(), owned_.data(), ghosts_.data(), MPI_REPLACE));
  for (std::size_t ghost = 0; ghost < ghosts_.size(); ++ghost) {
    std::ranges::copy(ghosts_[ghost], state[owned_.size() + ghost].velocity);
  }
}

}  // namespace idiophone::motion
