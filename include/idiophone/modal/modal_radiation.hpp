#pragma once
// The sound that the modes of a body radiate: pressure at listeners and in all directions, and the decay that goes with
// it.

#include <mpi.h>

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "idiophone/store/sound_map.hpp"

namespace idiophone::modal {

/// The air at a vibrating surface: from an angular frequency (rad/s) and the outward normal velocity of each triangle
/// (m/s, [triangles]) to the complex pressure at each triangle (Pa, [triangles]); numbers belong to exp(+i w t). The
/// pressure elsewhere follows from both by Kirchhoff's integral. A solver of the wave equation fits here.
using ModalRadiation =
    std::function<std::vector<std::complex<double>>(double angular_frequency, std::span<const double> normal_velocity)>;

/// Gives all ranks what the radiation depends on: rank 0's modes, surface, air and directions. Collective.
void share_vibrations(store::SoundMap& map, MPI_Comm communicator);

/// Model kirchhoff: each triangle has the pressure of a patch of a sphere (surface::SurfacePressure).
/// @param map  holds the surface
[[nodiscard]] ModalRadiation sphere_patches(const store::SoundMap& map, const scene::Radiation& radiation);

/// A sheet in an infinite rigid wall, with no air behind it: Rayleigh's integral instead of Kirchhoff's.
[[nodiscard]] inline ModalRadiation rigid_wall() {
  return {};
}

/// Directions of a sphere in `rings` rings at Gauss' nodes and twice as many azimuths. The weights integrate spherical
/// harmonics up to the degree 2 rings - 1 exactly.
[[nodiscard]] store::MapSphere sphere_of_directions(std::size_t rings);

/// Finds what a map lacks: its listeners, its sphere and radiation_decay. The modes are dealt to the ranks; the bits do
/// not depend on their number. Collective.
/// @param map    shared by share_vibrations(); complete on all ranks at the end, except for the facts
/// @param scene  whose listeners hear, with the floor and the absorption of its air. Listeners that move stand where
///               they are at time 0; a head hears the pressure at its centre.
void add_radiation(store::SoundMap& map, const scene::Scene& scene, const ModalRadiation& radiation,
                   MPI_Comm communicator);

}  // namespace idiophone::modal
