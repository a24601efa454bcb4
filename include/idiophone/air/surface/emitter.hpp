#pragma once
// From a surface's motion at the audio rate to its emission: the end of O'Brien 2001, section 3.2.

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "idiophone/air/surface/emission.hpp"
#include "idiophone/air/surface/surface_motion.hpp"
#include "idiophone/air/surface/surface_pressure.hpp"
#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::surface {

/// One rank's triangles as the air sees them. Fed by a Surface, or by a motion that was recorded. A triangle's results
/// depend on its own three vertices only, to the bit.
class Emitter {
 public:
  /// @param triangles  three vertices each, in the order that makes the normal of eq. 4 point outwards
  /// @param dc_loss    alpha of eq. 9, in [0, 1); 0 keeps constant pressures
  /// @param surface_pressure  of these triangles
  /// @param fade_step  1/audio samples of a fade, for triangles that change over time: one that becomes a point fades
  ///                   out, with the area and the normal that it had, and one that was a point fades in; 0: no fades
  /// @throws std::invalid_argument when dc_loss is out of its range
  Emitter(const std::vector<std::array<Index, 3>>& triangles, double dc_loss, SurfacePressure surface_pressure = {},
          double fade_step = 0.0);

  [[nodiscard]] std::size_t triangles() const { return triangles_; }

  /// Begins after a motion that is taken to have lasted for ever.
  void start(const SurfaceMotion& motion);

  /// Takes the motion of the next audio sample.
  /// @param emission  [padded(triangles)]; triangles added as padding have no area, normal or pressure.
  ///                  Pressure is eq. 9, the geometry is that of the low-passed positions (footnote 2).
  void emit(const SurfaceMotion& motion, Emission& emission);

  /// All that decides the future; restoring takes the place of start(). A row depends on its triangle alone.
  /// Collective.
  /// @param triangles  the rows that those of this rank are
  void archive(parallel::Archive& archive, const parallel::Rows& triangles);

 private:
  void block_constant(const std::vector<double>& low_passed, std::vector<double>& pressure) const;
  void fade(Emission& emission);
  void emit_geometry(const std::vector<double>& positions, Emission& emission) const;

  std::size_t triangles_;
  double dc_loss_;
  std::vector<Index> corners_;            // see corner_places()
  std::vector<double> low_passed_;        // g_{i-1} of eq. 9
  std::vector<double> without_constant_;  // p tilde_{i-1} of eq. 9
  SurfacePressure surface_pressure_;

  /// How much of a triangle is heard.
  struct Fade {
    double progress = std::numeric_limits<double>::quiet_NaN();  ///< 0 to 1; NaN: before the first emission
    double area = 0.0;                                           ///< that it had last, m2
    Vector3 normal = Vector3::Zero();                            ///< likewise
  };
  double fade_step_;
  std::vector<Fade> fades_;  ///< [triangles]; empty if nothing fades
};

}  // namespace idiophone::surface
