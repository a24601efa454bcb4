// Meshes of spectral hexahedra, from gmsh's.

#include "spectral_hexahedra.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "element_shape.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr element::Type thin = element::hex(4, 2);

/// From the first to the last node along the third direction.
Vector3 across(const Mesh& mesh, Index element) {
  const auto nodes = mesh.element_nodes(element);
  const std::size_t edge = mesh.element.plane + 1;
  return mesh.nodes[nodes[edge * edge * mesh.element.thickness]] - mesh.nodes[nodes[0]];
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    sum += volume_of(shape_of(mesh, element));
  }
  return sum;
}

/// Two cells side by side: a box of 2 x 1 x height, as a .msh of linear hexahedra, and further element lines.
std::string two_cells(const std::vector<MshElement>& more = {}, double height = 1.0,
                      const MshElement& second = "5 2 1 1 2 3 6 5 8 9 12 11") {
  std::vector<Vector3> nodes;
  for (const int z : {0, 1}) {
    for (const int y : {0, 1}) {
      for (const int x : {0, 1, 2}) {
        nodes.emplace_back(x, y, height * z);
      }
    }
  }
  std::vector<MshElement> elements = {"5 2 1 1 1 2 5 4 7 8 11 10", second};
  elements.insert(elements.end(), more.begin(), more.end());
  return msh_text(nodes, elements, "$PhysicalNames\n2\n2 2 \"end\"\n3 1 \"body\"\n$EndPhysicalNames\n");
}

/// A cube within a larger one, and six cells between their faces, as a .msh of linear hexahedra.
std::string cube_of_seven() {
  std::vector<Vector3> nodes;
  for (const double half : {1.0, 2.0}) {
    for (const double z : {-half, half}) {
      for (const auto& [x, y] : {std::pair(-half, -half), {half, -half}, {half, half}, {-half, half}}) {
        nodes.emplace_back(x, y, z);
      }
    }
  }
  return msh_text(nodes, {"5 2 1 1 1 2 3 4 5 6 7 8", "5 2 1 1 9 10 11 12 1 2 3 4", "5 2 1 1 5 6 7 8 13 14 15 16",
                          "5 2 1 1 9 10 2 1 13 14 6 5", "5 2 1 1 10 11 3 2 14 15 7 6", "5 2 1 1 11 12 4 3 15 16 8 7",
                          "5 2 1 1 12 9 1 4 16 13 5 8"});
}

ON_RANKS(1);

TEST(Hexahedra, ShareTheNodesOfAPlate) {
  const Mesh mesh = read_mesh(shipped("square_plate.geo", thin, {{"size", 0.05}}));
  EXPECT_EQ(mesh.element, thin);
  EXPECT_EQ(mesh.element_count(), 36);
  EXPECT_EQ(mesh.nodes.size(), 25U * 25U * 3U);
  EXPECT_NEAR(volume(mesh), 0.3 * 0.3 * 0.006, 1e-15);
  EXPECT_NEAR(enclosed_volume(mesh), 0.3 * 0.3 * 0.006, 1e-15);
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_EQ(mesh.surface.size(), 2U * (2U * 24U * 24U + 4U * 24U * 2U));
}

TEST(Hexahedra, OfAPlateAreInTheGroupsOfTheirFaces) {
  const Mesh mesh = read_mesh(shipped("square_plate.geo", thin, {{"size", 0.3}}));  // two cells along a side
  ASSERT_EQ(mesh.element_count(), 4);
  const auto count = [&](auto condition) { return std::ranges::count_if(mesh.nodes, condition); };
  const auto is_rim = [](const Vector3& x) { return std::max(std::abs(x[0]), std::abs(x[1])) > 0.15 - 1e-9; };
  const auto is_top = [](const Vector3& x) { return x[2] > 0.003 - 1e-9; };
  EXPECT_EQ(mesh.groups.at("body").size(), mesh.nodes.size());
  EXPECT_EQ(std::ssize(mesh.groups.at("rim")), count(is_rim));
  EXPECT_EQ(std::ssize(mesh.groups.at("top")), count(is_top));
  EXPECT_TRUE(std::ranges::all_of(mesh.groups.at("rim"), [&](Index node) { return is_rim(mesh.nodes[node]); }));
  EXPECT_TRUE(std::ranges::all_of(mesh.groups.at("top"), [&](Index node) { return is_top(mesh.nodes[node]); }));
}

