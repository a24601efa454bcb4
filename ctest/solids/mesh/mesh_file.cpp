// Meshes that are written once and read often.

#include "idiophone/solids/mesh/mesh_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "cube_file.hpp"
#include "gmsh_mesh.hpp"
#include "hash.hpp"
#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/tables.hpp"
#include "idiophone/solids/mesh/numbered_faces.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const Origin origin{.name = "test", .code_version = "0", .deck_text = "name: test\n", .overrides = {}};

/// A body, and the same one whose mesh is a file of the first one's.
struct Stored {
  explicit Stored(const scene::Body& original) : body(original), file(original.name + ".mesh.h5") {
    write_mesh_file(file.path(), storable_mesh(original), origin);
    body.mesh = file.path();
    body.parameters.clear();
    body.thickness.reset();
    body.regions.clear();
  }

  scene::Body body;
  TemporaryFile file;
};

void expect_same(const Mesh& found, const Mesh& wanted) {
  EXPECT_EQ(found.nodes, wanted.nodes);
  EXPECT_EQ(found.elements, wanted.elements);
  EXPECT_EQ(found.regions, wanted.regions);
  EXPECT_EQ(found.surface, wanted.surface);
  EXPECT_EQ(found.groups, wanted.groups);
  EXPECT_EQ(found.group_triangles, wanted.group_triangles);
  EXPECT_EQ(found.element, wanted.element);
  EXPECT_EQ(found.hash, wanted.hash);
}

ON_RANKS(1);

TEST(MeshFile, GivesTheMeshThatItWasMadeFrom) {
  for (const element::Type type : {element::tet4, element::tet10, element::hex(3, 2)}) {
    scene::Body body = shipped("square_plate.geo", type, {{"size", 0.05}});
    expect_same(read_mesh(Stored(body).body), read_mesh(body));
  }
}

TEST(MeshFile, IsTurnedAndMovedByTheDeck) {
  for (const element::Type type : {element::tet10, element::hex(3, 2)}) {
    const scene::Body body = shipped("bar.geo", type);
    const scene::Body moved = turned_and_moved(body);
    const Stored stored(moved);
    EXPECT_EQ(storable_mesh(moved).mesh.nodes, read_mesh(body).nodes);
    expect_same(read_mesh(stored.body), read_mesh(moved));
    EXPECT_EQ(read_mesh(moved).elements, read_mesh(body).elements);
  }
}

TEST(MeshFile, ThatTheDeckMovesTooFarIsRefused) {
  Stored stored(shipped("bar.geo", element::tet4, {{"size", 0.03}}));
  stored.body.position = {0.0, 1e4, 0.0};
  EXPECT_THAT(refusal(stored.body), AllOf(StartsWith("deck.yaml:7:9: "), HasSubstr("comes to lie too far away")));
}

TEST(MeshFile, HasTheFacesOfAPartAndNotTheGroupsOfItsDeck) {
  const TemporaryFile file("cube.brep", cube_file(".brep"));
  scene::Body body = body_of(file.path(), element::tet4, {{"size", 0.5}});
  const std::string bottom = "box -0.1 -0.1 -0.1 1.1 1.1 0.1";
  body.fixed.emplace_back().group = bottom;
  const Stored stored(body);
  EXPECT_FALSE(read_mesh_file(stored.file.path()).mesh.groups.contains(bottom));
  ASSERT_TRUE(read_mesh(body).groups.contains(bottom));
  expect_same(read_mesh(stored.body), read_mesh(body));
  EXPECT_EQ(numbered_faces(read_mesh(stored.body), stored.body).size(), 6U);
}

TEST(MeshFile, HasTheGroupsOfElementsForAnyMaterials) {
  const TemporaryFile file("boxes.geo", two_boxes);
  for (const element::Type type : {element::tet4, element::tet10}) {
    const Stored stored(body_of(file.path(), type));
    for (const std::vector<std::string>& names : {std::vector<std::string>{"core", "head"}, {"head", "core"}}) {
      const scene::Body original = with_groups(file, type, names);
      scene::Body again = stored.body;
      again.regions = original.regions;
      expect_same(read_mesh(again), read_mesh(original));
    }
  }
}

