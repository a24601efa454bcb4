#include "stage_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "map_loudness.hpp"
#include "stage_checks.hpp"

namespace idiophone::engines {

namespace {

// Shares of the budget. The rest is for what rings.
constexpr double share_of_struck = 0.5;
constexpr double share_of_strokes = 0.25;

constexpr std::size_t most_commands = 256;  // to a body; more wait for the audio thread

/// Ears before the first step, when all bodies are where their maps are: no farther away than can be played.
std::vector<Vector3> first_ears(std::vector<Vector3> ears, const std::vector<SharedMap>& bodies) {
  double farthest = largest_number;
  for (const SharedMap& map : bodies) {
    farthest = std::min(farthest, 0.9 * (voices::longest_way * map->air_speed - map->centre.norm()));
  }
  for (Vector3& ear : ears) {
    ear *= std::min(1.0, farthest / std::max(farthest, ear.norm()));
  }
  return ears;
}

voices::Audience audience_at(const std::vector<Vector3>& ears) {
  scene::Listener listener;
  for (const Vector3& ear : ears) {
    listener.receivers.push_back({.channel = "ear", .position = ear});
  }
  return voices::Audience(std::move(listener));
}

}  // namespace

StageBodies::StageBodies(const std::vector<SharedMap>& maps, std::vector<Vector3> ears, const StageOptions& options)
    : budget_(options.budget),
      ears_(std::move(ears)),
      voices_(maps, audience_at(first_ears(ears_, maps)), options.rate,
              {.budget = options.budget, .priority = proxies::Priority::audibility, .most_commands = most_commands}),
      struck_(share_of_struck * budget_, costs()) {
  const std::vector<Vector3> first = first_ears(ears_, maps);
  std::map<SharedMap, double> loudness;
  for (const SharedMap& map : maps) {
    if (!loudness.contains(map)) {
      loudness[map] = loudness_of(*map);
    }
    bodies_.emplace_back(*map, loudness[map], first, options.rate);
  }
}

std::vector<double> StageBodies::costs() const {
  std::vector<double> costs;
  for (std::size_t body = 0; body < voices_.bodies().size(); ++body) {
    costs.push_back(voices_.cost_of_driven(body));
  }
  return costs;
}

std::size_t StageBodies::most_strokes() const {
  const std::vector<double> all = costs();
  const double strokes = share_of_strokes * budget_ / (2.0 * std::ranges::max(all));
  return static_cast<std::size_t>(std::clamp(strokes, 1.0, 1e9));
}

/// Forces on bodies for which there is room, in the coordinates of the bodies: [bodies].
std::vector<drivers::Excitation> StageBodies::chosen(std::span<const ContactForce> forces, std::int64_t start) {
  std::vector<drivers::Excitation> excitations(bodies_.size());
  std::vector<double> loudness(bodies_.size(), -1.0);
  for (const ContactForce& force : forces) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (force.bodies[side] != ContactEvent::nobody) {
        const auto body = static_cast<std::size_t>(force.bodies[side]);
        resonators::PointForce& added = excitations[body].forces.emplace_back(bodies_[body].in_body(force.force));
        added.direction *= side == 0 ? 1.0 : -1.0;
        loudness[body] = std::max(loudness[body], bodies_[body].loudness(force.impulse, ears_));
      }
    }
  }
  const std::vector<bool> has_room = struck_.choose(loudness, start);
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    if (!has_room[body]) {
      left_out_ += std::exchange(excitations[body].forces, {}).size();
    }
  }
  return excitations;
}

void StageBodies::send(std::span<const ContactForce> forces, std::int64_t start, std::int64_t length) {
  const std::vector<drivers::Excitation> excitations = chosen(forces, start);
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    send(body, excitations[body], start, length);
  }
  if (std::isfinite(budget_)) {
    voices_.set_budget(std::max(0.0, budget_ - struck_.cost_after_forces(start)), start);
  }
}

void StageBodies::send(std::size_t body, const drivers::Excitation& excitation, std::int64_t start,
                       std::int64_t length) {
  const bool is_struck = !excitation.forces.empty();
  const MovingBody::Part part = is_struck                ? MovingBody::Part::struck
                                : voices_.is_heard(body) ? MovingBody::Part::heard
                                                         : MovingBody::Part::unheard;
  if (const auto place = bodies_[body].follow(ears_, start, length, part)) {
    voices_.hear_at(body, *place);
  }
  for (const resonators::PointForce& force : excitation.forces) {
    const std::int64_t end = force.start + static_cast<std::int64_t>(force.force.size());
    bodies_[body].sound_until(end);
    struck_.act(body, end);
  }
  if (is_struck) {
    voices_.excite(body, excitation, 0);
  }
}

}  // namespace idiophone::engines
