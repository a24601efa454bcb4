#include "idiophone/solids/motion/deforming_cause.hpp"

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

void refuse_modal(const scene::Solids& solids, std::span<const std::size_t> bodies, const DeformingCause& cause) {
  const auto is_modal = [&](std::size_t body) { return solids.bodies[body].modal.has_value(); };
  if (const auto modal = std::ranges::find_if(bodies, is_modal); bodies.size() > 1 && modal != bodies.end()) {
    throw deck::DeckError(cause.where,
                          fmt::format("{} deforms bodies that joints tie together, and '{}' is modal, which can't be "
                                      "deformed by a joint at rest: use model: {{type: finite_elements}}",
                                      cause.what, solids.bodies[*modal].name));
  }
}

}  // namespace idiophone::motion
