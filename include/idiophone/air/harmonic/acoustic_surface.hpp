#pragma once
// All surfaces of a deck that reflect sound, and how one body's modes move.

#include <string>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/scene/radiation_section.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/eigenmodes/eigenmodes.hpp"

namespace idiophone::harmonic {

/// Bodies where the deck puts them, obstacles, and the floor of `radiation`.
struct AcousticSurface {
  harmonic::Boundary boundary;
  std::vector<std::string> parts;     ///< names of bodies, then obstacles
  std::vector<Index> first_triangle;  ///< of each part, and one past the last: [parts + 1]
};

/// How a body vibrates.
struct Vibration {
  std::string name;                     ///< "mode 3"
  double frequency = 0.0;               ///< Hz
  double energy = 0.0;                  ///< of an undamped mode at this amplitude, J; 0: has none
  std::vector<Vector3> velocity;        ///< [vertices of all parts] m/s
  std::vector<double> normal_velocity;  ///< [3 x triangles of all parts] at the corners, m/s
};

/// Meshes everything. Half-spaces have no surface and are left out. Call on one rank.
/// @throws deck::DeckError where a mesh can't be read
[[nodiscard]] AcousticSurface acoustic_surface(const scene::Solids& solids, const std::optional<scene::Floor>& floor);

/// The lowest modes of a body for a modal velocity of 1 m sqrt(kg)/s, all else at rest. Call on one rank.
/// @param body  index into Solids::bodies
/// @throws deck::DeckError, std::runtime_error as eigenmodes::find_modes()
[[nodiscard]] std::vector<Vibration> modal_vibrations(const scene::Solids& solids, std::size_t body, int count,
                                                      const AcousticSurface& surface);

/// The body moves to and fro along each axis, with 1 m/s, at each frequency.
[[nodiscard]] std::vector<Vibration> rigid_vibrations(std::size_t body, const std::vector<double>& frequencies,
                                                      const AcousticSurface& surface);

}  // namespace idiophone::harmonic
