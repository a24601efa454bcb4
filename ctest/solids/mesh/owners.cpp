#include "owners.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "idiophone/solids/mesh/faces.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

std::vector<std::int64_t> nodes_per_rank(const std::vector<int>& owners, int ranks) {
  std::vector<std::int64_t> counts(ranks);
  for (const int owner : owners) {
    ++counts[owner];
  }
  return counts;
}

ON_RANKS(1);

TEST(Owners, SharesAreAlikeAndRepeatable) {
  const std::vector<Mesh> meshes = {read_mesh(shipped("square_plate.geo", element::tet10, {{"size", 0.03}}))};
  const auto owners = node_owners(meshes, 4);
  EXPECT_EQ(owners, node_owners(meshes, 4));
  const auto mean = static_cast<std::int64_t>(owners.size()) / 4;
  for (const auto count : nodes_per_rank(owners, 4)) {
    EXPECT_NEAR(static_cast<double>(count), static_cast<double>(mean), 0.2 * static_cast<double>(mean));
  }
}

TEST(Owners, NoRankIsEmptyUpToAsManyRanksAsThereCanBe) {
  const std::vector<Mesh> meshes = {read_mesh(shipped("bar.geo", element::tet4, {{"length", 0.06}, {"size", 0.03}}))};
  const int most = static_cast<int>(std::min<std::size_t>(meshes[0].nodes.size(), meshes[0].element_count()));
  for (int ranks = 1; ranks <= most; ++ranks) {
    EXPECT_THAT(nodes_per_rank(node_owners(meshes, ranks), ranks), ::testing::Each(::testing::Gt(0))) << ranks;
  }
  EXPECT_THROW(static_cast<void>(node_owners(meshes, most + 1)), std::runtime_error);
}

/// Elements that the busiest rank computes.
int most_computed(const Mesh& mesh, int ranks) {
  const auto owners = node_owners({mesh}, ranks);
  std::vector<int> computed(ranks);
  for (Index element = 0; element < mesh.element_count(); ++element) {
    std::set<int> here;
    for (const Index node : mesh.element_nodes(element)) {
      here.insert(owners[node]);
    }
    for (const int rank : here) {
      ++computed[rank];
    }
  }
  return std::ranges::max(computed);
}

// On 16 ranks METIS's k-way method, which keeps the fewest links, lets one rank compute 12 of these 36 elements.
TEST(Owners, TheBusiestRankComputesFewElements) {
  EXPECT_LE(most_computed(read_mesh(shipped("square_plate.geo", element::hex(5, 2),
                                            {{"side", 1.0}, {"size", 0.17}, {"bump", 0.5}})),
                          16),
            10);
}

// Cells that are thicker than long have their columns along the plate: 20 of them make a line. If lines stayed whole,
// one rank would compute 108 of the 400 elements.
TEST(Owners, LinesThroughManyHexahedraAreDivided) {
  EXPECT_LE(most_computed(
                read_mesh(shipped("square_plate.geo", element::hex(3, 2), {{"size", 0.015}, {"thickness", 0.02}})), 16),
            45);
}

TEST(Owners, CloseBodiesAreOnOneRank) {
  // Two pairs of bars, one after the other of each pair: the second bar of a pair lies close beside the first.
  std::vector<Mesh> meshes;
  for (const double place : {0.0, 1.0, 0.031, 1.031}) {
    meshes.push_back(read_mesh(shipped("bar.geo", element::tet4, {{"length", 0.06}, {"size", 0.01}})));
    for (Vector3& node : meshes.back().nodes) {
      node.y() += place;
    }
  }
  const auto owners = node_owners(meshes, 2);
  const std::vector<Index> first = offsets(meshes).nodes;
  const auto owner = [&](std::size_t body) {
    return std::set<int>(owners.begin() + first[body], owners.begin() + first[body + 1]);
  };
  EXPECT_EQ(owner(0), owner(2));
  EXPECT_EQ(owner(1), owner(3));
  EXPECT_NE(owner(0), owner(1));
}

