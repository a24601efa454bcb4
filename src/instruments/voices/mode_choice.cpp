#include "mode_choice.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace idiophone::voices {

namespace {

using resonators::modes_in_group;

// Processor time for an audio sample on the machine of usual_speed, s; benchmark_stage and benchmark_resonators measure
// it.
constexpr double ringing_mode = 7e-11, ringing_mode_of_output = 8e-11;
constexpr double driven_mode = 5.5e-10;
constexpr double body_of_output = 3e-8;
constexpr double multiply_add = 5e-11;

constexpr double negligible = 1e-10;  // of the power of the loudest mode

}  // namespace

ModeChoice::ModeChoice(const MapDetail& detail, std::span<const std::unique_ptr<MapBody>> bodies, std::size_t receivers,
                       int rate)
    : detail_(detail), is_limited_(std::isfinite(detail.budget)) {
  const double scale = rate * usual_speed / detail.speed, outputs = static_cast<double>(receivers);
  body_cost_ = scale * outputs * body_of_output;
  group_cost_ = scale * modes_in_group * (ringing_mode + outputs * ringing_mode_of_output);
  driven_group_cost_ = scale * modes_in_group * driven_mode;
  stretching_cost_ = scale * multiply_add;
  std::size_t groups = 0;
  for (const auto& body : bodies) {
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

MapChoice ModeChoice::choose(std::span<const std::unique_ptr<MapBody>> bodies, std::int64_t sample) {
  measure(bodies);
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

void ModeChoice::measure(std::span<const std::unique_ptr<MapBody>> bodies) {
  std::ranges::fill(heard_, 0);
  candidates_.clear();
  threshold_.clear();
  cost_ = 0.0;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    measure(bodies[body]->player(), body);
  }
}

void ModeChoice::measure(Player& player, std::size_t body) {
  Part& part = parts_[body];
  part.is_driven = player.is_driven() || player.sound().stretches();
  part.sounds = part.is_driven || player.sound().sounds();
  part.cost = 0.0;
  if (!part.sounds) {
    return;
  }
  part.priority = player.priority(detail_.priority);
  player.measure(std::span(power_).subspan(part.first * modes_in_group, part.groups * modes_in_group));
  if (part.is_driven) {
    std::fill_n(heard_.begin() + static_cast<std::ptrdiff_t>(part.first), part.groups, 1);
    part.cost = cost_of_driven(body) + static_cast<double>(player.sound().stretching_operations()) * stretching_cost_;
    cost_ += part.cost;
    return;
  }
  for (std::size_t group = part.first; group < part.first + part.groups; ++group) {
    const double loudest = std::ranges::max(powers(group));
    if (loudest > 0.0) {
      candidates_.push_back({.body = body, .group = group, .loudest = loudest, .priority = part.priority});
    }
  }
}

/// The loudest first: what is not hidden by louder modes hides others.
void ModeChoice::find_audibility(std::span<const std::unique_ptr<MapBody>> bodies) {
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
    const bool is_audible = !detail_.masking || candidate.audibility > 1.0;
    return std::tuple(is_audible, by_priority ? candidate.priority : 0.0, candidate.audibility);
  };
  std::ranges::sort(candidates_, std::ranges::greater(), rank);
  for (const Candidate& candidate : candidates_) {
    Part& part = parts_[candidate.body];
    const double more = group_cost_ + (part.cost > 0.0 ? 0.0 : body_cost_);
    const double others = detail_.shared ? detail_.shared->proxies.above(candidate.priority) : 0.0;
    if (cost_ + others + more <= detail_.budget) {
      heard_[candidate.group] = 1;
      part.cost += more;
      cost_ += more;
    }
  }
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

MapChoice ModeChoice::apply(std::span<const std::unique_ptr<MapBody>> bodies) {
  MapChoice choice;
  double left_out = 0.0;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const Part& part = parts_[body];
    bodies[body]->player().set_heard(!part.sounds || part.cost > 0.0);
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
