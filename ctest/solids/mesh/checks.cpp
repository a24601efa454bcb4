// Meshes that can't be computed, as small files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal_of(const std::vector<Vector3>& nodes, const std::vector<MshElement>& elements,
                       const std::string& names = "") {
  const TemporaryFile file("bad.msh", msh_text(nodes, elements, names));
  return refusal(body_of(file.path(), element::tet4));
}

/// A unit tetrahedron and more nodes.
std::vector<Vector3> unit_and(std::initializer_list<Vector3> more) {
  auto nodes = unit_corners();
  nodes.insert(nodes.end(), more);
  return nodes;
}

ON_RANKS(1);

TEST(Checks, OneGoodElementPasses) {
  EXPECT_EQ(refusal_of(unit_corners(), {"4 2 0 1 1 2 3 4"}), "");
}

TEST(Checks, UnusedNodesAreDropped) {
  const TemporaryFile file("unused.msh", msh_text(unit_and({{9, 9, 9}}), {"4 2 0 1 1 2 3 4"}));
  EXPECT_EQ(read_mesh(body_of(file.path(), element::tet4)).nodes.size(), 4U);
}

TEST(Checks, UnusedNodesInAGroupAreRefused) {
  const auto said = refusal_of(unit_and({{9, 9, 9}}), {"15 2 3 7 5", "4 2 0 1 1 2 3 4"},
                               "$PhysicalNames\n1\n0 3 \"pin\"\n$EndPhysicalNames\n");
  EXPECT_THAT(said, AllOf(StartsWith("deck.yaml:7:9:"), HasSubstr("group 'pin'"), HasSubstr("node 5")));
}

TEST(Checks, NamesInvertedElements) {
  const auto nodes = unit_and({{1, 1, 1}});
  const auto said = refusal_of(nodes, {"4 2 0 1 1 2 3 4", "4 2 0 1 2 3 5 4"});
  EXPECT_THAT(said, AllOf(HasSubstr("1 inverted and 0 flat elements of 2"), HasSubstr("element 2 at [0.5, 0.5, 0.5]")));
}

TEST(Checks, HintsAtLeftHandedNumbering) {
  EXPECT_THAT(refusal_of(unit_corners(), {"4 2 0 1 2 1 3 4"}), HasSubstr("left-handed"));
}

TEST(Checks, NamesFlatElementsAndHowManyMore) {
  std::vector<Vector3> nodes = unit_corners();
  std::vector<MshElement> elements = {"4 2 0 1 1 2 3 4"};
  for (int i = 0; i < 12; ++i) {
    nodes.emplace_back(0.3 + 0.01 * i, 0.3, 0.0);  // in the plane of nodes 1, 2, 3
    elements.push_back("4 2 0 1 1 2 3 " + std::to_string(nodes.size()));
  }
  EXPECT_THAT(refusal_of(nodes, elements), AllOf(HasSubstr("12 flat"), HasSubstr("and 2 more")));
}

TEST(Checks, CountsDisconnectedParts) {
  std::vector<Vector3> nodes;
  std::vector<MshElement> elements;
  for (int part = 0; part < 300; ++part) {
    for (const auto& corner : unit_corners()) {
      nodes.emplace_back(corner + Vector3(2.0 * part, 0, 0));
    }
    const int last = 4 * part + 4;
    elements.push_back("4 2 0 1 " + std::to_string(last - 3) + " " + std::to_string(last - 2) + " " +
                       std::to_string(last - 1) + " " + std::to_string(last));
  }
  const auto said = refusal_of(nodes, elements);
  EXPECT_THAT(said, AllOf(HasSubstr("falls into 300 parts"), HasSubstr("element 2 at [2.25, 0.25, 0.25]"),
                          HasSubstr("and 290 more")));
}

TEST(Checks, RefusesSizesThatAreNotMetres) {
  const auto scaled = [](double factor) {
    auto nodes = unit_corners();
    std::ranges::for_each(nodes, [&](auto& node) { node *= factor; });
    return refusal_of(nodes, {"4 2 0 1 1 2 3 4"});
  };
  EXPECT_THAT(scaled(1e120), AllOf(StartsWith("deck.yaml:7:9:"), HasSubstr("at most 10000 m")));
  EXPECT_THAT(scaled(1e-120), AllOf(StartsWith("deck.yaml:7:9:"), HasSubstr("at least 1e-06 m")));
}

TEST(Checks, NamesNodesInOnePlace) {
  const auto nodes = unit_and({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
  EXPECT_THAT(refusal_of(nodes, {"4 2 0 1 1 2 3 4", "4 2 0 1 5 6 7 8"}),
              AllOf(HasSubstr("3 pairs of nodes in one place"), HasSubstr("nodes 2 and 5 at [1, 0, 0]")));
}

TEST(Checks, NamesOverlappingElements) {
  const auto nodes = unit_and({{0, 0, 2}, {0, 0, 3}});
  EXPECT_THAT(refusal_of(nodes, {"4 2 0 1 1 2 3 4", "4 2 0 1 1 2 3 5", "4 2 0 1 1 2 3 6"}),
              AllOf(HasSubstr("overlap"), HasSubstr("element 3")));
}

TEST(Checks, NamesAPositionThatIsNone) {
  auto text = msh_text(unit_corners(), {"4 2 0 1 1 2 3 4"});
  text.replace(text.find("2 1.000000"), 10, "2 nan");
  const TemporaryFile file("nan.msh", text);
  EXPECT_NE(refusal(body_of(file.path(), element::tet4)), "");
}

}  // namespace
}  // namespace idiophone::mesh
