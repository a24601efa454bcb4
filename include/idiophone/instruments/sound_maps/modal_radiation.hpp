#pragma once
// The sound that the modes of a body radiate: pressure at listeners and in all directions, and the decay that goes with
// it.

#include <mpi.h>

#include <complex>
#include <functional>
#include <span>
#include <vector>

#include "idiophone/foundation/part_watch.hpp"
#include "idiophone/instruments/sound_maps/sound_map.hpp"
#include "idiophone/scene/acoustics.hpp"

namespace idiophone::sound_maps {

/// The air at a vibrating surface: from an angular frequency (rad/s) and the outward normal velocity at the corners of
/// each triangle (m/s, [3 x triangles]) to the complex pressure at each triangle (Pa, [triangles]), the mean of its
/// corners; numbers belong to exp(+i w t). The pressure elsewhere follows from both by Kirchhoff's integral.
using ModalRadiation =
    std::function<std::vector<std::complex<double>>(double angular_frequency, std::span<const double> normal_velocity)>;

/// Gives all ranks what the radiation depends on: rank 0's modes, surface, air and directions. Collective.
void share_vibrations(sound_maps::SoundMap& map, MPI_Comm communicator);

/// Model kirchhoff: each triangle has the pressure of a patch of a sphere (surface::SurfacePressure).
/// @param map  holds the surface
[[nodiscard]] ModalRadiation sphere_patches(const sound_maps::SoundMap& map, const scene::Radiation& radiation);

/// Boundary elements (radiation/boundary_elements.hpp): the wave equation around the body alone, in the open. Modes
/// whose wave length of sound is below three edges of the surface have the pressure of sphere_patches().
/// @param map  holds the surface
/// @throws std::invalid_argument as harmonic::BoundaryElements
[[nodiscard]] ModalRadiation boundary_elements(const sound_maps::SoundMap& map, const scene::Radiation& radiation);

/// The frequency (Hz) up to which boundary_elements() solves the wave equation.
[[nodiscard]] double resolved_frequency(const sound_maps::SoundMap& map);

/// A sheet in an infinite rigid wall, with no air behind it: Rayleigh's integral instead of Kirchhoff's.
[[nodiscard]] inline ModalRadiation rigid_wall() {
  return {};
}

/// Directions of a sphere in `rings` rings at Gauss' nodes and twice as many azimuths. The weights integrate spherical
/// harmonics up to the degree 2 rings - 1 exactly.
[[nodiscard]] sound_maps::MapSphere sphere_of_directions(std::size_t rings);

/// Finds what a map lacks: its listeners, its sphere and radiation_decay. The modes are dealt to the ranks; the bits do
/// not depend on their number. Collective.
/// @param map    shared by share_vibrations(); complete on all ranks at the end, except for the facts
/// @param acoustics  whose listeners hear, with the floor and the absorption of its air. Listeners that move stand
/// where
///               they are at time 0; a head hears the pressure at its centre.
/// @param watch      may end the work: the map then keeps only the lowest modes, those that all ranks have done
void add_radiation(sound_maps::SoundMap& map, const scene::Acoustics& acoustics, const ModalRadiation& radiation,
                   MPI_Comm communicator, const PartWatch& watch = {});

}  // namespace idiophone::sound_maps
