#pragma once
// Triangles of some bodies in this rank's share, with their vertices.

#include <cstddef>
#include <vector>

#include "idiophone/foundation/parallel/archive.hpp"
#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::bodies {

class SurfaceShare {
 public:
  /// @param left_out  [bodies] whose triangles are not among them
  /// @param part      must outlive this object
  SurfaceShare(const std::vector<bool>& left_out, const mesh::Part& part);

  /// Those of one body.
  static SurfaceShare of_body(std::size_t body, const mesh::Part& part);

  /// Places in the rank's share, ascending.
  [[nodiscard]] const std::vector<std::size_t>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<std::size_t>& vertices() const { return vertices_; }

  /// The triangles, as places among vertices().
  [[nodiscard]] std::vector<mesh::Triangle> corners() const;

  /// Node of each vertex, a place among the part's nodes.
  [[nodiscard]] std::vector<std::size_t> nodes() const;

  /// Of each vertex in the reference state, m.
  [[nodiscard]] std::vector<Vector3> positions() const;

 private:
  const mesh::Part& part_;
  std::vector<std::size_t> triangles_;
  std::vector<std::size_t> vertices_;
};

/// Rows of an archive: the triangles or vertices of some bodies, numbered without gaps. Collective.
/// @param numbers  global numbers of this rank's, of all bodies
/// @param first    of each body, and one past the last
/// @param places   those of these bodies among the numbers
parallel::Rows rows_without(const std::vector<bool>& left_out, const std::vector<Index>& numbers,
                            const std::vector<Index>& first, const std::vector<std::size_t>& places,
                            MPI_Comm communicator);

}  // namespace idiophone::bodies
