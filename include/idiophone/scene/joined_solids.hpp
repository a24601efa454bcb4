#pragma once
// Bodies that joints tie together, as solids.

#include <vector>

#include "idiophone/scene/solids.hpp"

namespace idiophone::scene {

/// Which bodies joints tie together, directly or not: indices into Solids::bodies, ascending, by the first of them. A
/// body without joints is by itself.
[[nodiscard]] std::vector<std::vector<std::size_t>> assemblies(const Solids& solids);

/// Whether a body has large amplitudes and a joint. A deck gives them to all bodies of an assembly, or to none. Such
/// bodies have common modes, of which their joints are a part.
[[nodiscard]] bool has_common_modes(const Solids& solids, std::size_t body);

/// A body with all others that joints tie to it, directly or not, and these joints. The body comes first, and the
/// others in the order of the deck.
struct Assembly {
  Assembly(const Solids& all, std::size_t body);

  /// Without loads, contacts and gauges. A view: this assembly, and what the solids it was made of refer to, have to
  /// outlive it.
  [[nodiscard]] Solids solids() const;

  std::vector<Body> bodies;
  std::vector<Joint> joints;  ///< between these bodies
  Solids rest;                ///< the body alone: materials, obstacles, gravity and air are those of all
};

}  // namespace idiophone::scene
