#include "idiophone/solid/packed_elements.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace idiophone::solid {

namespace {

using ElementNodes = std::span<const Index>;
using Positions = std::span<const Vector3>;

const Vector3& position(Positions reference, ElementNodes nodes, int a) {
  return reference[static_cast<std::size_t>(nodes[static_cast<std::size_t>(a)])];
}

/// J[i][k] = dX_i/dxi_k at a quadrature point.
template <class Element>
Eigen::Matrix3d jacobian(int point, ElementNodes nodes, Positions reference) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (int a = 0; a < Element::nodes; ++a) {
    for (int k = 0; k < 3; ++k) {
      j.col(k) += Element::gradient(point, a, k) * position(reference, nodes, a);
    }
  }
  return j;
}

/// Whether every edge node lies in the middle of its edge, to round-off: then the Jacobian is the same everywhere.
template <class Element>
bool straight_sided(ElementNodes nodes, Positions reference) {
  for (int edge = 4; edge < Element::nodes; ++edge) {
    const auto [i, j] = Tet10::edges[static_cast<std::size_t>(edge - 4)];
    const Vector3& a = position(reference, nodes, i);
    const Vector3& b = position(reference, nodes, j);
    if ((position(reference, nodes, edge) - (a + b) / 2).norm() > 1e-10 * (a - b).norm()) {
      return false;
    }
  }
  return true;
}

/// The motion of one node of eight elements: displacement 0 1 2, velocity 3 4 5.
inline void gather(const NodeState* state, const Index (&nodes)[lanes], Pack (&rows)[lanes]) {
  for (int lane = 0; lane < lanes; ++lane) {
    std::memcpy(&rows[lane], &state[nodes[lane]], sizeof(Pack));
  }
  transpose(rows);
}

/// d field/d xi at every quadrature point, [points], from the components of a nodal field.
template <class Element>
inline void differentiate(const Pack (&field)[3][Element::nodes], PackMatrix (&gradient)[Element::points]) {
  for (int i = 0; i < 3; ++i) {
    Pack slope[Element::points][3];
    Element::differentiate(field[i], slope);
    for (int q = 0; q < Element::points; ++q) {
      std::copy(slope[q], slope[q] + 3, gradient[q].at[i]);
    }
  }
}

/// Adds the forces of a pack to its nodes: element after element, so that a node's sum has the same order on any rank.
template <class Element>
inline void scatter(const Pack (&force)[3][Element::nodes], const Index (&nodes)[Element::nodes][lanes], int filled,
                    NodeForce* target) {
  using Line = double __attribute__((vector_size(4 * sizeof(double))));
  Line lines[lanes][Element::nodes];
  for (int a = 0; a < Element::nodes; a += 2) {
    Pack rows[lanes] = {force[0][a],     force[1][a],     force[2][a],     {},
                        force[0][a + 1], force[1][a + 1], force[2][a + 1], {}};
    transpose(rows);
    for (int lane = 0; lane < lanes; ++lane) {
      std::memcpy(&lines[lane][a], &rows[lane], sizeof(Pack));
    }
  }
  for (int lane = 0; lane < filled; ++lane) {
    for (int a = 0; a < Element::nodes; ++a) {
      auto* component = static_cast<double*>(__builtin_assume_aligned(target[nodes[a][lane]].component, sizeof(Line)));
      Line sum;
      std::memcpy(&sum, component, sizeof(Line));
      sum += lines[lane][a];
      std::memcpy(component, &sum, sizeof(Line));
    }
  }
}

}  // namespace

template <class Element>
PackedElements<Element>::PackedElements(const mesh::BodyPart& part, Positions reference)
    : packs_((part.element_ids.size() + lanes - 1) / lanes), count_(static_cast<Index>(part.element_ids.size())) {
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t element = std::min(number * lanes + lane, part.element_ids.size() - 1);
      for (std::size_t a = 0; a < Element::nodes; ++a) {
        packs_[number].nodes[a][lane] = part.elements[element * Element::nodes + a];
      }
    }
    add_geometry(packs_[number], number * lanes, part, reference);
  }
}

