// Who may sound, and in which detail.

#include <algorithm>

#include "engine_state.hpp"

namespace idiophone::proxies {

std::vector<Voice*> Engine::State::active() {
  std::vector<Voice*> active;
  for (Voice& voice : voices) {
    if (voice.is_active()) {
      active.push_back(&voice);
    }
  }
  std::ranges::stable_sort(active, {}, [](const Voice* voice) { return voice->priority(); });
  return active;
}

double Engine::State::budget_for(double priority) const {
  return options.others ? options.budget - options.others(priority) : options.budget;
}

bool Engine::State::make_room(double priority, double cost, std::int64_t sample) {
  const std::vector<Voice*> others = active();
  double total = cost;
  for (const Voice* voice : others) {
    total += voice->detail().cost;
  }
  std::size_t stopped = 0;
  const double budget = budget_for(priority);
  while (others.size() - stopped >= options.most_active || total > budget) {
    if (stopped == others.size() || others[stopped]->priority() >= priority) {
      return false;
    }
    total -= others[stopped]->detail().cost;
    ++stopped;
  }
  for (std::size_t i = 0; i < stopped; ++i) {
    others[i]->fade();
    note(*others[i], Choice::Kind::stop, sample);
  }
  return true;
}

std::size_t Engine::State::choose_detail(const Voice& voice, double priority) {
  double left = budget_for(priority);
  bool is_first = true;
  for (const Voice* other : active()) {
    left -= other->detail().cost;
    is_first &= other->priority() < priority;
  }
  const double share = options.budget / static_cast<double>(options.most_active);
  const double allowed = is_first ? left : std::min(left, share);
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < voice.details().size(); ++i) {
    if (voice.may_have(voice.details()[i])) {
      chosen = i;
      if (voice.details()[i].cost <= allowed) {
        break;
      }
    }
  }
  return chosen;
}

void Engine::State::keep_limits() {
  std::vector<Voice*> others = active();
  double total = 0.0;
  for (const Voice* voice : others) {
    total += voice->detail().cost;
  }
  std::size_t count = others.size();
  for (Voice* voice : others) {
    if (count <= options.most_active && total <= budget_for(voice->priority())) {
      return;
    }
    voice->fade();
    note(*voice, Choice::Kind::stop, now);
    total -= voice->detail().cost;
    --count;
  }
}

void Engine::keep_limits() {
  state_->keep_limits();
}

std::vector<Share> Engine::shares() const {
  std::vector<Share> shares;
  for (const Voice* voice : state_->active()) {
    shares.push_back({.priority = voice->priority(), .cost = voice->detail().cost});
  }
  return shares;
}

}  // namespace idiophone::proxies
