#include "named_modes.hpp"

#include <algorithm>
#include <iterator>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"

namespace idiophone::app {

namespace {

std::vector<std::string> kinds_in_assembly(const BodyModes& modes, const scene::Scene& scene,
                                           const std::vector<mesh::Mesh>& meshes) {
  std::vector<mode_kinds::JoinedBody> bodies;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    bodies.push_back({scene.bodies[b].name, meshes[b].nodes});
  }
  std::vector<std::vector<double>> shares;
  std::ranges::transform(modes.found.modes, std::back_inserter(shares), &eigenmodes::Mode::kinetic_shares);
  return mode_kinds::kinds_of_assembly(bodies, std::ranges::all_of(scene.joints, &scene::Joint::is_layer), modes.shapes,
                                       shares);
}

}  // namespace

std::vector<std::string> kinds_of(const BodyModes& modes, const scene::Scene& scene,
                                  const std::vector<mesh::Mesh>& meshes, MPI_Comm communicator) {
  std::vector<std::string> kinds;
  parallel::on_root(communicator, [&] {
    kinds = meshes.size() == 1 ? mode_kinds::kinds_of(meshes.front().nodes, modes.shapes)
                               : kinds_in_assembly(modes, scene, meshes);
  });
  parallel::broadcast(kinds, communicator);
  return kinds;
}

}  // namespace idiophone::app
