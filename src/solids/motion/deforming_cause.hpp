#pragma once
// What deforms bodies at rest: a pluck, or a prestress that does not balance by itself.

#include <optional>
#include <span>
#include <string>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/scene/solids.hpp"

namespace idiophone::motion {

/// Why and where bodies have an equilibrium of their own, for messages.
struct DeformingCause {
  std::string what;  ///< "pluck 'finger'"
  deck::Location where;
};

/// The first cause that deforms some bodies; none: they rest undeformed.
/// @param bodies    that joints tie together, or one: indices into Solids::bodies
/// @param deformed  by deformed_by_prestress(), [Solids::bodies]
[[nodiscard]] std::optional<DeformingCause> deforming_cause(const scene::Solids& solids,
                                                            std::span<const std::size_t> bodies,
                                                            std::span<const char> deformed);

}  // namespace idiophone::motion
