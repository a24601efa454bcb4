// Meshes of bodies that can break.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "breakable_block.hpp"
#include "owners.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

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
  ASSERT_EQ(inner.size(), triangle_count(divided.fracture_faces));
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

TEST(Divide, NumbersThePiecesThatABodyCanFallInto) {
  const Mesh halves = divide(Breakable({on_x}).mesh, Breakable({on_x}).body);
  EXPECT_EQ(halves.piece_count(), 2);
  EXPECT_EQ(halves.pieces.front(), 0);
  for (Index element = 0; element < halves.element_count(); ++element) {
    for (const Index node : halves.element_nodes(element)) {
      EXPECT_EQ(halves.pieces[node], halves.pieces[halves.element_nodes(element)[0]]);
    }
  }
  for (const FractureFace& face : halves.fracture_faces) {
    EXPECT_NE(halves.pieces[face.nodes[0][0]], halves.pieces[face.nodes[1][0]]);
  }
  EXPECT_EQ(divide(Breakable({on_x, on_y}).mesh, Breakable({on_x, on_y}).body).piece_count(), 4);
  const Breakable cracked({[](const Vector3& node) { return on_x(node) && node.y() < 0.1 + 1e-9; }});
  EXPECT_EQ(divide(cracked.mesh, cracked.body).piece_count(), 0);  // it stays in one piece
}

// All corners of these linear tetrahedra lie on surfaces, as they do where surfaces meet at an angle.
TEST(Divide, LinearTetrahedraHaveTheTrianglesOfTheGroup) {
  Breakable block({on_x}, element::tet4);
  std::vector<Index> all(block.mesh.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  block.mesh.groups["0"] = all;
  const Mesh divided = divide(block.mesh, block.body);
  EXPECT_EQ(divided.fracture_faces.size(), 8U);  // two of each of 2 x 2 cells
  EXPECT_EQ(divided.nodes.size(), block.mesh.nodes.size() + 9);
  EXPECT_EQ(divided.piece_count(), 2);
  block.mesh.group_triangles.clear();
  EXPECT_NE(block.refusal().find("has no faces inside the body"), std::string::npos);
}

// The force of a stress that grows linearly along y: its integral with the shape functions of all nodes.
TEST(Divide, SharesOfAFaceAreTheIntegralsOfItsShapeFunctions) {
  for (const element::Type element : {element::hex(2, 2), element::hex(4, 3)}) {
    SCOPED_TRACE(element::name(element));
    Breakable block({on_x}, element);
    for (Vector3& node : block.mesh.nodes) {  // cells that are no rectangles, on a plane
      node.y() += 0.5 * node.y() * node.z();
    }
    const Mesh divided = divide(block.mesh, block.body);
    double area = 0.0, moment = 0.0;
    for (const FractureFace& face : divided.fracture_faces) {
      const auto corner = [&](std::size_t k) { return divided.nodes[face.nodes[0][k]]; };
      double own = 0.0;
      for (std::size_t k = 2; k < face.corners; ++k) {
        own += 0.5 * (corner(k - 1) - corner(0)).cross(corner(k) - corner(0)).norm();
      }
      area += own;
      EXPECT_NEAR(std::accumulate(face.shares.begin(), face.shares.end(), 0.0), 1.0, 1e-14);
      for (std::size_t k = 0; k < face.shares.size(); ++k) {
        moment += own * face.shares[k] * divided.nodes[face.nodes[0][k]].y();
      }
    }
    // y goes from 0 to w = 0.2 (1 + z/2) while z goes from 0 to h = 0.2: areas by int w dz, moments by int w^2/2 dz.
    EXPECT_NEAR(area, 0.2 * 0.2 * (1 + 0.2 / 4), 1e-14);
    EXPECT_NEAR(moment, 0.02 * 2.0 / 3 * (std::pow(1.1, 3) - 1), 1e-15);
  }
}

TEST(Divide, LeavesTheRimOfASurfaceInsideTheBodyJoined) {
  const Breakable block({[](const Vector3& node) { return on_x(node) && node.y() < 0.1 + 1e-9; }});
  const Mesh divided = divide(block.mesh, block.body);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.1, 0.1}), 1U);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.05, 0.1}), 2U);
  EXPECT_EQ(nodes_at(divided, {0.2, 0.15, 0.1}), 1U);
}

TEST(Divide, OneRankOwnsAllNodesOfTheSurfaces) {
  const auto across_half_the_thickness = [](const Vector3& node) {
    return std::abs(node.z() - block_size.z() / 2) < 1e-9 && node.x() > 0.3 - 1e-9;
  };
  for (const element::Type element : {element::tet4, element::tet10, element::hex(2, 2)}) {
    SCOPED_TRACE(element::name(element));
    std::vector<Inside> surfaces = {on_x, on_y};
    if (element::lines_through(element) > 0) {
      surfaces.emplace_back(across_half_the_thickness);
    }
    Breakable block(surfaces, element);
    const std::vector<Mesh> meshes = {divide(block.mesh, block.body)};
    const std::vector<int> owners = node_owners(meshes, 2);
    std::set<int> of_surfaces;
    for (const FractureFace& face : meshes[0].fracture_faces) {
      for (const auto& side : face.nodes) {
        std::ranges::for_each(side, [&](Index node) { of_surfaces.insert(owners[node]); });
      }
    }
    EXPECT_EQ(of_surfaces.size(), 1U);
    EXPECT_EQ(std::set<int>(owners.begin(), owners.end()).size(), 2U);
  }
}

}  // namespace
}  // namespace idiophone::mesh
