#include "idiophone/solids/mesh/mesh_values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::HasSubstr;

ON_RANKS(1);

/// A view as gmsh writes it. @param values  lines of number and value
std::string view_text(const std::string& kind, const std::string& name, int count, const std::string& values) {
  return "$" + kind + "\n1\n\"" + name + "\"\n1\n0.0\n3\n0\n1\n" + std::to_string(count) + "\n" + values + "$End" +
         kind + "\n";
}

/// Two tetrahedra, and a node that belongs to neither.
std::string two_tetrahedra() {
  std::vector<Vector3> nodes = unit_corners();
  nodes.insert(nodes.begin(), Vector3(5, 5, 5));
  nodes.emplace_back(1, 1, 1);
  return msh_text(nodes, {"4 2 1 1 2 3 4 5", "4 2 1 1 3 4 5 6"});
}

ValuedMesh read_text(const std::string& text) {
  const TemporaryFile file("values.msh", text);
  return read_mesh_with_values(body_of(file.path(), element::tet4));
}

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(read_text(text));
    return "";
  } catch (const deck::DeckError& error) {
    return error.what();
  }
}

TEST(MeshValues, FollowTheirNodesAndElements) {
  const ValuedMesh read =
      read_text(two_tetrahedra() + view_text("NodeData", "mass", 6, "1 10\n2 20\n3 30\n4 40\n5 50\n6 60\n") +
                view_text("ElementData", "spring_stiffness", 2, "1 0.5\n2 2.5\n"));
  ASSERT_EQ(read.values.size(), 2U);
  ASSERT_EQ(read.mesh.nodes.size(), 5U);
  const std::vector<Vector3> places = unit_corners();
  for (std::size_t node = 0; node < read.mesh.nodes.size(); ++node) {
    const auto found = std::ranges::find(places, read.mesh.nodes[node]);
    EXPECT_EQ(read.values[0].value[node], 20.0 + 10.0 * static_cast<double>(found - places.begin()));
  }
  EXPECT_EQ(read.values[1].name, "spring_stiffness");
  EXPECT_TRUE(read.values[1].of_elements);
  for (Index element = 0; element < 2; ++element) {
    const bool has_origin = std::ranges::any_of(read.mesh.element_nodes(element),
                                                [&](Index node) { return read.mesh.nodes[node] == Vector3::Zero(); });
    EXPECT_EQ(read.values[1].value[element], has_origin ? 0.5 : 2.5);
  }
}

TEST(MeshValues, RefusesWhatIsMissingOrNotANumber) {
  const std::string mesh = two_tetrahedra();
  EXPECT_THAT(refusal_of(mesh + view_text("ElementData", "spring_length", 1, "1 0.5\n")),
              HasSubstr("the view 'spring_length' of"));
  EXPECT_THAT(refusal_of(mesh + view_text("ElementData", "spring_length", 1, "1 0.5\n")),
              HasSubstr("no value for element 2"));
  EXPECT_THAT(refusal_of(mesh + view_text("ElementData", "spring_length", 2, "1 nan\n2 1\n")), HasSubstr("not finite"));
  const std::string vectors = "$NodeData\n1\n\"mass\"\n1\n0.0\n3\n0\n3\n1\n1 1 2 3\n$EndNodeData\n";
  EXPECT_THAT(refusal_of(mesh + vectors), HasSubstr("has vectors"));
}

}  // namespace
}  // namespace idiophone::mesh
