#pragma once
// How thick and how wide the parts of a body are, and what cells of waves make of them.

#include <span>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::advice {

/// The cross-section of a part of a body.
struct CrossSection {
  double thickness = 0.0;  ///< m
  double width = 0.0;      ///< across the thickness, not smaller, m
};

/// The smallest cross-section of a body, by rays from its surface inwards and from the middle between the two surfaces
/// to the sides. A twentieth of the surface may have a smaller one: edges and tips do not count.
/// @param triangles  corners, normals outwards
/// @param nodes      m
[[nodiscard]] CrossSection smallest_cross_section(std::span<const mesh::Triangle> triangles,
                                                  std::span<const Vector3> nodes);

/// By how much the level of a part that moves to and fro is off at the most with the model waves, dB: 9 h^2/(thickness
/// width), by measurements of bars (docs/method/waves.md). Sheets, thinner than 5/8 of a cell, count as this thick.
/// @param cell  h, m
[[nodiscard]] double level_error(const CrossSection& section, double cell);

/// From this frequency on, Hz, the level of two parts that move against each other, such as the tines of a fork, is off
/// by less than 3 dB: they cancel but for k times their distance, so that part of the level error is heard over k
/// thickness, if they are as near as parts can be.
/// @param speed  of sound, m/s
[[nodiscard]] double opposite_parts_from(const CrossSection& section, double cell, double speed);

constexpr double small_level_error = 0.5;  ///< dB

/// The cells with which the level error is small_level_error, m.
[[nodiscard]] double fine_cell(const CrossSection& section);

}  // namespace idiophone::advice
