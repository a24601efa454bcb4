#include "idiophone/instruments/sound_maps/solid_map.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "idiophone/scene/joined_bodies.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/motion/initial_state.hpp"
#include "solid_facts.hpp"

namespace idiophone::sound_maps {

namespace {

void add_modes(sound_maps::SoundMap& map, const std::vector<eigenmodes::Mode>& modes, const mesh::Part& part) {
  for (const eigenmodes::Mode& mode : modes) {
    map.frequency.push_back(mode.frequency);
    map.material_decay.push_back(mode.damping_ratio * 2.0 * std::numbers::pi * mode.frequency);
    if (map.scalable) {
      map.scalable->lossless_frequency.push_back(mode.lossless_frequency);
    }
    for (const Index node : part.vertices) {
      for (int axis = 0; axis < 3; ++axis) {
        map.shape.push_back(static_cast<float>(mode.shape[3 * node + axis]));
      }
    }
  }
}

}  // namespace

sound_maps::SoundMap solid_map(const scene::Scene& scene, std::size_t body, const eigenmodes::Options& options,
                               eigenmodes::Estimates estimates) {
  scene::refuse_joints(scene, "map");
  const scene::Solids alone = scene::Solids(scene).alone(body);
  const std::vector<mesh::Mesh> meshes = {mesh::read_mesh(alone.bodies.front())};
  const motion::Attachments attachments = motion::attach(alone, meshes);
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  const motion::InitialState properties =
      motion::mass_properties(motion::FiniteElementDynamics(alone, part, attachments), part);
  sound_maps::SoundMap map;
  add_facts(map, scene, scene.bodies[body]);
  if (why_not_scalable(scene.bodies[body]).empty()) {
    map.scalable = scalable_modes(scene, scene.bodies[body], meshes.front());
  }
  map.mass = properties.masses.front();
  map.centre = properties.centres.front();
  map.triangles = part.surface;
  for (const Index node : part.vertices) {
    map.vertices.push_back(part.reference[node]);
  }
  eigenmodes::Modes found = eigenmodes::find_modes(alone, part, attachments, options, MPI_COMM_SELF);
  std::vector<eigenmodes::Mode>& modes = found.modes;
  std::ranges::stable_sort(modes, {}, &eigenmodes::Mode::frequency);  // a loss factor shifts each a little
  add_modes(map, modes, part);
  if (const auto& model = scene.bodies[body].modal; model && model->stretching_tolerance) {
    map.stretching = eigenmodes::stretching_of(found, alone, part, attachments, *model->stretching_tolerance);
  }
  std::vector<std::vector<double>> shapes;
  for (eigenmodes::Mode& mode : modes) {
    shapes.push_back(std::move(mode.shape));
  }
  map.mesh_error = eigenmodes::mesh_errors(alone, meshes.front(), options.mass, shapes, estimates);
  return map;
}

}  // namespace idiophone::sound_maps
