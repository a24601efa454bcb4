#include "idiophone/motion/stable_step.hpp"

#include <fmt/format.h>
#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "idiophone/element/reference.hpp"
#include "idiophone/parallel/petsc.hpp"
#include "idiophone/scene/limits.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

/// y = L^T K L x for one body, with L L^T = M^-1 (solid::Mass) and held components left out; at rest Kelvin-Voigt's
/// damping force gives K x exactly.
struct BodyOperator {
  const mesh::BodyPart& body;
  const solid::Solid& solid;
  const solid::Mass& mass;
  std::span<const char> held;         ///< 1 where a component is held, [3 x owned nodes of the body]
  std::span<const double> stiffness;  ///< of supports, [owned nodes of all bodies]
  std::vector<NodeState> state;
  std::vector<NodeForce> force;

  [[nodiscard]] std::size_t size() const { return held.size(); }
  [[nodiscard]] NodeState& node(std::size_t component) { return state[body.owned_begin + component / 3]; }

  /// L x, zero where it is held.
  [[nodiscard]] std::vector<double> displacements(std::span<const double> x) const {
    std::vector<double> moved(x.begin(), x.end());
    mass.apply_inverse_factor(moved);
    leave_out_held(moved);
    return moved;
  }

  void apply(std::span<const double> x, std::span<double> result) {
    const std::vector<double> moved = displacements(x);
    for (std::size_t c = 0; c < size(); ++c) {
      node(c).velocity[c % 3] = moved[c];
    }
    std::ranges::fill(force, NodeForce{});
    solid.add_linear_stiffness_force(state, force);
    for (std::size_t c = 0; c < size(); ++c) {
      const std::size_t node = body.owned_begin + c / 3;
      result[c] = stiffness[node] * state[node].velocity[c % 3] - force[node].component[c % 3];
    }
    leave_out_held(result);
    mass.apply_transposed_inverse_factor(result);
  }

 private:
  void leave_out_held(std::span<double> values) const {
    for (std::size_t c = 0; c < size(); ++c) {
      values[c] = held[c] != 0 ? 0.0 : values[c];
    }
  }
};

PetscErrorCode apply_operator(Mat matrix, Vec in, Vec out) {
  PetscFunctionBegin;
  BodyOperator* body = nullptr;
  PetscCall(MatShellGetContext(matrix, static_cast<void*>(&body)));
  const PetscScalar* x = nullptr;
  PetscScalar* y = nullptr;
  PetscCall(VecGetArrayRead(in, &x));
  PetscCall(VecGetArrayWrite(out, &y));
  body->apply({x, body->size()}, {y, body->size()});
  PetscCall(VecRestoreArrayWrite(out, &y));
  PetscCall(VecRestoreArrayRead(in, &x));
  PetscFunctionReturn(0);
}

/// The largest eigenvalue (w^2) and its vector, by SLEPc's Krylov-Schur method on this rank alone.
double largest_eigenvalue(BodyOperator& body, std::vector<double>& vector) {
  const auto size = static_cast<PetscInt>(body.size());
  parallel::Handle<Mat> matrix;
  petsc(MatCreateShell(PETSC_COMM_SELF, size, size, size, size, &body, matrix.out()));
  petsc(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(apply_operator)));
  parallel::Handle<EPS> solver;
  petsc(EPSCreate(PETSC_COMM_SELF, solver.out()));
  petsc(EPSSetOptionsPrefix(solver, "stable_step_"));
  petsc(EPSSetOperators(solver, matrix, nullptr));
  petsc(EPSSetProblemType(solver, EPS_HEP));
  petsc(EPSSetWhichEigenpairs(solver, EPS_LARGEST_REAL));
  petsc(EPSSetTolerances(solver, 1e-3, 1000));  // far inside the safety factor
  petsc(EPSSetFromOptions(solver));
  petsc(EPSSolve(solver));
  PetscInt converged = 0;
  petsc(EPSGetConverged(solver, &converged));
  if (converged < 1) {
    throw std::runtime_error(
        "the largest eigenfrequency was not found, so no stable step is known; set time.steps_per_sample yourself");
  }
  parallel::Handle<Vec> mode;
  PetscScalar value = 0.0;
  petsc(MatCreateVecs(matrix, mode.out(), nullptr));
  petsc(EPSGetEigenpair(solver, 0, &value, nullptr, mode, nullptr));
  const PetscScalar* entries = nullptr;
  petsc(VecGetArrayRead(mode, &entries));
  vector.assign(entries, entries + size);
  petsc(VecRestoreArrayRead(mode, &entries));
  return value;
}

