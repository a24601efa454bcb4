#include <gmock/gmock.h>
#include <gmsh.h>
#include <gtest/gtest.h>

#include "gmsh_session.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::map<std::string, double> small_plate = {{"side", 0.2}, {"thickness", 0.01}, {"size", 0.05}};

ON_RANKS(1);

TEST(ReadMesh, PlateHasTheVolumeAreaAndGroupsOfItsParameters) {
  for (const auto type : {element::tet4, element::tet10}) {
    const Mesh plate = read_mesh(shipped("square_plate.geo", type, small_plate));
    const double side = 0.2;
    const double thickness = 0.01;
    EXPECT_NEAR(statistics(plate).volume, side * side * thickness, 1e-12);
    EXPECT_NEAR(enclosed_volume(plate), side * side * thickness, 1e-12);
    EXPECT_NEAR(surface_area(plate), 2 * side * side + 4 * side * thickness, 1e-12);
    EXPECT_TRUE(is_watertight(plate));
    ASSERT_TRUE(plate.groups.contains("rim"));
    const auto nodes_across = static_cast<std::size_t>(type == element::tet4 ? 5 : 9);
    EXPECT_EQ(plate.groups.at("top").size(), nodes_across * nodes_across);
    for (const Index node : plate.groups.at("top")) {
      EXPECT_DOUBLE_EQ(plate.nodes[node].z(), thickness / 2);
    }
    for (const Index node : plate.groups.at("rim")) {
      const Vector3& x = plate.nodes[node];
      EXPECT_NEAR(std::max(std::abs(x.x()), std::abs(x.y())), side / 2, 1e-12);
    }
    EXPECT_EQ(plate.groups.at("body").size(), plate.nodes.size());
    EXPECT_EQ(plate.groups.at("rim").size(), (4 * (nodes_across - 1)) * (type == element::tet4 ? 2 : 3));
  }
}

TEST(ReadMesh, BodiesOfOneShapeAreMeshedOnceAndPlacedApart) {
  const scene::Body first = shipped("square_plate.geo", element::tet4, small_plate);
  scene::Body second = first;
  second.position = {0.0, 0.0, 1.0};
  scene::Body other = shipped("square_plate.geo", element::tet10, small_plate);
  const auto meshes = read_meshes(std::vector{first, second, other});
  ASSERT_EQ(meshes.size(), 3U);
  for (const auto& [mesh, body] : {std::pair(meshes[0], first), {meshes[1], second}, {meshes[2], other}}) {
    EXPECT_EQ(mesh.hash, read_mesh(body).hash);
  }
  EXPECT_NE(meshes[0].hash, meshes[1].hash);
}

