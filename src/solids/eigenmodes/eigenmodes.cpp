#include "idiophone/solids/eigenmodes/eigenmodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "damped_mode.hpp"
#include "double_modes.hpp"
#include "eigensolver.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "inertia.hpp"
#include "operators.hpp"
#include "rigid_motions.hpp"

namespace idiophone::eigenmodes {

namespace {

double angular(double frequency) {
  return 2 * std::numbers::pi * frequency;
}

/// The body, or all that joints tie together, for messages.
std::string name_of(std::span<const scene::Body> bodies) {
  std::string names;
  for (const scene::Body& body : bodies) {
    names += (names.empty() ? "'" : ", '") + body.name + "'";
  }
  return (bodies.size() == 1 ? "body " : "the assembly of bodies ") + names;
}

/// How many modes are wanted. @param rigid  number of rigid motions
EigenpairCount wanted(const Options& options, const Operators& operators, int rigid) {
  if (!options.up_to) {
    return {options.count};
  }
  const double bound = std::pow(angular(*options.up_to), 2);
  return {static_cast<int>(eigenvalues_below(operators, bound)) - rigid, bound};
}

/// Refuses what the body cannot give. @param rigid  number of rigid motions
void check(const Options& options, const std::string& name, const Operators& operators, int rigid) {
  const PetscInt modes = operators.size() - rigid;
  if (modes < 1) {
    throw NoModes(fmt::format("{} has no modes: all of it is held", name));
  }
  if (options.count > modes) {
    throw std::runtime_error(
        fmt::format("{} has no more than {} modes on this mesh, not {}", name, modes, options.count));
  }
  if (rigid > 0 && options.shift && *options.shift == 0) {
    throw std::runtime_error(
        fmt::format("{} can move rigidly in {} ways, so its stiffness can't be inverted: the shift must be above zero",
                    name, rigid));
  }
}

/// @param rigid  number of rigid motions, whose eigenvalues are rounding errors far below the shift's, Hz
/// @throws std::runtime_error where a prestress that presses makes the body buckle
void check_buckling(std::span<const scene::Body> bodies, const Operators& operators, int rigid, double shift) {
  const double bound = rigid > 0 ? -std::pow(angular(shift), 2) : 0.0;
  const bool is_prestressed =
      std::ranges::any_of(bodies, [](const scene::Body& body) { return body.prestress.has_value(); });
  if (is_prestressed && eigenvalues_below(operators, bound) > 0) {
    throw std::runtime_error(
        fmt::format("{} buckles under its prestress, so it has no modes: give it a "
                    "smaller pressure",
                    name_of(bodies)));
  }
}

}  // namespace

Modes find_modes(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
                 const Options& options, MPI_Comm communicator) {
  return find_modes(solids, part, Operators(solids, part, attachments, options.mass, communicator), options,
                    communicator);
}

Modes find_modes(const scene::Solids& solids, const mesh::Part& part, const Operators& operators,
                 const Options& options, MPI_Comm communicator) {
  const std::string name = name_of(solids.bodies);
  const auto rigid = rigid_motions(part, operators, communicator);
  Modes found;
  found.rigid_motions = static_cast<int>(rigid.size());
  check(options, name, operators, found.rigid_motions);
  found.shift =
      options.shift ? *options.shift : 0.1 * rough_frequency(solids, part, operators.dynamics(), communicator);
  check_buckling(solids.bodies, operators, found.rigid_motions, found.shift);
  const double shift = std::pow(angular(found.shift), 2);
  const EigenpairCount count = wanted(options, operators, found.rigid_motions);
  if (count.count < 1) {
    throw no_modes_up_to(options.up_to.value(), name, operators, rigid, shift);
  }
  auto pairs = lowest_eigenpairs(operators, rigid, count, shift, options.watch);
  if (options.align_double_modes) {
    align_double_modes(pairs, part.reference);
  }
  for (Eigenpair& pair : pairs) {
    found.modes.push_back(damped_mode(std::move(pair), solids, operators, part, communicator));
  }
  return found;
}

}  // namespace idiophone::eigenmodes
