#include "stage_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "stage_checks.hpp"

namespace idiophone::engines {

namespace {

constexpr double longest_pause = 0.25;  // s, of the audio thread, after which contacts are left out
// Of the budget. The rest is for blows between two choices, and for caches that many bodies share.
constexpr double share_to_spend = 0.85;
constexpr std::size_t most_claims = 4096;  // of bodies with maps, and of proxies, to a budget

std::shared_ptr<voices::SharedBudget> shared_budget(double budget) {
  return std::isfinite(budget) ? std::make_shared<voices::SharedBudget>(most_claims, most_claims) : nullptr;
}

std::vector<double> masses_of(const std::vector<SharedMap>& bodies) {
  std::vector<double> masses;
  std::ranges::transform(bodies, std::back_inserter(masses), [](const SharedMap& map) { return map->mass; });
  return masses;
}

}  // namespace

EngineStage::Parts::Parts(StageOptions stage_options, const std::vector<SharedMap>& maps, std::vector<Surface> surfaces)
    : options(checked(std::move(stage_options))),
      channels(options.ears.size()),
      surface_count(surfaces.size()),
      shared(shared_budget(options.budget)),
      bodies(checked(maps), checked(options.ears), options, share_to_spend * options.budget, shared),
      proxies(checked(options.ears), options, share_to_spend * options.budget, shared),
      sounds(checked(std::move(surfaces)), masses_of(maps), options.rate,
             std::min(options.most_strokes, bodies.most_strokes()), options.seed) {}

std::size_t EngineStage::Parts::free_number() const {
  std::size_t number = 0;
  while (!bodies.is_free(number) || proxies.has(number)) {
    ++number;
  }
  return number;
}

void EngineStage::Parts::require_body(std::size_t body) const {
  const bool is_there = bodies.has(body) || proxies.has(body);
  if (!is_there || std::ranges::find(leaving, body) != leaving.end()) {
    throw std::runtime_error(fmt::format("there is no body {}", body));
  }
}

bool EngineStage::Parts::keep_time(double duration) {
  const std::int64_t played = rendered.load(std::memory_order_acquire);
  pause = played == last_played ? pause + duration : 0.0;
  last_played = played;
  const double earliest = static_cast<double>(played) + options.latency * options.rate;
  const bool is_ahead = clock > earliest + most_ahead * options.rate;
  clock = std::max(clock, earliest);
  start = std::llround(clock);
  clock += is_ahead ? 0.0 : duration * options.rate;
  return pause <= longest_pause;
}

void EngineStage::Parts::tune() {
  for (const auto& [body, tuning] : std::exchange(tunings, {})) {
    proxies.has(body) ? proxies.tune(body, tuning, start) : bodies.tune(body, tuning, start);
  }
}

void EngineStage::Parts::let_leave() {
  for (const std::size_t body : std::exchange(leaving, {})) {
    sounds.leave(body);
    proxies.has(body) ? proxies.remove(body) : bodies.remove(body);
  }
}

void EngineStage::Parts::note_choices() {
  for (const voices::MapChoice& choice : bodies.voices().take_choices()) {
    last_report.sounding = choice.sounding;
    last_report.modes = choice.modes;
    last_report.heard = choice.heard;
    last_report.cost = choice.cost;
    last_report.loss = choice.left_out;
  }
}

}  // namespace idiophone::engines
