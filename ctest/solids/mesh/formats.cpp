// Files other than .geo, and how they come to the order that a body asks for.
#include <gmock/gmock.h>
#include <gmsh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gmsh_session.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Writes a box of 2 x 1 x 0.2 with gmsh, with its x = 0 face named "clamp", and meshed to an order where asked.
void write_box(const std::filesystem::path& file, int dimension, int order = 1) {
  const GmshSession session;
  gmsh::option::setString("Geometry.OCCTargetUnit", "MM");  // of a STEP file that is written
  gmsh::model::add("box");
  gmsh::model::occ::addBox(0, 0, 0, 2, 1, 0.2);
  gmsh::model::occ::synchronize();
  if (dimension == 3) {
    gmsh::model::addPhysicalGroup(3, {1}, 1);
    gmsh::model::setPhysicalName(2, gmsh::model::addPhysicalGroup(2, {1}), "clamp");
  }
  gmsh::option::setNumber("Mesh.MeshSizeMax", 0.5);
  if (dimension > 0) {
    gmsh::model::mesh::generate(dimension);
    gmsh::model::mesh::setOrder(order);
  }
  gmsh::write(file.string());
}

void expect_box(const Mesh& mesh, double scale = 1.0) {
  EXPECT_NEAR(statistics(mesh).volume, 0.4 * scale * scale * scale, 1e-9 * scale * scale * scale);
  EXPECT_NEAR(enclosed_volume(mesh), 0.4 * scale * scale * scale, 1e-9 * scale * scale * scale);
  EXPECT_NEAR(surface_area(mesh), 5.2 * scale * scale, 1e-9 * scale * scale);
  EXPECT_TRUE(is_watertight(mesh));
}

ON_RANKS(1);

TEST(Formats, MshOfEitherOrderGivesEitherOrderAndKeepsItsGroups) {
  std::map<std::string_view, std::size_t> clamped;  // by the name of the element
  for (const int order : {1, 2}) {
    const TemporaryFile file("box.msh");
    write_box(file.path(), 3, order);
    for (const auto type : {element::tet4, element::tet10}) {
      const Mesh mesh = read_mesh(body_of(file.path(), type));
      expect_box(mesh);
      const auto& clamp = mesh.groups.at("clamp");
      for (const Index node : clamp) {
        EXPECT_NEAR(mesh.nodes[node].x(), 0.0, 1e-12);
      }
      EXPECT_EQ(std::ranges::count_if(mesh.nodes, [](const Vector3& x) { return std::abs(x.x()) < 1e-9; }),
                static_cast<std::ptrdiff_t>(clamp.size()));
      const auto [known, is_new] = clamped.try_emplace(element::name(type), clamp.size());
      EXPECT_EQ(known->second, clamp.size());
      EXPECT_EQ(mesh.groups.at("1").size(), mesh.nodes.size());  // a group without a name
    }
  }
  EXPECT_GT(clamped["tet10"], clamped["tet4"]);
}

TEST(Formats, StepIsReadInMetres) {
  const TemporaryFile file("box.step");
  write_box(file.path(), 0);  // 2 x 1 x 0.2 mm
  expect_box(read_mesh(body_of(file.path(), element::tet10, {{"size", 5e-4}})), 1e-3);
}

TEST(Formats, FacesOfPartsAreGroupsByTheirNumbers) {
  for (const std::string name : {"box.step", "box.brep", "box.stl"}) {
    const TemporaryFile file(name);
    write_box(file.path(), name == "box.stl" ? 2 : 0);
    const double size = name == "box.step" ? 5e-4 : 0.5;
    const Mesh mesh = read_mesh(body_of(file.path(), element::tet10, {{"size", size}}));
    EXPECT_GE(mesh.groups.size(), 6U) << name;  // facets: a side can be several faces
    EXPECT_TRUE(name == "box.stl" || mesh.groups.size() == 6U) << name;
    std::size_t flat = 0;
    for (const auto& [group, nodes] : mesh.groups) {
      EXPECT_THAT(group, StartsWith("face_"));
      EXPECT_GT(nodes.size(), 4U);
      for (const int axis : {0, 1, 2}) {
        flat += std::ranges::all_of(nodes, [&](Index node) {
          return std::abs(mesh.nodes[node][axis] - mesh.nodes[nodes.front()][axis]) < 1e-9;
        });
      }
    }
    EXPECT_EQ(flat, mesh.groups.size()) << name;
  }
}

TEST(Formats, BrepIsReadAsItIs) {
  const TemporaryFile file("box.brep");
  write_box(file.path(), 0);
  expect_box(read_mesh(body_of(file.path(), element::tet4, {{"size", 0.3}})));
}

