// The parts that ranks read of mesh files, and those of the whole mesh.

#include "idiophone/solids/mesh/meshes_in_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cube_file.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "mesh_files_of_ranks.hpp"
#include "part_builder.hpp"
#include "ranks.hpp"

namespace idiophone::mesh {
namespace {

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
    EXPECT_EQ(a.regions, b.regions);
  }
}

ON_RANKS(1, 2, 3);

void expect_same(const Statistics& found, const Statistics& wanted) {
  EXPECT_EQ(found.elements, wanted.elements);
  EXPECT_EQ(found.smallest_edge, wanted.smallest_edge);
  EXPECT_EQ(found.largest_edge, wanted.largest_edge);
  EXPECT_NEAR(found.volume, wanted.volume, 1e-12 * wanted.volume);
  ASSERT_EQ(found.volumes.size(), wanted.volumes.size());
  for (std::size_t region = 0; region < found.volumes.size(); ++region) {
    EXPECT_NEAR(found.volumes[region], wanted.volumes[region], 1e-12 * wanted.volume);
  }
  EXPECT_TRUE(found.cells.isApprox(wanted.cells, 1e-12));
  EXPECT_EQ(found.worst_quality, wanted.worst_quality);
  EXPECT_EQ(found.worst_element, wanted.worst_element);
  EXPECT_EQ(found.surface_area, wanted.surface_area);
}

