#pragma once
// The loops over packs: forces and energies of tetrahedra of any type by any law.

#include <algorithm>

#include "finite_strain.hpp"
#include "idiophone/solids/solid/packed_tetrahedra.hpp"
#include "nodal_gradient.hpp"
#include "node_lines.hpp"

namespace idiophone::solid {

/// Asks for the cache lines of a pack's nodes.
template <int nodes>
inline void prefetch(const Index (&numbers)[nodes][lanes], const NodeState* state, const NodeForce* force) {
  for (const auto& of_pack : numbers) {
    for (const Index node : of_pack) {
      __builtin_prefetch(&state[node]);
      __builtin_prefetch(&force[node], 1);
    }
  }
}

/// d field/d xi at every quadrature point, [points()], from the components of a nodal field.
template <class Element>
inline void differentiate(const Pack (&field)[3][Element::nodes], PackMatrix (&gradient)[Element::points]) {
  for (int i = 0; i < 3; ++i) {
    Pack slope[Element::points][3];
    NodalGradient<Element>::differentiate(field[i], slope);
    for (int q = 0; q < Element::points; ++q) {
      std::copy(slope[q], slope[q] + 3, gradient[q].at[i]);
    }
  }
}

/// Adds the forces of a pack to its nodes; see scatter_lines.
/// @param force_on  force_on(a, lane) is the force on a node
template <class Element, class ForceOn>
inline void scatter(const Pack (&force)[3][Element::nodes], int filled, std::size_t pack, HeldForces* held,
                    const ForceOn& force_on) {
  constexpr int count = Element::nodes;
  ForceLine lines[lanes][count + count % 2];
  for (int a = 0; a < count; a += 2) {
    const int b = a + 1 < count ? a + 1 : a;
    put_lines({force[0][a], force[1][a], force[2][a]}, {force[0][b], force[1][b], force[2][b]}, lines,
              static_cast<std::size_t>(a));
  }
  scatter_lines(lines, count, filled, pack, held, force_on);
}

template <class Element>
template <class Law>
auto PackedTetrahedra<Element>::gather(const Law& law, const ElementPack& pack, const NodeState* state) -> Fields {
  Fields fields;
  for (int a = 0; a < Element::nodes; ++a) {
    Pack rows[line_length];
    gather_node(state, pack.nodes[a], rows);
    for (int i = 0; i < 3; ++i) {
      fields.displacement[i][a] = rows[i];
      fields.rate[i][a] = law.rate_field(rows[i], rows[i + 3]);
    }
  }
  return fields;
}

template <class Element>
template <class Law>
void PackedTetrahedra<Element>::add_internal_force(const Law& law, PackRange range, HeldForces* held,
                                                   std::span<const NodeState> state, std::span<NodeForce> force) const {
  for (std::size_t number = range.begin; number < range.end; ++number) {
    if (number + prefetch_distance < range.end) {
      prefetch(packs_[number + prefetch_distance].nodes, state.data(), force.data());
    }
    const ElementPack& pack = packs_[number];
    const Fields fields = gather(law, pack, state.data());
    PackMatrix gradient[points()];
    PackMatrix rate_gradient[points()];
    differentiate<Element>(fields.displacement, gradient);
    differentiate<Element>(fields.rate, rate_gradient);

    Pack flux[3][Element::points][3];  // w P (dxi/dX)^T, component by component
    for (std::size_t q = 0; q < points(); ++q) {
      const auto& [inverse, weight] = geometry(pack, q);
      const PackMatrix h = multiply(gradient[q], inverse);
      const PackSymmetric strain = law.strain(h, multiply(rate_gradient[q], inverse), number * points() + q);
      const PackMatrix pull = multiply_transposed(first_piola(h, law.elasticity.stress(strain, -weight)), inverse);
      for (int i = 0; i < 3; ++i) {
        std::copy(pull.at[i], pull.at[i] + 3, flux[i][q]);
      }
    }
    Pack nodal[3][Element::nodes];
    for (int i = 0; i < 3; ++i) {
      NodalGradient<Element>::assemble(flux[i], nodal[i]);
    }
    scatter<Element>(nodal, layout_.filled_lanes(number), number, held,
                     [&](std::size_t a, int lane) -> NodeForce& { return force[pack.nodes[a][lane]]; });
  }
}

template <class Element>
template <class Law>
void PackedTetrahedra<Element>::elastic_energy(const Law& law, PackRange range, std::span<const NodeState> state,
                                               std::span<double> energy) const {
  for (std::size_t number = range.begin; number < range.end; ++number) {
    const ElementPack& pack = packs_[number];
    const Fields fields = gather(law, pack, state.data());
    PackMatrix gradient[points()];
    PackMatrix rate_gradient[points()];
    differentiate<Element>(fields.displacement, gradient);
    differentiate<Element>(fields.rate, rate_gradient);
    Pack sum = {};
    for (std::size_t q = 0; q < points(); ++q) {
      const auto& [inverse, weight] = geometry(pack, q);
      sum += weight * law.energy_density(multiply(gradient[q], inverse), multiply(rate_gradient[q], inverse),
                                         number * points() + q);
    }
    for (int lane = 0; lane < layout_.filled_lanes(number); ++lane) {
      energy[layout_.first_element(number) + lane] = sum[lane];
    }
  }
}

}  // namespace idiophone::solid
