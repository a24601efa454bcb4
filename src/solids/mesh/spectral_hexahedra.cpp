#include "spectral_hexahedra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "checks.hpp"
#include "idiophone/foundation/element/lagrange.hpp"
#include "idiophone/foundation/element/lobatto.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "thickness_direction.hpp"

namespace idiophone::mesh {

namespace {

using GridIndex = std::array<int, 3>;  ///< along the directions of gmsh's element

/// A spectral hexahedron within gmsh's, its third direction along one of gmsh's.
struct Embedding {
  Embedding(element::Type type, int geometry_order, int thickness_direction)
      : geometry(geometry_order),
        functions(element::node_count(type), element::node_count(element::hex(geometry_order, geometry_order))) {
    const GridIndex axes = {(thickness_direction + 1) % 3, (thickness_direction + 2) % 3, thickness_direction};
    for (int a = 0; a < 3; ++a) {
      orders[axes[a]] = a < 2 ? type.plane : type.thickness;
    }
    for (const int k : numbers(type.thickness)) {
      for (const int j : numbers(type.plane)) {
        for (const int i : numbers(type.plane)) {
          GridIndex at{};
          at[axes[0]] = i;
          at[axes[1]] = j;
          at[axes[2]] = k;
          places.push_back(at);
        }
      }
    }
    for (std::size_t a = 0; a < places.size(); ++a) {
      functions.row(static_cast<Eigen::Index>(a)) = functions_at(places[a]);
    }
  }

  /// gmsh's node at a place of its grid.
  [[nodiscard]] int geometry_node(const GridIndex& at) const {
    return at[0] + (geometry + 1) * (at[1] + (geometry + 1) * at[2]);
  }

  int geometry;                   ///< order of gmsh's element
  GridIndex orders{};             ///< of the spectral element
  std::vector<GridIndex> places;  ///< [nodes]
  Eigen::MatrixXd functions;      ///< [nodes x gmsh's nodes] shape functions of gmsh's nodes

 private:
  static std::vector<int> numbers(int last) {
    std::vector<int> result;
    for (int i = 0; i <= last; ++i) {
      result.push_back(i);
    }
    return result;
  }

  [[nodiscard]] Eigen::RowVectorXd functions_at(const GridIndex& at) const {
    const Eigen::VectorXd nodes = element::evenly_spaced_nodes(geometry);
    std::array<Eigen::VectorXd, 3> lines;
    for (int d = 0; d < 3; ++d) {
      lines[d] = element::lagrange(nodes, element::lobatto(orders[d]).nodes[at[d]]).values;
    }
    Eigen::RowVectorXd row(functions.cols());
    for (int k = 0; k <= geometry; ++k) {
      for (int j = 0; j <= geometry; ++j) {
        for (int i = 0; i <= geometry; ++i) {
          row[geometry_node({i, j, k})] = lines[0][i] * lines[1][j] * lines[2][k];
        }
      }
    }
    return row;
  }
};

/// What all elements that have a node agree on: it lies at a vertex, within an edge, within a face or within a cell. Of
/// that one's corners the lowest numbered, the neighbours of this corner along it, ascending, and the number of steps
/// towards each.
using Key = std::pair<Index, std::array<std::pair<Index, int>, 3>>;

Key key_of(const Embedding& embedding, std::span<const Index> nodes, const GridIndex& at) {
  const auto corner = [&](const GridIndex& end) {
    GridIndex place{};
    std::ranges::transform(end, place.begin(), [&](int upper) { return upper * embedding.geometry; });
    return nodes[embedding.geometry_node(place)];
  };
  const auto is_within = [&](int d) { return at[d] != 0 && at[d] != embedding.orders[d]; };
  GridIndex origin{};
  std::ranges::transform(at, origin.begin(), [](int steps) { return steps == 0 ? 0 : 1; });
  for (int choice = 0; choice < 8; ++choice) {
    GridIndex end = origin;
    for (int d = 0; d < 3; ++d) {
      end[d] = is_within(d) ? choice >> d & 1 : end[d];
    }
    origin = corner(end) < corner(origin) ? end : origin;
  }
  Key key{corner(origin), {}};
  key.second.fill({-1, 0});
  for (int d = 0; d < 3; ++d) {
    if (is_within(d)) {
      GridIndex neighbour = origin;
      neighbour[d] = 1 - origin[d];
      key.second[d] = {corner(neighbour), origin[d] == 0 ? at[d] : embedding.orders[d] - at[d]};
    }
  }
  std::ranges::sort(key.second);
  return key;
}

/// One of gmsh's nodes within the same vertex, edge, face or cell.
Index representative(const Embedding& embedding, std::span<const Index> nodes, const GridIndex& at) {
  GridIndex place{};
  for (int d = 0; d < 3; ++d) {
    place[d] = at[d] == 0 ? 0 : (at[d] == embedding.orders[d] ? embedding.geometry : 1);
  }
  return nodes[embedding.geometry_node(place)];
}

/// Numbers nodes as elements bring them.
class NodeNumbers {
 public:
  NodeNumbers(const scene::Body& body, const GmshMesh& geometry) : body_(body), geometry_(geometry) {
    for (const Vector3& node : geometry.mesh.nodes) {
      size_ = std::max(size_, (node - geometry.mesh.nodes.front()).norm());
    }
    result.mesh.element = body.element;
    result.element_tags = geometry.element_tags;
    result.element_groups = geometry.element_groups;
    result.made_here = geometry.made_here;
    result.mesh.notes = geometry.mesh.notes;
    result.mesh.regions = geometry.mesh.regions;
  }