/// [global nodes] The ranks that own them, from parts that are visited on this process. Collective.
template <class ForEachPart>
std::vector<int> owners_in(const ForEachPart& for_each_part) {
  std::vector<int> owners;
  for_each_part([&](const Part& part, int rank) {
    owners.resize(part.global_nodes);
    for (Index node = 0; node < part.owned_nodes; ++node) {
      owners[part.node_ids[node]] += rank;
    }
  });
  MPI_Allreduce(MPI_IN_PLACE, owners.data(), static_cast<int>(owners.size()), MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  return owners;
}

std::vector<int> owners_in(const Part& part) {
  return owners_in([&](const auto& visit) { visit(part, parallel::rank_of(MPI_COMM_WORLD)); });
}

/// Columns of nodes of a mesh that several ranks own.
int divided_columns(const Mesh& mesh, const std::vector<int>& owners) {
  const auto lines = static_cast<std::size_t>(element::lines_through(mesh.element));
  int divided = 0;
  for (Index element = 0; element < mesh.element_count(); ++element) {
    const auto nodes = mesh.element_nodes(element);
    for (std::size_t a = lines; a < nodes.size(); ++a) {
      divided += owners[nodes[a]] != owners[nodes[a % lines]] ? 1 : 0;
    }
  }
  return divided;
}

/// What the rank has read, and what the whole meshes give it with the same owners.
void expect_parts_of_whole_meshes(std::span<const scene::Body> bodies) {
  const std::vector<Mesh> whole = read_meshes(bodies);
  const std::vector<std::vector<Index>> coupled = {{0, 5, offsets(whole).nodes.back() - 1}};
  MeshShares shares = read_shares(bodies, MPI_COMM_WORLD);
  const ReadPart read = read_part(bodies, shares, coupled, MPI_COMM_WORLD);
  expect_same(read.part, PartBuilder(whole, owners_in(read.part), coupled).build(parallel::rank_of(MPI_COMM_WORLD)));
  ASSERT_EQ(read.statistics.size(), parallel::is_root(MPI_COMM_WORLD) ? bodies.size() : 0U);
  for (std::size_t body = 0; body < read.statistics.size(); ++body) {
    expect_same(read.statistics[body], statistics(whole[body]));
    EXPECT_EQ(shares.outlines[body].groups, whole[body].groups);
    EXPECT_EQ(shares.outlines[body].hash, whole[body].hash);
  }
}

TEST_F(MeshesInParts, AreThoseOfTheWholeMeshes) {
  add(shipped("square_plate.geo", element::tet10, {{"size", 0.05}}));
  add(turned_and_moved(shipped("bar.geo", element::tet4)));
  expect_parts_of_whole_meshes(bodies);
}

TEST_F(MeshesInParts, HaveSeveralMaterials) {
  const TemporaryFile boxes("boxes.geo", two_boxes);
  add(turned_and_moved(with_groups(boxes, element::tet10, {"head", "core"})));
  add(with_groups(boxes, element::tet4, {"both"}));
  add(with_groups(boxes, element::tet4, {"core", "head"}));
  expect_parts_of_whole_meshes(bodies);
}

TEST_F(MeshesInParts, HaveTheRegionsOfTheirDecksAndNotOfTheirFiles) {
  const TemporaryFile boxes("boxes.geo", two_boxes);
  add(with_groups(boxes, element::tet4, {"core", "head"}));
  bodies.back().regions.clear();
  add(with_groups(boxes, element::tet10, {"head", "core"}));
  bodies.back().regions = with_groups(boxes, element::tet10, {"both"}).regions;
  expect_parts_of_whole_meshes(bodies);
}

TEST_F(MeshesInParts, AreOfHexahedra) {
  const TemporaryFile sheets("sheets.geo", two_rectangles);
  scene::Body wall = with_groups(sheets, element::hex(3, 2), {"right", "left"});
  wall.thickness = 0.005;
  add(wall);
  bodies.back().thickness.reset();
  add(turned_and_moved(shipped("square_plate.geo", element::hex(4, 2), {{"size", 0.1}})));
  expect_parts_of_whole_meshes(bodies);
}

TEST_F(MeshesInParts, HaveWholeColumnsWhereMassIsScaled) {
  add(turned_and_moved(shipped("square_plate.geo", element::hex(3, 2), {{"size", 0.02}})));
  const Mesh whole = read_mesh(bodies.front());
  const auto divided = [&] {
    MeshShares shares = read_shares(bodies, MPI_COMM_WORLD);
    return divided_columns(whole, owners_in(read_part(bodies, shares, {}, MPI_COMM_WORLD).part));
  };
  if (parallel::size_of(MPI_COMM_WORLD) == 3) {
    EXPECT_GT(divided(), 0);
  }
  bodies.front().mass_scaling.emplace();
  EXPECT_EQ(divided(), 0);
  expect_parts_of_whole_meshes(bodies);
}

TEST_F(MeshesInParts, GiveRankZeroTheElementsAtNodes) {
  const TemporaryFile boxes("boxes.geo", two_boxes);
  add(with_groups(boxes, element::tet10, {"head", "core"}));
  add(with_groups(boxes, element::tet4, {"both"}));
  const std::vector<Mesh> whole = read_meshes(bodies);
  MeshShares shares = read_shares(bodies, MPI_COMM_WORLD);
  const std::vector<Index> places = {3, 8, static_cast<Index>(whole[0].nodes.size()) - 1};
  give_root_elements(bodies, shares, {places, {}}, MPI_COMM_WORLD);
  Mesh wanted;
  for (Index element = 0; element < whole[0].element_count(); ++element) {
    const auto nodes = whole[0].element_nodes(element);
    if (std::ranges::any_of(nodes, [&](Index node) { return std::ranges::binary_search(places, node); })) {
      wanted.elements.insert(wanted.elements.end(), nodes.begin(), nodes.end());
      wanted.regions.push_back(whole[0].regions[element]);
    }
  }
  if (parallel::is_root(MPI_COMM_WORLD)) {
    EXPECT_EQ(shares.outlines[0].elements, wanted.elements);
    EXPECT_EQ(shares.outlines[0].regions, wanted.regions);
    EXPECT_LT(wanted.regions.front(), wanted.regions.back());
    EXPECT_TRUE(shares.outlines[1].elements.empty());
  }
}

TEST_F(MeshesInParts, AreDividedAmongMoreRanksThanProcesses) {
  add(shipped("square_plate.geo", element::hex(3, 2), {{"size", 0.02}}));
  bodies.front().mass_scaling.emplace();
  add(shipped("bar.geo", element::tet4));
  const std::vector<Mesh> whole = read_meshes(bodies);
  const std::vector<std::vector<Index>> coupled = {{0, 5, offsets(whole).nodes.back() - 1}};
  MeshShares shares = read_shares(bodies, MPI_COMM_WORLD);
  std::vector<Part> parts;
  for_each_part_in_rows(
      bodies, shares.outlines, shares.offsets, shares.rows, coupled, 7,
      [&](const Part& part) { parts.push_back(part); }, MPI_COMM_WORLD);
  const int begin = 7 * parallel::rank_of(MPI_COMM_WORLD) / parallel::size_of(MPI_COMM_WORLD);
  PartBuilder builder(whole, owners_in([&](const auto& visit) {
                        for (std::size_t place = 0; place < parts.size(); ++place) {
                          visit(parts[place], begin + static_cast<int>(place));
                        }
                      }),
                      coupled);
  for (std::size_t place = 0; place < parts.size(); ++place) {
    expect_same(parts[place], builder.build(begin + static_cast<int>(place)));
  }
}

TEST_F(MeshesInParts, HaveTheGroupsThatTheirDecksDescribe) {
  const TemporaryFile cube("cube.brep", cube_file(".brep"));
  scene::Body body = body_of(cube.path(), element::tet4, {{"size", 0.5}});
  body.fixed.emplace_back().group = "normal 0 0 -1";
  add(body);
  expect_parts_of_whole_meshes(bodies);
}

}  // namespace
}  // namespace idiophone::mesh
