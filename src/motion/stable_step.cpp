#include "idiophone/motion/stable_step.hpp"

#include <fmt/format.h>
#include <slepceps.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "idiophone/parallel/petsc.hpp"

namespace idiophone::motion {

using parallel::petsc;

namespace {

/// y = M^-1/2 K M^-1/2 x for one body, held components left out; at rest Kelvin-Voigt's damping force gives K x
/// exactly.
struct BodyOperator {
  const mesh::BodyPart& body;
  const solid::Solid& solid;
  std::span<const double> root;       ///< M^-1/2 of each component, zero where it is held, [3 x owned nodes]
  std::span<const double> stiffness;  ///< of supports, [owned nodes]
  std::vector<NodeState> state;
  std::vector<NodeForce> force;

  void apply(const double* x, double* y) {
    for (Index c = 3 * body.owned_begin; c < 3 * body.owned_end; ++c) {
      state[static_cast<std::size_t>(c / 3)].velocity[c % 3] = root[static_cast<std::size_t>(c)] * *x++;
    }
    std::ranges::fill(force, NodeForce{});
    solid.add_linear_stiffness_force(state.data(), force.data());
    for (Index c = 3 * body.owned_begin; c < 3 * body.owned_end; ++c) {
      const auto node = static_cast<std::size_t>(c / 3);
      const double pull = stiffness[node] * state[node].velocity[c % 3] - force[node].component[c % 3];
      *y++ = root[static_cast<std::size_t>(c)] * pull;
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
  body->apply(x, y);
  PetscCall(VecRestoreArrayWrite(out, &y));
  PetscCall(VecRestoreArrayRead(in, &x));
  PetscFunctionReturn(0);
}

/// The largest eigenvalue (w^2) and its vector, by SLEPc's Krylov-Schur method on this rank alone.
double largest_eigenvalue(BodyOperator& body, std::vector<double>& vector) {
  const PetscInt size = 3 * (body.body.owned_end - body.body.owned_begin);
  Mat matrix = nullptr;
  petsc(MatCreateShell(PETSC_COMM_SELF, size, size, size, size, &body, &matrix));
  petsc(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(apply_operator)));
  EPS solver = nullptr;
  petsc(EPSCreate(PETSC_COMM_SELF, &solver));
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
  Vec mode = nullptr;
  PetscScalar value = 0.0;
  petsc(MatCreateVecs(matrix, &mode, nullptr));
  petsc(EPSGetEigenpair(solver, 0, &value, nullptr, mode, nullptr));
  const PetscScalar* entries = nullptr;
  petsc(VecGetArrayRead(mode, &entries));
  vector.assign(entries, entries + size);
  petsc(VecRestoreArrayRead(mode, &entries));
  petsc(VecDestroy(&mode));
  petsc(EPSDestroy(&solver));
  petsc(MatDestroy(&matrix));
  return value;
}

/// Place in `body` of the element that holds most energy of a mode of M^-1/2 K M^-1/2.
std::size_t most_strained_element(const BodyOperator& body, const std::vector<double>& mode) {
  constexpr double small = 1e-12;  // displacements so small that the strain is linear
  std::vector<NodeState> state(body.state.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const auto node = static_cast<std::size_t>(body.body.owned_begin) + i / 3;
    state[node].displacement[i % 3] = mode[i] * body.root[3 * node + i % 3];
    largest = std::max(largest, std::abs(state[node].displacement[i % 3]));
  }
  for (NodeState& node : state) {
    for (double& component : node.displacement) {
      component *= small / largest;
    }
  }
  std::vector<double> energy(body.body.element_ids.size());
  body.solid.elastic_energy(state.data(), energy);
  return static_cast<std::size_t>(std::ranges::max_element(energy) - energy.begin());
}

/// M^-1/2 of each component, zero where it is held. [3 x owned nodes]
std::vector<double> inverse_roots(const Dynamics& dynamics) {
  std::vector<double> roots;
  for (const double mass : dynamics.mass()) {
    roots.insert(roots.end(), 3, 1.0 / std::sqrt(mass));
  }
  for (const Index component : dynamics.constraints().held_components()) {
    roots[static_cast<std::size_t>(component)] = 0.0;
  }
  return roots;
}

/// (2/w)(sqrt(1 + zeta^2) - zeta), without its cancellation for large zeta, s.
/// @param damping  2 zeta w, 1/s
double largest_step(double w, double damping) {
  const double zeta = damping / (2 * w);
  return 2 / w / (std::sqrt(1 + zeta * zeta) + zeta);
}

bool is_held_everywhere(const mesh::BodyPart& body, std::span<const double> roots) {
  const auto components = roots.subspan(3 * static_cast<std::size_t>(body.owned_begin),
                                        3 * static_cast<std::size_t>(body.owned_end - body.owned_begin));
  return std::ranges::all_of(components, [](double root) { return root == 0.0; });
}

Vector3 element_centre(const mesh::BodyPart& body, std::size_t element, const std::vector<Vector3>& reference) {
  Vector3 centre = Vector3::Zero();
  const auto width = static_cast<std::size_t>(mesh::nodes_per_element(body.element));
  for (std::size_t corner = 0; corner < 4; ++corner) {
    centre += reference[static_cast<std::size_t>(body.elements[element * width + corner])] / 4;
  }
  return centre;
}

}  // namespace

std::vector<StableStep> find_stable_steps(const scene::Scene& scene, const mesh::Part& part, const Dynamics& dynamics) {
  std::vector<double> stiffness(part.node_ids.size());
  std::vector<double> dashpot(part.node_ids.size());
  dynamics.loads().add_support_stiffness(stiffness);
  dynamics.loads().add_support_damping(dashpot);
  const std::vector<double> roots = inverse_roots(dynamics);
  std::vector<StableStep> steps;
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const mesh::BodyPart& body = part.bodies[b];
    StableStep& result = steps.emplace_back();
    if (is_held_everywhere(body, roots)) {
      continue;
    }
    BodyOperator whole{body,
                       dynamics.solids()[b],
                       roots,
                       stiffness,
                       std::vector<NodeState>(part.node_ids.size()),
                       std::vector<NodeForce>(part.node_ids.size())};
    std::vector<double> mode;
    const double w = result.largest_frequency = std::sqrt(largest_eigenvalue(whole, mode));
    double rate = 0.0;  // largest c/m of the dashpots, 1/s
    for (auto node = static_cast<std::size_t>(body.owned_begin); node < static_cast<std::size_t>(body.owned_end);
         ++node) {
      rate = std::max(rate, dashpot[node] / dynamics.mass()[node]);
    }
    const double mass_damping = scene.materials[scene.bodies[b].material].damping.mass;
    result.damping = mass_damping + rate + dynamics.solids()[b].damping(w);
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

}  // namespace

void stiffen_by_contact(const scene::Scene& scene, const Dynamics& dynamics, contact::Partners& partners,
                        std::vector<StableStep>& steps) {
  std::vector<double> inverse_mass;  // zero where a node can't be pushed in any direction
  std::vector<int> held(dynamics.mass().size());
  for (const Index component : dynamics.constraints().held_components()) {
    ++held[static_cast<std::size_t>(component / 3)];
  }
  for (std::size_t node = 0; node < held.size(); ++node) {
    inverse_mass.push_back(held[node] == 3 ? 0.0 : 1 / dynamics.mass()[node]);
  }
  const double largest = std::ranges::max_element(steps, {}, &StableStep::largest_frequency)->largest_frequency;
  contact::choose_stiffness(scene, inverse_mass, largest, affordable_share(scene, steps, largest), partners);
  const std::vector<double> squares = contact::squared_frequencies(scene, inverse_mass, partners);
  const double relaxation = relaxation_time(scene);
  for (std::size_t b = 0; b < steps.size(); ++b) {
    if (squares[b] > 0 && steps[b].is_limited()) {
      const double w = std::hypot(steps[b].largest_frequency, std::sqrt(squares[b]));
      steps[b].step = largest_step(w, steps[b].damping + relaxation * squares[b]);
    }
  }
}

/// The highest frequency at which a body's loss factor is to hold, Hz; 0 where there is none.
static double highest_loss(const scene::Scene& scene) {
  double highest = 0.0;
  for (const scene::Body& body : scene.bodies) {
    const auto& loss = scene.materials[body.material].damping.loss;
    highest = std::max(highest, loss ? loss->band[1] : 0.0);
  }
  return highest;
}

int choose_steps_per_sample(const scene::Scene& scene, double step) {
  const double period = 1.0 / scene.audio.rate;
  const double steps_for_loss = std::ceil(2 * M_PI * highest_loss(scene) * period);
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
                      "Hz: give {:.0f} "
                      "or more, or lower the upper end of the materials' damping.band",
                      wanted, period / wanted, highest_loss(scene), steps_for_loss));
    }
    return wanted;
  }
  if (!std::isfinite(step)) {
    throw std::runtime_error(
        "every body is held everywhere, so nothing limits the time step: set time.steps_per_sample yourself");
  }
  const double least = std::max(std::ceil(period / (scene.time.safety * step)), steps_for_loss);
  if (!(least < 1e6)) {
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
  while (!divides(steps)) {
    ++steps;
  }
  return steps;
}

}  // namespace idiophone::motion
