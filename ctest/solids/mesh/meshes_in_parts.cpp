// The parts that ranks read of mesh files, and those of the whole mesh.

#include "idiophone/solids/mesh/meshes_in_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <numeric>

#include "hash.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "part_builder.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::HasSubstr;

const Origin origin_of_parts{.name = "test", .code_version = "0", .deck_text = "name: test\n", .overrides = {}};

/// A plate of tet10 and a bar of tet4, whose meshes are files. Every rank has files of its own.
class MeshesInParts : public ::testing::Test {
 protected:
  MeshesInParts()
      : plate_(name("plate")),
        bar_(name("bar")),
        originals_{shipped("square_plate.geo", element::tet10, {{"size", 0.05}}), shipped("bar.geo", element::tet4)} {
    write(0, plate_, [](Mesh&) {});
    write(1, bar_, [](Mesh&) {});
  }

  static std::string name(const std::string& body) {
    return body + std::to_string(parallel::rank_of(MPI_COMM_WORLD)) + ".mesh.h5";
  }

  void write(std::size_t number, const TemporaryFile& file, const std::function<void(Mesh&)>& change) {
    StoredMesh stored = storable_mesh(originals_[number]);
    change(stored.mesh);
    stored.mesh.hash = hash_of(stored.mesh);
    write_mesh_file(file.path(), stored, origin_of_parts);
    bodies[number] = originals_[number];
    bodies[number].mesh = file.path();
    bodies[number].parameters.clear();
  }

  /// What is said on rank 0 of a bar whose mesh was changed; all ranks have to fail.
  std::string refusal_after(const std::function<void(Mesh&)>& change) {
    write(1, bar_, change);
    try {
      const Outlines outlines = read_outlines(bodies, MPI_COMM_WORLD);
      static_cast<void>(read_part(bodies, outlines, {}, MPI_COMM_WORLD));
    } catch (const deck::DeckError& error) {
      return error.what();
    } catch (const parallel::RemoteFailure& error) {
      return error.what();
    }
    return "";
  }

  std::array<scene::Body, 2> bodies;

 private:
  TemporaryFile plate_, bar_;
  std::array<scene::Body, 2> originals_;
};

void expect_same(const Part& found, const Part& wanted) {
  EXPECT_EQ(found.global_nodes, wanted.global_nodes);
  EXPECT_EQ(found.global_elements, wanted.global_elements);
  EXPECT_EQ(found.global_triangles, wanted.global_triangles);
  EXPECT_EQ(found.global_vertices, wanted.global_vertices);
  EXPECT_EQ(found.owned_nodes, wanted.owned_nodes);
  EXPECT_EQ(found.node_ids, wanted.node_ids);
  EXPECT_EQ(found.reference, wanted.reference);
  EXPECT_EQ(found.ghost_rank, wanted.ghost_rank);
  EXPECT_EQ(found.ghost_index, wanted.ghost_index);
  EXPECT_EQ(found.surface, wanted.surface);
  EXPECT_EQ(found.triangle_ids, wanted.triangle_ids);
  EXPECT_EQ(found.triangle_body, wanted.triangle_body);
  EXPECT_EQ(found.vertices, wanted.vertices);
  EXPECT_EQ(found.vertex_ids, wanted.vertex_ids);
  EXPECT_EQ(found.first_piece, wanted.first_piece);
  EXPECT_EQ(found.pieces, wanted.pieces);
  ASSERT_EQ(found.bodies.size(), wanted.bodies.size());
  for (std::size_t body = 0; body < found.bodies.size(); ++body) {
    const BodyPart &a = found.bodies[body], &b = wanted.bodies[body];
    EXPECT_EQ(a.owned_begin, b.owned_begin);
    EXPECT_EQ(a.owned_end, b.owned_end);
    EXPECT_EQ(a.first_element, b.first_element);
    EXPECT_EQ(a.global_elements, b.global_elements);
    EXPECT_EQ(a.element_ids, b.element_ids);
    EXPECT_EQ(a.elements, b.elements);
    EXPECT_EQ(a.owned, b.owned);
  }
}

ON_RANKS(1, 2, 3);

TEST_F(MeshesInParts, AreThoseOfTheWholeMeshWithTheSameOwners) {
  const std::vector<Mesh> whole = read_meshes(bodies);
  const std::vector<std::vector<Index>> coupled = {{0, 5, offsets(whole).nodes[2] - 1}};
  const Outlines outlines = read_outlines(bodies, MPI_COMM_WORLD);
  const ReadPart read = read_part(bodies, outlines, coupled, MPI_COMM_WORLD);
  std::vector<int> owners(read.part.global_nodes);
  for (Index node = 0; node < read.part.owned_nodes; ++node) {
    owners[read.part.node_ids[node]] = parallel::rank_of(MPI_COMM_WORLD);
  }
  MPI_Allreduce(MPI_IN_PLACE, owners.data(), static_cast<int>(owners.size()), MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  expect_same(read.part, PartBuilder(whole, owners, coupled).build(parallel::rank_of(MPI_COMM_WORLD)));
  ASSERT_EQ(read.statistics.size(), parallel::is_root(MPI_COMM_WORLD) ? 2U : 0U);
  for (std::size_t body = 0; body < read.statistics.size(); ++body) {
    const Statistics &found = read.statistics[body], wanted = statistics(whole[body]);
    EXPECT_EQ(found.elements, wanted.elements);
    EXPECT_EQ(found.smallest_edge, wanted.smallest_edge);
    EXPECT_EQ(found.largest_edge, wanted.largest_edge);
    EXPECT_NEAR(found.volume, wanted.volume, 1e-12 * wanted.volume);
    EXPECT_TRUE(found.cells.isApprox(wanted.cells, 1e-12));
    EXPECT_EQ(found.worst_quality, wanted.worst_quality);
    EXPECT_EQ(found.surface_area, wanted.surface_area);
    EXPECT_EQ(outlines.meshes[body].groups, whole[body].groups);
    EXPECT_EQ(outlines.meshes[body].hash, whole[body].hash);
  }
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
