// Thin bodies from their middle surfaces.

#include "thick_wall.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "element_shape.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A wall, its thickness at deck.yaml:9:16.
scene::Body wall_of(const std::filesystem::path& file, element::Type type, double thickness,
                    const std::map<std::string, double>& parameters = {}) {
  scene::Body body = body_of(file, type, parameters);
  body.thickness = thickness;
  body.thickness_where = {.file = "deck.yaml", .line = 9, .column = 16};
  return body;
}

/// A cylinder along z around the origin, without its ends; its lower rim is a group.
constexpr const char* cylinder = R"(
SetFactory("OpenCASCADE");
DefineConstant[ radius = 0.1, length = 0.2, around = 4, along = 2 ];
Circle(1) = {0, 0, 0, radius, 0, Pi};
Circle(2) = {0, 0, 0, radius, Pi, 2 * Pi};
Extrude {0, 0, length} { Curve{1, 2}; Layers{along}; Recombine; }
Coherence;
rim[] = Curve In BoundingBox{-1, -1, -1e-6, 1, 1, 1e-6};
Transfinite Curve {rim[]} = around / 2 + 1;
Physical Curve("rim") = {rim[]};
Physical Surface("all") = Surface{:};
)";

/// The part of a sphere around the origin between two cones about z.
constexpr const char* zone = R"(
SetFactory("OpenCASCADE");
DefineConstant[ radius = 0.1, size = 0.03 ];
Point(1) = {0, 0, 0};
Point(2) = {radius * Sin(0.4), 0, radius * Cos(0.4)};
Point(3) = {radius, 0, 0};
Circle(1) = {2, 1, 3};
Extrude {{0, 0, 1}, {0, 0, 0}, 2 * Pi} { Curve{1}; }
Mesh.MeshSizeMax = size;
)";

ON_RANKS(1);

TEST(ThickWall, OfAPlaneIsAPlate) {
  const TemporaryFile file("plane.geo",
                           "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 0.2, 0.1};"
                           "Transfinite Curve {1:4} = 3; Transfinite Surface {1};"
                           "Physical Curve(\"rim\") = {4};");
  const Mesh mesh = read_mesh(wall_of(file.path(), element::hex(4, 2), 0.004));
  EXPECT_EQ(mesh.element_count(), 4);
  EXPECT_EQ(mesh.nodes.size(), 9U * 9U * 3U);
  EXPECT_NEAR(statistics(mesh).volume, 0.2 * 0.1 * 0.004, 1e-17);
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_EQ(mesh.groups.at("rim").size(), 9U * 3U);
  for (const Index node : mesh.groups.at("rim")) {
    EXPECT_NEAR(mesh.nodes[node].x(), 0.0, 1e-15);
  }
  for (const Vector3& node : mesh.nodes) {
    EXPECT_LE(std::abs(node.z()), 0.002 + 1e-15);
  }
}

TEST(ThickWall, OfACylinderConvergesToItsVolume) {
  const TemporaryFile file("cylinder.geo", cylinder);
  const double exact = 2 * std::numbers::pi * 0.1 * 0.2 * 0.01;
  for (const int order : {2, 3, 4}) {
    const auto error = [&](double around) {
      const Mesh mesh = read_mesh(wall_of(file.path(), element::hex(order, 2), 0.01, {{"around", around}}));
      EXPECT_TRUE(is_watertight(mesh));
      EXPECT_EQ(std::ssize(mesh.groups.at("rim")), 3 * order * static_cast<int>(around));
      return std::abs(statistics(mesh).volume / exact - 1);
    };
    const double coarse = error(4);
    const double fine = error(8);
    EXPECT_LT(fine, 1e-3) << order;
    EXPECT_GT(std::log2(coarse / fine), order + 1 - 0.5) << order;
  }
}

TEST(ThickWall, OfASphericalZoneConvergesToItsVolume) {
  const TemporaryFile file("zone.geo", zone);
  const double solid_angle = 2 * std::numbers::pi * std::cos(0.4);
  const double exact = solid_angle * (0.1 * 0.1 * 0.01 + std::pow(0.01, 3) / 12);
  for (const auto& [order, tolerance] : {std::pair(2, 1e-4), {3, 3e-5}, {4, 1e-6}}) {
    const Mesh mesh = read_mesh(wall_of(file.path(), element::hex(order, 2), 0.01));
    EXPECT_NEAR(statistics(mesh).volume / exact, 1, tolerance) << order;
    EXPECT_TRUE(is_watertight(mesh));
    for (const Vector3& node : mesh.nodes) {
      EXPECT_LE(std::abs(node.norm() - 0.1), 0.005 + 2e-4);
    }
  }
}

/// Three squares in a row, along x, as a .msh.
std::string row_of_squares(const std::vector<MshElement>& elements) {
  std::vector<Vector3> nodes;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0, 2.0, 3.0}) {
      nodes.emplace_back(x, y, 0.0);
    }
  }
  nodes.emplace_back(1.5, 0.5, 1.0);  // above
  nodes.emplace_back(1.5, 1.5, 1.0);
  return msh_text(nodes, elements);
}

