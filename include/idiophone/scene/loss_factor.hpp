#pragma once
// Internal friction of a material: how much, at which frequency, and along which of its axes.

#include <array>
#include <optional>
#include <vector>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::scene {

/// Loss factors of the moduli of an orthotropic material: E_i (1 + i young_i) and G_ij (1 + i shear_ij), tan(phi).
struct DirectionalLoss {
  Vector3 young = Vector3::Zero();  ///< of E_x, E_y, E_z
  Vector3 shear = Vector3::Zero();  ///< of G_xy, G_yz, G_xz
};

/// A mode of frequency f in the band loses the fraction 2 pi at(f) of its energy per period; its amplitude decays as
/// exp(-pi f at(f) t).
struct LossFactor {
  /// A measured value.
  struct Point {
    double frequency = 0.0;  ///< Hz
    double value = 0.0;      ///< tan(phi), above 0
  };

  double value = 0.0;                            ///< tan(phi), above 0; the largest of all frequencies and directions
  std::array<double, 2> band = {20.0, 20000.0};  ///< Hz, ascending
  std::optional<int> mechanisms;                 ///< number of relaxation mechanisms; as few as possible if omitted
  deck::Location where;
  std::vector<Point> curve = {};  ///< from one end of the band to the other, ascending; none: the same at all of them
  std::optional<DirectionalLoss> directions = {};  ///< none: the same in all of them

  /// tan(phi), of the direction with most: a straight line between the points of the curve, with both axes logarithmic.
  /// @param frequency  Hz; beyond the ends of the curve, their values hold
  [[nodiscard]] double at(double frequency) const;
};

}  // namespace idiophone::scene