TEST(Owners, ModalBodiesStayWhole) {
  std::vector<Mesh> meshes = {read_mesh(shipped("bar.geo", element::tet4)),
                              read_mesh(shipped("square_plate.geo", element::hex(3, 4), {{"size", 0.06}}))};
  meshes[1].indivisible = true;
  const auto first = static_cast<std::size_t>(offsets(meshes).nodes[1]);
  for (const int ranks : {2, 3, 5}) {
    const auto owners = node_owners(meshes, ranks);
    EXPECT_EQ(std::set<int>(owners.begin() + static_cast<std::ptrdiff_t>(first), owners.end()).size(), 1U);
    EXPECT_THAT(nodes_per_rank(owners, ranks), ::testing::Each(::testing::Gt(0))) << ranks;
  }
  meshes[0].indivisible = true;
  EXPECT_THAT(nodes_per_rank(node_owners(meshes, 2), 2), ::testing::Each(::testing::Gt(0)));
  EXPECT_THROW(static_cast<void>(node_owners(meshes, 3)), std::runtime_error);
}

TEST(Owners, BodiesOfCommonModesStayTogether) {
  std::vector<Mesh> meshes(3, read_mesh(shipped("bar.geo", element::tet4)));
  meshes[1].indivisible = meshes[2].indivisible = true;
  meshes[2].beside = 1;
  const std::vector<Index> first = offsets(meshes).nodes;
  for (const int ranks : {2, 3, 5}) {
    const auto owners = node_owners(meshes, ranks);
    EXPECT_EQ(std::set<int>(owners.begin() + first[1], owners.end()).size(), 1U);
    EXPECT_THAT(nodes_per_rank(owners, ranks), ::testing::Each(::testing::Gt(0))) << ranks;
  }
}

TEST(Owners, TooManyRanksForBodiesOfCommonModes) {
  std::vector<Mesh> meshes(2, read_mesh(shipped("bar.geo", element::tet4)));
  meshes[0].indivisible = meshes[1].indivisible = true;
  meshes[1].beside = 0;
  try {
    static_cast<void>(node_owners(meshes, 2));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("joined ones with large amplitudes lie all on one: run on at most 1"));
  }
}

TEST(Owners, BodiesAreBesideEarlierOnes) {
  std::vector<Mesh> meshes(2, read_mesh(shipped("bar.geo", element::tet4)));
  meshes[0].indivisible = meshes[1].indivisible = true;
  meshes[1].beside = 1;
  EXPECT_THROW(static_cast<void>(node_owners(meshes, 1)), std::invalid_argument);
}

// Mass scaling couples the nodes of a column.
TEST(Owners, ColumnsOfHexahedraStayWhole) {
  const std::vector<Mesh> meshes = {read_mesh(shipped("bar.geo", element::tet4)),
                                    read_mesh(shipped("square_plate.geo", element::hex(3, 4), {{"size", 0.06}}))};
  const auto first = static_cast<std::size_t>(offsets(meshes).nodes[1]);
  for (const int ranks : {2, 3, 5}) {
    const auto owners = node_owners(meshes, ranks);
    std::map<std::pair<double, double>, std::set<int>> columns;  // by place in the plane
    for (std::size_t node = 0; node < meshes[1].nodes.size(); ++node) {
      const Vector3& x = meshes[1].nodes[node];
      columns[{std::round(1e9 * x.x()), std::round(1e9 * x.y())}].insert(owners[first + node]);
    }
    EXPECT_EQ(columns.size(), meshes[1].nodes.size() / 5);
    EXPECT_TRUE(std::ranges::all_of(columns, [](const auto& column) { return column.second.size() == 1; })) << ranks;
    EXPECT_THAT(nodes_per_rank(owners, ranks), ::testing::Each(::testing::Gt(0))) << ranks;
  }
}

}  // namespace
}  // namespace idiophone::mesh
