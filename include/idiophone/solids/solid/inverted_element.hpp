#pragma once
// The error of an element that is turned inside out.

#include <fmt/format.h>

#include <stdexcept>

#include "idiophone/foundation/types.hpp"

namespace idiophone::solid {

/// An element whose Jacobian is not positive at one of its quadrature points.
class InvertedElement : public std::runtime_error {
 public:
  /// @param jacobian  its determinant, m3
  InvertedElement(Index element, double jacobian)
      : std::runtime_error(
            fmt::format("element {} is inverted or degenerate: its Jacobian is {:.3g} m3 at a quadrature point",
                        element, jacobian)) {}
};

}  // namespace idiophone::solid
