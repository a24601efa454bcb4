#include "idiophone/solids/eigenmodes/compute_modal_basis.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "basis_of_modes.hpp"
#include "damped_mode.hpp"
#include "fewest_terms.hpp"
#include "find_stretching.hpp"
#include "flexibility_solution.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/solids/accuracy/pitch_error.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "joined_shapes.hpp"
#include "operators.hpp"
#include "rigid_motions.hpp"
#include "shifted_stiffness.hpp"
#include "with_place.hpp"

namespace idiophone::eigenmodes {

namespace {

void check(const Modes& found, const scene::Body& body, const deck::Location& where) {
  if (found.rigid_motions != 0 && found.rigid_motions != 6) {
    throw deck::DeckError(where,
                          fmt::format("body '{}' can still move rigidly in {} of 6 ways: a modal body is held or "
                                      "it is free; hold it in all directions, or use model: {{type: "
                                      "finite_elements}}",
                                      body.name, found.rigid_motions));
  }
}

bool is_deformed(const JoinedMotion* joined) {
  return joined != nullptr && !joined->rest.empty();
}

/// What a body alone is, without its prestress.
struct Unstressed {
  const scene::Solids& solids;
  const mesh::Part& part;
  const motion::Attachments& attachments;
  const Operators& operators;
};

/// Lets a mode be as stiff and as damped as with the stress at rest. Stress that stiffens it raises its frequency, but
/// not what its material loses in a cycle. Where stress makes it less stiff, the neighbours hold it: it keeps its
/// damping.
/// @param added  to the square of its frequency by the stress, 1/s2; corrected by what its loss factor does
void damp_at_rest(const Unstressed& body, const Mode& mode, double& decay_rate, double& added) {
  if (added <= 0) {
    return;
  }
  const double lossless = 2 * std::numbers::pi * mode.lossless_frequency, slack = 2 * std::numbers::pi * mode.frequency;
  const Mode taut = damped_mode({.value = lossless * lossless, .vector = mode.shape}, body.solids, body.operators,
                                body.part, MPI_COMM_SELF, added);
  const double frequency = 2 * std::numbers::pi * taut.frequency;
  decay_rate = taut.damping_ratio * frequency;
  added = frequency * frequency - slack * slack;
}

/// What stress at rest does to the modes of the unstressed body.
/// @param stressed_body  the same with its prestress
/// @param rest           [3 x nodes] displacements, m
void add_rest(const Unstressed& body, const scene::Body& stressed_body, const std::vector<double>& rest,
              const std::vector<Mode>& found, modal_bodies::ModalBasis& basis) {
  scene::Solids alone = body.solids;
  alone.bodies = {&stressed_body, 1};
  const Operators stressed(alone, body.part, body.attachments, MassMatrix::lumped, rest, MPI_COMM_SELF);
  const auto rows = static_cast<Eigen::Index>(3 * basis.nodes()), modes = static_cast<Eigen::Index>(basis.modes());
  const auto shapes = Eigen::MatrixXd::Map(basis.shapes.data(), rows, modes);
  std::vector<solid::NodeForce> force(basis.nodes());
  stressed.dynamics().solid(0).add_internal_force(stressed.rest(), force);
  Eigen::VectorXd at_components(rows);
  for (Eigen::Index c = 0; c < rows; ++c) {
    at_components[c] = force[c / 3].component[c % 3];
  }
  const Eigen::VectorXd of_modes = shapes.transpose() * at_components;
  Eigen::MatrixXd added = shapes.transpose() * product(stressed.stiffness(), stressed, shapes);
  for (Eigen::Index mode = 0; mode < modes; ++mode) {
    added(mode, mode) -= std::pow(2 * std::numbers::pi * found[mode].lossless_frequency, 2);
    damp_at_rest(body, found[mode], basis.decay_rates[mode], added(mode, mode));
  }
  added = (added + added.transpose()).eval() / 2;
  basis.rest = rest;
  basis.rest_force.assign(of_modes.begin(), of_modes.end());
  basis.rest_stiffness.assign(added.data(), added.data() + added.size());
}

}  // namespace

modal_bodies::ModalBasis modal_basis(const scene::Solids& solids, std::size_t body, const mesh::Mesh& mesh,
                                     std::span<const Index> loaded, const JoinedMotion* joined) {
  const scene::ModalModel& model = *solids.bodies[body].modal;
  scene::Body unsupported = solids.bodies[body];
  unsupported.supports.clear();  // they are loads of a modal body
  const scene::Body stressed = unsupported;
  if (is_deformed(joined)) {
    unsupported.prestress.reset();
  }
  scene::Solids alone = solids.alone(body);
  alone.bodies = {&unsupported, 1};
  const std::vector meshes = {mesh};
  const motion::Attachments attachments = motion::attach(alone, meshes);
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  Options options;
  options.count = model.count.value_or(options.count);
  options.up_to = model.up_to;
  options.align_double_modes = model.stretching_tolerance.has_value();
  const Operators operators =
      with_place(model.where, [&] { return Operators(alone, part, attachments, options.mass, MPI_COMM_SELF); });
  Modes found = with_place(model.where, [&] { return find_modes(alone, part, operators, options, MPI_COMM_SELF); });
  check(found, solids.bodies[body], model.where);
  const std::size_t own = found.modes.size();
  if (joined != nullptr) {
    const auto rigid = rigid_motions(part, operators, MPI_COMM_SELF);
    for (Eigenpair& pair : joined_shapes(operators, found, rigid, *joined)) {
      found.modes.push_back(damped_mode(std::move(pair), alone, operators, part, MPI_COMM_SELF));
    }
  }
  modal_bodies::ModalBasis basis = basis_of(found, operators.dynamics(), 1);
  basis.further = found.modes.size() - own;
  if (is_deformed(joined)) {
    add_rest({alone, part, attachments, operators}, stressed, joined->rest, found.modes, basis);
  }
  basis.mass_damping = solids.materials[unsupported.material].damping.of_all_motion();
  basis.thickness = thickness_of(solids, unsupported, mesh, basis.masses);
  const ShiftedStiffness stiffness = invertible_stiffness(operators, found);
  basis.residual = residual_flexibility(stiffness, part, basis, loaded, normals_at(loaded, mesh));
  if (model.stretching_tolerance) {
    const double tolerance = *model.stretching_tolerance;
    basis.stretching =
        in_fewest_terms(find_stretching(operators, part, basis, stiffness, tolerance), basis.frequencies, tolerance);
  }
  return basis;
}

modal_bodies::Stretching stretching_of(const Modes& found, const scene::Solids& alone, const mesh::Part& part,
                                       const motion::Attachments& attachments, double tolerance) {
  const Operators operators(alone, part, attachments, MassMatrix::lumped, MPI_COMM_SELF);
  const modal_bodies::ModalBasis basis = basis_of(found, operators.dynamics(), part.bodies.size());
  return in_fewest_terms(find_stretching(operators, part, basis, invertible_stiffness(operators, found), tolerance),
                         basis.frequencies, tolerance);
}

}  // namespace idiophone::eigenmodes
