#pragma once
// Spectral hexahedra in packs: order p along xi_1 and xi_2, order q along xi_3 (through the thickness). Nodes
// and quadrature points are the same Gauss-Lobatto-Legendre points, so the mass is diagonal, and a derivative at a
// point is a sum along the line of nodes through it (sum factorisation; Patera, Journal of Computational Physics 54,
// 1984; Komatitsch and Vilotte, Bulletin of the Seismological Society of America 88, 1998).

#include <algorithm>
#include <span>
#include <vector>

#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/pack.hpp"
#include "idiophone/solids/solid/pack_division.hpp"
#include "idiophone/solids/solid/pack_layout.hpp"

namespace idiophone::solid {

/// Hexahedra of one order: ElementPacks (element_packs.hpp). The mass of a node is density w_a det J. The loops over
/// them are in src/solids/solid/hexahedron_kernels.hpp. Node (i, j, k) of an element is number i + (p + 1) (j + (p + 1)
/// k), and so is its quadrature point. A pack with too few elements is padded with copies of its last element that
/// have no volume and add nothing.
class PackedHexahedra {
 public:
  PackedHexahedra(const mesh::BodyPart& part, std::span<const Vector3> reference);

  template <class Law>
  void add_internal_force(const Law& law, std::span<const NodeState> state, std::span<NodeForce> force) const {
    add_internal_force(law, all(), nullptr, state, force);
  }
  template <class Law>
  void add_internal_force(const Law& law, PackRange range, HeldForces* held, std::span<const NodeState> state,
                          std::span<NodeForce> force) const;
  void add_mass(double density, std::span<double> mass) const { add_mass(density, all(), mass); }
  void add_mass(double density, PackRange range, std::span<double> mass) const;
  template <class Law>
  void elastic_energy(const Law& law, std::span<const NodeState> state, std::span<double> energy) const {
    elastic_energy(law, all(), state, energy);
  }
  template <class Law>
  void elastic_energy(const Law& law, PackRange range, std::span<const NodeState> state,
                      std::span<double> energy) const;

  [[nodiscard]] Index element_count() const { return layout_.element_count(); }
  [[nodiscard]] const PackLayout& layout() const { return layout_; }
  [[nodiscard]] std::size_t points() const { return weight_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return layout_.bytes() + nodes_.size() * sizeof(PackNodes) + packs_.size() * sizeof(ElementPack) +
           geometry_.size() * sizeof(Geometry);
  }

 private:
  /// Geometry of the elements of a pack at one quadrature point.
  struct Geometry {
    PackMatrix inverse_jacobian;  ///< dxi_k/dX_j at [k][j], 1/m
    Pack determinant;             ///< of the Jacobian, m3; 0 in lanes that are padding
  };
  struct ElementPack {
    std::size_t geometry;  ///< of the first quadrature point
    std::size_t stride;    ///< to the next point's: 0 where all its elements are parallelepipeds
  };
  /// Local numbers of one node of the elements of a pack.
  struct PackNodes {
    Index at[lanes];
  };
  static constexpr std::size_t most_line_points = element::highest_hex_order + 1;
  static constexpr std::size_t most_points = most_line_points * most_line_points * most_line_points;
  /// Derivative of the Lagrange polynomial l_j at node i, [i][j], and the transpose.
  struct Derivative {
    explicit Derivative(int order);
    double at[most_line_points][most_line_points] = {};
    double transposed[most_line_points][most_line_points] = {};
  };
  struct Fields;
  struct Flux;

  template <class Visitor>
  void for_each_point(Visitor visit) const;
  template <class Law>
  void gather(const Law& law, std::size_t pack, const NodeState* state, Fields& fields) const;
  template <class Law, class Visitor>
  void differentiate(std::size_t pack, const Fields& fields, Visitor visit) const;
  void assemble(std::size_t pack, const Flux& flux, HeldForces* held, NodeForce* force) const;

  [[nodiscard]] const PackNodes* nodes(std::size_t pack) const { return &nodes_[pack * points()]; }
  [[nodiscard]] PackRange all() const { return {0, layout_.pack_count()}; }
  void add_pack(std::size_t number, const mesh::BodyPart& part, std::span<const Vector3> reference);

  PackLayout layout_;
  int plane_;      ///< order p
  int thickness_;  ///< order q
  Derivative along_plane_;
  Derivative along_thickness_;
  std::vector<double> weight_;    ///< [points] quadrature weight in the reference cube, of volume 8
  std::vector<PackNodes> nodes_;  ///< [points x packs]
  std::vector<ElementPack> packs_;
  std::vector<Geometry> geometry_;
};

}  // namespace idiophone::solid
