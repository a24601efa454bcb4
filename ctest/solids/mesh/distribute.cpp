#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/solids/mesh/part.hpp"
#include "idiophone/solids/mesh/part_size.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

std::size_t at(Index number) {
  return static_cast<std::size_t>(number);
}

/// All ranks' lists one after the other, and where each begins: [ranks + 1].
struct Gathered {
  std::vector<Index> items;
  std::vector<int> begins;
};

Gathered gather(const std::vector<Index>& mine) {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(ranks);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  Gathered all{.items = {}, .begins = {0}};
  std::partial_sum(counts.begin(), counts.end(), std::back_inserter(all.begins));
  all.items.resize(all.begins.back());
  MPI_Allgatherv(mine.data(), count, MPI_INT32_T, all.items.data(), counts.data(), all.begins.data(), MPI_INT32_T,
                 MPI_COMM_WORLD);
  return all;
}

/// Do the ranks' lists together hold each number from 0 up to `count` once?
void expect_each_once(const std::vector<Index>& mine, Index count) {
  auto all = gather(mine).items;
  std::ranges::sort(all);
  std::vector<Index> wanted(at(count));
  std::iota(wanted.begin(), wanted.end(), 0);
  EXPECT_EQ(all, wanted);
}

/// A plate of tet10 and a bar of tet4. Every rank reads them, to compare; only rank 0's are distributed.
class Distribute : public ::testing::Test {
 protected:
  Distribute()
      : meshes{read_mesh(shipped("square_plate.geo", element::tet10, {{"size", 0.05}})),
               read_mesh(shipped("bar.geo", element::tet4))} {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    part = distribute(rank == 0 ? meshes : std::vector<Mesh>{}, MPI_COMM_WORLD);
  }

  std::vector<Mesh> meshes;
  Offsets first = offsets(meshes);
  Part part;
};

ON_RANKS(1, 2, 3, 4);

TEST_F(Distribute, EveryNodeElementAndTriangleIsOwnedOnce) {
  EXPECT_EQ(part.global_nodes, first.nodes.back());
  EXPECT_EQ(part.global_elements, first.elements.back());
  EXPECT_EQ(part.global_triangles, first.triangles.back());
  EXPECT_GT(part.owned_nodes, 0);
  expect_each_once({part.node_ids.begin(), part.node_ids.begin() + part.owned_nodes}, part.global_nodes);
  std::vector<Index> owned_elements;
  for (const auto& body : part.bodies) {
    for (std::size_t i = 0; i < body.element_ids.size(); ++i) {
      if (body.owned[i] != 0) {
        owned_elements.push_back(body.element_ids[i]);
      }
    }
  }
  expect_each_once(owned_elements, part.global_elements);
  expect_each_once(part.triangle_ids, part.global_triangles);
}

TEST_F(Distribute, PartsWithoutRanksAreThoseOfTheRanks) {
  int rank = 0, ranks = 0, number = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  for_each_part(meshes, ranks, [&](const Part& other) {
    if (number++ == rank) {
      EXPECT_EQ(other.node_ids, part.node_ids);
      EXPECT_EQ(other.triangle_ids, part.triangle_ids);
      EXPECT_EQ(other.bodies[0].elements, part.bodies[0].elements);
      EXPECT_EQ(size_of(other).ghost_nodes, std::ssize(part.node_ids) - part.owned_nodes);
    }
  });
  EXPECT_EQ(number, ranks);
}

TEST_F(Distribute, SizesAddUpToTheWhole) {
  PartSize sum;
  for_each_part(meshes, 5, [&](const Part& other) {
    const PartSize size = size_of(other);
    sum.elements += size.elements;
    sum.nodes += size.nodes;
    sum.triangles += size.triangles;
    sum.ghost_nodes += size.ghost_nodes;
    EXPECT_EQ(size.neighbours > 0, size.ghost_nodes > 0);  // a rank may have the whole bar, and nothing else
    EXPECT_LE(size.neighbours, 4);
  });
  EXPECT_EQ(sum.elements, part.global_elements);
  EXPECT_EQ(sum.nodes, part.global_nodes);
  EXPECT_EQ(sum.triangles, part.global_triangles);
  EXPECT_GT(sum.ghost_nodes, 0);
}

