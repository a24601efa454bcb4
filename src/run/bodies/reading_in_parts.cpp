#include "idiophone/run/bodies/reading_in_parts.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/petsc.hpp"
#include "idiophone/solids/mesh/meshes_in_parts.hpp"

namespace idiophone::bodies {

namespace {

constexpr std::int64_t many_elements = 4'000'000;

/// Modes and cracks are found with whole bodies.
bool is_plain(const scene::Body& body) {
  return mesh::fits_parts(body) && !body.modal && body.fracture.empty();
}

bool is_plain(const scene::Scene& scene) {
  return !scene.bodies.empty() &&
         std::ranges::all_of(scene.bodies, [](const scene::Body& body) { return is_plain(body); });
}

/// All bodies' together; 0 where a file can't be read, which reading whole explains.
std::int64_t elements_of(const scene::Scene& scene) {
  std::int64_t sum = 0;
  for (const scene::Body& body : scene.bodies) {
    const auto elements = mesh::stored_elements(body);
    if (!elements) {
      return 0;
    }
    sum += *elements;
  }
  return sum;
}

bool wants_parts(const scene::Scene& scene) {
  PetscBool wanted = PETSC_FALSE, is_set = PETSC_FALSE;
  parallel::petsc(PetscOptionsGetBool(nullptr, nullptr, "-meshes_in_parts", &wanted, &is_set));
  const std::int64_t elements = elements_of(scene);
  return is_set == PETSC_TRUE ? wanted == PETSC_TRUE && elements > 0 : elements >= many_elements;
}

}  // namespace

bool reads_in_parts(const scene::Scene& scene, MPI_Comm communicator) {
  return parallel::from_root(parallel::is_root(communicator) && is_plain(scene) && wants_parts(scene), communicator);
}

}  // namespace idiophone::bodies