TEST(MeshFile, HasTheLayersOfAWallAsGroups) {
  const TemporaryFile file("rectangles.geo", two_rectangles);
  scene::Body wall = body_of(file.path(), element::hex(3, 2));
  wall.regions = {region("1", 10, 0.002), region("2", 11, 0.003)};
  wall.thickness = 0.005;
  const Stored stored(wall);
  scene::Body again = stored.body;
  again.regions = {region("1", 10), region("2", 11)};
  expect_same(read_mesh(again), read_mesh(wall));

  scene::Body parted = with_groups(file, element::hex(3, 2), {"right", "left"});
  parted.thickness = 0.005;
  scene::Body parted_again = stored.body;
  parted_again.regions = parted.regions;
  EXPECT_EQ(read_mesh(parted_again).regions.size(), 2 * read_mesh(parted).regions.size());  // of two layers

  scene::Body halves = stored.body;
  halves.regions = {region("left", 10)};
  EXPECT_THAT(refusal(halves), HasSubstr("are in none of these groups"));
}

TEST(MeshFile, ThatDoesNotFitTheBodyIsRefused) {
  const Stored stored(shipped("square_plate.geo", element::hex(3, 2), {{"size", 0.1}}));
  const auto answer = [&](const auto& change) {
    scene::Body body = stored.body;
    change(body);
    return refusal(body);
  };
  EXPECT_EQ(answer([](scene::Body&) {}), "");
  EXPECT_THAT(answer([](scene::Body& body) { body.element = element::tet10; }),
              AllOf(StartsWith("deck.yaml:7:9: "),
                    HasSubstr("has `element: hex, order: {plane: 3, thickness: 2}`, and body 'plate' needs `element: "
                              "tet10`: make it from a body with element: tet10")));
  EXPECT_THAT(answer([](scene::Body& body) { body.element = element::hex(3, 3); }), HasSubstr("thickness: 3}"));
  EXPECT_THAT(answer([](scene::Body& body) {
                body.thickness = 0.01;
                body.thickness_where = {.file = "deck.yaml", .line = 9, .column = 5};
              }),
              AllOf(StartsWith("deck.yaml:9:5: "), HasSubstr("already contains the thickness")));
  EXPECT_THAT(answer([](scene::Body& body) { body.mesh = "nowhere.mesh.h5"; }),
              StartsWith("deck.yaml:7:9: there is no file nowhere.mesh.h5"));
}

/// What is said of a file with another number in a dataset, and the checksum of it.
/// @param keep_checksum  the dataset's own
std::string refusal_with(const scene::Body& body, const char* dataset, hsize_t place, auto number, bool keep_checksum) {
  const TemporaryFile changed("changed.mesh.h5");
  std::filesystem::copy_file(body.mesh, changed.path(), std::filesystem::copy_options::overwrite_existing);
  {
    const auto file = hdf5::open_file(changed.path(), MPI_COMM_SELF);
    const auto table = hdf5::open_dataset(file.id(), dataset);
    auto values = hdf5::read<decltype(number)>(table.id(), hdf5::whole(table.id()));
    values.at(place) = number;
    hdf5::write(table.id(), hdf5::whole(table.id()), std::span<const decltype(number)>(values), hdf5::Transfer::alone);
    if (!keep_checksum) {
      hdf5::replace(table.id(), files::checksum_attribute,
                    std::int64_t{files::checksum(std::as_bytes(std::span(values)))});
    }
  }
  scene::Body other = body;
  other.mesh = changed.path();
  return refusal(other);
}

TEST(MeshFile, ThatWasChangedIsRefused) {
  const Stored stored(shipped("bar.geo", element::tet4, {{"size", 0.03}}));
  const auto answer = [&](const char* dataset, auto number, bool keep_checksum = false) {
    return refusal_with(stored.body, dataset, 5, number, keep_checksum);
  };
  EXPECT_THAT(answer("/nodes", 0.5, true),
              AllOf(StartsWith("deck.yaml:7:9: the mesh of body 'plate' can't be read: "), HasSubstr("changed.mesh.h5"),
                    HasSubstr("/nodes does not match its checksum: the file is damaged")));
  EXPECT_THAT(answer("/nodes", 0.5), HasSubstr("the file was changed"));
  EXPECT_THAT(answer("/surface", Index{0}), HasSubstr("the file was changed"));
  EXPECT_THAT(answer("/elements", Index{-1}), HasSubstr("/elements has the number -1, but there are "));
  EXPECT_THAT(answer("/surface", Index{1'000'000}), HasSubstr("/surface has the number 1000000, but there are "));
  EXPECT_THAT(answer("/groups/members", Index{0}), HasSubstr("which does not ascend"));
  EXPECT_THAT(answer("/groups/begins", Index{1}), HasSubstr("/groups has lists that do not fit their names"));
  EXPECT_THAT(answer("/element_groups/members", Index{1'000'000}), HasSubstr("/element_groups has the number 1000000"));
  EXPECT_THAT(answer("/group_triangles/members", Index{-7}), HasSubstr("/group_triangles has the number -7"));
}

