#pragma once
// The overlap of two cells, shared out over their nodes: what a contact's potential is made of. A cell is a tetrahedron
// of a body, or a convex part of an obstacle.
//
// psi_i are the linear shape functions of one cell, the field's own; every overlap of a body's cells with those of its
// partner adds V_i = integral of psi_i over the overlap to node i. Moving the nodes changes it by
//   dV_i = sum over the partner's exterior faces inside the cell of integral psi_i n.(dx_other - dx_own) dA
//          + V_i sum_j grad psi_j . dx_j ,
// n the partner's outward normal (Reynolds' transport theorem; the partner's inner faces cancel between neighbours).

#include <span>
#include <vector>

#include "polyhedron.hpp"

namespace idiophone::contact {

struct Cell {
  Index number = 0;                          ///< of the cell in its skin
  const Tetrahedron* tetrahedron = nullptr;  ///< null for an obstacle's
  std::span<const Plane> planes;             ///< that bound it
  std::span<const char> exterior;            ///< [planes] 1 where the plane's face lies on the surface
};

/// Whether the plane of a face has the two cells on its two sides, at least `distance` (m) apart along its normal.
[[nodiscard]] bool separated(const Cell& first, const Cell& second, double distance);

/// One cell's part in an overlap.
struct CellShare {
  int side = 0;                      ///< 0: of the first body, 1: of the second
  Index cell = 0;                    ///< in its skin
  double overlap = 0.0;              ///< the whole volume, m3
  Eigen::Vector4d volumes;           ///< V_i of its four nodes, m3
  std::array<Vector3, 4> gradients;  ///< of psi, 1/m
};

/// A piece of one side's surface inside a cell of the other side, whose field is used.
struct FaceShare {
  int side = 0;           ///< whose field it is; the surface is the other's
  Index own_cell = 0;     ///< in the field's skin
  Index other_cell = 0;   ///< in the surface's skin
  Vector3 normal;         ///< of the surface, outward
  Eigen::Matrix4d own;    ///< integral psi_i psi_j dA over the piece, m2
  Eigen::Matrix4d other;  ///< integral psi_i chi_j dA, chi_j the other cell's shape functions, m2; zero for an obstacle
};

/// All overlaps of a contact at one moment, in the order in which they were added.
class Overlaps {
 public:
  void clear();

  /// Adds the overlap of a cell of the first body with one of its partner, if there is any.
  void add(const Cell& first, const Cell& second);

  /// Adds overlaps that another rank has computed, after all others.
  void append(std::span<const CellShare> cells, std::span<const FaceShare> faces);

  [[nodiscard]] double volume() const;  ///< of all overlaps together, m3
  [[nodiscard]] const std::vector<CellShare>& cells() const { return cells_; }
  [[nodiscard]] const std::vector<FaceShare>& faces() const { return faces_; }

 private:
  void add_cell(int side, const Cell& cell, const Polyhedron::Moments& moments);
  void add_face(int side, const Cell& own, const Cell& other, const Vector3& normal, std::span<const Vector3> corners);

  std::vector<CellShare> cells_;
  std::vector<FaceShare> faces_;
  Polyhedron common_;
};

}  // namespace idiophone::contact
