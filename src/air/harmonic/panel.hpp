#pragma once
// A flat triangle of a boundary, with a linear shape function for each corner, and the potentials of layers on it.

#include <array>
#include <complex>
#include <span>

#include "idiophone/air/radiation/floor.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::harmonic {

/// A flat triangle.
struct Panel {
  std::array<Vector3, 3> corners;    ///< m
  std::array<Vector3, 3> gradients;  ///< of the three shape functions, 1/m
  Vector3 normal = Vector3::Zero();  ///< unit vector into the air
  Vector3 centre = Vector3::Zero();  ///< m
  double area = 0.0;                 ///< m2
  double radius = 0.0;               ///< largest distance of a corner from the centre, m

  Panel() = default;
  /// @param places  in the order that makes the normal point into the air
  explicit Panel(std::array<Vector3, 3> places);

  /// The point with these shape functions.
  [[nodiscard]] Vector3 at(const Vector3& shape) const {
    return shape[0] * corners[0] + shape[1] * corners[1] + shape[2] * corners[2];
  }
};

/// The mirror image, with its normal into the mirrored air.
[[nodiscard]] Panel mirrored(const Panel& panel, const radiation::ReflectingPlane& plane);

/// A point of a quadrature rule on triangles.
struct TrianglePoint {
  Vector3 shape = Vector3::Zero();  ///< the three shape functions there
  double weight = 0.0;              ///< the weights add up to 1
};

/// Quadrature rules, exact for polynomials of degree 2 (3 points) and 5 (7 points; Radon 1948).
[[nodiscard]] std::span<const TrianglePoint> triangle_rule_2();
[[nodiscard]] std::span<const TrianglePoint> triangle_rule_5();

/// Integrals over a panel of its shape functions N_b with G = exp(-i k r)/(4 pi r), at a point.
struct LayerPotentials {
  std::array<std::complex<double>, 3> single_layer = {};  ///< of N_b G
  std::array<std::complex<double>, 3> double_layer = {};  ///< of N_b dG/dn, n the panel's normal
};

/// By a quadrature rule, for points that are far away.
[[nodiscard]] LayerPotentials quadrature_potentials(const Panel& panel, const Vector3& point, double wave_number,
                                                    std::span<const TrianglePoint> rule);

/// For points as near as one likes, also on the panel: 1/r in closed form (Wilton et al. 1984, Graglia 1993), the
/// rest, which has no singularity, by quadrature. On the panel the double layer has its principal value, 0.
[[nodiscard]] LayerPotentials near_potentials(const Panel& panel, const Vector3& point, double wave_number);

/// Whichever of them suits the distance.
[[nodiscard]] LayerPotentials layer_potentials(const Panel& panel, const Vector3& point, double wave_number);

}  // namespace idiophone::harmonic
