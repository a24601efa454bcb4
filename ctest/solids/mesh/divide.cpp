// Meshes of bodies that can break.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "block_mesh.hpp"
#include "owners.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using Inside = std::function<bool(const Vector3&)>;

const Vector3 block_size(0.4, 0.2, 0.2);  // m

bool on_x(const Vector3& node) {
  return std::abs(node.x() - block_size.x() / 2) < 1e-9;
}
bool on_y(const Vector3& node) {
  return std::abs(node.y() - block_size.y() / 2) < 1e-9;
}

/// A block and its fracture surfaces "0", "1", ...
struct Breakable {
  explicit Breakable(const std::vector<Inside>& surfaces)
      : mesh(support::block_mesh(element::tet10, block_size, {4, 2, 2})) {
    body.name = "block";
    body.element = element::tet10;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      name(std::to_string(s));
      for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
        if (surfaces[s](mesh.nodes[node])) {
          mesh.groups[std::to_string(s)].push_back(static_cast<Index>(node));
        }
      }
    }
  }

  void name(const std::string& group) {
    body.fracture.push_back({.group = group, .strength = 1e6, .where = {.file = "deck.yaml", .line = 9, .column = 5}});
  }

  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(divide(mesh, body));
      return "";
    } catch (const deck::DeckError& error) {
      return error.what();
    }
  }

  Mesh mesh;
  scene::Body body;
};

std::size_t count_if(const std::vector<Vector3>& nodes, const Inside& inside) {
  return static_cast<std::size_t>(std::ranges::count_if(nodes, inside));
}

/// How often nodes are in each place.
std::size_t nodes_at(const Mesh& mesh, const Vector3& place) {
  return count_if(mesh.nodes, [&](const Vector3& node) { return (node - place).norm() < 1e-9; });
}

double area_of(std::span<const Triangle> triangles, const Mesh& mesh) {
  const std::vector<double> areas = nodal_areas(triangles, mesh.nodes);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

Vector3 twice_area(const Mesh& mesh, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return (mesh.nodes[b] - mesh.nodes[a]).cross(mesh.nodes[c] - mesh.nodes[a]);
}

ON_RANKS(1);

TEST(Divide, GivesBothSidesOfASurfaceNodesOfTheirOwn) {
  const Breakable block({on_x});
  const Mesh divided = divide(block.mesh, block.body);
  const std::size_t shared = count_if(block.mesh.nodes, on_x);
  EXPECT_EQ(divided.nodes.size(), block.mesh.nodes.size() + shared);
  EXPECT_EQ(divided.groups.at("0").size(), 2 * shared);
  EXPECT_EQ(divided.groups.at("x0").size(), block.mesh.groups.at("x0").size());
  EXPECT_EQ(divided.element_count(), block.mesh.element_count());
  EXPECT_NE(divided.hash, block.mesh.hash);
  std::array<std::set<Index>, 2> halves;
  for (Index element = 0; element < divided.element_count(); ++element) {
    double middle = 0.0;
    for (const Index node : divided.element_nodes(element)) {
      middle += divided.nodes[node].x() / 10;
    }
    halves.at(middle > block_size.x() / 2 ? 1 : 0)
        .insert(divided.element_nodes(element).begin(), divided.element_nodes(element).end());
  }
  EXPECT_EQ(halves[0].size() + halves[1].size(), divided.nodes.size());  // none is in both
}

TEST(Divide, KeepsTheOuterSurfaceAndAddsBothFaces) {
  const Breakable block({on_x});
  const Mesh divided = divide(block.mesh, block.body);
  EXPECT_EQ(divided.outer_surface().size(), block.mesh.surface.size());
  EXPECT_TRUE(std::ranges::is_sorted(divided.outer_surface()));
  EXPECT_NEAR(area_of(divided.outer_surface(), divided), area_of(block.mesh.surface, block.mesh), 1e-12);
  ASSERT_EQ(divided.fracture_faces.size(), 8U);  // two of each of 2 x 2 cells
  const std::span<const Triangle> inner = std::span(divided.surface).subspan(divided.outer_surface().size());
  ASSERT_EQ(inner.size(), 8 * divided.fracture_faces.size());
  EXPECT_NEAR(area_of(inner, divided), 2 * block_size.y() * block_size.z(), 1e-12);
  for (std::size_t f = 0; f < divided.fracture_faces.size(); ++f) {
    const auto& sides = divided.fracture_faces[f].nodes;
    const Vector3 out_of_0 = twice_area(divided, {sides[0][0], sides[0][1], sides[0][2]});
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NE(sides[0].at(k), sides[1].at(k));
      EXPECT_EQ(divided.nodes[sides[0].at(k)], divided.nodes[sides[1].at(k)]);
    }
    for (std::size_t t = 0; t < 8; ++t) {
      const Triangle& triangle = inner[8 * f + t];
      EXPECT_NEAR(twice_area(divided, triangle).dot(out_of_0) / out_of_0.squaredNorm(), t < 4 ? 0.25 : -0.25, 1e-12);
      for (const Index node : triangle) {
        EXPECT_NE(std::ranges::find(sides.at(t / 4), node), sides.at(t / 4).end());
      }
    }
  }
}

