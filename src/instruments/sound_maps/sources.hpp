#pragma once
// A vibrating surface as monopoles and dipoles at the centres of its triangles: Kirchhoff's integral for harmonic
// motion.

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "idiophone/air/radiation/absorption.hpp"
#include "idiophone/air/radiation/paths.hpp"
#include "idiophone/air/surface/emission.hpp"
#include "idiophone/instruments/sound_maps/modal_radiation.hpp"

namespace idiophone::sound_maps {

/// Mean over the corners of a triangle.
/// @param values  [3 x triangles]
[[nodiscard]] inline double corner_mean(std::span<const double> values, std::size_t triangle) {
  return (values[3 * triangle] + values[3 * triangle + 1] + values[3 * triangle + 2]) / 3.0;
}

/// The undeformed surface of a map: areas, normals and centres of its triangles.
[[nodiscard]] surface::Emission surface_of(const sound_maps::SoundMap& map);

/// One mode's, for a modal velocity of 1 m sqrt(kg)/s.
struct Sources {
  double frequency = 0.0;                      ///< Hz
  double wave_number = 0.0;                    ///< k = w/c, 1/m
  std::vector<std::complex<double>> monopole;  ///< [triangles] i w rho v a/(4 pi)
  std::vector<std::complex<double>> dipole;    ///< [triangles] p_s a/(4 pi); empty in a rigid wall
};

/// @param radiation  none in a rigid wall, whose image of the sources doubles the monopoles
[[nodiscard]] Sources sources_of(const sound_maps::SoundMap& map, std::size_t mode, const surface::Emission& surface,
                                 const ModalRadiation& radiation);

/// Pressure at a receiver, Pa: sum of exp(-i k R)/R (monopole + cos(theta) (1/R + i k) dipole), theta between the
/// normal and the direction to the receiver. In a rigid wall only triangles that face the receiver count.
/// @param paths       from the triangles to the receiver
/// @param atmosphere  that absorbs sound on its way; none for air that does not
[[nodiscard]] std::complex<double> pressure_at(const radiation::Paths& paths, const Sources& sources,
                                               const std::optional<radiation::Atmosphere>& atmosphere);

/// Pressure times distance in the far field, Pa m, of all directions of a sphere, without the phase exp(-i k r) of the
/// way from the centre: sum of exp(i k n.y) (monopole + i k cos(theta) dipole).
/// @param centre  from which y is counted, m
[[nodiscard]] std::vector<std::complex<double>> far_field(const surface::Emission& surface, const Sources& sources,
                                                          const Vector3& centre, const sound_maps::MapSphere& sphere);

}  // namespace idiophone::sound_maps
