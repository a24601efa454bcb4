#pragma once
// Sound through a thin wall that resists by its mass alone.

#include "idiophone/timbre/nodes/sound_node.hpp"

namespace idiophone::timbre {

/// The mass law: a plane wave that meets a limp wall of m kg/m2 at an angle off its normal gets through with
/// 1/(1 + i f/f_c) of its pressure, where f_c = rho c/(pi m cos(angle)), and the rest is reflected (Fahy 1985, "Sound
/// and structural vibration", section 4.3). A filter with one pole and one zero: exact at frequency 0 and at half the
/// rate, within 0.1 dB up to a tenth of the rate and within 1 dB above.
class LimpWall {
 public:
  /// f_c, Hz: infinite for a wall without mass.
  /// @param surface_density  m, kg/m2, at least 0
  /// @param cosine           of the angle off the normal
  /// @param impedance        rho c of the air, Pa s/m
  [[nodiscard]] static double corner(double surface_density, double cosine, double impedance);

  /// From now on, the wall has this corner.
  /// @param corner  f_c over the rate; not a number makes samples that are none
  void tune(double corner);

  /// The next sample behind the wall.
  double step(double input) {
    const double output = now_ * input + before_ * last_ + without_denormals(pole_ * behind_);
    last_ = input;
    behind_ = output;
    return output;
  }

 private:
  double now_ = 1.0, before_ = 0.0, pole_ = 0.0;
  double last_ = 0.0, behind_ = 0.0;
};

}  // namespace idiophone::timbre
