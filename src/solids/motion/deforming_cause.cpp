#include "deforming_cause.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace idiophone::motion {

std::optional<DeformingCause> deforming_cause(const scene::Solids& solids, std::span<const std::size_t> bodies,
                                              std::span<const char> deformed) {
  for (const std::size_t body : bodies) {
    const auto pluck = std::ranges::find(solids.plucks, body, &scene::Pluck::body);
    if (pluck != solids.plucks.end()) {
      return DeformingCause{fmt::format("pluck '{}'", pluck->name), pluck->place.where};
    }
    if (deformed[body] != 0) {
      return DeformingCause{fmt::format("the prestress of body '{}'", solids.bodies[body].name),
                            solids.bodies[body].prestress->where};
    }
  }
  return std::nullopt;
}

}  // namespace idiophone::motion
