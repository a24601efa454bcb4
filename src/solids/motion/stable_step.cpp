#include "idiophone/solids/motion/stable_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/scene/limits.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"

namespace idiophone::motion {

double largest_step(double w, double damping) {
  const double zeta = damping / (2 * w);
  return 2 / w / (std::sqrt(1 + zeta * zeta) + zeta);
}

Supports supports_of(const mesh::Part& part, const Dynamics& dynamics) {
  Supports supports{std::vector<double>(part.node_ids.size()), std::vector<double>(part.node_ids.size())};
  dynamics.loads().add_support_stiffness(supports.stiffness);
  dynamics.loads().add_support_damping(supports.damping);
  dynamics.loads().add_bow_bounds(supports.stiffness, supports.damping);
  dynamics.acting_joints().add_bounds(supports.stiffness, supports.damping);
  return supports;
}

namespace {

/// [bodies] The rank that has all of a body's nodes, or -1 if several have some. Collective.
std::vector<int> only_ranks(const mesh::Part& part, MPI_Comm communicator) {
  std::vector<int> lowest, highest;
  for (const mesh::BodyPart& body : part.bodies) {
    const bool is_here = body.owned_begin < body.owned_end;
    lowest.push_back(is_here ? parallel::rank_of(communicator) : std::numeric_limits<int>::max());
    highest.push_back(is_here ? parallel::rank_of(communicator) : -1);
  }
  parallel::reduce(lowest, MPI_MIN, communicator);
  parallel::reduce(highest, MPI_MAX, communicator);
  for (std::size_t b = 0; b < lowest.size(); ++b) {
    lowest[b] = lowest[b] == highest[b] ? lowest[b] : -1;
  }
  return lowest;
}

}  // namespace

std::vector<StableStep> find_stable_steps(
    const mesh::Part& part, const std::function<StableStep(std::size_t body, const BodyRanks& ranks)>& of_body,
    MPI_Comm communicator) {
  std::vector<StableStep> steps(part.bodies.size());
  const std::vector<int> only = only_ranks(part, communicator);
  parallel::collectively(communicator, [&] {
    for (std::size_t b = 0; b < steps.size(); ++b) {
      if (only[b] == parallel::rank_of(communicator)) {
        steps[b] = of_body(b, {});
      }
    }
  });
  const parallel::Handle<PetscSF> ghosts = ghost_exchange(part, communicator);
  for (std::size_t b = 0; b < steps.size(); ++b) {
    if (only[b] < 0) {
      steps[b] = of_body(b, {communicator, ghosts});
    } else {
      std::vector<StableStep> found = {steps[b]};
      parallel::broadcast(found, communicator, only[b]);
      steps[b] = found.front();
    }
  }
  return steps;
}

std::vector<StableStep> find_stable_steps(const mesh::Part& part, const Dynamics& dynamics, MPI_Comm communicator) {
  const Supports supports = supports_of(part, dynamics);
  return find_stable_steps(
      part, [&](std::size_t body, const BodyRanks& ranks) { return dynamics.model(body).stable_step(supports, ranks); },
      communicator);
}

namespace {

/// Largest damping time of the contacts, which is stiffness-proportional, s.
double relaxation_time(std::span<const scene::Contact> contacts) {
  double longest = 0.0;
  for (const scene::Contact& contact : contacts) {
    longest = std::max(longest, contact.damping);
  }
  return longest;
}

/// What contact may add to the square of the largest frequency: the share of hexahedra, or less where the deck's own
/// step leaves less. A step is stable while w^2 step^2/4 + c step/2 < 1, with c = 2 zeta w; contact adds to w^2 and to
/// c.
double affordable_share(std::optional<double> step, double relaxation, const std::vector<StableStep>& bodies,
                        const std::vector<contact::BristleBounds>& bristles, double largest_frequency) {
  if (!step) {
    return contact::stiffness_share_of_hexahedra;
  }
  constexpr double margin = 0.95;
  constexpr double least = 0.01;  // where the step leaves nothing, choose_steps_per_sample refuses it
  const double half = *step / 2;
  double room = margin;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double w = bodies[b].largest_frequency;
    const double stiff = (w * w + bristles[b].square) * half * half;
    room = std::min(room, margin - stiff - (bodies[b].damping + bristles[b].damping) * half);
  }
  const double square = largest_frequency * largest_frequency;
  return std::clamp(room / (square * half * (half + relaxation)), least, contact::stiffness_share_of_hexahedra);
}

}  // namespace

