#include "idiophone/study/advice/step_measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "idiophone/study/advice/processor_clock.hpp"

namespace idiophone::advice {

namespace {

constexpr std::size_t rounds = 9;
constexpr double round_seconds = 0.02;  ///< about, s
constexpr int most_calls = 1000;

/// Seconds of a call.
template <class Call>
double seconds_of(int calls, const Call& call) {
  const double start = processor_clock();
  for (int i = 0; i < calls; ++i) {
    call();
  }
  return (processor_clock() - start) / calls;
}

double median(std::array<double, rounds> values) {
  std::ranges::nth_element(values, values.begin() + rounds / 2);
  return values[rounds / 2];
}

/// The initial displacement and a uniform strain. Processors are slow where the motion has not arrived yet, because its
/// numbers are subnormal there; with the strain there are none of these. [3 x global nodes] m
std::vector<double> strained(const bodies::Preparation& ready) {
  constexpr double strain = 1e-9;
  std::vector<double> displacement = ready.initial_state.displacement;
  displacement.resize(3 * static_cast<std::size_t>(ready.part.global_nodes));
  for (Index node = 0; node < ready.part.owned_nodes; ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      displacement[3 * static_cast<std::size_t>(ready.part.node_ids[node]) + axis] +=
          strain * ready.part.reference[node][axis];
    }
  }
  return displacement;
}

}  // namespace

StepMeasurement measure_steps(const bodies::Preparation& ready, double program, MPI_Comm communicator) {
  motion::Motion motion(ready.scene, ready.part, ready.attachments, ready.contact_surfaces, ready.step(),
                        ready.steps_per_sample, communicator, ready.models());
  motion.start(ready.initial_state.centres, strained(ready));
  const auto advance = [&] { motion.advance(); };
  motion.advance();
  const double first = parallel::largest(seconds_of(1, advance), communicator);
  const int calls = std::clamp(static_cast<int>(round_seconds / std::max(first, 1e-6)), 1, most_calls);
  std::vector<solid::NodeForce> force(motion.state().size());
  std::array<double, rounds> whole{};
  std::array<double, rounds> of_force{};
  for (std::size_t round = 0; round < rounds; ++round) {
    whole[round] = seconds_of(calls, advance);
    of_force[round] = seconds_of(calls, [&] { motion.dynamics().compute_force(motion.time(), motion.state(), force); });
  }
  return {.step = {.force = parallel::sum(std::min(median(of_force), median(whole)), communicator),
                   .whole = parallel::sum(median(whole), communicator)},
          .memory = MemoryEstimate(ready, motion.dynamics(), program)};
}

}  // namespace idiophone::advice