TEST(ThickWall, TurnsQuadrilateralsOver) {
  const TemporaryFile alike("alike.msh", row_of_squares({"3 2 1 1 1 2 6 5", "3 2 1 1 2 3 7 6", "3 2 1 1 3 4 8 7"}));
  const TemporaryFile mixed("mixed.msh", row_of_squares({"3 2 1 1 1 2 6 5", "3 2 1 1 2 6 7 3", "3 2 1 1 3 4 8 7"}));
  const Mesh mesh = read_mesh(wall_of(mixed.path(), element::hex(3, 2), 0.5));
  EXPECT_NEAR(statistics(mesh).volume, 3 * 0.5, 1e-12);
  EXPECT_TRUE(is_watertight(mesh));
  const Mesh same = read_mesh(wall_of(alike.path(), element::hex(3, 2), 0.5));
  EXPECT_EQ(mesh.nodes.size(), same.nodes.size());
}

TEST(ThickWall, RefusesWhatIsNoSurface) {
  const element::Type type = element::hex(3, 2);
  const TemporaryFile branching("branching.msh",
                                row_of_squares({"3 2 1 1 1 2 6 5", "3 2 1 1 2 3 7 6", "3 2 1 1 2 6 10 9"}));
  EXPECT_THAT(refusal(wall_of(branching.path(), type, 0.1)),
              AllOf(StartsWith("deck.yaml:7:9"), HasSubstr("more than two quadrilaterals share"),
                    HasSubstr("element 1 at"), HasSubstr("element 2 at"), HasSubstr("element 3 at")));
  const TemporaryFile mixed("triangles.msh", row_of_squares({"3 2 1 1 1 2 6 5", "2 2 1 1 2 3 7"}));
  EXPECT_THAT(refusal(wall_of(mixed.path(), type, 0.1)),
              AllOf(StartsWith("deck.yaml:7:9"), HasSubstr("Triangle"), HasSubstr("elements 2"),
                    HasSubstr("needs quadrilaterals")));
  EXPECT_THAT(refusal(wall_of(std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "meshes/bar.geo", type, 0.1)),
              AllOf(StartsWith("deck.yaml:7:9"), HasSubstr("it has a volume")));
}

TEST(ThickWall, RefusesAMoebiusStrip) {
  constexpr int cells = 8;
  std::vector<Vector3> nodes;
  std::vector<MshElement> elements;
  for (int i = 0; i < cells; ++i) {
    const double angle = 2 * std::numbers::pi * i / cells;
    for (const double side : {-1.0, 1.0}) {
      const double radius = 4 + side * std::cos(angle / 2);
      nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2));
    }
    const int a = 2 * i + 1;
    elements.push_back(i + 1 < cells ? fmt::format("3 2 1 1 {} {} {} {}", a, a + 1, a + 3, a + 2)
                                     : fmt::format("3 2 1 1 {} {} 1 2", a, a + 1));
  }
  const TemporaryFile file("strip.msh", msh_text(nodes, elements));
  EXPECT_THAT(refusal(wall_of(file.path(), element::hex(2, 2), 0.01)),
              AllOf(StartsWith("deck.yaml:7:9"), HasSubstr("one side only"), HasSubstr("element ")));
}

TEST(ThickWall, RefusesAThicknessThatFoldsIt) {
  const TemporaryFile file("cylinder.geo", cylinder);
  const auto said = [&](double thickness) {
    return refusal(wall_of(file.path(), element::hex(4, 2), thickness, {{"around", 8}}));
  };
  EXPECT_EQ(said(0.19), "");
  EXPECT_THAT(said(0.21), AllOf(StartsWith("deck.yaml:9:16"), HasSubstr("a wall of 0.21 m folds in element "),
                                HasSubstr("the thickness must be below 0.")));
}

/// Two squares with an edge between them, bent by an angle.
std::string bent(double angle) {
  std::vector<Vector3> nodes;
  for (const double y : {0.0, 1.0}) {
    nodes.emplace_back(-1, y, 0);
    nodes.emplace_back(0, y, 0);
    nodes.emplace_back(std::cos(angle), y, std::sin(angle));
  }
  return msh_text(nodes, {"3 2 1 1 1 2 5 4", "3 2 1 1 2 3 6 5"});
}

TEST(ThickWall, KeepsItsThicknessAtBends) {
  const TemporaryFile file("bent.msh", bent(std::numbers::pi / 2));
  const Mesh mesh = read_mesh(wall_of(file.path(), element::hex(2, 2), 0.2));
  EXPECT_NEAR(statistics(mesh).volume, 2 * 0.2, 1e-6);
  for (const Vector3& node : mesh.nodes) {  // the profile of an angle
    EXPECT_GE(std::max(node.z(), -node.x()), -0.1 - 1e-6);
    EXPECT_LE(std::min(node.z(), -node.x()), 0.1 + 1e-6);
  }
  const TemporaryFile folded("folded.msh", bent(2.8));
  EXPECT_THAT(refusal(wall_of(folded.path(), element::hex(2, 2), 0.01)),
              AllOf(StartsWith("deck.yaml:7:9"), HasSubstr("at less than 35 degrees"), HasSubstr("element 1 at")));
}

}  // namespace
}  // namespace idiophone::mesh