  void add(Index element, const Embedding& embedding) {
    const auto nodes = geometry_.mesh.element_nodes(element);
    Eigen::MatrixX3d corners(nodes.size(), 3);
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      corners.row(static_cast<Eigen::Index>(a)) = geometry_.mesh.nodes[nodes[a]];
    }
    const Eigen::MatrixX3d positions = embedding.functions * corners;
    for (std::size_t a = 0; a < embedding.places.size(); ++a) {
      const Vector3 position = positions.row(static_cast<Eigen::Index>(a));
      const auto [known, is_new] = numbers_.emplace(key_of(embedding, nodes, embedding.places[a]), std::ssize(owners_));
      const Index number = known->second;
      if (is_new) {
        owners_.push_back(element);
        representatives.push_back(representative(embedding, nodes, embedding.places[a]));
        result.mesh.nodes.push_back(position);
        result.node_tags.push_back(geometry_.node_tags[representatives.back()]);
      } else if (!((position - result.mesh.nodes[number]).norm() <= 1e-9 * size_)) {
        refuse_elements(body_, geometry_, {owners_[number], element},
                        "has elements that share the corners of an edge or a face, which isn't the same in both "
                        "(more cells may help)");
      }
      result.mesh.elements.push_back(number);
    }
  }

  GmshMesh result;
  std::vector<Index> representatives;  ///< [nodes]

 private:
  const scene::Body& body_;
  const GmshMesh& geometry_;
  double size_ = 0.0;  ///< of the body, m
  std::map<Key, Index> numbers_;
  std::vector<Index> owners_;  ///< [nodes] the first element that has it
};

}  // namespace

GmshMesh spectral_mesh(const scene::Body& body, const GmshMesh& geometry) {
  const int order = geometry.mesh.element.plane;
  const std::array<Embedding, 3> embeddings = {Embedding(body.element, order, 0), Embedding(body.element, order, 1),
                                               Embedding(body.element, order, 2)};
  const std::vector<int> directions = thickness_directions(body, geometry);
  NodeNumbers numbers(body, geometry);
  for (Index element = 0; element < geometry.mesh.element_count(); ++element) {
    numbers.add(element, embeddings[directions[element]]);
  }
  for (const auto& [name, nodes] : geometry.mesh.groups) {
    auto& group = numbers.result.mesh.groups[name];
    for (Index node = 0; node < std::ssize(numbers.representatives); ++node) {
      if (std::ranges::binary_search(nodes, numbers.representatives[node])) {
        group.push_back(node);
      }
    }
  }
  return std::move(numbers.result);
}

}  // namespace idiophone::mesh