TEST(Formats, StlIsFilledWithElementsOfTheSizeAsked) {
  const TemporaryFile file("box.stl");
  write_box(file.path(), 2);
  const Mesh coarse = read_mesh(body_of(file.path(), element::tet4, {{"size", 0.5}}));
  const Mesh fine = read_mesh(body_of(file.path(), element::tet4, {{"size", 0.1}}));
  expect_box(coarse);
  expect_box(fine);
  EXPECT_GT(fine.element_count(), 2 * coarse.element_count());
}

TEST(Formats, ObjOfQuadsIsFilledAndScaled) {
  const TemporaryFile file("box.obj",
                           "v 0 0 0\nv 2000 0 0\nv 0 1000 0\nv 2000 1000 0\nv 0 0 200\nv 2000 0 200\nv 0 1000 200\n"
                           "v 2000 1000 200\nvn 0 0 1\nf 1//1 3//1 4//1 2//1\nf 5 6 8 7\nf -8 -7 -3 -4\nf 3 7 8 4\n"
                           "f 1 5 7 3\nf 2 4 8 6\n");
  const Mesh mesh = read_mesh(body_of(file.path(), element::tet10, {{"size", 0.3}, {"scale", 0.001}}));
  expect_box(mesh);
  EXPECT_TRUE(mesh.notes.empty());
}

