#pragma once
// One body's tetrahedra on this rank, in packs (AoSoA), and the loops over them.

#include <algorithm>
#include <span>
#include <vector>

#include "idiophone/foundation/element/tetrahedra.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/solid/node_state.hpp"
#include "idiophone/solids/solid/pack.hpp"
#include "idiophone/solids/solid/pack_division.hpp"
#include "idiophone/solids/solid/pack_layout.hpp"

namespace idiophone::solid {

/// Tetrahedra of one type: ElementPacks (element_packs.hpp). The loops over them are in
/// src/solids/solid/tetrahedron_kernels.hpp. A pack with too few elements is padded with copies of its last element
/// that have no mass and add no force.
/// @tparam Element  one of element/tetrahedra.hpp
template <class Element>
class PackedTetrahedra {
 public:
  PackedTetrahedra(const mesh::BodyPart& part, std::span<const Vector3> reference);

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
  [[nodiscard]] static constexpr std::size_t points() { return Element::points; }
  [[nodiscard]] std::size_t bytes() const {
    return layout_.bytes() + packs_.size() * sizeof(ElementPack) + geometry_.size() * sizeof(Geometry);
  }

 private:
  /// Geometry of the elements of a pack at one quadrature point.
  struct Geometry {
    PackMatrix inverse_jacobian;  ///< dxi_k/dX_j at [k][j], 1/m
    Pack weight;                  ///< quadrature weight times Jacobian determinant, m3
  };
  struct ElementPack {
    Index nodes[Element::nodes][lanes];  ///< local node numbers
    std::size_t geometry;                ///< of the first quadrature point
    std::size_t stride;                  ///< to the next point's: 0 if all points of each element share one
  };

  /// How many packs ahead the nodes' cache lines are asked for; matters on meshes larger than the cache.
  static constexpr std::size_t prefetch_distance = 2;

  /// Displacement and rate field of a law at an element's nodes, component by component.
  struct Fields {
    Pack displacement[3][Element::nodes];
    Pack rate[3][Element::nodes];
  };

  template <class Law>
  [[nodiscard]] static Fields gather(const Law& law, const ElementPack& pack, const NodeState* state);
  [[nodiscard]] PackRange all() const { return {0, layout_.pack_count()}; }

  void add_geometry(std::size_t number, const mesh::BodyPart& part, std::span<const Vector3> reference);
  [[nodiscard]] const Geometry& geometry(const ElementPack& pack, std::size_t point) const {
    return geometry_[pack.geometry + point * pack.stride];
  }

  PackLayout layout_;
  std::vector<ElementPack> packs_;
  std::vector<Geometry> geometry_;
};

extern template class PackedTetrahedra<element::Tet4>;
extern template class PackedTetrahedra<element::Tet10>;

}  // namespace idiophone::solid
