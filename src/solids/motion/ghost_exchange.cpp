#include "idiophone/solids/motion/ghost_exchange.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/solid/pack_division.hpp"
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

double work_without_ghosts(const mesh::Part& part) {
  double work = 0.0;
  for (const mesh::BodyPart& body : part.bodies) {
    for (const solid::PackRange& packs : solid::PackDivision::by_ghosts(body).inner) {
      const std::size_t elements =
          std::min(body.element_ids.size(), packs.end * solid::lanes) - packs.begin * solid::lanes;
      work += static_cast<double>(elements) * mesh::work_of_element(body.element);
    }
  }
  return work;
}

Halo halo_of(const scene::Solids& solids) {
  const bool joins_modal_body = std::ranges::any_of(solids.joints, [&](const scene::Joint& joint) {
    return std::ranges::any_of(joint.surfaces, [&](const scene::JoinedSurface& surface) {
      return solids.bodies[surface.body].modal.has_value();
    });
  });
  return joins_modal_body ? Halo::states : Halo::velocities;
}

double halo_bytes(const mesh::PartSize& size, Halo halo) {
  return static_cast<double>(size.ghost_nodes) * (halo == Halo::states ? sizeof(solid::NodeState) : sizeof(Velocity));
}

}  // namespace idiophone::motion
