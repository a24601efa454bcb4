#include "stage_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "map_loudness.hpp"
#include "stage_checks.hpp"
#include "stage_ears.hpp"

namespace idiophone::engines {

namespace {

// Of the budget. The rest is for what rings.
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

}  // namespace

StageBodies::StageBodies(const std::vector<SharedMap>& maps, std::vector<Vector3> ears, const StageOptions& options,
                         double budget, std::shared_ptr<voices::SharedBudget> shared)
    : budget_(budget),
      rate_(options.rate),
      ears_(std::move(ears)),
      voices_(maps, audience_at(first_ears(ears_, maps)), options.rate,
              {.budget = budget_,
               .speed = options.speed * voices::usual_speed,
               .priority = proxies::Priority::audibility,
               .shared = std::move(shared),
               .most_commands = most_commands}),
      struck_(share_of_struck * budget_) {
  const std::vector<Vector3> first = first_ears(ears_, maps);
  for (std::size_t body = 0; body < maps.size(); ++body) {
    join(body, maps[body], first);
  }
}

/// @param ears  as the voices know them
void StageBodies::join(std::size_t body, const SharedMap& map, std::span<const Vector3> ears) {
  std::erase_if(loudness_, [](const auto& one) { return one.first.expired(); });
  if (!loudness_.contains(map)) {
    loudness_.emplace(map, loudness_of(*map));
  }
  bodies_.resize(std::max(bodies_.size(), body + 1));
  bodies_[body].emplace(*map, loudness_.find(map)->second, ears, rate_);
  struck_.join(body, voices_.cost_of_driven(body));
}

void StageBodies::add(std::size_t number, const SharedMap& map) {
  const std::vector<Vector3> ears = first_ears(ears_, {map});
  voices_.add(number, map, points_at(ears));
  join(number, map, ears);
}

void StageBodies::remove(std::size_t body) {
  voices_.remove(body);
  bodies_[body].reset();
}

void StageBodies::tune(std::size_t body, const score::Tuning& tuning, std::int64_t start) {
  bodies_[body]->tune(tuning, start);
  voices_.tune(body, tuning, start);
}

std::size_t StageBodies::most_strokes() const {
  double most = 1e-9;  // that a body costs
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    most = std::max(most, voices_.cost_of_driven(body));
  }
  return static_cast<std::size_t>(std::clamp(share_of_strokes * budget_ / (2.0 * most), 1.0, 1e9));
}

/// Forces on bodies for which there is room, in the coordinates of the bodies: [bodies].
std::vector<drivers::Excitation> StageBodies::chosen(std::span<const ContactForce> forces, std::int64_t start) {
  std::vector<drivers::Excitation> excitations(bodies_.size());
  std::vector<double> loudness(bodies_.size(), -1.0);
  for (const ContactForce& force : forces) {
    for (std::size_t side = 0; side < 2; ++side) {
      const auto body = static_cast<std::size_t>(force.bodies[side]);
      if (force.bodies[side] != ContactEvent::nobody && has(body)) {
        resonators::PointForce& added =
            excitations[body].forces.emplace_back(in_body(bodies_[body]->to_body(), force.force));
        added.direction *= side == 0 ? 1.0 : -1.0;
        loudness[body] = std::max(loudness[body], bodies_[body]->loudness(force.impulse, ears_));
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
    if (has(body)) {
      send(body, excitations[body], start, length);
    }
  }
}

void StageBodies::send(std::size_t body, const drivers::Excitation& excitation, std::int64_t start,
                       std::int64_t length) {
  const bool is_struck = !excitation.forces.empty();
  const MovingBody::Part part = is_struck                ? MovingBody::Part::struck
                                : voices_.is_heard(body) ? MovingBody::Part::heard
                                                         : MovingBody::Part::unheard;
  if (const auto place = bodies_[body]->follow(ears_, start, length, part)) {
    voices_.hear_at(body, *place);
  }
  for (const resonators::PointForce& force : excitation.forces) {
    const std::int64_t end = force.start + static_cast<std::int64_t>(force.force.size());
    bodies_[body]->sound_until(end);
    struck_.act(body, end);
  }
  if (is_struck) {
    voices_.excite(body, excitation, 0);
  }
}

}  // namespace idiophone::engines
