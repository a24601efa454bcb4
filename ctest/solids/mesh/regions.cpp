// Which elements have which material: by physical groups of the mesh, or by layers of a wall.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "idiophone/solids/mesh/part_size.hpp"
#include "idiophone/solids/mesh/refined.hpp"
#include "idiophone/solids/mesh/statistics.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

ON_RANKS(1);

TEST(MaterialRegions, AreThePhysicalGroupsOfTheMesh) {
  const TemporaryFile file("boxes.geo", two_boxes);
  for (const element::Type type : {element::tet4, element::tet10}) {
    const Mesh mesh = read_mesh(with_groups(file, type, {"head", "core"}));
    EXPECT_TRUE(std::ranges::is_sorted(mesh.regions));
    const Statistics found = statistics(mesh);
    ASSERT_EQ(found.volumes.size(), 2U);
    EXPECT_NEAR(found.volumes[0], 0.2 * 0.05 * 0.05, 1e-15);
    EXPECT_NEAR(found.volumes[1], 0.1 * 0.05 * 0.05, 1e-15);
    EXPECT_NE(mesh.hash, read_mesh(with_groups(file, type, {"core", "head"})).hash);
    EXPECT_TRUE(read_mesh(body_of(file.path(), type)).regions.empty());
  }
}

TEST(MaterialRegions, OfHexahedraAndOfWalls) {
  const TemporaryFile file("rectangles.geo", two_rectangles);
  scene::Body body = with_groups(file, element::hex(3, 2), {"left", "right"});
  body.thickness = 0.01;
  const Statistics wall = statistics(read_mesh(body));
  ASSERT_EQ(wall.volumes.size(), 2U);
  EXPECT_NEAR(wall.volumes[0], 0.1 * 0.05 * 0.01, 1e-16);
  EXPECT_NEAR(wall.volumes[1], 0.2 * 0.05 * 0.01, 1e-16);

  const TemporaryFile blocks("blocks.geo", std::string(two_boxes) +
                                               "Transfinite Curve {:} = 3; Transfinite Surface {:};\n"
                                               "Transfinite Volume {:}; Recombine Surface {:};\n");
  const Mesh mesh = read_mesh(with_groups(blocks, element::hex(3, 2), {"core", "head"}));
  EXPECT_NEAR(statistics(mesh).volumes.at(1), 0.2 * 0.05 * 0.05, 1e-15);
}

TEST(MaterialRegions, OfLayersFollowTheSurfaceNormal) {
  const TemporaryFile file("rectangles.geo", two_rectangles);
  scene::Body body = body_of(file.path(), element::hex(3, 2));
  body.regions = {region("1", 10, 0.002), region("2", 11, 0.003), region("3", 12, 0.001)};
  body.thickness = 0.006;
  const Mesh mesh = read_mesh(body);
  const std::array<double, 4> heights = {-0.003, -0.001, 0.002, 0.003};
  for (Index element = 0; element < mesh.element_count(); ++element) {
    const auto layer = static_cast<std::size_t>(mesh.regions[element]);
    for (const Index node : mesh.element_nodes(element)) {
      EXPECT_GE(mesh.nodes[node].z(), heights.at(layer) - 1e-15);
      EXPECT_LE(mesh.nodes[node].z(), heights.at(layer + 1) + 1e-15);
    }
  }
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_THAT(statistics(mesh).volumes,
              ::testing::Pointwise(::testing::DoubleNear(1e-16), std::vector{3e-5, 4.5e-5, 1.5e-5}));
}

TEST(MaterialRegions, StayWhenTheMeshIsRefinedOrDistributed) {
  const TemporaryFile file("boxes.geo", two_boxes);
  const Mesh mesh = read_mesh(with_groups(file, element::tet10, {"head", "core"}));
  EXPECT_NEAR(statistics(refined(mesh).mesh).volumes.at(1), 0.1 * 0.05 * 0.05, 1e-15);
  for_each_part({mesh}, 3, [&](const Part& part) {
    const BodyPart& body = part.bodies[0];
    for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
      EXPECT_EQ(body.region(element), mesh.regions[body.element_ids[element]]);
    }
  });
}

TEST(MaterialRegions, MistakesAreAnswered) {
  const TemporaryFile file("boxes.geo", two_boxes);
  const auto answer = [&](const std::vector<std::string>& groups) {
    return refusal(with_groups(file, element::tet4, groups));
  };
  EXPECT_EQ(answer({"core", "haed"}), "deck.yaml:11:5: bodies.plate.materials: " + file.path().string() +
                                          " has no physical group 'haed' of elements of the body; it has: both, core, "
                                          "head");
  EXPECT_THAT(answer({"core", "skin"}), HasSubstr("no physical group 'skin' of elements of the body"));
  EXPECT_THAT(answer({"core"}), AllOf(StartsWith("deck.yaml:10:5: bodies.plate.materials: "),
                                      HasSubstr("boxes.geo are in none of these groups, such as element ")));
  EXPECT_THAT(answer({"core", "both"}),
              AllOf(StartsWith("deck.yaml:11:5: bodies.plate.materials: in "), HasSubstr("boxes.geo, element "),
                    HasSubstr("is in both groups 'core' and 'both', so it would have two materials")));
  const TemporaryFile without("box.geo", "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 0.1, 0.1, 0.1};");
  EXPECT_THAT(refusal(with_groups(without, element::tet4, {"core"})),
              HasSubstr("it has none: define them by Physical Volume(\"core\") in gmsh"));
}

TEST(MaterialRegions, VolumesInNoGroupAreToldOf) {
  const std::string boxes =
      "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 0.1, 0.1, 0.1}; Box(2) = {0.1, 0, 0, 0.1, 0.1, 0.1}; Coherence;";
  const TemporaryFile one("one.geo", boxes + "Physical Volume(\"part\") = {1};");
  const Mesh mesh = read_mesh(body_of(one.path(), element::tet4));
  EXPECT_NEAR(enclosed_volume(mesh), 0.002, 1e-15);
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("volumes in no physical group (1 of 2) belong to the body, too")));
  for (const std::string groups : {"", "Physical Volume(\"part\") = {1, 2};"}) {
    const TemporaryFile file("all.geo", boxes + groups);
    EXPECT_THAT(read_mesh(body_of(file.path(), element::tet4)).notes, IsEmpty()) << groups;
  }
}

}  // namespace
}  // namespace idiophone::mesh