TEST(Divide, MakesFourNodesWhereSurfacesCross) {
  const Breakable block({on_x, on_y});
  const Mesh divided = divide(block.mesh, block.body);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.1, 0.1}), 4U);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.05, 0.1}), 2U);
  EXPECT_EQ(nodes_at(divided, {0.1, 0.1, 0.1}), 2U);
  EXPECT_EQ(nodes_at(divided, {0.1, 0.05, 0.1}), 1U);
}

TEST(Divide, LeavesTheRimOfASurfaceInsideTheBodyJoined) {
  const Breakable block({[](const Vector3& node) { return on_x(node) && node.y() < 0.1 + 1e-9; }});
  const Mesh divided = divide(block.mesh, block.body);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.1, 0.1}), 1U);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.05, 0.1}), 2U);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.15, 0.1}), 1U);
}

TEST(Divide, OneRankOwnsAllNodesOfTheSurfaces) {
  const Breakable block({on_x, on_y});
  const std::vector<Mesh> meshes = {divide(block.mesh, block.body)};
  const std::vector<int> owners = node_owners(meshes, 3);
  std::set<int> of_surfaces;
  for (const FractureFace& face : meshes[0].fracture_faces) {
    for (const auto& side : face.nodes) {
      std::ranges::for_each(side, [&](Index node) { of_surfaces.insert(owners[node]); });
    }
  }
  EXPECT_EQ(of_surfaces.size(), 1U);
  EXPECT_EQ(std::set<int>(owners.begin(), owners.end()).size(), 3U);
}

TEST(Divide, RefusesWhatIsNoSurfaceInside) {
  Breakable block({on_x});
  block.name("nowhere");
  EXPECT_EQ(block.refusal().find("deck.yaml:9:5: the mesh has no group 'nowhere'"), 0U) << block.refusal();
  block.body.fracture.pop_back();
  block.name("x0");
  EXPECT_EQ(
      block.refusal(),
      "deck.yaml:9:5: bodies.block.fracture: the surface 'x0' has faces on the outside of the body, where nothing "
      "joins");
  block.body.fracture.pop_back();
  block.mesh.groups["line"] = {block.mesh.groups.at("0")[0], block.mesh.groups.at("0")[1]};
  block.name("line");
  EXPECT_EQ(block.refusal(),
            "deck.yaml:9:5: bodies.block.fracture: the surface 'line' has no faces inside the body: name a Physical "
            "Surface of gmsh that is embedded in the volume, or lies between two volumes");
  block.body.fracture.pop_back();
  block.mesh.groups["again"] = block.mesh.groups.at("0");
  block.name("again");
  EXPECT_EQ(block.refusal(), "deck.yaml:9:5: bodies.block.fracture: the surface 'again' shares faces with '0'");
}

TEST(Divide, RefusesASurfaceThatDividesNothing) {
  Breakable block({on_x});
  const Mesh whole = divide(block.mesh, block.body);
  const auto is_inside = [&](Index node) {
    const Vector3& place = whole.nodes[node];
    return std::min(place.y(), place.z()) > 1e-9 && std::max(place.y(), place.z()) < block_size.y() - 1e-9;
  };
  // One face all of whose edges are inside the body: all of it is its rim.
  const auto face = std::ranges::find_if(whole.fracture_faces, [&](const FractureFace& each) {
    return std::all_of(each.nodes[0].begin() + 3, each.nodes[0].end(), is_inside);
  });
  ASSERT_NE(face, whole.fracture_faces.end());
  const auto of_face = [&](Index node) {
    return std::ranges::any_of(face->nodes[0], [&](Index k) { return whole.nodes[k] == block.mesh.nodes[node]; });
  };
  std::erase_if(block.mesh.groups.at("0"), [&](Index node) { return !of_face(node); });
  EXPECT_EQ(
      block.refusal(),
      "deck.yaml:9:5: bodies.block.fracture: the surface '0' divides nothing: all its nodes are on its rim inside "
      "the body. Make it finer");
}

TEST(Divide, RefusesAFaceWithCrossingsAtAllEdges) {
  const auto is_outside = [](const Vector3& node) {
    return node.minCoeff() < 1e-9 || (block_size - node).minCoeff() < 1e-9;
  };
  const auto is_corner = [](const Vector3& node) {
    return (node / 0.1 - (node / 0.1).array().round().matrix()).norm() < 1e-9;
  };
  // All faces inside the body that have no edge on its outside.
  const Breakable block({[&](const Vector3& node) { return is_corner(node) || !is_outside(node); }});
  EXPECT_NE(block.refusal().find("the surface '0' is too coarse at"), std::string::npos) << block.refusal();
}

}  // namespace
}  // namespace idiophone::mesh
