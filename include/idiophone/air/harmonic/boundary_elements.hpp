#pragma once
// Sound of one frequency around vibrating and rigid bodies of any shape, by boundary elements
// (docs/method/radiation.md). Complex numbers belong to exp(+i w t). The outward normals point into the air.

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/radiation/floor.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::harmonic {

using Complex = std::complex<double>;
using ComplexVector = Eigen::Vector3cd;

/// What bounds the air: closed surfaces of one or several bodies. Bodies that stand on the floor may be open there.
struct Boundary {
  std::vector<Vector3> vertices;                ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< vertex numbers, in the order that makes normals point outwards
  std::optional<radiation::ReflectingPlane> floor = {};  ///< all bodies are on the side of its normal
};

/// The air at rest.
struct QuietAir {
  double density = 1.21;  ///< kg/m3
  double speed = 343.0;   ///< of sound, m/s

  /// Specific acoustic impedance z = rho c, Pa s/m.
  [[nodiscard]] double impedance() const { return density * speed; }
};

/// The air's motion at the boundary, for one frequency. Between the corners of a triangle, both are linear.
struct BoundaryField {
  double wave_number = 0.0;              ///< k = w/c, 1/m
  std::vector<Complex> pressure;         ///< [vertices] Pa
  std::vector<Complex> normal_velocity;  ///< [3 x triangles] outward, at the three corners of each triangle, m/s
  double power = 0.0;                    ///< radiated: |p|^2/(2 z) over a far sphere, W; p and v are amplitudes
};

/// A point that sends out sound: p = strength exp(-i k r)/r.
struct PointSource {
  Vector3 position = Vector3::Zero();  ///< m
  Complex strength = 1.0;              ///< Pa m
};

/// How the linear equations are solved.
enum class LinearSolver {
  by_size,    ///< direct up to 2500 vertices, iterative beyond
  direct,     ///< LU factors of the matrix of vertices x vertices complex numbers
  iterative,  ///< PETSc's GMRES on a compressed matrix; PETSc must have been initialised
};

/// Longest edges in a wave length: with fewer, a solution is worth nothing.
inline constexpr double least_resolution = 3.0;

/// About what one core takes for one motion of one frequency by the solver for this size, s (docs/method/radiate.md).
[[nodiscard]] double solution_time(std::size_t vertices);

/// The exterior Helmholtz problem on a boundary whose normal velocity is given. Pressures are continuous and linear on
/// each triangle; Galerkin's method. Burton and Miller's combination of the boundary integral equation and its normal
/// derivative has one solution at every frequency (Burton and Miller 1971).
class BoundaryElements {
 public:
  /// @throws std::invalid_argument if there is no triangle, a vertex number is wrong, a vertex is not finite or in no
  ///         triangle, a triangle has no area, or a vertex is behind the floor by more than a thousandth of the longest
  ///         edge
  BoundaryElements(Boundary boundary, const QuietAir& air);

  [[nodiscard]] const Boundary& boundary() const { return boundary_; }
  [[nodiscard]] const QuietAir& air() const { return air_; }

  /// Longest edge of the triangles, m. Six of them in a wavelength give about 0.1 dB, four about 0.3 dB.
  [[nodiscard]] double longest_edge() const { return longest_edge_; }

  /// Solves for several motions of one frequency.
  /// @param wave_number  above 0, 1/m
  /// @param velocities   [motions] of [3 x triangles] outward normal velocities at the corners of each triangle, m/s
  /// @param sources      sound that arrives besides, the same for all motions; the pressure is that of the total field
  /// @throws std::invalid_argument if the wave number or a length is wrong, std::runtime_error if the matrix is
  ///         singular or the iteration does not converge
  [[nodiscard]] std::vector<BoundaryField> solve(double wave_number, std::span<const std::vector<Complex>> velocities,
                                                 std::span<const PointSource> sources = {},
                                                 LinearSolver solver = LinearSolver::by_size) const;

  /// Pressure in the air (Pa, [points]) that the boundary sends out; without that of point sources. A point may be as
  /// near to the boundary as it likes.
  /// @param attenuation  of the air, 1/m: the sound of each triangle falls as exp(-attenuation distance) besides
  [[nodiscard]] std::vector<Complex> pressure_at(const BoundaryField& field, std::span<const Vector3> points,
                                                 double attenuation = 0.0) const;

  /// Pressure times distance in the far field (Pa m, [directions]), without the phase exp(-i k r) of the way from the
  /// origin. Directions are unit vectors; one that points behind the floor has the value of its mirror image.
  [[nodiscard]] std::vector<Complex> far_field(const BoundaryField& field, std::span<const Vector3> directions) const;

 private:
  [[nodiscard]] double radiated_power(const BoundaryField& field) const;

  Boundary boundary_;
  QuietAir air_;
  double extent_ = 0.0;  // radius of all, m
  double longest_edge_ = 0.0;
};

/// Mean of each triangle's three corners: [triangles] Pa.
[[nodiscard]] std::vector<Complex> triangle_pressures(const Boundary& boundary, const BoundaryField& field);

}  // namespace idiophone::harmonic
