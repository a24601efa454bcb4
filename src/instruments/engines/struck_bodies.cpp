#include "struck_bodies.hpp"

#include <algorithm>

#include "idiophone/instruments/voices/map_detail.hpp"

namespace idiophone::engines {

namespace {

constexpr std::int64_t choice_and_fade = 2 * voices::MapChoice::interval;

}  // namespace

void StruckBodies::join(std::size_t body, double cost) {
  bodies_.resize(std::max(bodies_.size(), body + 1));
  bodies_[body] = {.cost = cost};
}

std::vector<bool> StruckBodies::choose(std::span<const double> loudness, std::int64_t start) {
  std::vector<std::size_t> loudest;
  for (std::size_t body = 0; body < loudness.size(); ++body) {
    if (loudness[body] >= 0.0) {
      loudest.push_back(body);
    }
  }
  std::ranges::stable_sort(loudest, std::ranges::greater(), [&](std::size_t body) { return loudness[body]; });
  std::vector<bool> chosen(loudness.size());
  for (const std::size_t body : loudest) {
    Body& one = bodies_[body];
    const double others = cost_of_others(body, loudness[body], start);
    if (others == 0.0 || others + one.cost <= budget_) {
      chosen[body] = true;
      one.loudness = std::max(one.end > start ? one.loudness : 0.0, loudness[body]);
      one.end = std::max(one.end, start + choice_and_fade);
    }
  }
  return chosen;
}

void StruckBodies::act(std::size_t body, std::int64_t end) {
  bodies_[body].end = std::max(bodies_[body].end, end + choice_and_fade);
}

double StruckBodies::cost_of_others(std::size_t body, double loudness, std::int64_t sample) const {
  double sum = 0.0;
  for (std::size_t other = 0; other < bodies_.size(); ++other) {
    const Body& one = bodies_[other];
    sum += other != body && one.end > sample && one.loudness >= loudness ? one.cost : 0.0;
  }
  return sum;
}

}  // namespace idiophone::engines
