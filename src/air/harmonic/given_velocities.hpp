#pragma once
// Velocities of a body's surface that someone measured, or computed elsewhere.

#include <filesystem>
#include <map>

#include "idiophone/air/harmonic/acoustic_surface.hpp"

namespace idiophone::harmonic {

/// Amplitude of each vertex of the body, m/s, by the number of the vertex.
using VertexVelocities = std::map<Index, ComplexVector>;

/// Reads a file (docs/use/radiate.md#velocities).
/// @param body  index of the part whose vertices the file has
/// @return the velocities at each frequency (Hz)
/// @throws deck::DeckError or std::runtime_error if the file can't be read, a place is no vertex of the body, or a
/// vertex has not exactly one row at each frequency
[[nodiscard]] std::map<double, VertexVelocities> read_velocities(const std::filesystem::path& file,
                                                                 const AcousticSurface& surface, std::size_t body);

}  // namespace idiophone::harmonic