void InverseMasses::add(std::span<const double> mesh, std::span<const double> model) {
  of_mesh.insert(of_mesh.end(), mesh.begin(), mesh.end());
  of_model.insert(of_model.end(), model.begin(), model.end());
}

void stiffen_by_contact(const scene::Solids& solids, std::optional<double> step, const InverseMasses& inverse_masses,
                        double largest_frequency, contact::ContactSurfaces& contact_surfaces,
                        std::vector<StableStep>& steps) {
  const double relaxation = relaxation_time(solids.contacts);
  const auto bristles = contact::bristle_bounds(solids, inverse_masses.of_model, contact_surfaces);
  contact::choose_stiffness(solids, inverse_masses.of_mesh, largest_frequency,
                            affordable_share(step, relaxation, steps, bristles, largest_frequency), contact_surfaces);
  const std::vector<double> squares = contact::squared_frequencies(solids, inverse_masses.of_model, contact_surfaces);
  for (std::size_t b = 0; b < steps.size(); ++b) {
    if (squares[b] > 0 && steps[b].is_limited()) {
      const double alone = steps[b].step;
      const auto with = [&](const contact::BristleBounds& more) {
        const double w = std::hypot(steps[b].largest_frequency, std::sqrt(squares[b] + more.square));
        return largest_step(w, steps[b].damping + relaxation * squares[b] + more.damping);
      };
      steps[b].step = with(bristles[b]);
      if (steps[b].step < with({}) / 2) {
        steps[b].cause = StepCause::bristles;
      } else if (steps[b].step < alone / 2) {
        steps[b].cause = StepCause::contact;
      }
    }
  }
}

namespace {

constexpr std::string_view elements_as_cause =
    "Small or flat elements, a stiff or light material, and a large damping.stiffness make it short";

/// Names what makes the steps so short.
[[noreturn]] void refuse_steps(double steps, double stable_step, double steps_for_loss, double highest_loss,
                               std::string_view cause) {
  const std::string reason =
      steps == steps_for_loss
          ? fmt::format("the loss factor holds up to {:.6g} Hz; lower the upper end of the materials' damping.band",
                        highest_loss)
          : fmt::format("the largest stable step is {:.3g} s. {}", stable_step, cause);
  throw std::runtime_error(fmt::format("the motion needs {:.3g} steps per audio sample, more than {}: {}", steps,
                                       scene::most_steps_per_sample, reason));
}

}  // namespace

int choose_steps_per_sample(const scene::Time& time, const scene::Audio& audio, double step, double highest_loss,
                            int multiple_of, std::string_view cause) {
  cause = cause.empty() ? elements_as_cause : cause;
  const double period = 1.0 / audio.rate;
  const double steps_for_loss = std::ceil(2 * std::numbers::pi * highest_loss * period);
  if (time.steps_per_sample) {
    const int wanted = *time.steps_per_sample;
    if (period / wanted > step) {
      throw std::runtime_error(fmt::format(
          "time.steps_per_sample = {} makes a step of {:.4g} s, but the largest stable step is {:.4g} s: give {} "
          "or more, or leave it out. {}",
          wanted, period / wanted, step, static_cast<int>(std::ceil(period / (time.safety * step))), cause));
    }
    if (wanted < steps_for_loss) {
      throw std::runtime_error(
          fmt::format("time.steps_per_sample = {} makes a step of {:.4g} s, too long for a loss factor up to {:.6g} "
                      "Hz: give {:.0f} or more, or lower the upper end of the materials' damping.band",
                      wanted, period / wanted, highest_loss, steps_for_loss));
    }
    if (wanted % multiple_of != 0) {
      throw std::runtime_error(
          fmt::format("time.steps_per_sample = {} is not a multiple of the {} steps that the air takes in an audio "
                      "sample; radiation.back needs a multiple: give {}, or leave it out",
                      wanted, multiple_of, (wanted / multiple_of + 1) * multiple_of));
    }
    return wanted;
  }
  if (!std::isfinite(step)) {
    throw std::runtime_error(
        "every body is held everywhere, so nothing limits the time step: set time.steps_per_sample yourself");
  }
  const double least = std::max(std::ceil(period / (time.safety * step)), steps_for_loss);
  if (!(least <= scene::most_steps_per_sample)) {
    refuse_steps(least, step, steps_for_loss, highest_loss, cause);
  }
  // The surface is to be read at least every 1/(12 f_max), and not much oftener, after a whole number of steps.
  const int reads = static_cast<int>(std::ceil(12 * audio.max_frequency / audio.rate));
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
