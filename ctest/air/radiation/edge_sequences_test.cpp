// Which edges follow on which.

#include "idiophone/air/radiation/edge_sequences.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

namespace idiophone::radiation {
namespace {

using std::numbers::pi;

/// The twelve edges of a box.
std::vector<DiffractingEdge> box_edges(const Vector3& corner, const Vector3& size) {
  std::vector<DiffractingEdge> edges;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const double at_u : {0.0, 1.0}) {
      for (const double at_v : {0.0, 1.0}) {
        const Vector3 begin = corner + at_u * size[u] * Vector3::Unit(u) + at_v * size[v] * Vector3::Unit(v);
        // One face is normal to u and extends along v.
        edges.push_back({begin, begin + size[axis] * Vector3::Unit(axis), (1.0 - 2.0 * at_v) * Vector3::Unit(v),
                         (2.0 * at_u - 1.0) * Vector3::Unit(u), 1.5 * pi});
      }
    }
  }
  return edges;
}

std::array<std::size_t, most_in_turn> counts(const std::vector<DiffractingEdge>& edges,
                                             const std::vector<std::size_t>& objects) {
  std::array<std::size_t, most_in_turn> numbers = {};
  for (const EdgeSequence& sequence : find_edge_sequences(edges, objects)) {
    ++numbers.at(sequence.count - 1);
  }
  return numbers;
}

TEST(EdgeSequences, OfABoxGoOverItsFaces) {
  const std::vector<DiffractingEdge> edges = box_edges(Vector3::Zero(), {0.3, 0.2, 0.1});
  EXPECT_EQ(counts(edges, std::vector<std::size_t>(12)), (std::array<std::size_t, 3>{12, 72, 24}));
  for (const EdgeSequence& sequence : find_edge_sequences(edges, std::vector<std::size_t>(12))) {
    const EdgesInTurn way = sequence.placed(edges);
    for (std::size_t i = 1; i < way.count; ++i) {
      EXPECT_TRUE(way.over_face.at(i - 1));
      const Vector3 face = way.edges.at(i).normal;  // of the face that the way comes by
      EXPECT_GT(way.edges.at(i - 1).turned().normal.dot(face), 0.999);
      EXPECT_NEAR((way.edges.at(i).begin - way.edges.at(i - 1).begin).dot(face), 0.0, 1e-9);
    }
  }
}

TEST(EdgeSequences, LeadFromOneThingToAnother) {
  std::vector<DiffractingEdge> edges = screen_edges({{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}});
  EXPECT_EQ(counts(edges, {0, 0, 0, 0}), (std::array<std::size_t, 3>{4, 0, 0}));
  const std::vector<DiffractingEdge> second = screen_edges({{1, -1, 0}, {1, 1, 0}, {1, 1, 1}, {1, -1, 1}});
  edges.insert(edges.end(), second.begin(), second.end());
  const std::vector<EdgeSequence> all = find_edge_sequences(edges, std::vector<std::size_t>(8));
  const auto over_both = [&](const EdgeSequence& sequence) {  // over the upper edges, from x < 0 to x > 1
    const EdgesInTurn way = sequence.placed(edges);
    return sequence.count == 2 && sequence.edges[0] == 2 && sequence.edges[1] == 6 && way.edges[0].normal.x() < 0.0 &&
           way.edges[1].normal.x() < 0.0 && !sequence.over_face[0];
  };
  EXPECT_EQ(std::ranges::count_if(all, over_both), 1);
}

/// Two steps of a staircase: from the upper edge to the lower one through the air.
TEST(EdgeSequences, LeadThroughTheAirBesideAHollow) {
  const std::vector<DiffractingEdge> edges = {
      {{0, -1, 1}, {0, 1, 1}, -Vector3::UnitX(), Vector3::UnitZ(), 1.5 * pi},
      {{1, -1, 0}, {1, 1, 0}, -Vector3::UnitX(), Vector3::UnitZ(), 1.5 * pi},
  };
  const std::vector<EdgeSequence> all = find_edge_sequences(edges, std::vector<std::size_t>(2));
  ASSERT_EQ(all.size(), 4U);  // each edge, and there and back
  EXPECT_FALSE(all[2].over_face[0]);
}

TEST(EdgeSequences, DoNotLeadToWhatIsBehindTheSolid) {
  const std::vector<DiffractingEdge> edges = {
      {{0, -1, 0}, {0, 1, 0}, Vector3::UnitX(), Vector3::UnitZ(), 1.5 * pi},    // the wedge x > 0, z < 0
      {{1, -1, -1}, {1, 1, -1}, Vector3::UnitX(), Vector3::UnitZ(), 1.5 * pi},  // within it
  };
  EXPECT_EQ(find_edge_sequences(edges, std::vector<std::size_t>(2)).size(), 2U);
}

}  // namespace
}  // namespace idiophone::radiation
