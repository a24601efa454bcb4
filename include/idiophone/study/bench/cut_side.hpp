#pragma once
// The side of a body on which a maker works, and what a cut there does to its modes.

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "idiophone/solids/eigenmodes/removal.hpp"
#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::bench {

/// A side of a body, and the axis of the deck along which cuts are placed on it.
struct Side {
  int along = 0;       ///< axis: 0, 1, 2 for x, y, z
  int facing = 2;      ///< axis that the side faces
  double sign = -1.0;  ///< 1 or -1: to which end of that axis
};

/// The side that a user names, "-z", "+x", ...; without a name, that below: the negative end of the shortest side of
/// the body's box. Cuts are placed along the longest other side of the box.
/// @throws std::runtime_error for another name
[[nodiscard]] Side read_side(const std::string& name, const mesh::Mesh& mesh);

/// "-z"
[[nodiscard]] std::string name_of(const Side& side);

/// "x", of the axis along which cuts are placed
[[nodiscard]] char axis_name(const Side& side);

/// The ends of the body along a side, m.
[[nodiscard]] std::array<double, 2> ends_along(const mesh::Mesh& mesh, const Side& side);

/// Triangles of the surface that look within 60 degrees to the side's end.
/// @throws std::runtime_error if none does
[[nodiscard]] std::vector<mesh::Triangle> side_faces(const mesh::Mesh& mesh, const Side& side);

/// What material that is removed from strips of a side does to modes. Strips lie across the side, one beside the other.
struct Strips {
  static constexpr int count = 600;

  /// The ends of the body along it, m.
  [[nodiscard]] double low() const { return places.front() - width / 2; }
  [[nodiscard]] double high() const { return places.back() + width / 2; }

  double width = 0.0;          ///< of each, m
  double thickness = 0.0;      ///< of the body's box, across the side, m
  std::vector<double> places;  ///< [strips] of their middles along the body, m
  Eigen::MatrixXd slopes;      ///< [modes x strips] cents for each metre of depth
};

/// @param removal  of this mesh; depth is measured along the axis that the side faces
/// @throws std::runtime_error if all faces of the side are held, and as side_faces()
[[nodiscard]] Strips strips_of(const mesh::Mesh& mesh, const eigenmodes::RemovalSlopes& removal, const Side& side);

}  // namespace idiophone::bench