/// Place in `body` of the element that holds most energy of a mode of L^T K L.
std::size_t most_strained_element(BodyOperator& body, const std::vector<double>& mode) {
  constexpr double small = 1e-12;  // displacements so small that the strain is linear
  const std::vector<double> moved = body.displacements(mode);
  const double largest = std::abs(*std::ranges::max_element(moved, {}, [](double u) { return std::abs(u); }));
  body.state.assign(body.state.size(), NodeState{});
  for (std::size_t c = 0; c < moved.size(); ++c) {
    body.node(c).displacement[c % 3] = moved[c] * (small / largest);
  }
  std::vector<double> energy(body.body.element_ids.size());
  body.solid.elastic_energy(body.state, energy);
  return std::ranges::max_element(energy) - energy.begin();
}

/// 1 where a component is held. [3 x owned nodes]
std::vector<char> held_flags(const Dynamics& dynamics, Index owned_nodes) {
  std::vector<char> held(3 * owned_nodes);
  for (const Index component : dynamics.constraints().held_components()) {
    held[component] = 1;
  }
  return held;
}

/// (2/w)(sqrt(1 + zeta^2) - zeta), without its cancellation for large zeta, s.
/// @param damping  2 zeta w, 1/s
double largest_step(double w, double damping) {
  const double zeta = damping / (2 * w);
  return 2 / w / (std::sqrt(1 + zeta * zeta) + zeta);
}

Vector3 element_centre(const mesh::BodyPart& body, std::size_t element, const std::vector<Vector3>& reference) {
  const std::vector<int>& corners = element::reference(body.element).corners;
  Vector3 centre = Vector3::Zero();
  for (const int corner : corners) {
    centre += reference[body.element_nodes(element)[corner]] / static_cast<double>(corners.size());
  }
  return centre;
}

}  // namespace

std::vector<StableStep> find_stable_steps(const scene::Scene& scene, const mesh::Part& part, const Dynamics& dynamics) {
  std::vector<double> stiffness(part.node_ids.size());
  std::vector<double> dashpot(part.node_ids.size());
  dynamics.loads().add_support_stiffness(stiffness);
  dynamics.loads().add_support_damping(dashpot);
  const std::vector<char> held = held_flags(dynamics, part.owned_nodes);
  std::vector<StableStep> steps;
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const mesh::BodyPart& body = part.bodies[b];
    StableStep& result = steps.emplace_back();
    const auto held_here = std::span(held).subspan(3 * body.owned_begin, 3 * (body.owned_end - body.owned_begin));
    if (std::ranges::all_of(held_here, [](char flag) { return flag != 0; })) {
      continue;
    }
    BodyOperator whole{.body = body,
                       .solid = dynamics.solid(b),
                       .mass = dynamics.mass(b),
                       .held = held_here,
                       .stiffness = stiffness,
                       .state = std::vector<NodeState>(part.node_ids.size()),
                       .force = std::vector<NodeForce>(part.node_ids.size())};
    std::vector<double> mode;
    const double w = result.largest_frequency = std::sqrt(largest_eigenvalue(whole, mode));
    double rate = 0.0;  // largest c/m of the dashpots, 1/s
    for (Index node = body.owned_begin; node < body.owned_end; ++node) {
      rate = std::max(rate, dashpot[node] / dynamics.mass(b).lumped(node));
    }
    const double mass_damping = scene.materials[scene.bodies[b].material].damping.of_all_motion();
    result.damping = mass_damping + rate + dynamics.solid(b).damping(w);
    result.step = largest_step(w, result.damping);
    const std::size_t element = most_strained_element(whole, mode);
    result.element = body.element_ids[element];
    result.centre = element_centre(body, element, part.reference);
  }
  return steps;
}

namespace {

/// Largest damping time of the contacts, which is stiffness-proportional, s.
double relaxation_time(const scene::Scene& scene) {
  double longest = 0.0;
  for (const scene::Contact& contact : scene.contacts) {
    longest = std::max(longest, contact.damping);
  }
  return longest;
}

/// What contact may add to the square of the largest frequency: the usual share, or less where the deck's own step
/// leaves less. A step is stable while w^2 step^2/4 + c step/2 < 1, with c = 2 zeta w; contact adds to w^2 and to c.
double affordable_share(const scene::Scene& scene, const std::vector<StableStep>& bodies, double largest_frequency) {
  if (!scene.time.steps_per_sample) {
    return contact::stiffness_share;
  }
  constexpr double margin = 0.95;
  constexpr double least = 0.01;  // where the step leaves nothing, choose_steps_per_sample refuses it
  const double half = 0.5 / (*scene.time.steps_per_sample * scene.audio.rate);  // of a step, s
  double room = margin;
  for (const StableStep& body : bodies) {
    const double w = body.largest_frequency;
    room = std::min(room, margin - w * w * half * half - body.damping * half);
  }
  const double square = largest_frequency * largest_frequency;
  return std::clamp(room / (square * half * (half + relaxation_time(scene))), least, contact::stiffness_share);
}

/// 1/kg, zero where a node can't move in any direction. [nodes of all bodies]
std::vector<double> inverse_masses(const Dynamics& dynamics, std::size_t bodies) {
  std::vector<double> inverse;
  for (std::size_t b = 0; b < bodies; ++b) {
    const std::vector<double> of_body = dynamics.model(b).inverse_masses();
    inverse.insert(inverse.end(), of_body.begin(), of_body.end());
  }
  return inverse;
}

/// The highest frequency at which a body's loss factor is to hold, Hz; 0 where there is none.
double highest_loss(const scene::Scene& scene) {
  double highest = 0.0;
  for (const scene::Body& body : scene.bodies) {
    const auto& loss = scene.materials[body.material].damping.loss;
    if (body.modal) {
      continue;  // its modes know their own damping
    }
    highest = std::max(highest, loss ? loss->band[1] : 0.0);
  }
  return highest;
}

}  // namespace