TEST(Hexahedra, HaveTheirThirdDirectionThroughTheThickness) {
  for (const auto& [file, axis] : {std::pair("bar.geo", Vector3::UnitZ()), {"pendulum.geo", Vector3::UnitX()}}) {
    const Mesh mesh = read_mesh(shipped(file, thin, {{"size", 0.02}}));
    for (Index element = 0; element < mesh.element_count(); ++element) {
      EXPECT_NEAR(across(mesh, element).normalized().cwiseAbs().dot(axis), 1.0, 1e-12) << file;
    }
  }
}

TEST(Hexahedra, OfEveryOrderOfGmshAreParallelepipedsInAPlate) {
  for (const int order : {2, 3, 4, 5}) {
    const element::Type type = element::hex(order, order);
    const Mesh mesh = read_mesh(shipped("square_plate.geo", type, {{"size", 0.15}, {"thickness", 0.15}}));
    for (Index element = 0; element < mesh.element_count(); ++element) {
      EXPECT_NEAR(quality_of(shape_of(mesh, element)), 1.0, 1e-9) << order;  // a cube
    }
  }
}

TEST(Hexahedra, FollowCurvedFaces) {
  // Largest relative error of the volume; versions of gmsh place the nodes differently.
  for (const auto& [order, largest] : {std::pair(2, 1e-3), {3, 5e-4}, {4, 5e-6}}) {
    const Mesh mesh = read_mesh(shipped("sphere.geo", element::hex(order, order), {{"size", 0.03}}));
    const double exact = 4.0 / 3.0 * std::numbers::pi * std::pow(0.05, 3);
    EXPECT_NEAR(volume(mesh) / exact, 1.0, largest) << order;
    EXPECT_TRUE(is_watertight(mesh));
    for (const Index node : mesh.groups.at("surface")) {
      EXPECT_NEAR(mesh.nodes[node].norm(), 0.05, 5e-4);
    }
  }
}

TEST(Hexahedra, ComeFromEveryShippedSolid) {
  const auto exact = 4.0 / 3.0 * std::numbers::pi;
  const auto of = [](const scene::Body& body) {
    const Mesh mesh = read_mesh(body);
    EXPECT_TRUE(is_watertight(mesh)) << body.mesh;
    return volume(mesh);
  };
  const auto verification = [](const std::string& name, const std::map<std::string, double>& parameters) {
    return body_of(std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "verification" / name, thin, parameters);
  };
  EXPECT_NEAR(
      of(shipped("graded_sphere.geo", element::hex(2, 2), {{"size", 4e-3}, {"pole_size", 5e-4}})) / 1e-6 / exact, 1.0,
      1e-3);
  const double disc = std::numbers::pi * 0.15 * 0.15 * 0.003;
  EXPECT_NEAR(of(verification("disc.geo", {{"size", 0.05}})) / disc, 1.0, 1e-6);
  EXPECT_NEAR(of(verification("disc.geo", {{"size", 0.05}, {"rim_size", 0.01}, {"quarters", 1}})) / disc, 0.25, 1e-6);
  const double tube = std::numbers::pi * (0.0125 * 0.0125 - 0.011 * 0.011) * 0.5;
  EXPECT_NEAR(of(verification("tube.geo", {{"along", 4}, {"around", 2}})) / tube, 1.0, 1e-5);
  EXPECT_NEAR(of(verification("tube.geo", {{"along", 4}, {"around", 2}, {"quarters", 1}})) / tube, 0.25, 1e-5);
  EXPECT_NEAR(of(verification("quarter_bar.geo", {})), 0.3 * 0.015 * 0.005, 1e-15);
  EXPECT_NEAR(of(verification("quarter_plate.geo", {{"size", 0.1}, {"grading", 1.2}})), 0.5 * 0.5 * 0.02, 1e-12);
}

TEST(Hexahedra, NeedADirectionThroughTheThicknessForTwoOrders) {
  EXPECT_THAT(refusal(shipped("sphere.geo", thin, {{"size", 0.05}})),
              AllOf(HasSubstr("deck.yaml:7:9"), HasSubstr("no direction through the thickness"),
                    HasSubstr("the same order for both"), HasSubstr("element ")));
}

TEST(Hexahedra, OfAFileAreReadWithTheirGroups) {
  const TemporaryFile file("cells.msh", two_cells({"3 2 2 1 3 6 12 9"}));
  const Mesh mesh = read_mesh(body_of(file.path(), element::hex(3, 3)));
  EXPECT_EQ(mesh.element_count(), 2);
  EXPECT_EQ(mesh.nodes.size(), 7U * 4U * 4U);
  EXPECT_NEAR(volume(mesh), 2.0, 1e-12);
  for (const Index node : mesh.groups.at("end")) {
    EXPECT_NEAR(mesh.nodes[node].x(), 2.0, 1e-12);
  }
}

