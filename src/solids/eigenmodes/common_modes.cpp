// The modes that joined bodies with large amplitudes have in common.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "basis_of_modes.hpp"
#include "fewest_terms.hpp"
#include "find_stretching.hpp"
#include "flexibility_solution.hpp"
#include "idiophone/scene/joined_solids.hpp"
#include "idiophone/scene/large_amplitudes.hpp"
#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"
#include "idiophone/solids/motion/prestress_balance.hpp"
#include "wanted_modes.hpp"
#include "with_place.hpp"

namespace idiophone::eigenmodes {

namespace {

void require_held(const Modes& found, const scene::Body& body, const deck::Location& where) {
  if (found.rigid_motions != 0) {
    throw deck::DeckError(where,
                          fmt::format("body '{}' and those that joints tie to it can move rigidly in {} ways: "
                                      "joined bodies with large_amplitudes have to be held by fixed groups. Hold "
                                      "them, or use model: {{type: finite_elements}}",
                                      body.name, found.rigid_motions));
  }
}

/// @throws deck::DeckError, pointing at a prestress that deforms its body
void require_undeformed(const scene::Solids& assembly, const mesh::Part& part, const Operators& operators) {
  const std::vector<char> deformed = motion::deformed_by_prestress(assembly, part, operators.dynamics(), MPI_COMM_SELF);
  for (std::size_t body = 0; body < deformed.size(); ++body) {
    if (deformed[body] != 0) {
      throw deck::DeckError(assembly.bodies[body].prestress->where,
                            fmt::format("bodies.{}.prestress: {}", assembly.bodies[body].name, deforms));
    }
  }
}

/// The loaded nodes of all bodies in the numbers of the assembly, and the normals there.
struct LoadedNodes {
  std::vector<Index> numbers;
  std::vector<Vector3> normals;
};

LoadedNodes of_assembly(std::span<const std::vector<Index>> loaded, const std::vector<mesh::Mesh>& meshes) {
  LoadedNodes all;
  const std::vector<Index> first = mesh::offsets(meshes).nodes;
  for (std::size_t body = 0; body < meshes.size(); ++body) {
    std::ranges::transform(loaded[body], std::back_inserter(all.numbers),
                           [&](Index node) { return first[body] + node; });
    std::ranges::copy(normals_at(loaded[body], meshes[body]), std::back_inserter(all.normals));
  }
  return all;
}

/// What one body has of a basis of all: nodes from `first` on.
modal_bodies::ModalBasis share_of(const modal_bodies::ModalBasis& all, std::ptrdiff_t first, std::ptrdiff_t nodes) {
  modal_bodies::ModalBasis own;
  own.frequencies = all.frequencies;
  own.decay_rates = all.decay_rates;
  own.masses.assign(all.masses.begin() + first, all.masses.begin() + first + nodes);
  own.residual.assign(all.residual.begin() + first, all.residual.begin() + first + nodes);
  for (std::size_t mode = 0; mode < all.modes(); ++mode) {
    const auto shape = all.shapes.begin() + static_cast<std::ptrdiff_t>(3 * mode * all.nodes()) + 3 * first;
    own.shapes.insert(own.shapes.end(), shape, shape + 3 * nodes);
  }
  own.stretching.rotation = all.stretching.rotation;
  return own;
}

/// The modes of the assembly at the nodes of all bodies, which follow each other.
modal_bodies::ModalBasis basis_of_all(const scene::Solids& assembly, const mesh::Part& part, const Operators& operators,
                                      const LoadedNodes& loaded, const deck::Location& where) {
  require_undeformed(assembly, part, operators);
  Options options = wanted_modes(assembly.bodies);
  options.align_double_modes = true;
  const Modes found = find_modes(assembly, part, operators, options, MPI_COMM_SELF);
  require_held(found, assembly.bodies.front(), where);
  modal_bodies::ModalBasis all = basis_of(found, operators.dynamics(), assembly.bodies.size());
  const ShiftedStiffness stiffness = invertible_stiffness(operators, found);
  all.residual = residual_flexibility(stiffness, part, all, loaded.numbers, loaded.normals);
  const double tolerance = scene::stretching_tolerance(assembly.bodies);
  all.stretching =
      in_fewest_terms(find_stretching(operators, part, all, stiffness, tolerance), all.frequencies, tolerance);
  return all;
}

}  // namespace

std::vector<modal_bodies::ModalBasis> common_bases(const scene::Solids& solids, const std::vector<std::size_t>& bodies,
                                                   const std::vector<mesh::Mesh>& meshes,
                                                   std::span<const std::vector<Index>> loaded) {
  scene::Assembly joined(solids, bodies.front());
  for (scene::Body& body : joined.bodies) {
    body.supports.clear();  // they are loads of a modal body
  }
  const scene::Solids assembly = joined.solids();
  const motion::Attachments attachments = motion::attach(assembly, meshes);
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  const deck::Location& where = most_demanding(assembly.bodies).where;
  modal_bodies::ModalBasis all = with_place(where, [&] {
    const Operators operators(assembly, part, attachments, MassMatrix::lumped, MPI_COMM_SELF);
    return basis_of_all(assembly, part, operators, of_assembly(loaded, meshes), where);
  });
  std::vector<modal_bodies::ModalBasis> bases;
  for (std::size_t place = 0; place < bodies.size(); ++place) {
    const auto [begin, end] =
        std::pair<std::ptrdiff_t, std::ptrdiff_t>(part.bodies[place].owned_begin, part.bodies[place].owned_end);
    modal_bodies::ModalBasis& own = bases.emplace_back(share_of(all, begin, end - begin));
    own.common_with = bodies.front();
    own.mass_damping = solids.materials[assembly.bodies[place].material].damping.of_all_motion();
    own.thickness = thickness_of(solids, assembly.bodies[place], meshes[place], own.masses);
  }
  bases.front().stretching = std::move(all.stretching);
  return bases;
}

}  // namespace idiophone::eigenmodes
