#pragma once
// An obstacle as convex parts, each bounded by planes.

#include <mpi.h>

#include <Eigen/Geometry>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/contact_sections.hpp"

namespace idiophone::contact {

/// A plane with a point on it; the inside is where distance() is negative.
struct Plane {
  Vector3 normal;  ///< unit, outward
  Vector3 point;   ///< m

  [[nodiscard]] double distance(const Vector3& x) const { return normal.dot(x - point); }
};

using Box = Eigen::AlignedBox3d;  ///< m

struct RigidShape {
  std::vector<Plane> planes;       ///< of all parts, one after the other
  std::vector<char> exterior;      ///< [planes] 1 where the plane's face lies on the surface
  std::vector<Index> first_plane;  ///< [parts + 1]
  std::vector<Box> boxes;          ///< [parts] around them; a half-space's has no bounds
};

/// Planes that a sphere and a cylinder's mantle are made of.
constexpr int sphere_facets = 1280;
constexpr int cylinder_facets = 128;

/// The shape of an obstacle. Spheres and cylinders are polyhedra of the same volume with many facets. A surface is
/// filled with tetrahedra by gmsh. Call on one rank only.
/// @throws deck::DeckError, pointing at the obstacle's mesh key, when that can't be read or filled
[[nodiscard]] RigidShape make_shape(const scene::Obstacle& obstacle);

/// Rank 0's shape, on every rank. Collective.
[[nodiscard]] RigidShape broadcast(RigidShape shape, MPI_Comm communicator);

}  // namespace idiophone::contact
