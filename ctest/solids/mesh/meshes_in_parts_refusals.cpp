// Mesh files that ranks refuse together.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh_files_of_ranks.hpp"
#include "ranks.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

ON_RANKS(1, 2, 3);

TEST_F(MeshesInParts, NeedAMaterialForEachElement) {
  const TemporaryFile boxes("boxes.geo", two_boxes);
  const auto refusal_of = [&](const std::vector<std::string>& groups, const auto& change) {
    bodies.clear();
    add(with_groups(boxes, element::tet4, {"core", "head"}), change);
    bodies.back().regions = with_groups(boxes, element::tet4, groups).regions;
    return refusal_in_parts();
  };
  const auto leave = [](StoredMesh&) {};
  EXPECT_EQ(refusal_of({"core", "head"}, leave), "");
  EXPECT_THAT(
      refusal_of({"core", "tail"}, leave),
      AllOf(StartsWith("deck.yaml:11:5: "), HasSubstr("no physical group 'tail'"), HasSubstr("both, core, head")));
  EXPECT_THAT(refusal_of({"core", "both"}, leave),
              AllOf(StartsWith("deck.yaml:11:5: "), HasSubstr("is in both groups 'core' and 'both'")));
  const std::string missing = refusal_of({"head"}, leave);
  EXPECT_THAT(missing,
              AllOf(StartsWith("deck.yaml:10:5: "), HasSubstr("are in none of these groups, such as element")));
  const StoredMesh stored = read_mesh_file(bodies.back().mesh);
  EXPECT_THAT(missing, HasSubstr(std::to_string(stored.element_groups.at("core").size()) + " elements of "));
  EXPECT_THAT(
      refusal_of({"core", "head"}, [](StoredMesh& mesh) { std::ranges::reverse(mesh.element_groups.at("head")); }),
      HasSubstr("/element_groups has the list 'head', which does not ascend"));
  EXPECT_THAT(refusal_of({"core", "head"}, [](StoredMesh& mesh) { mesh.element_groups.at("head").push_back(1 << 20); }),
              HasSubstr("/element_groups has the number 1048576"));
}

/// Exchanges the last member that the first of three ranks reads, and the next one.
void exchange_between_ranks(StoredMesh& mesh) {
  Index row = 0;
  for (const auto& [name, elements] : mesh.element_groups) {
    row += static_cast<Index>(elements.size());
  }
  row /= 3;
  for (auto& [name, elements] : mesh.element_groups) {
    if (row > 0 && row < std::ssize(elements)) {
      std::swap(elements[row - 1], elements[row]);
    }
    row -= static_cast<Index>(elements.size());
  }
}

TEST_F(MeshesInParts, HaveGroupsOfElementsThatAscend) {
  const TemporaryFile boxes("boxes.geo", two_boxes);
  add(with_groups(boxes, element::tet4, {"core", "head"}), exchange_between_ranks);
  EXPECT_THAT(refusal_in_parts(), HasSubstr("/element_groups has the list 'both', which does not ascend"));
}

TEST_F(MeshesInParts, AreCheckedAsWholeMeshes) {
  EXPECT_EQ(refusal_after([](Mesh&) {}), "");
  EXPECT_THAT(refusal_after([](Mesh& mesh) { std::swap(mesh.elements[0], mesh.elements[1]); }),
              HasSubstr("has 1 inverted and 0 flat elements"));
  EXPECT_THAT(refusal_after([](Mesh& mesh) { mesh.nodes.emplace_back(9, 9, 9); }), HasSubstr("which no element has"));
  EXPECT_THAT(refusal_after([](Mesh& mesh) { std::swap(mesh.surface.front(), mesh.surface.back()); }),
              HasSubstr("its surface is not sorted"));
  EXPECT_THAT(refusal_after([](Mesh& mesh) {
                const auto first = static_cast<Index>(mesh.nodes.size());
                for (const Vector3& corner : unit_corners()) {
                  mesh.nodes.push_back(corner + Vector3(5, 5, 5));
                }
                for (Index corner = 0; corner < 4; ++corner) {
                  mesh.elements.push_back(first + corner);
                }
              }),
              HasSubstr("falls into 2 parts that share no node"));
}

}  // namespace
}  // namespace idiophone::mesh
