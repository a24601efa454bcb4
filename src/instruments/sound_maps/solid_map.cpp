#include "idiophone/instruments/sound_maps/solid_map.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/scene/large_amplitudes.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/joints/covered_triangles.hpp"
#include "idiophone/solids/joints/exposed_surface.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/initial_state.hpp"
#include "solid_facts.hpp"

namespace idiophone::sound_maps {

namespace {

/// @param nodes  of the map's vertices
void add_modes(SoundMap& map, const std::vector<eigenmodes::Mode>& modes, const std::vector<Index>& nodes) {
  for (const eigenmodes::Mode& mode : modes) {
    map.frequency.push_back(mode.frequency);
    map.material_decay.push_back(mode.damping_ratio * 2.0 * std::numbers::pi * mode.frequency);
    if (map.scalable) {
      map.scalable->lossless_frequency.push_back(mode.lossless_frequency);
    }
    for (const Index node : nodes) {
      for (int axis = 0; axis < 3; ++axis) {
        map.shape.push_back(static_cast<float>(mode.shape[3 * node + axis]));
      }
    }
  }
}

/// Mass and centre of all bodies together.
void add_mass_properties(SoundMap& map, const motion::InitialState& properties) {
  const Vector3& origin = properties.centres.front();
  Vector3 moment = Vector3::Zero();
  for (std::size_t b = 0; b < properties.masses.size(); ++b) {
    map.mass += properties.masses[b];
    moment += properties.masses[b] * (properties.centres[b] - origin);
  }
  map.centre = origin + moment / map.mass;
}

std::vector<std::vector<double>> shapes_of(std::vector<eigenmodes::Mode> modes) {
  std::vector<std::vector<double>> shapes;
  shapes.reserve(modes.size());
  for (eigenmodes::Mode& mode : modes) {
    shapes.push_back(std::move(mode.shape));
  }
  return shapes;
}

}  // namespace

SolvedSolid solve_solid(const scene::Scene& scene, std::size_t body, const eigenmodes::Options& wanted) {
  SolvedSolid solved{.assembly = scene::assembly_of(scene, body), .options = wanted};
  const scene::Solids solids(solved.assembly);
  solved.options.align_double_modes = scene::has_large_amplitudes(solids.bodies.front());
  solved.meshes = mesh::read_meshes(solids.bodies);
  solved.attachments = motion::attach(solids, solved.meshes);
  solved.part = mesh::distribute(solved.meshes, MPI_COMM_SELF);
  solved.found = eigenmodes::find_modes(solids, solved.part, solved.attachments, solved.options, MPI_COMM_SELF);
  // A loss factor shifts each a little.
  std::ranges::stable_sort(solved.found.modes, {}, &eigenmodes::Mode::frequency);
  return solved;
}

SoundMap map_of(const scene::Scene& scene, SolvedSolid solved, eigenmodes::Estimates estimates) {
  const scene::Solids solids(solved.assembly);
  const scene::Body& first = solids.bodies.front();
  const bool is_alone = solids.joints.empty();
  const mesh::Part& part = solved.part;
  SoundMap map;
  add_facts(map, scene, solids.bodies);
  if (is_alone && why_not_scalable(first).empty()) {
    map.scalable = scalable_modes(scene, first, solved.meshes.front());
  }
  const motion::FiniteElementDynamics dynamics(solids, part, solved.attachments);
  add_mass_properties(map, motion::mass_properties(dynamics, part));
  joints::ExposedSurface surface = joints::exposed_surface(part, joints::covered_triangles(solids, solved.meshes));
  for (const Index node : surface.nodes) {
    map.vertices.push_back(part.reference[node]);
  }
  map.triangles = std::move(surface.triangles);
  add_modes(map, solved.found.modes, surface.nodes);
  if (scene::has_large_amplitudes(first)) {
    map.stretching = eigenmodes::stretching_of(solved.found, solids, part, solved.attachments,
                                               scene::stretching_tolerance(solids.bodies));
  }
  if (is_alone) {
    map.mesh_error = eigenmodes::mesh_errors(solids, solved.meshes, solved.options.mass,
                                             shapes_of(std::move(solved.found.modes)), estimates)
                         .cents;
  }
  return map;
}

SoundMap solid_map(const scene::Scene& scene, std::size_t body, const eigenmodes::Options& wanted,
                   eigenmodes::Estimates estimates) {
  return map_of(scene, solve_solid(scene, body, wanted), estimates);
}

}  // namespace idiophone::sound_maps
