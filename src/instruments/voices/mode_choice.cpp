#include "mode_choice.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace idiophone::voices {

namespace {

using resonators::modes_in_group;

constexpr double negligible = 1e-10;   // of the power of the loudest mode
constexpr double reserve_stays = 0.5;  // of the reserve, from choice to choice
constexpr double stays = 4.0;          // by which another mode has to be more audible than one that is heard

}  // namespace

ModeChoice::ModeChoice(const MapDetail& detail, std::span<MapBody* const> bodies, std::size_t receivers, int rate)
    : detail_(detail), is_limited_(std::isfinite(detail.budget)), costs_(rate, detail.speed, receivers) {
  std::size_t groups = 0;
  for (const MapBody* body : bodies) {
    parts_.push_back({.first = groups, .groups = body->player().sound().groups()});
    groups += parts_.back().groups;
  }
  power_.resize(groups * modes_in_group);
  heard_.resize(groups);
  candidates_.reserve(groups);
  claims_.reserve(parts_.size());
}

void ModeChoice::set_budget(double budget) {
  detail_.budget = budget;
  is_limited_ |= std::isfinite(budget);
}

void ModeChoice::go_on_from(const ModeChoice& other) {
  detail_.budget = other.detail_.budget;
  is_limited_ |= other.is_limited_;
  reserve_ = other.reserve_;
}

MapChoice ModeChoice::choose(std::span<MapBody* const> bodies, std::int64_t sample) {
  measure(bodies, sample);
  find_audibility(bodies);
  spend();
  claim();
  MapChoice choice = apply(bodies);
  choice.sample = sample;
  choice.cost = cost_;
  return choice;
}

std::span<const double> ModeChoice::powers(std::size_t group) const {
  return std::span(power_).subspan(group * modes_in_group, modes_in_group);
}

void ModeChoice::measure(std::span<MapBody* const> bodies, std::int64_t sample) {
  std::ranges::fill(heard_, 0);
  candidates_.clear();
  threshold_.clear();
  cost_ = 0.0;
  double struck = 0.0;  // cost of bodies of which nothing was heard at the last choice
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const bool was_paid = bodies[body]->player().is_paid();
    measure(bodies[body]->player(), body, sample);
    struck += parts_[body].is_driven && !was_paid ? parts_[body].cost : 0.0;
  }
  reserve_ = std::max(struck, reserve_stays * reserve_);
}

void ModeChoice::measure(Player& player, std::size_t body, std::int64_t sample) {
  Part& part = parts_[body];
  const MappedSound& sound = player.sound();
  part.is_driven = player.is_driven() || sound.stretches();
  part.sounds = part.is_driven || sound.sounds();
  part.moves = sound.is_changing(sample);
  part.cost = 0.0;
  if (!part.sounds) {
    return;
  }
  part.priority = player.priority(detail_.priority);
  player.measure(std::span(power_).subspan(part.first * modes_in_group, part.groups * modes_in_group));
  cost_ += costs_.of_choice(part.groups);
  if (part.is_driven) {
    std::fill_n(heard_.begin() + static_cast<std::ptrdiff_t>(part.first), part.groups, 1);
    part.cost = costs_.of_driven(part.groups, part.moves) + costs_.of_stretching(sound.stretching_operations());
    cost_ += part.cost;
    return;
  }
  for (std::size_t group = 0; group < part.groups; ++group) {
    const double loudest = std::ranges::max(powers(part.first + group));
    if (loudest > 0.0) {
      candidates_.push_back({.body = body,
                             .group = part.first + group,
                             .loudest = loudest,
                             .priority = part.priority,
                             .was_heard = sound.hears(group)});
    }
  }
}