TEST(ReadMesh, MidNodesAreBetweenTheCornersThatTheHeaderSays) {
  const Mesh plate = read_mesh(shipped("square_plate.geo", element::tet10, small_plate));
  constexpr std::array<std::array<std::size_t, 2>, 6> edges = {{{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};
  for (Index element = 0; element < plate.element_count(); ++element) {
    const auto nodes = plate.element_nodes(element);
    for (std::size_t edge = 0; edge < 6; ++edge) {
      const auto at = [&](std::size_t place) { return plate.nodes[nodes[place]]; };
      EXPECT_NEAR((at(4 + edge) - (at(edges[edge][0]) + at(edges[edge][1])) / 2).norm(), 0.0, 1e-12);
    }
  }
}

TEST(ReadMesh, TrianglesBeginWithTheirSmallestNodeAndAscend) {
  const Mesh plate = read_mesh(shipped("square_plate.geo", element::tet10, small_plate));
  EXPECT_TRUE(std::ranges::is_sorted(plate.surface));
  for (const auto& triangle : plate.surface) {
    EXPECT_EQ(triangle[0], std::ranges::min(triangle));
  }
}

TEST(ReadMesh, RegularPlateHasTheSymmetriesOfTheSquare) {
  const Mesh plate = read_mesh(shipped("square_plate.geo", element::tet10, small_plate));
  const auto holds = [&](const Vector3& wanted) {
    return std::ranges::any_of(plate.groups.at("top"),
                               [&](Index node) { return (plate.nodes[node] - wanted).norm() < 1e-9; });
  };
  std::vector<Vector3> centres;  // of triangles on top
  for (const auto& triangle : plate.surface) {
    const auto [a, b, c] = corners_of(plate, triangle);
    if (a.z() + b.z() + c.z() > 3 * 0.005 - 1e-9) {
      centres.emplace_back((a + b + c) / 3);
    }
  }
  EXPECT_EQ(centres.size(), 4U * 4U * 2U * 4U);
  for (const auto& at : centres) {
    for (const Vector3& image : {Vector3(-at.x(), at.y(), at.z()), Vector3(at.y(), at.x(), at.z())}) {
      EXPECT_TRUE(std::ranges::any_of(centres, [&](const auto& other) { return (other - image).norm() < 1e-9; }));
    }
  }
  EXPECT_TRUE(holds({0.1, 0.1, 0.005}));
}

TEST(ReadMesh, UnstructuredPlateOfThePapersSize) {
  const Mesh plate = read_mesh(shipped("square_plate.geo", element::tet4, {{"regular", 0}, {"size", 0.3 / 16}}));
  EXPECT_NEAR(static_cast<double>(plate.nodes.size()), 688, 688 * 0.05);
  EXPECT_NEAR(plate.element_count(), 1864, 1864 * 0.05);
  EXPECT_NEAR(static_cast<double>(plate.surface.size()), 1372, 1372 * 0.05);
}

TEST(ReadMesh, BarRunsFromClampToTip) {
  const Mesh bar = read_mesh(
      shipped("bar.geo", element::tet4, {{"length", 0.4}, {"width", 0.04}, {"thickness", 0.01}, {"size", 0.02}}));
  EXPECT_EQ(bar.nodes.size(), 126U);  // the paper's clamped bar has 125, with 265 elements
  EXPECT_EQ(bar.element_count(), 240);
  EXPECT_NEAR(enclosed_volume(bar), 0.4 * 0.04 * 0.01, 1e-12);
  for (const auto& [group, x] : {std::pair("clamp", 0.0), std::pair("tip", 0.4)}) {
    EXPECT_EQ(bar.groups.at(group).size(), 6U);
    for (const Index node : bar.groups.at(group)) {
      EXPECT_NEAR(bar.nodes[node].x(), x, 1e-12);
    }
  }
}

/// A block of 0.3 x 0.2 x 0.1 whose edge along y at x = z = 0 is the physical curve "axle".
constexpr const char* hinged_block = R"(
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 0.3, 0.2, 0.1};
Mesh.MeshSizeMax = 0.06;
Mesh.Algorithm3D = 1;
Physical Volume("body") = {1};
e = 1e-6;
Physical Curve("axle") = Curve In BoundingBox{-e, -e, -e, e, 0.2 + e, e};
)";

void expect_axle(const Mesh& mesh) {
  const auto on_the_edge = [](const Vector3& x) { return std::abs(x.x()) < 1e-9 && std::abs(x.z()) < 1e-9; };
  const std::vector<Index>& axle = mesh.groups.at("axle");
  for (const Index node : axle) {
    EXPECT_TRUE(on_the_edge(mesh.nodes[node]));
  }
  EXPECT_EQ(static_cast<std::ptrdiff_t>(axle.size()), std::ranges::count_if(mesh.nodes, on_the_edge));
}

TEST(ReadMesh, APhysicalCurveIsTheGroupOfAllNodesOnIt) {
  const TemporaryFile geometry("hinged.geo", hinged_block);
  expect_axle(read_mesh(body_of(geometry.path(), element::tet4)));
  expect_axle(read_mesh(body_of(geometry.path(), element::tet10)));
  // And from a mesh of the other order, whose middle nodes come or go.
  for (const int order : {1, 2}) {
    const TemporaryFile file("hinged.msh");
    {
      const GmshSession session;
      gmsh::open(geometry.path().string());
      gmsh::model::mesh::generate(3);
      gmsh::model::mesh::setOrder(order);
      gmsh::write(file.path().string());
    }
    expect_axle(read_mesh(body_of(file.path(), element::tet4)));
    expect_axle(read_mesh(body_of(file.path(), element::tet10)));
  }
}

