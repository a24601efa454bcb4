#pragma once
// Closed surfaces whose normal velocity is a formula, and what a receiver hears of them: the whole audio path behind
// the low-pass, for comparison with exact solutions.

#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/air/radiation/radiation.hpp"
#include "idiophone/air/surface/surface_pressure.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::radiation {

using Field = surface::SurfacePressure::Field;

/// Density and speed of the air in these tests: z = 415.03 Pa s/m.
inline constexpr double air_density = 1.21;  // kg/m3
inline constexpr Medium test_air{.speed = 343.0, .rate = 44100};
inline constexpr harmonic::QuietAir quiet_air{.density = air_density, .speed = test_air.speed};
inline const Rayleigh rayleigh(test_air);
inline const Kirchhoff kirchhoff(test_air);

struct Solid {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Vector3> vertices;  // m

  [[nodiscard]] std::vector<std::array<Vector3, 3>> corners() const;
  [[nodiscard]] std::vector<double> radii() const;  ///< equivalent radii of all triangles, m
  [[nodiscard]] double area() const;                ///< m2
};

/// About the origin: an octahedron with each face cut into n^2 triangles, pushed out to the radius.
[[nodiscard]] Solid sphere(double radius, int n);

/// About the origin: an icosahedron with each face cut into n^2 triangles, pushed out; 20 n^2 triangles that are more
/// alike than those of sphere(). Its area is that of a sphere of this radius.
[[nodiscard]] Solid icosphere(double radius, int n);

/// A box about the origin, edges along the axes; each face is cut into squares of two triangles.
/// @param cells  along each axis
[[nodiscard]] Solid box(const Vector3& size, const std::array<int, 3>& cells);

/// A flat disc about the z axis in 6 n^2 triangles. Its face looks along z, at z = thickness/2; where the thickness is
/// above 0 there are also a back and a rim.
[[nodiscard]] Solid disc(double radius, int n, double thickness = 0.0);

/// A solid's normal velocity at a place of its surface, m/s, at a time, s.
using NormalVelocity = std::function<double(const Vector3& centre, const Vector3& normal, double time)>;

/// What a receiver hears in so many audio samples from time 0 on. The solid's pressures are the formula's: no low-pass,
/// no DC block.
/// @param field  of the surface pressure; none: plane waves
[[nodiscard]] std::vector<double> listen(const Solid& solid, const NormalVelocity& velocity, const Model& model,
                                         std::optional<Field> field, const Vector3& receiver, int samples);

/// Amplitude and phase at the receiver, Pa, when the normal velocity is shape(centre, normal) sin(2 pi frequency t).
[[nodiscard]] std::complex<double> response(const Solid& solid,
                                            const std::function<double(const Vector3&, const Vector3&)>& shape,
                                            const Model& model, std::optional<Field> field, const Vector3& receiver,
                                            double frequency);

/// 20 log10 |one/other|
[[nodiscard]] double decibels(double one, double other);

}  // namespace idiophone::radiation
