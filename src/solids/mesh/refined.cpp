#include "idiophone/solids/mesh/refined.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/solids/mesh/faces.hpp"

namespace idiophone::mesh {

namespace {

/// Where an element of the refined mesh lies in the reference element of the given one: origin + axes xi.
struct Child {
  Vector3 origin = Vector3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// What each element becomes.
struct Refinement {
  element::Type type;
  std::vector<Child> children;
};

Refinement eight_tetrahedra() {
  Refinement refinement{.type = element::tet10, .children = {}};
  const element::ReferenceElement& parent = element::reference(element::tet10);
  for (const auto& corners : parent.straight_tetrahedra) {
    Child& child = refinement.children.emplace_back();
    child.origin = parent.nodes[corners[0]];
    for (int k = 0; k < 3; ++k) {
      child.axes.col(k) = parent.nodes[corners[k + 1]] - child.origin;
    }
  }
  return refinement;
}

Refinement higher_hexahedra(element::Type type) {
  const auto raised = [](int order) { return std::min(order + 1, element::highest_hex_order); };
  const auto pieces = [](int order) { return order < element::highest_hex_order ? 1 : 2; };
  const std::array<int, 3> counts = {pieces(type.plane), pieces(type.plane), pieces(type.thickness)};
  Refinement refinement{.type = element::hex(raised(type.plane), raised(type.thickness)), .children = {}};
  for (int number = 0; number < counts[0] * counts[1] * counts[2]; ++number) {
    const std::array<int, 3> at = {number % counts[0], number / counts[0] % counts[1],
                                   number / (counts[0] * counts[1])};
    Child& child = refinement.children.emplace_back();
    for (int d = 0; d < 3; ++d) {
      child.axes(d, d) = 1.0 / counts[d];
      child.origin[d] = (2 * at[d] + 1.0) / counts[d] - 1;  // the reference cube goes from -1 to 1
    }
  }
  return refinement;
}

Refinement refinement_of(element::Type type) {
  switch (type.kind) {
    case element::Kind::tet4:
      return {.type = element::tet10, .children = {Child{}}};
    case element::Kind::tet10:
      return eight_tetrahedra();
    case element::Kind::hex:
      return higher_hexahedra(type);
  }
  element::unknown_kind();
}

/// [children x nodes of a child] the shape functions of the given element at each node of its children.
std::vector<Eigen::VectorXd> functions_at_nodes(element::Type type, const Refinement& refinement) {
  std::vector<Eigen::VectorXd> functions;
  for (const Child& child : refinement.children) {
    for (const Vector3& xi : element::reference(refinement.type).nodes) {
      functions.push_back(element::shape_functions(type, child.origin + child.axes * xi));
    }
  }
  return functions;
}

std::vector<Parent> parents_of(std::span<const Index> nodes, const Eigen::VectorXd& functions) {
  constexpr double rounding = 1e-9;
  std::vector<Parent> parents;
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    const double weight = functions[static_cast<Eigen::Index>(a)];
    if (std::abs(weight) > rounding) {
      parents.push_back({nodes[a], weight});
    }
  }
  std::ranges::sort(parents, {}, &Parent::node);
  return parents;
}

/// Numbers nodes as elements bring them. Elements that share a face see the same parents with the same weights there.
class RefinedNodes {
 public:
  /// @return the number of the node with these parents
  Index number_of(std::vector<Parent> parents) {
    Key key;
    std::ranges::transform(parents, std::back_inserter(key), [](const Parent& parent) {
      return std::pair(parent.node, std::lround(1e6 * parent.weight));
    });
    const auto [known, is_new] = numbers_.emplace(std::move(key), static_cast<Index>(nodes.size()));
    if (is_new) {
      nodes.push_back(std::move(parents));
    }
    return known->second;
  }

  std::vector<std::vector<Parent>> nodes;

 private:
  using Key = std::vector<std::pair<Index, long>>;
  std::map<Key, Index> numbers_;
};

Vector3 place_of(const std::vector<Parent>& parents, const std::vector<Vector3>& nodes) {
  Vector3 place = Vector3::Zero();
  for (const Parent& parent : parents) {
    place += parent.weight * nodes[parent.node];
  }
  return place;
}

/// The refined nodes all of whose parents are in a group, ascending.
std::vector<Index> refined_group(const std::vector<Index>& group, const std::vector<std::vector<Parent>>& nodes) {
  const auto is_in_group = [&](const Parent& parent) { return std::ranges::binary_search(group, parent.node); };
  std::vector<Index> result;
  for (Index node = 0; node < std::ssize(nodes); ++node) {
    if (std::ranges::all_of(nodes[node], is_in_group)) {
      result.push_back(node);
    }
  }
  return result;
}

}  // namespace

RefinedMesh refined(const Mesh& mesh) {
  const Refinement refinement = refinement_of(mesh.element);
  const std::vector<Eigen::VectorXd> functions = functions_at_nodes(mesh.element, refinement);
  RefinedMesh result;
  result.mesh.element = refinement.type;
  RefinedNodes numbered;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    for (const Eigen::VectorXd& values : functions) {
      result.mesh.elements.push_back(numbered.number_of(parents_of(mesh.element_nodes(element), values)));
    }
    if (!mesh.regions.empty()) {
      result.mesh.regions.insert(result.mesh.regions.end(), refinement.children.size(), mesh.regions[element]);
    }
  }
  for (const auto& parents : numbered.nodes) {
    result.mesh.nodes.push_back(place_of(parents, mesh.nodes));
  }
  for (const auto& [name, nodes] : mesh.groups) {
    result.mesh.groups[name] = refined_group(nodes, numbered.nodes);
  }
  result.mesh.surface = exterior_triangles(result.mesh);
  result.mesh.indivisible = mesh.indivisible;
  result.parents = std::move(numbered.nodes);
  return result;
}

double refined_entries(const Mesh& mesh) {
  const Refinement refinement = refinement_of(mesh.element);
  const auto components = 3.0 * static_cast<double>(element::reference(refinement.type).nodes.size());
  return static_cast<double>(mesh.element_count()) * static_cast<double>(refinement.children.size()) * components *
         components;
}

double refined_nodes(element::Type type) {
  const Refinement refinement = refinement_of(type);
  const auto nodes = [](element::Type of) { return static_cast<double>(element::reference(of).nodes.size()); };
  return static_cast<double>(refinement.children.size()) * nodes(refinement.type) / nodes(type);
}

}  // namespace idiophone::mesh