TEST(ReadMesh, SphereConvergesToItsVolume) {
  const double exact = 4.0 / 3.0 * std::numbers::pi * 0.05 * 0.05 * 0.05;
  const auto error = [&](double size) {
    return std::abs(enclosed_volume(read_mesh(shipped("sphere.geo", element::tet10, {{"size", size}}))) / exact - 1);
  };
  const double coarse = error(0.03);
  const double fine = error(0.015);
  EXPECT_LT(fine, 0.03);
  EXPECT_GT(coarse / fine, 2.5);  // the flat triangles' error goes with the square of their size
}

TEST(ReadMesh, TheSameFileGivesTheSameHashAndAnotherDoesNot) {
  const auto hash = [](const std::map<std::string, double>& parameters, element::Type type) {
    return read_mesh(shipped("square_plate.geo", type, parameters)).hash;
  };
  const auto first = hash(small_plate, element::tet4);
  EXPECT_EQ(first.size(), 16U);
  EXPECT_EQ(first, hash(small_plate, element::tet4));
  EXPECT_NE(first, hash(small_plate, element::tet10));
  auto other = small_plate;
  other["thickness"] = 0.010000000000000002;
  EXPECT_NE(first, hash(other, element::tet4));
}

TEST(ReadMesh, ABodysParametersAreGoneForTheNext) {
  const auto standard = read_mesh(shipped("square_plate.geo", element::tet4)).hash;
  EXPECT_NE(read_mesh(shipped("square_plate.geo", element::tet4, small_plate)).hash, standard);
  EXPECT_EQ(read_mesh(shipped("square_plate.geo", element::tet4)).hash, standard);
}

TEST(ReadMesh, RefusesParametersThatTheFileDoesNotDefine) {
  const auto said = refusal(shipped("square_plate.geo", element::tet4, {{"side", 0.3}, {"syde", 0.3}}));
  EXPECT_THAT(said,
              AllOf(StartsWith("deck.yaml:21:1:"), HasSubstr("no parameter 'syde'"), HasSubstr("DefineConstant")));
}

TEST(ReadMesh, RefusesParametersThatTheFileOverwrites) {
  const TemporaryFile file("fixed.geo", "side = 2;\n");
  const auto said = refusal(body_of(file.path(), element::tet4, {{"side", 1.0}}));
  EXPECT_THAT(said, AllOf(StartsWith("deck.yaml:20:1:"), HasSubstr("sets 'side' to 2 itself")));
}

TEST(ReadMesh, RefusesWhatIsNoMesh) {
  EXPECT_THAT(refusal(body_of("nowhere.msh", element::tet4)),
              AllOf(StartsWith("deck.yaml:7:9:"), HasSubstr("no file nowhere.msh")));
  EXPECT_THAT(refusal(body_of("plate.vtk", element::tet4)), HasSubstr("give a .geo, .msh"));
  const TemporaryFile nonsense("nonsense.geo", "Point(1) = {0, 0,\n");
  EXPECT_THAT(refusal(body_of(nonsense.path(), element::tet4)), AllOf(HasSubstr("line 1"), HasSubstr("syntax error")));
  const TemporaryFile empty("empty.msh", "");
  EXPECT_NE(refusal(body_of(empty.path(), element::tet4)), "");
  const TemporaryFile flat("flat.geo", "Point(1)={0,0,0,1};Point(2)={1,0,0,1};Line(1)={1,2};");
  EXPECT_THAT(refusal(body_of(flat.path(), element::tet4)), HasSubstr("has no volume elements"));
  const TemporaryFile hexahedra("hexahedra.geo",
                                "SetFactory(\"OpenCASCADE\"); Rectangle(1)={0,0,0,1,1};"
                                "Extrude{0,0,1}{Surface{1};Layers{1};Recombine;}");
  EXPECT_THAT(refusal(body_of(hexahedra.path(), element::tet4)),
              HasSubstr("needs tetrahedra (in a .geo file, leave out Recombine"));
}

}  // namespace
}  // namespace idiophone::mesh
