// Meshes and shapes, which gmsh reads in a program of its own, and that program's answers.

#include "cube_file.hpp"
#include "fixture.hpp"
#include "gmsh_extract.hpp"
#include "idiophone/foundation/deck/tree.hpp"
#include "samples.hpp"

namespace idiophone::mutants {

namespace {

using Meshes = Mutants;
using File = std::filesystem::path;
using mesh::body_of;

/// Two tetrahedra and a group.
mesh::MeshingAnswer small_answer() {
  mesh::MeshingAnswer answer;
  answer.node_tags = {1, 2, 3, 4, 7};
  answer.coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1};
  answer.elements = {{"Tetrahedron 4", 4, 4, {1, 2}, {1, 2, 3, 4, 1, 3, 2, 7}}};
  answer.groups = {{"rim", 1, {1, 2, 3}, {1, 2, 3}, {1}}, {"", 5, {7}, {}, {}}};
  answer.notes = {"note"};
  return answer;
}

TEST_F(Meshes, Answer) {
  expect_answers({.type = "answer",
                  .originals = {made("answer", mesh::to_bytes(small_answer()))},
                  .mutate = mutate_bytes,
                  .read =
                      [](const File& file) {
                        const auto answer = mesh::answer_from(deck::read_text(file));
                        static_cast<void>(mesh::extract(body_of("plate.geo", element::tet4), answer));
                      },
                  .named = " "});
}

TEST_F(Meshes, NumbersOfAnAnswer) {  // which gmsh may make of a foreign file
  const auto mutate = [](const File& file, Random& random) {
    auto answer = small_answer();
    const auto any = [&] { return below(2, random) == 0 ? random() : below(9, random); };
    for (std::size_t changes = 1 + below(3, random); changes > 0; --changes) {
      mesh::ElementBlock& block = answer.elements.front();
      switch (below(9, random)) {
        case 0:
          answer.node_tags[below(5, random)] = any();
          break;
        case 1:
          answer.coordinates.resize(below(16, random));
          break;
        case 2:
          answer.coordinates.push_back(std::nan(""));
          break;
        case 3:
          block.node_tags[below(block.node_tags.size(), random)] = any();
          break;
        case 4:
          block.node_tags.resize(1 + below(9, random));
          break;
        case 5:
          block.width = static_cast<std::int32_t>(any());
          break;
        case 6:
          block.element_tags.resize(below(4, random));
          break;
        case 7:
          answer.groups[0].triangles.push_back(any());
          break;
        default:
          answer.groups[below(2, random)].node_tags.push_back(any());
      }
    }
    std::ofstream(file, std::ios::binary) << mesh::to_bytes(answer);
  };
  expect_answers({.type = "answer_numbers",
                  .originals = {made("answer", mesh::to_bytes(small_answer()))},
                  .mutate = mutate,
                  .read =
                      [](const File& file) {
                        const auto answer = mesh::answer_from(deck::read_text(file));
                        static_cast<void>(mesh::extract(body_of("plate.geo", element::tet4), answer));
                      },
                  .named = "deck.yaml:7:9: "});
}

/// Through gmsh, one in ten.
void expect_meshes_or_errors(const std::string& type, const File& original,
                             const std::map<std::string, double>& parameters = {},
                             const std::function<void(const File&, Random&)>& mutate = mutate_text) {
  expect_answers({.type = type,
                  .originals = {original},
                  .mutate = mutate,
                  .read =
                      [&](const File& file) {
                        scene::Body body = body_of(file, element::tet4, parameters);
                        body.meshing.time_limit = 5.0;
                        body.meshing.memory_limit = 1e9;
                        static_cast<void>(mesh::read_mesh(body));
                      },
                  .named = "deck.yaml:",
                  .share = 10});
}

TEST_F(Meshes, Msh2) {
  expect_meshes_or_errors("msh2",
                          made("two.msh", mesh::msh_text({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                                                         {"4 2 1 1 1 2 3 4", "4 2 1 1 1 3 2 5"},
                                                         "$PhysicalNames\n1\n3 1 \"all\"\n$EndPhysicalNames\n")));
}

TEST_F(Meshes, Msh4) {
  expect_meshes_or_errors("msh4", made("one.msh",
                                       "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                                       "$PhysicalNames\n1\n3 1 \"all\"\n$EndPhysicalNames\n"
                                       "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 1 0\n$EndEntities\n"
                                       "$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"
                                       "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n"));
}

TEST_F(Meshes, Geo) {
  expect_meshes_or_errors("geo", shipped({"meshes/bar.geo"}).front(), {{"size", 0.05}});
}

/// The triangles of a cube of 0.1 m.
std::vector<std::array<int, 3>> cube() {
  return {{1, 3, 2}, {1, 4, 3}, {5, 6, 7}, {5, 7, 8}, {1, 2, 6}, {1, 6, 5},
          {2, 3, 7}, {2, 7, 6}, {3, 4, 8}, {3, 8, 7}, {4, 1, 5}, {4, 5, 8}};
}
constexpr std::array<const char*, 8> cube_corners = {"0 0 0",   "0.1 0 0",   "0.1 0.1 0",   "0 0.1 0",
                                                     "0 0 0.1", "0.1 0 0.1", "0.1 0.1 0.1", "0 0.1 0.1"};

TEST_F(Meshes, Obj) {
  std::string text = "# cube\no cube\n";
  for (const char* corner : cube_corners) {
    text += fmt::format("v {}\n", corner);
  }
  for (const auto& [a, b, c] : cube()) {
    text += fmt::format("f {} {}/1 {}//2\n", a, b, c);
  }
  expect_meshes_or_errors("obj", made("cube.obj", text), {{"size", 0.05}});
}

TEST_F(Meshes, Stl) {
  std::string text = "solid cube\n";
  for (const auto& triangle : cube()) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : triangle) {
      text += fmt::format("vertex {}\n", cube_corners[static_cast<std::size_t>(corner - 1)]);
    }
    text += "endloop\nendfacet\n";
  }
  expect_meshes_or_errors("stl", made("cube.stl", text + "endsolid cube\n"), {{"size", 0.05}});
}

TEST_F(Meshes, BinaryStl) {
  expect_meshes_or_errors("binary_stl", made("cube.stl", mesh::cube_file(".stl", mesh::Encoding::binary)),
                          {{"size", 0.5}}, mutate_bytes);
}

TEST_F(Meshes, BinaryMsh) {
  expect_meshes_or_errors("binary_msh", made("cube.msh", mesh::cube_file(".msh", mesh::Encoding::binary)), {},
                          mutate_bytes);
}

TEST_F(Meshes, Step) {
  expect_meshes_or_errors("step", made("cube.step", mesh::cube_file(".step")), {{"size", 0.5}});
}

TEST_F(Meshes, Brep) {
  expect_meshes_or_errors("brep", made("cube.brep", mesh::cube_file(".brep")), {{"size", 0.5}});
}

}  // namespace

}  // namespace idiophone::mutants
