#include "with_ghosts.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/datatype.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"

namespace idiophone::eigenmodes {

using parallel::petsc;

std::vector<double> with_ghosts(const mesh::Part& part, std::span<const double> owned, MPI_Comm communicator) {
  std::vector<double> values(3 * part.node_ids.size());
  std::ranges::copy(owned, values.begin());
  const parallel::Datatype node(3, MPI_DOUBLE);
  const parallel::Handle<PetscSF> ghosts = motion::ghost_exchange(part, communicator);
  petsc(PetscSFBcastBegin(ghosts, node.get(), values.data(), values.data() + owned.size(), MPI_REPLACE));
  petsc(PetscSFBcastEnd(ghosts, node.get(), values.data(), values.data() + owned.size(), MPI_REPLACE));
  return values;
}

}  // namespace idiophone::eigenmodes
