#pragma once
// What a soundtrack is made of.

#include <limits>
#include <vector>

#include "idiophone/timbre/language/timbre_tree.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"

namespace idiophone::timbre {

/// One start of a sound.
struct Soundtrack::Instance {
  std::int64_t start = 0;  ///< audio sample
  std::int64_t stop = std::numeric_limits<std::int64_t>::max();
  Bindings bindings;
};

/// A sound: a point that emits all of its instances.
struct Soundtrack::Source {
  const Tree* tree = nullptr;
  double gain = 1.0;
  Path path;
  std::optional<Aim> aim;
  std::vector<Instance> instances;
};

}  // namespace idiophone::timbre