StableStep modal_stable_step(const ModalBasis& basis, const Dynamics& dynamics, const mesh::Part& part,
                             std::size_t body) {
  std::vector<double> stiffness(part.node_ids.size());
  std::vector<double> dashpot(part.node_ids.size());
  dynamics.loads().add_support_stiffness(stiffness);
  dynamics.loads().add_support_damping(dashpot);
  const std::vector<double> inverse = dynamics.model(body).inverse_masses();
  double square = std::pow(residual_frequency(basis), 2);
  StableStep result;
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    const std::size_t node = part.bodies[body].owned_begin + i;
    square += stiffness[node] * inverse[i];
    result.damping += dashpot[node] * inverse[i];
  }
  result.largest_frequency = std::sqrt(square);
  result.step = largest_step(result.largest_frequency, result.damping);
  return result;
}

void stiffen_by_contact(const scene::Scene& scene, const Dynamics& finite_elements, double largest_frequency,
                        const Dynamics& dynamics, contact::ContactSurfaces& contact_surfaces,
                        std::vector<StableStep>& steps) {
  contact::choose_stiffness(scene, inverse_masses(finite_elements, steps.size()), largest_frequency,
                            affordable_share(scene, steps, largest_frequency), contact_surfaces);
  const std::vector<double> squares =
      contact::squared_frequencies(scene, inverse_masses(dynamics, steps.size()), contact_surfaces);
  const double relaxation = relaxation_time(scene);
  for (std::size_t b = 0; b < steps.size(); ++b) {
    if (squares[b] > 0 && steps[b].is_limited()) {
      const double w = std::hypot(steps[b].largest_frequency, std::sqrt(squares[b]));
      steps[b].step = largest_step(w, steps[b].damping + relaxation * squares[b]);
    }
  }
}

int choose_steps_per_sample(const scene::Scene& scene, double step, int multiple_of) {
  const double period = 1.0 / scene.audio.rate;
  const double steps_for_loss = std::ceil(2 * std::numbers::pi * highest_loss(scene) * period);
  if (scene.time.steps_per_sample) {
    const int wanted = *scene.time.steps_per_sample;
    if (period / wanted > step) {
      throw std::runtime_error(fmt::format(
          "time.steps_per_sample = {} makes a step of {:.4g} s, but the largest stable step is {:.4g} s: give {} "
          "or more, or leave it out",
          wanted, period / wanted, step, static_cast<int>(std::ceil(period / (scene.time.safety * step)))));
    }
    if (wanted < steps_for_loss) {
      throw std::runtime_error(
          fmt::format("time.steps_per_sample = {} makes a step of {:.4g} s, too long for a loss factor up to {:.6g} "
                      "Hz: give {:.0f} or more, or lower the upper end of the materials' damping.band",
                      wanted, period / wanted, highest_loss(scene), steps_for_loss));
    }
    if (wanted % multiple_of != 0) {
      throw std::runtime_error(
          fmt::format("time.steps_per_sample = {} is not a multiple of the {} steps that the air takes in an audio "
                      "sample, and with "
                      "radiation.back the two must keep time: give {}, or leave it out",
                      wanted, multiple_of, (wanted / multiple_of + 1) * multiple_of));
    }
    return wanted;
  }
  if (!std::isfinite(step)) {
    throw std::runtime_error(
        "every body is held everywhere, so nothing limits the time step: set time.steps_per_sample yourself");
  }
  const double least = std::max(std::ceil(period / (scene.time.safety * step)), steps_for_loss);
  if (!(least <= scene::most_steps_per_sample)) {
    throw std::runtime_error(
        fmt::format("the mesh needs {:.3g} steps per audio sample (its stable step is {:.3g} s): it has a sliver; see "
                    "`idiophone check`",
                    least, step));
  }
  // The surface is to be read at least every 1/(12 f_max), and not much oftener, after a whole number of steps.
  const int reads = static_cast<int>(std::ceil(12 * scene.audio.max_frequency / scene.audio.rate));
  const auto divides = [&](int steps) {
    return steps <= reads || steps % reads == 0 || steps % (reads + 1) == 0 || steps % (reads + 2) == 0;
  };
  int steps = static_cast<int>(least);
  while (!divides(steps) || steps % multiple_of != 0) {
    ++steps;
  }
  return steps;
}

}  // namespace idiophone::motion
