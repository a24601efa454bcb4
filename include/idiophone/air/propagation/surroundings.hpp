#pragma once
// The closed surfaces that listeners stand among, undeformed.

#include <mpi.h>

#include <array>
#include <string>
#include <vector>

#include "idiophone/air/propagation/audible_surface.hpp"
#include "idiophone/solids/mesh/triangle_point.hpp"

namespace idiophone::propagation {

struct Surroundings {
  std::vector<std::string> names;               ///< of the parts: bodies in the order of the deck, then obstacles
  std::size_t bodies = 0;                       ///< how many of the parts sound
  std::vector<Vector3> vertices;                ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< vertex numbers, in the order that makes normals point outwards
  std::vector<Index> first_triangle = {0};      ///< of each part, and one past the last: [parts + 1]

  /// Adds a part.
  /// @param nodes  m
  /// @param faces  as places in `nodes`
  void add(const std::string& name, std::span<const Vector3> nodes, std::span<const mesh::Triangle> faces);
  /// Adds an obstacle by the corners of its triangles, m; nothing if there are none.
  void add(const std::string& name, std::span<const mesh::TrianglePoints> faces);

  [[nodiscard]] mesh::TrianglePoints corners(Index triangle) const;

  /// Whether a point is inside a part: by the solid angle of its triangles (Van Oosterom and Strackee 1983).
  [[nodiscard]] bool is_inside(std::size_t part, const Vector3& point) const;

  /// The surface near a point.
  struct Nearest {
    double distance = 0.0;  ///< m
    double edge = 0.0;      ///< longest one of the nearest triangle, m
  };
  [[nodiscard]] Nearest nearest(std::size_t part, const Vector3& point) const;

  /// Whether a part stands in the straight way between two points.
  [[nodiscard]] bool is_between(std::size_t part, const Vector3& from, const Vector3& to) const;

  /// The share of a body's area, 0 to 1, from which the straight way to a point goes through another part; of some 200
  /// triangles.
  [[nodiscard]] double share_behind(std::size_t part, std::size_t body, const Vector3& point) const;
};

/// All bodies and obstacles of a surface, on all ranks; the obstacles as one part. Collective.
[[nodiscard]] Surroundings surroundings(const AudibleSurface& surface, MPI_Comm communicator);

}  // namespace idiophone::propagation
