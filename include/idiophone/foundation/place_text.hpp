#pragma once
// How messages write places.

#include <fmt/format.h>

#include <string>

#include "idiophone/foundation/types.hpp"

namespace idiophone {

/// A place, m, as a deck writes it: "[0.1, 0, 0.05]".
[[nodiscard]] inline std::string to_text(const Vector3& place) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", place.x(), place.y(), place.z());
}

}  // namespace idiophone
