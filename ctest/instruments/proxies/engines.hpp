#pragma once
// Bodies and forces for tests of the engine.

#include <memory>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "idiophone/instruments/proxies/engine.hpp"

namespace idiophone::proxies {

inline constexpr int engine_rate = 44100;

inline BodyOptions cube(const std::string& name, double distance = 1.0) {
  static const std::vector<std::shared_ptr<const Lattice>> levels = {rubber_cube(4), rubber_cube(2)};
  return {.name = name, .levels = levels, .listener = {0.05, 0.05, 0.05 + distance}};
}

inline Force tap(std::size_t body, std::int64_t start) {
  return impact(body, start, {0.03, 0.06, 0.1}, {0.0, 0.0, -1e-3}, 5e-4, engine_rate);
}

inline std::vector<Choice::Kind> kinds(Engine& engine) {
  std::vector<Choice::Kind> kinds;
  for (const Choice& choice : engine.take_choices()) {
    kinds.push_back(choice.kind);
  }
  return kinds;
}

}  // namespace idiophone::proxies