template <class Element>
void PackedElements<Element>::add_geometry(ElementPack& pack, std::size_t first, const mesh::BodyPart& part,
                                           Positions reference) {
  Geometry points[Element::points];
  bool straight = true;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t element = std::min(first + lane, part.element_ids.size() - 1);
    const ElementNodes nodes = std::span(part.elements).subspan(element * Element::nodes, Element::nodes);
    const bool element_straight = straight_sided<Element>(nodes, reference);
    straight = straight && element_straight;
    for (int q = 0; q < Element::points; ++q) {
      // A straight element has the same bits at all its points, so it doesn't matter who shares its pack.
      const Eigen::Matrix3d j =
          element_straight ? jacobian<Tet4>(0, nodes, reference) : jacobian<Element>(q, nodes, reference);
      const double determinant = j.determinant();
      if (!(determinant > 0)) {
        throw std::runtime_error(
            fmt::format("element {} is inverted or degenerate: its Jacobian is {:.3g} m3 at a quadrature point",
                        part.element_ids[element], determinant));
      }
      const Eigen::Matrix3d inverse = j.inverse();
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
          points[q].inverse_jacobian.at[k][i][lane] = inverse(k, i);
        }
      }
      points[q].weight[lane] = first + lane == element ? Element::weight * determinant : 0.0;
    }
  }
  pack.geometry = geometry_.size();
  pack.stride = straight ? 0 : 1;
  geometry_.insert(geometry_.end(), points, points + (straight ? 1 : Element::points));
}

template <class Element>
int PackedElements<Element>::filled_lanes(std::size_t pack) const {
  return static_cast<int>(std::min<std::size_t>(lanes, static_cast<std::size_t>(count_) - pack * lanes));
}

template <class Element>
void PackedElements<Element>::add_internal_force(const ElasticLaw& law, const NodeState* state,
                                                 NodeForce* force) const {
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    prefetch(number + prefetch_distance, state, force);
    const ElementPack& pack = packs_[number];
    Pack displacement[3][Element::nodes];
    Pack delayed[3][Element::nodes];  // u + beta v
    for (int a = 0; a < Element::nodes; ++a) {
      Pack rows[lanes];
      gather(state, pack.nodes[a], rows);
      for (int i = 0; i < 3; ++i) {
        displacement[i][a] = rows[i];
        delayed[i][a] = rows[i] + law.beta * rows[i + 3];
      }
    }
    PackMatrix gradient[Element::points];
    PackMatrix delayed_gradient[Element::points];
    differentiate<Element>(displacement, gradient);
    differentiate<Element>(delayed, delayed_gradient);

    Pack flux[3][Element::points][3];  // w P (dxi/dX)^T, component by component
    for (int q = 0; q < Element::points; ++q) {
      const auto& [inverse, weight] = geometry(pack, q);
      const PackMatrix stress =
          law.stress(multiply(gradient[q], inverse), multiply(delayed_gradient[q], inverse), -weight);
      const PackMatrix pull = multiply_transposed(stress, inverse);
      for (int i = 0; i < 3; ++i) {
        std::copy(pull.at[i], pull.at[i] + 3, flux[i][q]);
      }
    }
    Pack nodal[3][Element::nodes];
    for (int i = 0; i < 3; ++i) {
      Element::assemble(flux[i], nodal[i]);
    }
    scatter<Element>(nodal, pack.nodes, filled_lanes(number), force);
  }
}

template <class Element>
void PackedElements<Element>::prefetch(std::size_t number, const NodeState* state, const NodeForce* force) const {
  if (number < packs_.size()) {
    for (const auto& nodes : packs_[number].nodes) {
      for (const Index node : nodes) {
        __builtin_prefetch(&state[node]);
        __builtin_prefetch(&force[node], 1);
      }
    }
  }
}

template <class Element>
void PackedElements<Element>::elastic_energy(const ElasticLaw& law, const NodeState* state,
                                             std::span<double> energy) const {
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    const ElementPack& pack = packs_[number];
    Pack displacement[3][Element::nodes];
    for (int a = 0; a < Element::nodes; ++a) {
      Pack rows[lanes];
      gather(state, pack.nodes[a], rows);
      for (int i = 0; i < 3; ++i) {
        displacement[i][a] = rows[i];
      }
    }
    PackMatrix gradient[Element::points];
    differentiate<Element>(displacement, gradient);
    Pack sum = {};
    for (int q = 0; q < Element::points; ++q) {
      const auto& [inverse, weight] = geometry(pack, q);
      sum += weight * law.energy_density(multiply(gradient[q], inverse));
    }
    for (int lane = 0; lane < filled_lanes(number); ++lane) {
      energy[number * lanes + static_cast<std::size_t>(lane)] = sum[lane];
    }
  }
}

template <class Element>
void PackedElements<Element>::add_mass(double density, std::span<double> mass) const {
  for (std::size_t number = 0; number < packs_.size(); ++number) {
    const ElementPack& pack = packs_[number];
    Pack volume = {};
    for (int q = 0; q < Element::points; ++q) {
      volume += geometry(pack, q).weight;
    }
    for (int lane = 0; lane < filled_lanes(number); ++lane) {
      for (int a = 0; a < Element::nodes; ++a) {
        mass[static_cast<std::size_t>(pack.nodes[a][lane])] +=
            Element::mass_share[a < 4 ? 0 : 1] * density * volume[lane];
      }
    }
  }
}

template class PackedElements<Tet4>;
template class PackedElements<Tet10>;

}  // namespace idiophone::solid