TEST_F(Distribute, NodesAreTheMeshsAndGhostsNameTheirOwner) {
  const auto everywhere = gather({part.node_ids.begin(), part.node_ids.begin() + part.owned_nodes});
  EXPECT_TRUE(std::is_sorted(part.node_ids.begin(), part.node_ids.begin() + part.owned_nodes));
  EXPECT_TRUE(std::is_sorted(part.node_ids.begin() + part.owned_nodes, part.node_ids.end()));
  ASSERT_EQ(part.ghost_rank.size(), part.node_ids.size() - at(part.owned_nodes));
  for (std::size_t ghost = 0; ghost < part.ghost_rank.size(); ++ghost) {
    const int begin = everywhere.begins[part.ghost_rank[ghost]];
    EXPECT_EQ(everywhere.items[at(begin + part.ghost_index[ghost])], part.node_ids[at(part.owned_nodes) + ghost]);
  }
  for (std::size_t node = 0; node < part.node_ids.size(); ++node) {
    const std::size_t body = part.node_ids[node] < first.nodes[1] ? 0 : 1;
    EXPECT_EQ(part.reference[node], meshes[body].nodes[at(part.node_ids[node] - first.nodes[body])]);
  }
}

TEST_F(Distribute, ARankHasExactlyTheElementsAroundItsNodes) {
  ASSERT_EQ(part.bodies.size(), 2U);
  EXPECT_EQ(part.bodies[0].owned_end, part.bodies[1].owned_begin);
  EXPECT_EQ(part.bodies[1].owned_end, part.owned_nodes);
  for (std::size_t body = 0; body < 2; ++body) {
    const Mesh& mesh = meshes[body];
    const BodyPart& share = part.bodies[body];
    ASSERT_EQ(share.element, mesh.element);
    std::vector<char> is_owned(mesh.nodes.size(), 0);
    for (Index node = share.owned_begin; node < share.owned_end; ++node) {
      is_owned[at(part.node_ids[at(node)] - first.nodes[body])] = 1;
    }
    std::vector<Index> ids;
    std::vector<Index> nodes;
    std::vector<char> owned;
    for (Index element = 0; element < mesh.element_count(); ++element) {
      const auto its_nodes = mesh.element_nodes(element);
      if (std::ranges::any_of(its_nodes, [&](Index node) { return is_owned[at(node)] != 0; })) {
        ids.push_back(first.elements[body] + element);
        std::ranges::transform(its_nodes, std::back_inserter(nodes),
                               [&](Index node) { return first.nodes[body] + node; });
        owned.push_back(is_owned[at(std::ranges::min(its_nodes))]);
      }
    }
    std::vector<Index> global;
    std::ranges::transform(share.elements, std::back_inserter(global),
                           [&](Index node) { return part.node_ids[at(node)]; });
    EXPECT_EQ(share.element_ids, ids);
    EXPECT_EQ(share.owned, owned);
    EXPECT_EQ(global, nodes);
  }
}

TEST_F(Distribute, TrianglesAndVerticesAreTheMeshs) {
  EXPECT_TRUE(std::ranges::is_sorted(part.triangle_ids));
  EXPECT_TRUE(std::ranges::is_sorted(part.vertex_ids));
  for (std::size_t triangle = 0; triangle < part.surface.size(); ++triangle) {
    const auto body = at(part.triangle_body[triangle]);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index node = part.vertices[at(part.surface[triangle][corner])];
      EXPECT_EQ(part.node_ids[at(node)] - first.nodes[body],
                meshes[body].surface[at(part.triangle_ids[triangle] - first.triangles[body])][corner]);
    }
  }
  auto numbers = gather(part.vertex_ids).items;
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  EXPECT_EQ(static_cast<Index>(numbers.size()), part.global_vertices);
  EXPECT_EQ(numbers.back(), part.global_vertices - 1);
}

ON_RANKS(2, 3, 4);

TEST(DistributeTooWide, EveryRankIsToldHowManyRanksWouldDo) {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const TemporaryFile file("one.msh", msh_text(unit_corners(), {"4 2 0 1 1 2 3 4"}));
  const std::vector<Mesh> one = {read_mesh(body_of(file.path(), element::tet4))};
  try {
    static_cast<void>(distribute(one, MPI_COMM_WORLD));
    FAIL() << "one element was spread over " << ranks << " ranks";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("run on at most 1"));
  }
}

}  // namespace
}  // namespace idiophone::mesh