TEST(Formats, AsksForTheUnitOfAPartThatIsTooLarge) {
  const TemporaryFile file("huge.obj",
                           "v 0 0 0\nv 200 0 0\nv 0 100 0\nv 200 100 0\nv 0 0 20\nv 200 0 20\nv 0 100 20\n"
                           "v 200 100 20\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  const auto notes = read_mesh(body_of(file.path(), element::tet4, {{"size", 50}})).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("it is 200 m long. Is the file in another unit? `parameters: {scale: 0.001}`"));
  EXPECT_TRUE(read_mesh(body_of(file.path(), element::tet4, {{"size", 50}, {"scale", 1}})).notes.empty()) << "answered";
}

/// Millimetres that are read as metres would be more cells than gmsh can make in any time.
TEST(Formats, AsksForTheUnitBeforeItMeshesWhatIsTooLargeForItsSize) {
  const auto question = AllOf(StartsWith("deck.yaml:20:1:"), HasSubstr("is 200 x 100 x 20 m if its unit is the metre"),
                              HasSubstr("`parameters: {scale: 0.001}`"));
  const TemporaryFile obj("box.obj",
                          "v 0 0 0\nv 200 0 0\nv 0 100 0\nv 200 100 0\nv 0 0 20\nv 200 0 20\nv 0 100 20\n"
                          "v 200 100 20\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  const std::map<std::string, double> size = {{"size", 0.01}};
  EXPECT_THAT(refusal(body_of(obj.path(), element::tet4, size)), AllOf(question, HasSubstr("has 3e+12 tetrahedra")));
  scene::Body wall = body_of(obj.path(), element::hex(2, 2), size);
  wall.thickness = 0.002;
  EXPECT_THAT(refusal(wall), AllOf(question, HasSubstr("has 2e+08 quadrilaterals")));
  for (const std::string extension : {".stl", ".brep"}) {
    const TemporaryFile file("box" + extension);
    write_box(file.path(), extension == ".stl" ? 2 : 0);  // 2 x 1 x 0.2
    EXPECT_THAT(refusal(body_of(file.path(), element::tet4, {{"size", 1e-4}})), HasSubstr("is 2 x 1 x 0.2 m"))
        << extension;
  }
  expect_box(read_mesh(body_of(obj.path(), element::tet4, {{"size", 0.05}, {"scale", 0.01}})));
}

TEST(Formats, RefusesOtherParametersThanSizeAndScale) {
  const TemporaryFile file("box.brep");
  write_box(file.path(), 0);
  EXPECT_THAT(refusal(body_of(file.path(), element::tet4, {{"side", 1.0}})), StartsWith("deck.yaml:20:1:"));
  EXPECT_THAT(refusal(body_of(file.path(), element::tet4, {{"size", -1.0}})), HasSubstr("above 0"));
  const TemporaryFile mesh("box.msh");
  write_box(mesh.path(), 3);
  EXPECT_THAT(refusal(body_of(mesh.path(), element::tet4, {{"size", 1.0}})), HasSubstr("it has scale"));
}

TEST(Formats, AMeshHasItsUnitOfLength) {
  const TemporaryFile file("box.msh");
  write_box(file.path(), 3);
  const Mesh metres = read_mesh(body_of(file.path(), element::tet4));
  const Mesh tens = read_mesh(body_of(file.path(), element::tet4, {{"scale", 10.0}}));
  EXPECT_TRUE(metres.notes.empty());
  ASSERT_EQ(tens.nodes.size(), metres.nodes.size());
  for (std::size_t node = 0; node < metres.nodes.size(); ++node) {
    EXPECT_EQ(tens.nodes[node], Vector3(10.0 * metres.nodes[node]));
  }
}

TEST(Formats, AsksForTheUnitOfAMeshThatIsTooLarge) {
  const TemporaryFile file("huge.msh",
                           "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 100 0 0\n3 0 100 0\n"
                           "4 0 0 100\n$EndNodes\n$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n");
  const auto notes = read_mesh(body_of(file.path(), element::tet4)).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("it is 100 m long. Is the file in another unit? `parameters: {scale: 0.001}`"));
}

TEST(Formats, AGeoFileThatIsTooLargeHasLengthsInMetres) {
  const TemporaryFile file("box.geo", "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 350, 10, 10};\n");
  const Mesh mesh = read_mesh(body_of(file.path(), element::tet4));
  ASSERT_EQ(mesh.notes.size(), 1U);
  EXPECT_THAT(mesh.notes[0], HasSubstr("it is 350 m long. Lengths in a .geo file are metres"));
}

/// The middle of its flat arc is a point of the file, and no node of an element.
TEST(Formats, AGeoFileMayHavePointsFarAway) {
  const TemporaryFile file("arc.geo",
                           "Point(1) = {0, 0, 0, 0.1};\nPoint(2) = {0.1, 0, 0, 0.1};\nPoint(3) = {0.05, 40, 0, 0.1};\n"
                           "Point(4) = {0.05, -0.1, 0, 0.1};\nCircle(1) = {1, 3, 2};\nLine(2) = {2, 4};\n"
                           "Line(3) = {4, 1};\nCurve Loop(1) = {1, 2, 3};\nPlane Surface(1) = {1};\n"
                           "Extrude {0, 0, 0.01} { Surface{1}; }\n");
  EXPECT_TRUE(read_mesh(body_of(file.path(), element::tet4)).notes.empty());
}

TEST(Formats, RefusesAnOpenStl) {
  const TemporaryFile file("open.stl",
                           "solid open\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                           "endloop\nendfacet\nendsolid\n");
  EXPECT_THAT(refusal(body_of(file.path(), element::tet4)), StartsWith("deck.yaml:7:9:"));
}

/// Writes half a sphere of radius 0.1 around the origin, as surfaces or, for .stl, as facets.
void write_half_sphere(const std::filesystem::path& file) {
  const GmshSession session;
  gmsh::option::setString("Geometry.OCCTargetUnit", "M");
  gmsh::model::occ::addSphere(0, 0, 0, 0.1, -1, 0, std::numbers::pi / 2, 2 * std::numbers::pi);
  gmsh::model::occ::synchronize();
  gmsh::model::occ::remove({{3, 1}});
  gmsh::model::occ::synchronize();
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  for (const auto& [dimension, tag] : surfaces) {
    std::string type;
    gmsh::model::getType(dimension, tag, type);
    if (type != "Sphere") {
      gmsh::model::occ::remove({{dimension, tag}});
    }
  }
  gmsh::model::occ::synchronize();
  gmsh::option::setNumber("Mesh.MeshSizeMax", 0.01);
  gmsh::model::mesh::generate(2);
  gmsh::write(file.string());
}

TEST(Formats, ThinBodiesComeFromSurfacesOfEveryFormat) {
  const double exact = 2 * std::numbers::pi * (0.1 * 0.1 * 0.004 + std::pow(0.004, 3) / 12);
  for (const auto& [name, tolerance] :
       {std::pair("half.brep", 1e-3), {"half.step", 1e-3}, {"half.stl", 0.05}}) {  // facets lie within the sphere
    const TemporaryFile file(name);
    write_half_sphere(file.path());
    scene::Body body = body_of(file.path(), element::hex(2, 2), {{"size", 0.03}});
    body.thickness = 0.004;
    const Mesh mesh = read_mesh(body);
    EXPECT_NEAR(statistics(mesh).volume / exact, 1, tolerance) << name;
    EXPECT_TRUE(is_watertight(mesh)) << name;
    EXPECT_EQ(mesh.hash, read_mesh(body).hash) << name;
    EXPECT_LT(statistics(mesh).largest_edge, 0.05) << name;
  }
}

TEST(Formats, ThinBodiesComeFromObjFaces) {
  const TemporaryFile file("angle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nf 1 2 4 3\nf 1 2 6 5\n");
  scene::Body body = body_of(file.path(), element::hex(2, 2), {{"size", 0.3}});
  body.thickness = 0.02;
  EXPECT_NEAR(statistics(read_mesh(body)).volume, 2 * 0.02, 1e-9);
  const TemporaryFile branching("branching.obj",
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  body.mesh = branching.path();
  EXPECT_THAT(refusal(body), HasSubstr("its surface branches at 1 of 7 edges"));
}

}  // namespace
}  // namespace idiophone::mesh
