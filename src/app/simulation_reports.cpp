// What a run says of its bodies: that they overlap, how deeply they met, that they became unstable.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "simulation.hpp"

namespace idiophone::app {

double Simulation::deepest(std::size_t contact) {
  double deepest = motion_.contacts().deepest(contact);
  MPI_Allreduce(MPI_IN_PLACE, &deepest, 1, MPI_DOUBLE, MPI_MAX, communicator_);
  return deepest;
}

void Simulation::report_overlaps() {
  for (std::size_t c = 0; c < motion_.contacts().count(); ++c) {
    const contact::ContactMotion now = motion_.contacts().now(c);
    std::array<double, 4> place = {now.overlap, now.point.x(), now.point.y(), now.point.z()};
    MPI_Allreduce(MPI_IN_PLACE, place.data(), 4, MPI_DOUBLE, MPI_SUM, communicator_);  // but one are zero
    const double depth = deepest(c);
    if (depth > 0 && rank_ == 0) {
      spdlog::warn(
          "{}: the two overlap at the start, {:.3g} m3 around ({:.4g}, {:.4g}, {:.4g}), {:.3g} m deep, and will fly "
          "apart; move them so that they only touch",
          ready_.scene.contacts[c].name, place[0], place[1], place[2], place[3], depth);
    }
  }
}

void Simulation::report_silence() const {
  if (rank_ != 0 || !ready_.scene.radiation.visibility) {
    return;
  }
  for (const auto& obstacle : ready_.scene.obstacles) {
    const radiation::HalfSpace space{obstacle.at, obstacle.direction};
    for (const auto& listener : ready_.scene.listeners) {
      for (const auto& receiver : listener.receivers) {
        if (obstacle.shape == scene::Obstacle::Shape::half_space && space.holds(receiver.position)) {
          spdlog::warn("listener {}: it is inside the obstacle {} and hears nothing", receiver.channel, obstacle.name);
        }
      }
    }
  }
}

void Simulation::report_penetrations() {
  for (std::size_t c = 0; c < motion_.contacts().count(); ++c) {
    const double depth = deepest(c);
    if (rank_ == 0) {
      spdlog::info("contact {}: {}", ready_.scene.contacts[c].name,
                   depth > 0 ? fmt::format("deepest penetration {:.3g} m", depth) : "never touched");
      double thinnest = ready_.partners.skins[ready_.scene.contacts[c].body].thinnest;
      if (const auto& other = ready_.scene.contacts[c].other) {
        thinnest = std::min(thinnest, ready_.partners.skins[*other].thinnest);
      }
      if (depth > thinnest) {
        spdlog::warn(
            "contact {}: deeper than the outer layer of elements is thick, {:.3g} m; contact is weak there, and what "
            "is "
            "deeper still falls through. Give it more stiffness (now {:.3g} Pa/m), or hit less hard",
            ready_.scene.contacts[c].name, thinnest, ready_.partners.stiffness[c]);
      }
    }
  }
}

void Simulation::require_stability() {
  const source::Observation seen = source::observe(ready_, motion_, communicator_);
  const double moving = seen.energy() - seen.gravitational;
  const std::string& complaint = audio_path_.complaint();
  int wrong = complaint.empty() ? 0 : 1;
  if (rank_ == 0) {
    // Friction and damping only take from what the bodies were given; ten times as much, and more than round-off, is
    // invented.
    largest_given_ = std::max(largest_given_, energy_at_start_ + seen.work - seen.gravitational);
    double mass = 0.0;
    for (const double body : ready_.outset.masses) {
      mass += body;
    }
    const double allowed = 10 * largest_given_ + 1e-12 * mass;
    if (!(moving <= allowed)) {
      wrong = 1;
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, &wrong, 1, MPI_INT, MPI_MAX, communicator_);
  if (wrong != 0) {
    throw std::runtime_error(fmt::format(
        "the motion became unstable before {:.6g} s: rank {} sees an energy of {:.3g} J where start, loads and gravity "
        "gave {:.3g} J{}{}. "
        "The step is {:.3g} of the largest stable one for small strains: lower time.safety (now {}) or raise "
        "time.steps_per_sample above {}; if the body is strained by more than some 20 %, make the load smaller or the "
        "mesh "
        "finer there",
        static_cast<double>(sample_) / ready_.scene.audio.rate, rank_, moving, largest_given_,
        complaint.empty() ? "" : "; ", complaint, ready_.step() / ready_.outset.stable_step(), ready_.scene.time.safety,
        ready_.steps_per_sample));
  }
}

}  // namespace idiophone::app
