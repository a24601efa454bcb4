#pragma once
// The loops over packs of spectral hexahedra: forces and energies by any law. The orders are known at run time only: a
// sum along a line of nodes runs for six fields at once, so that fixed orders would be only 3 to 5 % faster.

#include "finite_strain.hpp"
#include "idiophone/solids/solid/packed_hexahedra.hpp"
#include "node_lines.hpp"

namespace idiophone::solid {

/// Displacement (0 1 2) and a law's rate field (3 4 5) at the nodes of a pack.
struct PackedHexahedra::Fields {
  Pack at[most_points][6];
};

/// w P (dxi/dX)^T at the quadrature points of a pack, [direction of xi][component].
struct PackedHexahedra::Flux {
  Pack at[most_points][3][3];
};

/// Asks for the geometry of a point well ahead. On meshes of curved elements that are larger than the cache this
/// doubles the speed.
template <class Geometry>
inline void prefetch_ahead(const Geometry* geometry, std::size_t stride) {
  constexpr std::size_t points_ahead = 8;
  constexpr std::size_t cache_line = line_length * sizeof(double);
  const auto* bytes = reinterpret_cast<const char*>(geometry + points_ahead * stride);
  for (std::size_t line = 0; line < sizeof(Geometry); line += cache_line) {
    __builtin_prefetch(bytes + line);
  }
}

/// Calls visit(i, j, k, number of the point).
template <class Visitor>
void PackedHexahedra::for_each_point(Visitor visit) const {
  int point = 0;
  for (int k = 0; k <= thickness_; ++k) {
    for (int j = 0; j <= plane_; ++j) {
      for (int i = 0; i <= plane_; ++i) {
        visit(i, j, k, point++);
      }
    }
  }
}

template <class Law>
void PackedHexahedra::gather(const Law& law, std::size_t pack, const NodeState* state, Fields& fields) const {
  const PackNodes* nodes_of_pack = nodes(pack);
  for (std::size_t a = 0; a < points(); ++a) {
    Pack rows[line_length];
    gather_node(state, nodes_of_pack[a].at, rows);
    for (int i = 0; i < 3; ++i) {
      fields.at[a][i] = rows[i];
      if constexpr (Law::has_rate_field) {
        fields.at[a][3 + i] = law.rate_field(rows[i], rows[i + 3]);
      }
    }
  }
}

/// Adds up fields along a line of nodes, each node with its coefficient: a derivative at one of them.
/// @param fields  of all nodes
/// @param node    the first of the line
/// @param stride  to the next one
template <int count, int width>
inline void add_along_line(const Pack (*fields)[width], int node, int stride, int length, const double* coefficient,
                           Pack (&sum)[count]) {
  for (int l = 0; l < length; ++l, node += stride) {
    for (int f = 0; f < count; ++f) {
      sum[f] += coefficient[l] * fields[node][f];
    }
  }
}

/// Calls visit(point, H, that of the rate field, geometry) at every quadrature point.
template <class Law, class Visitor>
void PackedHexahedra::differentiate(std::size_t pack, const Fields& fields, Visitor visit) const {
  constexpr int count = Law::has_rate_field ? 6 : 3;
  const int n = plane_ + 1;
  const int m = thickness_ + 1;
  const Geometry* geometry = &geometry_[packs_[pack].geometry];
  const std::size_t stride = packs_[pack].stride;
  for_each_point([&](int i, int j, int k, int point) {
    prefetch_ahead(geometry, stride);
    Pack slope[3][count] = {};
    add_along_line(fields.at, n * (j + n * k), 1, n, along_plane_.at[i], slope[0]);
    add_along_line(fields.at, i + n * n * k, n, n, along_plane_.at[j], slope[1]);
    add_along_line(fields.at, i + n * j, n * n, m, along_thickness_.at[k], slope[2]);
    PackMatrix gradient[count / 3];
    for (int f = 0; f < count; ++f) {
      for (int d = 0; d < 3; ++d) {
        gradient[f / 3].at[f % 3][d] = slope[d][f];
      }
    }
    const PackMatrix h = multiply(gradient[0], geometry->inverse_jacobian);
    const PackMatrix rate = Law::has_rate_field ? multiply(gradient[count / 3 - 1], geometry->inverse_jacobian) : h;
    visit(point, h, rate, *geometry);
    geometry += stride;
  });
}

template <class Law>
void PackedHexahedra::add_internal_force(const Law& law, PackRange range, HeldForces* held,
                                         std::span<const NodeState> state, std::span<NodeForce> force) const {
  Fields fields;
  Flux flux;
  for (std::size_t pack = range.begin; pack < range.end; ++pack) {
    gather(law, pack, state.data(), fields);
    differentiate<Law>(pack, fields,
                       [&](int point, const PackMatrix& h, const PackMatrix& delayed, const Geometry& geometry) {
                         const auto q = static_cast<std::size_t>(point);
                         const PackSymmetric strain = law.strain(h, delayed, pack * points() + q);
                         const PackSymmetric stress = law.elasticity.stress(strain, -weight_[q] * geometry.determinant);
                         const PackMatrix pull = multiply_transposed(first_piola(h, stress), geometry.inverse_jacobian);
                         for (int d = 0; d < 3; ++d) {
                           for (int i = 0; i < 3; ++i) {
                             flux.at[q][d][i] = pull.at[i][d];
                           }
                         }
                       });
    assemble(pack, flux, held, force.data());
  }
}

template <class Law>
void PackedHexahedra::elastic_energy(const Law& law, PackRange range, std::span<const NodeState> state,
                                     std::span<double> energy) const {
  Fields fields;
  for (std::size_t pack = range.begin; pack < range.end; ++pack) {
    gather(law, pack, state.data(), fields);
    Pack sum = {};
    differentiate<Law>(pack, fields,
                       [&](int point, const PackMatrix& h, const PackMatrix& delayed, const Geometry& geometry) {
                         const auto q = static_cast<std::size_t>(point);
                         sum += weight_[q] * geometry.determinant * law.energy_density(h, delayed, pack * points() + q);
                       });
    for (int lane = 0; lane < layout_.filled_lanes(pack); ++lane) {
      energy[layout_.first_element(pack) + static_cast<std::size_t>(lane)] = sum[lane];
    }
  }
}

}  // namespace idiophone::solid
