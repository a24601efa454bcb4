#include "idiophone/study/advice/pitch_estimate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "idiophone/solids/eigenmodes/is_rigid_motion.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/refined.hpp"
#include "idiophone/solids/motion/attachments.hpp"

namespace idiophone::advice {

namespace {

using Fields = Eigen::Map<const Eigen::Matrix3Xd>;  // [3 x nodes]

}  // namespace

std::optional<PitchEstimate> pitch_estimate(const scene::Scene& scene, std::size_t body, const mesh::Mesh& mesh) {
  constexpr double most_entries = 2e7;  // two seconds, or four on supports
  constexpr std::size_t count = 4;
  const int on_springs = scene.bodies[body].supports.empty() ? 0 : 6;
  if (mesh::refined_entries(mesh) > most_entries) {
    return {};
  }
  const scene::Solids alone = scene::Solids(scene).alone(body);
  const std::vector<mesh::Mesh> meshes = {mesh};
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  eigenmodes::Modes found;
  try {
    found = eigenmodes::find_modes(alone, part, motion::attach(alone, meshes),
                                   {.count = static_cast<int>(count) + on_springs}, MPI_COMM_SELF);
  } catch (const std::runtime_error&) {
    return {};  // held nearly everywhere; the run doesn't need its modes
  }
  std::vector<std::vector<double>> shapes;
  for (eigenmodes::Mode& mode : found.modes) {
    shapes.push_back(std::move(mode.shape));
  }
  using eigenmodes::Estimates;
  const std::vector<double> errors =
      eigenmodes::mesh_errors(alone, {mesh}, eigenmodes::MassMatrix::lumped, shapes, Estimates::all).cents;
  const Fields nodes(mesh.nodes.front().data(), 3, std::ssize(mesh.nodes));
  PitchEstimate result;
  for (std::size_t mode = 0; mode < shapes.size() && result.frequencies.size() < count; ++mode) {
    // On soft supports, the lowest modes are nearly rigid motions, which have no pitch.
    if (!eigenmodes::is_rigid_motion(nodes, Fields(shapes[mode].data(), 3, nodes.cols()))) {
      result.frequencies.push_back(found.modes[mode].frequency);
      result.mesh_errors.push_back(errors[mode]);
    }
  }
  if (std::ranges::any_of(result.mesh_errors, [](double error) { return std::isnan(error); })) {
    return {};  // a curved element can't be divided
  }
  return result;
}

}  // namespace idiophone::advice
