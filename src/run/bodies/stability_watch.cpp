#include "idiophone/run/bodies/stability_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "idiophone/foundation/parallel/errors.hpp"

namespace idiophone::bodies {

void StabilityWatch::start(const Observation& seen) {
  energy_at_start_ = seen.energy();
  largest_given_ = energy_at_start_ - seen.gravitational;
}

void StabilityWatch::check(const Observation& seen, double time, MPI_Comm communicator) {
  std::string problem;
  if (parallel::is_root(communicator)) {
    // Friction and damping only take energy. Ten times as much as was given, and more than round-off, is invented. What
    // a prestress deforms has less energy than undeformed, so what was given may be below zero.
    const double found = seen.energy() - seen.gravitational;
    largest_given_ = std::max(largest_given_, energy_at_start_ + seen.work - seen.gravitational);
    const double mass = std::accumulate(ready_.initial_state.masses.begin(), ready_.initial_state.masses.end(), 0.0);
    if (!(found <= largest_given_ + 9 * std::abs(largest_given_) + 1e-12 * mass)) {
      problem = fmt::format(
          "the motion became unstable before {:.6g} s: the bodies have an energy of {:.3g} J where initial state, "
          "loads and gravity gave {:.3g} J. The step is {:.3g} of the largest stable one for small strains: lower "
          "time.safety (now {}) or raise time.steps_per_sample above {}; if the body is strained by more than some "
          "20 %, make the load smaller or the mesh finer there",
          time, found, largest_given_, ready_.step() / ready_.initial_state.stable_step(), ready_.scene.time.safety,
          ready_.steps_per_sample);
    }
  }
  parallel::agree(communicator, problem);
}

void StabilityWatch::archive(parallel::Archive& archive) {
  archive.root("run/energy_at_start", energy_at_start_);
  archive.root("run/largest_energy_given", largest_given_);
}

}  // namespace idiophone::bodies