/// What is said of a file whose mesh has been changed, with the right checksums and the right hash.
std::string refusal_after(const Stored& original, const std::function<void(Mesh&)>& change) {
  StoredMesh stored = read_mesh_file(original.file.path());
  change(stored.mesh);
  stored.mesh.hash = hash_of(stored.mesh);
  const TemporaryFile changed("consistent.mesh.h5");
  write_mesh_file(changed.path(), stored, origin);
  scene::Body body = original.body;
  body.mesh = changed.path();
  return refusal(body);
}

TEST(MeshFile, OfNodesThatAreNowhereIsRefused) {
  const Stored stored(shipped("bar.geo", element::tet4, {{"size", 0.03}}));
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(refusal_after(stored, [&](Mesh& mesh) { mesh.nodes[5].y() = value; }),
                AllOf(StartsWith("deck.yaml:7:9: "), HasSubstr("/nodes has node 5 at ["), HasSubstr("isn't a place")));
  }
}

TEST(MeshFile, WhoseGroupsHaveTrianglesOfOtherNodesIsRefused) {
  const TemporaryFile boxes("boxes.geo", two_boxes);
  const Stored linear(body_of(boxes.path(), element::tet4));
  scene::Body other = body_of(boxes.path(), element::tet10);
  other.name = "other";
  const Stored quadratic(other);
  EXPECT_EQ(refusal_after(linear, [](Mesh&) {}), "");
  EXPECT_THAT(refusal_after(linear,
                            [](Mesh& mesh) {
                              mesh.group_triangles.at("skin").front()[0] = static_cast<Index>(mesh.nodes.size());
                              mesh.nodes.emplace_back(9, 9, 9);  // of no element
                            }),
              AllOf(StartsWith("deck.yaml:7:9: "), HasSubstr("/group_triangles has a triangle of the nodes "),
                    HasSubstr("in the list 'skin', which are not all in the group 'skin'")));
  EXPECT_THAT(refusal_after(linear, [](Mesh& mesh) { mesh.groups.erase("skin"); }), HasSubstr("not all in the group"));
  EXPECT_THAT(refusal_after(quadratic,
                            [](Mesh& mesh) {
                              mesh.group_triangles["skin"] = {{0, 1, 2}};
                            }),
              HasSubstr("/group_triangles has lists, which only a mesh of tet4 has"));
}

TEST(MeshFile, IsReadOnceForBodiesThatShareIt) {
  const Stored stored(shipped("bar.geo", element::tet4, {{"size", 0.03}}));
  scene::Body moved = stored.body;
  moved.position = {0.0, 1.0, 0.0};
  const std::vector<Mesh> meshes = read_meshes(std::array{stored.body, moved, stored.body});
  expect_same(meshes.at(0), read_mesh(stored.body));
  expect_same(meshes.at(1), read_mesh(moved));
  expect_same(meshes.at(2), meshes.at(0));

  Answers known;
  const GmshMesh first = load(stored.body, known);
  std::filesystem::resize_file(stored.file.path(), 100);
  EXPECT_NE(refusal(stored.body), "");
  EXPECT_EQ(load(stored.body, known).mesh.nodes, first.mesh.nodes);
}

TEST(MeshFile, SaysThatItLeavesValuesOut) {
  const std::string tetrahedron = msh_text(unit_corners(), {"4 2 0 1 1 2 3 4"});
  const auto notes = [](const std::string& text) {
    const TemporaryFile file("values.msh", text);
    return storable_mesh(body_of(file.path(), element::tet4)).mesh.notes;
  };
  EXPECT_THAT(notes(tetrahedron), IsEmpty());
  EXPECT_THAT(notes(tetrahedron + "$NodeData\n1\n\"mass\"\n1\n0.0\n3\n0\n1\n1\n1 10\n$EndNodeData\n"),
              ElementsAre(HasSubstr("are not in the mesh file")));
}

TEST(MeshFile, IsNoOtherFile) {
  const TemporaryFile text("text.h5", "not HDF5"), other("other.h5");
  {
    files::write_origin(hdf5::create_file(other.path(), MPI_COMM_SELF).id(), files::result_format, origin,
                        MPI_COMM_SELF);
  }
  EXPECT_THAT(refusal(body_of(text.path(), element::tet4)), AllOf(StartsWith("deck.yaml:7:9: "), HasSubstr("text.h5")));
  EXPECT_THAT(refusal(body_of(other.path(), element::tet4)),
              HasSubstr("is not an idiophone mesh but an idiophone result"));
}

}  // namespace
}  // namespace idiophone::mesh
