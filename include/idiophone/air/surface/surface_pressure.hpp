#pragma once
// The pressure of the air at a moving surface, found triangle by triangle: what Kirchhoff's integral needs beside the
// surface's own motion.

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "idiophone/foundation/parallel/archive_row.hpp"

namespace idiophone::surface {

/// Each triangle moves the air as a patch of a sphere of its own radius a would. P = z v is its plane-wave pressure;
/// for harmonic motion, with s = i k a, the pressure at the surface of a sphere is
///   pulsating:    P s/(s + 1)                       (spherical Hankel function of order 0)
///   oscillating:  P (s^2 + s)/(s^2 + 2 s + 2)       (order 1: the sphere moves to and fro),
/// both P at high frequencies, and a or a/2 times rho v' at low ones. In time both are p_s = P - Re(g q) with
/// q' = (c/a) (root q + P); q is stepped exactly for the parabola through P at the last three audio samples.
class SurfacePressure {
 public:
  enum class Field {
    pulsating,   ///< root -1, g 1
    oscillating  ///< root -1 + i, g 1 - i
  };

  /// The plane wave's: p_s = P.
  SurfacePressure() = default;

  /// @param radii             [triangles] a of each, m; above 0
  /// @param metres_per_sample c/rate: how far sound travels in an audio sample, m
  /// @throws std::invalid_argument when a radius isn't above 0 and finite
  SurfacePressure(Field field, const std::vector<double>& radii, double metres_per_sample);

  /// Takes other radii from now on; the waves that are under way stay. Only for a pressure that was made with radii.
  /// @param radii  [triangles] m
  /// @throws std::invalid_argument when one isn't above 0 and finite
  void set_radii(std::span<const double> radii);

  /// Begins after P has been what it is for ever.
  /// @param plane_wave  [padded(triangles)] P, Pa
  void start(std::span<const double> plane_wave);

  /// One audio sample.
  /// @param before, now   [padded(triangles)] P at the last audio sample and at this one, Pa
  /// @param pressure      [padded(triangles)] p_s at this one, Pa
  void step(std::span<const double> before, std::span<const double> now, std::span<double> pressure);

  /// One triangle's state between two audio samples: none in the plane wave's pressure.
  void archive(std::size_t triangle, parallel::ArchiveRow& row);

 private:
  /// Real and imaginary parts of a number for each triangle: [padded(triangles)] each.
  using ComplexValues = std::array<std::vector<double>, 2>;

  void set_radius(std::size_t triangle, double radius);

  double metres_per_sample_ = 0.0;
  std::vector<double> radii_;  // m
  std::complex<double> root_;
  std::complex<double> gain_;
  ComplexValues decay_;       // of q over an audio sample
  ComplexValues now_;         // what P at this audio sample adds to q
  ComplexValues before_;      // what P at the last one adds
  ComplexValues earlier_;     // what P at the one before adds
  ComplexValues memory_;      // q
  std::vector<double> past_;  // [padded(triangles)] P at the audio sample before the last one, Pa
};

}  // namespace idiophone::surface
