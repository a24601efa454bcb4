#include "idiophone/solids/eigenmodes/joined_motion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"
#include "idiophone/solids/joints/joints.hpp"
#include "operators.hpp"
#include "wanted_modes.hpp"
#include "with_place.hpp"

namespace idiophone::eigenmodes {

namespace {

/// The displacements of one body at rest. [3 x nodes]
std::vector<double> rest_of(const mesh::BodyPart& body, std::span<const solid::NodeState> rest) {
  std::vector<double> displacements;
  for (Index node = body.owned_begin; node < body.owned_end; ++node) {
    const auto& of_node = rest[node].displacement;
    displacements.insert(displacements.end(), std::begin(of_node), std::end(of_node));
  }
  return displacements;
}

/// @param bodies  numbers of the assembly's bodies
void add_motions(const scene::Solids& solids, const std::vector<std::size_t>& bodies,
                 const std::vector<mesh::Mesh>& meshes, std::map<std::size_t, JoinedMotion>& motions) {
  const auto modal = std::ranges::find_if(bodies, [&](std::size_t b) { return solids.bodies[b].modal.has_value(); });
  const scene::Assembly joined(solids, bodies.front());
  const scene::Solids assembly = joined.solids();
  if (modal == bodies.end() || assembly.joints.empty()) {
    return;
  }
  std::vector<mesh::Mesh> own;
  std::ranges::transform(bodies, std::back_inserter(own), [&](std::size_t b) { return meshes[b]; });
  const motion::Attachments attachments = motion::attach(assembly, own);
  const mesh::Part part = mesh::distribute(own, MPI_COMM_SELF);
  const Operators operators(assembly, part, attachments, MassMatrix::lumped, MPI_COMM_SELF);
  const Modes found = with_place(most_demanding(assembly.bodies).where, [&] {
    return find_modes(assembly, part, operators, wanted_modes(assembly.bodies), MPI_COMM_SELF);
  });
  std::vector<double> springs(part.node_ids.size()), dashpots(springs.size());
  joints::Joints(attachments.joints, part).add_bounds(springs, dashpots);
  for (std::size_t place = 0; place < bodies.size(); ++place) {
    if (!solids.bodies[bodies[place]].modal) {
      continue;
    }
    const std::ptrdiff_t begin = part.bodies[place].owned_begin, end = part.bodies[place].owned_end;
    JoinedMotion& motion = motions[bodies[place]];
    if (operators.is_deformed()) {
      motion.rest = rest_of(part.bodies[place], operators.rest());
    }
    motion.springs.assign(springs.begin() + begin, springs.begin() + end);
    for (const Mode& mode : found.modes) {
      motion.frequencies.push_back(2 * std::numbers::pi * mode.lossless_frequency);
      motion.shapes.emplace_back(mode.shape.begin() + 3 * begin, mode.shape.begin() + 3 * end);
    }
  }
}

}  // namespace

std::map<std::size_t, JoinedMotion> joined_motions(const scene::Solids& solids, const std::vector<mesh::Mesh>& meshes) {
  std::map<std::size_t, JoinedMotion> motions;
  for (const std::vector<std::size_t>& bodies : scene::assemblies(solids)) {
    if (!scene::has_common_modes(solids, bodies.front())) {
      add_motions(solids, bodies, meshes, motions);
    }
  }
  return motions;
}

}  // namespace idiophone::eigenmodes
