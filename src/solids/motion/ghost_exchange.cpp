#include "idiophone/solids/motion/ghost_exchange.hpp"

#include "idiophone/foundation/parallel/petsc.hpp"
#include "velocity_exchange.hpp"

namespace idiophone::motion {

using parallel::petsc;

parallel::Handle<PetscSF> ghost_exchange(const mesh::Part& part, MPI_Comm communicator) {
  std::vector<PetscSFNode> roots(part.ghost_rank.size());
  for (std::size_t ghost = 0; ghost < roots.size(); ++ghost) {
    roots[ghost] = {part.ghost_rank[ghost], part.ghost_index[ghost]};
  }
  parallel::Handle<PetscSF> sf;
  petsc(PetscSFCreate(communicator, sf.out()));
  petsc(PetscSFSetFromOptions(sf));
  petsc(PetscSFSetGraph(sf, part.owned_nodes, static_cast<PetscInt>(roots.size()), nullptr, PETSC_COPY_VALUES,
                        roots.data(), PETSC_COPY_VALUES));
  petsc(PetscSFSetUp(sf));
  return sf;
}

double halo_bytes(const mesh::PartSize& size) {
  return static_cast<double>(size.ghost_nodes) * sizeof(Velocity);
}

}  // namespace idiophone::motion
