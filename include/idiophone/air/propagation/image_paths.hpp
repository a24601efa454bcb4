#pragma once
// The paths of sound by way of reflecting planes: a floor, or the walls of a room (Allen and Berkley, Image method for
// efficiently simulating small-room acoustics, JASA 65, 1979).

#include <optional>
#include <vector>

#include "idiophone/air/radiation/floor.hpp"
#include "idiophone/air/receivers/absorbing_walls.hpp"
#include "idiophone/scene/radiation_section.hpp"

namespace idiophone::propagation {

/// From the receiver to its image.
struct ImagePath {
  std::vector<radiation::ReflectingPlane> planes;  ///< that mirror it, one after the other
  Vector3 shift = Vector3::Zero();                 ///< then, m: two mirrors that face each other only shift it
  int reflections = 1;                             ///< how many
  double reflection = 1.0;                         ///< of all walls of a room that absorbs evenly
  /// Of the amplitude in octave bands (scene::OctaveBands) elsewhere, Np.
  std::vector<double> losses = {};

  /// Its mirror image of a direction.
  [[nodiscard]] Vector3 mirrored(Vector3 direction) const;
};

/// In free field, the image receives what the receiver hears by way of the path: see radiation::image.
[[nodiscard]] radiation::ReceiverState image(const radiation::ReceiverState& receiver, const ImagePath& path);

/// All paths but the direct one: one by a floor; in a room, those with up to Room::order() reflections. Paths that
/// nothing is left of are omitted.
[[nodiscard]] std::vector<ImagePath> image_paths(const scene::Radiation& radiation);

/// The corners of the way from a source to a receiver: both, and where it is reflected in between.
/// @param image  of the receiver, as image_paths() mirror it; the receiver itself for the direct way, m
[[nodiscard]] std::vector<Vector3> reflected_way(const scene::Radiation& radiation, const Vector3& source,
                                                 const Vector3& image);

/// Their losses as filters; path 0 is the direct one. None where no reflection changes the spectrum.
/// @param rate  audio samples per second
[[nodiscard]] std::optional<receivers::AbsorbingWalls> absorbing_walls(const scene::Radiation& radiation,
                                                                       const std::vector<ImagePath>& images, int rate);

}  // namespace idiophone::propagation
