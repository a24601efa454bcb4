#pragma once
// The outer layer of a body, where contact takes place: tetrahedra with straight edges that touch its surface. A tet10
// is eight of them, as its face is four triangles.

#include <mpi.h>

#include <array>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"

namespace idiophone::contact {

struct Skin {
  std::vector<Index> nodes;                   ///< [skin nodes] global numbers, ascending
  std::vector<double> areas;                  ///< [skin nodes] share of the undeformed surface, m2; 0 below the surface
  std::vector<std::array<Index, 4>> cells;    ///< places in `nodes`, of positive volume
  std::vector<std::array<char, 4>> exterior;  ///< [cells] 1 where the face opposite that corner is on the surface
  double thinnest = 0.0;                      ///< smallest height of a cell in the undeformed body, m
};

/// @param first_node  global number of the mesh's first node
[[nodiscard]] Skin make_skin(const mesh::Mesh& mesh, Index first_node);

/// Rank 0's skin, on every rank. Collective.
[[nodiscard]] Skin broadcast(Skin skin, MPI_Comm communicator);

}  // namespace idiophone::contact
