#include "idiophone/study/advice/pitch_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/refined.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::advice {

std::optional<PitchEstimate> pitch_estimate(const scene::Scene& scene, std::size_t body, const mesh::Mesh& mesh) {
  constexpr double most_entries = 2e7;  // two seconds
  constexpr int count = 4;
  if (mesh::refined_entries(mesh) > most_entries) {
    return {};
  }
  const scene::Solids alone = scene::Solids(scene).alone(body);
  const std::vector<mesh::Mesh> meshes = {mesh};
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  eigenmodes::Modes found;
  try {
    found = eigenmodes::find_modes(alone, part, motion::attach(alone, meshes), {.count = count}, MPI_COMM_SELF);
  } catch (const std::runtime_error&) {
    return {};  // held nearly everywhere; the run doesn't need its modes
  }
  PitchEstimate result;
  std::vector<std::vector<double>> shapes;
  for (eigenmodes::Mode& mode : found.modes) {
    result.frequencies.push_back(mode.frequency);
    shapes.push_back(std::move(mode.shape));
  }
  using eigenmodes::Estimates;
  result.mesh_errors =
      eigenmodes::mesh_errors(alone, {mesh}, eigenmodes::MassMatrix::lumped, shapes, Estimates::all).cents;
  if (std::ranges::any_of(result.mesh_errors, [](double error) { return std::isnan(error); })) {
    return {};  // a curved element can't be divided
  }
  return result;
}

}  // namespace idiophone::advice