/// The loudest first: what is not hidden by louder modes hides others.
void ModeChoice::find_audibility(std::span<MapBody* const> bodies) {
  std::ranges::sort(candidates_, std::ranges::greater(), &Candidate::loudest);
  for (Candidate& candidate : candidates_) {
    if (!detail_.masking) {
      candidate.audibility = candidate.loudest;
      continue;
    }
    const MappedSound& sound = bodies[candidate.body]->player().sound();
    const std::size_t first_mode = (candidate.group - parts_[candidate.body].first) * modes_in_group;
    const std::span<const double> power = powers(candidate.group);
    for (std::size_t mode = 0; mode < power.size(); ++mode) {
      if (power[mode] < negligible * candidates_.front().loudest) {
        continue;
      }
      const std::size_t bin = sound.bin_of(first_mode + mode);
      const double audibility = power[mode] / std::max(threshold_.at(bin), negligible * power[mode]);
      candidate.audibility = std::max(candidate.audibility, audibility);
      if (audibility > 1.0) {
        threshold_.add(bin, power[mode]);
      }
    }
  }
}

void ModeChoice::spend() {
  const bool by_priority = detail_.priority != proxies::Priority::audibility;
  const auto rank = [&](const Candidate& candidate) {
    const double audibility = candidate.audibility * (candidate.was_heard ? stays : 1.0);
    const bool is_audible = !detail_.masking || audibility > 1.0;
    return std::tuple(is_audible, by_priority ? candidate.priority : 0.0, audibility);
  };
  std::ranges::sort(candidates_, std::ranges::greater(), rank);
  const double before = cost_;
  for (const Candidate& candidate : candidates_) {
    heard_[candidate.group] = has_room_for(candidate) ? 1 : 0;
    pay(candidate, heard_[candidate.group] != 0);
  }
  // What was heard costs as much while it fades. New groups have to wait until the rest suffices.
  cost_ = before;
  for (Part& part : parts_) {
    part.cost = part.is_driven ? part.cost : 0.0;
  }
  for (const Candidate& candidate : candidates_) {
    pay(candidate, candidate.was_heard);
  }
  for (const Candidate& candidate : candidates_) {
    if (!candidate.was_heard && heard_[candidate.group] != 0) {
      heard_[candidate.group] = has_room_for(candidate) ? 1 : 0;
      pay(candidate, heard_[candidate.group] != 0);
    }
  }
}

double ModeChoice::cost_of(const Candidate& candidate) const {
  const Part& part = parts_[candidate.body];
  return costs_.of_group(part.moves) + (part.cost > 0.0 ? 0.0 : costs_.of_body(part.moves));
}

bool ModeChoice::has_room_for(const Candidate& candidate) const {
  const double others = detail_.shared ? detail_.shared->proxies.above(candidate.priority) : 0.0;
  return cost_ + reserve_ + others + cost_of(candidate) <= detail_.budget;
}

void ModeChoice::pay(const Candidate& candidate, bool is_heard) {
  const double cost = is_heard ? cost_of(candidate) : 0.0;
  parts_[candidate.body].cost += cost;
  cost_ += cost;
}

void ModeChoice::claim() {
  claims_.clear();
  for (const Part& part : parts_) {
    if (part.cost > 0.0) {
      claims_.push_back({.priority = part.priority, .cost = part.cost});
    }
  }
  if (detail_.shared) {
    detail_.shared->maps.make(claims_);
  }
}

MapChoice ModeChoice::apply(std::span<MapBody* const> bodies) {
  MapChoice choice;
  double left_out = 0.0;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const Part& part = parts_[body];
    bodies[body]->player().set_heard(!part.sounds || part.cost > 0.0);
    bodies[body]->player().set_paid(part.cost > 0.0);
    if (!part.sounds) {
      continue;
    }
    ++choice.sounding;
    choice.silent += part.cost > 0.0 ? 0 : 1;
    for (std::size_t group = part.first; group < part.first + part.groups; ++group) {
      for (const double power : powers(group)) {
        const bool is_heard = heard_[group] != 0;
        choice.power += power;
        left_out += is_heard ? 0.0 : power;
        choice.modes += power > 0.0 ? 1 : 0;
        choice.heard += power > 0.0 && is_heard ? 1 : 0;
      }
    }
    if (!part.is_driven) {
      bodies[body]->player().choose(std::span(heard_).subspan(part.first, part.groups), MapChoice::interval);
    }
  }
  choice.left_out = choice.power > 0.0 ? left_out / choice.power : 0.0;
  return choice;
}

}  // namespace idiophone::voices
