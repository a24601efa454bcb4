#include "element_tables.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/solid/memory.hpp"

namespace idiophone::accelerated {

namespace {

using Eigen::Matrix3d;

/// J[i][k] = dX_i/dxi_k at each quadrature point.
std::vector<Matrix3d> jacobians(const element::ReferenceElement& type, std::span<const Index> nodes,
                                std::span<const Vector3> reference) {
  std::vector<Matrix3d> all;
  for (const element::QuadraturePoint& point : type.quadrature) {
    Matrix3d& jacobian = all.emplace_back(Matrix3d::Zero());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      jacobian += reference[nodes[a]] * point.gradient.row(static_cast<Eigen::Index>(a));
    }
  }
  return all;
}

bool are_same(const std::vector<Matrix3d>& jacobians) {
  return std::ranges::all_of(
      jacobians, [&](const Matrix3d& j) { return (j - jacobians.front()).norm() <= 1e-10 * jacobians.front().norm(); });
}

}  // namespace

GeometryTable geometry_table(const mesh::BodyPart& body, std::span<const Vector3> reference) {
  const element::ReferenceElement& type = element::reference(body.element);
  GeometryTable table;
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    std::vector<Matrix3d> all = jacobians(type, body.element_nodes(element), reference);
    const auto first = static_cast<Index>(table.values.size() / 10);
    const bool same = are_same(all);
    table.first.push_back(same ? -1 - first : first);
    all.resize(same ? 1 : all.size());
    for (const Matrix3d& jacobian : all) {
      const Matrix3d inverse = jacobian.inverse();
      for (int k = 0; k < 3; ++k) {
        table.values.insert(table.values.end(), {inverse(k, 0), inverse(k, 1), inverse(k, 2)});
      }
      table.values.push_back(jacobian.determinant());
    }
  }
  return table;
}

NodeElements node_elements(std::span<const Index> nodes, Index count) {
  NodeElements table;
  table.first.resize(count + 1);
  for (const Index node : nodes) {
    if (node < count) {
      ++table.first[node + 1];
    }
  }
  for (Index node = 0; node < count; ++node) {
    table.first[node + 1] += table.first[node];
  }
  table.places.resize(table.first.back());
  std::vector<Index> next = table.first;
  for (std::size_t place = 0; place < nodes.size(); ++place) {
    if (nodes[place] < count) {
      table.places[next[nodes[place]]++] = static_cast<Index>(place);
    }
  }
  return table;
}

LawSize law_size(const solid::Solid& solid) {
  LawSize size;
  for (std::size_t region = 0; region < solid.region_count(); ++region) {
    const auto mechanisms = static_cast<int>(solid.relaxation(region).mechanisms.size());
    size.mechanisms = std::max(size.mechanisms, mechanisms);
    size.has_rates = size.has_rates || mechanisms > 0 || solid.stiffness_damping(region) > 0;
  }
  return size;
}

std::vector<double> material_table(const solid::Solid& solid, const LawSize& size, double step) {
  std::vector<double> table;
  for (std::size_t region = 0; region < solid.region_count(); ++region) {
    const solid::Relaxation& relaxation = solid.relaxation(region);
    const bool remembers = !relaxation.mechanisms.empty();
    const solid::StiffnessMatrix stiffness =
        stiffness_matrix(remembers ? solid.elasticity(region) : solid.relaxed_elasticity(region));
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        table.push_back(stiffness(i, j));
      }
    }
    const Matrix3d& stress = solid.initial_stress(region);
    for (const auto& [i, j] : solid::direction_pairs) {
      table.push_back(stress(i, j));
    }
    const solid::Memory memory(relaxation, solid.stiffness_damping(region), step, {}, 0);
    table.push_back(remembers ? memory.long_term() : 0.0);
    table.push_back(remembers ? memory.damping() : solid.stiffness_damping(region));
    for (const auto& mechanism : memory.mechanisms()) {
      table.insert(table.end(), {mechanism.keep, mechanism.gain});
    }
    table.resize((region + 1) * static_cast<std::size_t>(material_length(size)));
  }
  return table;
}

}  // namespace idiophone::accelerated
