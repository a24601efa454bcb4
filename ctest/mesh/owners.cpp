#include "owners.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "faces.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

std::vector<std::int64_t> nodes_per_rank(const std::vector<int>& owners, int ranks) {
  std::vector<std::int64_t> counts;
  for (int rank = 0; rank < ranks; ++rank) {
    counts.push_back(std::ranges::count(owners, rank));
  }
  return counts;
}

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

}  // namespace
}  // namespace idiophone::mesh
