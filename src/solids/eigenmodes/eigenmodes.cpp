#include "idiophone/solids/eigenmodes/eigenmodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "damped_mode.hpp"
#include "eigensolver.hpp"
#include "idiophone/solids/eigenmodes/no_modes.hpp"
#include "idiophone/solids/motion/prestress_balance.hpp"
#include "inertia.hpp"
#include "operators.hpp"
#include "rigid_motions.hpp"

namespace idiophone::eigenmodes {

namespace {

double angular(double frequency) {
  return 2 * std::numbers::pi * frequency;
}

/// How many modes are wanted. @param rigid  number of rigid motions
int wanted(const Options& options, const scene::Body& body, const Operators& operators, int rigid) {
  if (!options.up_to) {
    return options.count;
  }
  const auto below = static_cast<int>(eigenvalues_below(operators, std::pow(angular(*options.up_to), 2))) - rigid;
  if (below < 1) {
    throw NoModes(fmt::format("body '{}' has no modes up to {} Hz", body.name, *options.up_to));
  }
  return below;
}

/// Refuses what the body cannot give. @param rigid  number of rigid motions
void check(const Options& options, const scene::Body& body, const Operators& operators, int rigid) {
  const PetscInt modes = operators.size() - rigid;
  if (modes < 1) {
    throw NoModes(fmt::format("body '{}' has no modes: all of it is held", body.name));
  }
  if (options.count > modes) {
    throw std::runtime_error(
        fmt::format("body '{}' has no more than {} modes on this mesh, not {}", body.name, modes, options.count));
  }
  if (rigid > 0 && options.shift && *options.shift == 0) {
    throw std::runtime_error(fmt::format(
        "body '{}' can move rigidly in {} ways, so its stiffness can't be inverted: the shift must be above zero",
        body.name, rigid));
  }
}

/// @param rigid  number of rigid motions, whose eigenvalues are rounding errors far below the shift's, Hz
/// @throws std::runtime_error where a prestress that presses makes the body buckle
void check_buckling(std::span<const scene::Body> bodies, const Operators& operators, int rigid, double shift) {
  const double bound = rigid > 0 ? -std::pow(angular(shift), 2) : 0.0;
  const auto body = std::ranges::find_if(bodies, [](const scene::Body& one) { return one.prestress.has_value(); });
  if (body != bodies.end() && eigenvalues_below(operators, bound) > 0) {
    throw std::runtime_error(
        fmt::format("body '{}' buckles under its prestress, so it has no modes about its undeformed shape: give it a "
                    "smaller pressure",
                    body->name));
  }
}

}  // namespace

Modes find_modes(const scene::Solids& solids, const mesh::Part& part, const motion::Attachments& attachments,
                 const Options& options, MPI_Comm communicator) {
  const scene::Body& body = solids.bodies.front();
  const Operators operators(solids, part, attachments, options.mass, communicator);
  motion::check_prestress(solids, part, operators.dynamics(), communicator);
  const auto rigid = rigid_motions(part, operators, communicator);
  Modes found;
  found.rigid_motions = static_cast<int>(rigid.size());
  check(options, body, operators, found.rigid_motions);
  found.shift =
      options.shift ? *options.shift : 0.1 * rough_frequency(solids, part, operators.dynamics(), communicator);
  check_buckling(solids.bodies, operators, found.rigid_motions, found.shift);
  const int count = wanted(options, body, operators, found.rigid_motions);
  for (Eigenpair& pair : lowest_eigenpairs(operators, rigid, count, std::pow(angular(found.shift), 2), options.watch)) {
    found.modes.push_back(damped_mode(std::move(pair), solids, operators, part, communicator));
  }
  return found;
}

}  // namespace idiophone::eigenmodes