TEST(Hexahedra, OfAFileAgreeOnTheThicknessWhateverTheirOwnDirections) {
  const TemporaryFile file("turned.msh", two_cells({}, 0.25, "5 2 1 1 2 8 9 3 5 11 12 6"));  // the second along z, x, y
  const Mesh mesh = read_mesh(body_of(file.path(), thin));
  EXPECT_EQ(mesh.nodes.size(), 9U * 5U * 3U);
  for (const Index element : {0, 1}) {
    EXPECT_NEAR(std::abs(across(mesh, element).z()), 0.25, 1e-12);
  }
}

TEST(Hexahedra, OfAFileWithNeighboursThatDisagreeAreRefused) {
  const TemporaryFile file("seven.msh", cube_of_seven());
  EXPECT_EQ(read_mesh(body_of(file.path(), element::hex(2, 2))).element_count(), 7);
  EXPECT_THAT(
      refusal(body_of(file.path(), thin)),
      AllOf(HasSubstr("deck.yaml:7:9"), HasSubstr("no direction through the thickness"), HasSubstr("element ")));
}

/// One hexahedron of 20 nodes, a curved image of the cube of edges 2, and the four faces around its third direction.
std::string serendipity_cell() {
  const std::vector<Vector3> cube = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1},
                                     {1, -1, 1},   {1, 1, 1},   {-1, 1, 1}, {0, -1, -1}, {-1, 0, -1},
                                     {-1, -1, 0},  {1, 0, -1},  {1, -1, 0}, {0, 1, -1},  {1, 1, 0},
                                     {-1, 1, 0},   {0, -1, 1},  {-1, 0, 1}, {1, 0, 1},   {0, 1, 1}};
  std::vector<Vector3> nodes(cube.size());
  std::ranges::transform(cube, nodes.begin(), [](const Vector3& xi) {
    return Vector3(xi[0] + 0.1 * xi[1] * xi[1], xi[1], xi[2] * (1 + 0.2 * xi[0] * xi[0]));
  });
  return msh_text(nodes,
                  {"17 2 1 1 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20", "16 2 2 1 1 2 6 5 9 13 17 11",
                   "16 2 2 2 2 3 7 6 12 15 19 13", "16 2 2 3 3 4 8 7 14 16 20 15", "16 2 2 4 4 1 5 8 10 11 18 16"},
                  "$PhysicalNames\n2\n2 2 \"sides\"\n3 1 \"body\"\n$EndPhysicalNames\n");
}

TEST(Hexahedra, WithoutNodesInTheirFacesAreCompletedExactly) {
  const TemporaryFile file("serendipity.msh", serendipity_cell());
  const Mesh mesh = read_mesh(body_of(file.path(), element::hex(3, 3)));
  EXPECT_EQ(mesh.element_count(), 1);
  EXPECT_NEAR(volume(mesh), 8 * (1 + 0.2 / 3), 1e-12);
  for (const Vector3& node : mesh.nodes) {
    const double xi = node.x() - 0.1 * node.y() * node.y();
    const double zeta = std::abs(node.z()) / (1 + 0.2 * xi * xi);
    EXPECT_LT(std::min(std::abs(zeta - 1), std::abs(zeta - std::sqrt(0.2))), 1e-12);
  }
  EXPECT_EQ(mesh.groups.at("body").size(), 64U);
  EXPECT_EQ(mesh.groups.at("sides").size(), 48U);
}

TEST(Hexahedra, OfAFileWithOtherElementsAreRefused) {
  const TemporaryFile mixed("mixed.msh", two_cells({"4 2 1 1 1 2 4 7"}));
  EXPECT_THAT(refusal(body_of(mixed.path(), thin)),
              AllOf(HasSubstr("deck.yaml:7:9"), HasSubstr("Tetrahedron"), HasSubstr("elements 3")));
  EXPECT_THAT(refusal(body_of(mixed.path(), element::tet10)),
              AllOf(HasSubstr("Hexahedron"), HasSubstr("elements 1, 2")));
  const TemporaryFile tetrahedra("tetrahedra.geo", "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 1, 1, 1};");
  EXPECT_THAT(refusal(body_of(tetrahedra.path(), thin)), AllOf(HasSubstr("Tetrahedron"), HasSubstr("Recombine")));
}

TEST(Hexahedra, LeftHandedAreRefused) {
  const TemporaryFile file("turned.msh", two_cells({"5 2 1 1 7 8 11 10 1 2 5 4"}));  // the first cell once more
  EXPECT_THAT(refusal(body_of(file.path(), thin)), AllOf(HasSubstr("1 inverted"), HasSubstr("element 3 at")));
}

}  // namespace
}  // namespace idiophone::mesh
