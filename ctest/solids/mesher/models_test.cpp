// Bodies from glTF, PLY and FBX files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "gltf_cube.hpp"
#include "model_files.hpp"
#include "samples.hpp"

namespace idiophone::mesher {

using namespace mesh;  // bodies and files of its tests
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A body of this file, with elements as large as it.
scene::Body model_of(const std::filesystem::path& file, const std::optional<std::string>& object = std::nullopt) {
  scene::Body body = body_of(file, element::tet4, {{"size", 10.0}});
  body.object = object;
  body.object_where = {.file = "deck.yaml", .line = 8, .column = 3};
  return body;
}

Eigen::AlignedBox3d box_around(const Mesh& mesh) {
  Eigen::AlignedBox3d around;
  for (const Vector3& node : mesh.nodes) {
    around.extend(node);
  }
  return around;
}

constexpr const char* placed_cubes =  // of 0.5 m at x = 1, below a node that doubles all, and of 1 m
    R"([{"name": "table", "scale": [2, 2, 2], "children": [1, 2]},
        {"name": "small", "mesh": 0, "translation": [1, 0, 0], "scale": [0.25, 0.25, 0.25]},
        {"name": "large", "mesh": 0, "scale": [0.5, 0.5, 0.5]}])";

TEST(Models, ObjectsAreWhereTheirNodesPutThem) {
  const TemporaryFile file("cubes.gltf", gltf_cube(placed_cubes));
  const Mesh small = read_mesh(model_of(file.path(), "small"));
  EXPECT_TRUE(is_watertight(small));
  EXPECT_NEAR(enclosed_volume(small), 0.125, 1e-12);
  EXPECT_LT((box_around(small).min() - Vector3(2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((box_around(small).max() - Vector3(2.5, 0.5, 0.5)).norm(), 1e-12);
  EXPECT_NEAR(enclosed_volume(read_mesh(model_of(file.path(), "large"))), 1.0, 1e-12);
}

TEST(Models, OneOfSeveralObjectsMustBeNamed) {
  const TemporaryFile file("cubes.gltf", gltf_cube(placed_cubes));
  EXPECT_THAT(
      refusal(model_of(file.path())),
      AllOf(HasSubstr("deck.yaml:7:9: "), HasSubstr("has 2 objects. Name one by the key object: small, large")));
  EXPECT_THAT(refusal(model_of(file.path(), "cup")),
              AllOf(HasSubstr("deck.yaml:8:3: "), HasSubstr("has no object 'cup'. It has: small, large")));
}

TEST(Models, HaveMetresAsTheirFilesSay) {
  for (const auto& [extension, unit] : {std::pair(".glb", 1.0), {".ply", 1.0}, {".fbx", 0.01}}) {
    const TemporaryFile file(std::string("cube") + extension, model_cube(extension));
    const Mesh mesh = read_mesh(model_of(file.path()));
    EXPECT_TRUE(is_watertight(mesh)) << extension;
    EXPECT_LT((box_around(mesh).sizes() - Vector3::Constant(unit)).norm(), 1e-6 * unit) << extension;
    scene::Body scaled = model_of(file.path());
    scaled.parameters["scale"] = 0.1;
    EXPECT_LT((box_around(read_mesh(scaled)).sizes() - Vector3::Constant(0.1 * unit)).norm(), 1e-6 * unit) << extension;
  }
}

TEST(Models, NamePartsOfAnObjFile) {
  std::string text;
  for (const std::string part : {"o left\n", "g right part\n"}) {
    text += part;
    for (std::size_t i = 0; i < 36; ++i) {
      const std::vector<float> all = cube_vertices();
      text += fmt::format("v {} {} {}\n", all[3 * i] + (part == "o left\n" ? 0 : 5), all[3 * i + 1], all[3 * i + 2]);
      text += i % 3 == 2 ? "f -3 -2 -1\n" : "";
    }
  }
  const TemporaryFile file("two.obj", text);
  EXPECT_NEAR(box_around(read_mesh(model_of(file.path(), "right part"))).max()[0], 6.0, 1e-12);
  EXPECT_THAT(refusal(model_of(file.path(), "middle")),
              HasSubstr("no faces of an object 'middle'. It has: left, right part"));
}

TEST(Models, ObjectsOfAnObjFileHaveAllTheirGroups) {
  std::string text = "o cube\ng below\n";
  const std::vector<float> all = cube_vertices();
  for (std::size_t i = 0; i < 36; ++i) {
    text += i == 18 ? "g above\n" : "";
    text += fmt::format("v {} {} {}\n", all[3 * i], all[3 * i + 1], all[3 * i + 2]);
    text += i % 3 == 2 ? "f -3 -2 -1\n" : "";
  }
  const TemporaryFile file("groups.obj", text);
  EXPECT_TRUE(is_watertight(read_mesh(model_of(file.path(), "cube"))));
  EXPECT_THAT(refusal(model_of(file.path(), "below")), HasSubstr("isn't closed"));
}

TEST(Models, WithAHoleAreRefused) {
  const TemporaryFile file("open.gltf", gltf_cube(R"([{"mesh": 0}])", "", 30));
  EXPECT_THAT(refusal(model_of(file.path())), HasSubstr("isn't closed at 4 of 17 edges"));
}

TEST(Models, ReadNothingOutsideTheirFolder) {
  const TemporaryFile beside("beside.bin", cube_bytes());
  const TemporaryFile good("good.gltf", gltf_cube(R"([{"mesh": 0}])", beside.path().filename().string()));
  EXPECT_EQ(refusal(model_of(good.path())), "");
  const TemporaryFile missing("missing.gltf", gltf_cube(R"([{"mesh": 0}])", "cube.bin"));
  EXPECT_THAT(refusal(model_of(missing.path())), HasSubstr("cube.bin, which isn't there. Put that file beside it"));
  const TemporaryFile outside("outside.gltf", gltf_cube(R"([{"mesh": 0}])", "../etc/passwd"));
  EXPECT_THAT(refusal(model_of(outside.path())), AllOf(HasSubstr("etc/passwd"), HasSubstr("outside its folder")));
}

TEST(Models, WithCompressedVerticesAreRefused) {
  std::string text = gltf_cube(R"([{"mesh": 0}])");
  text.insert(1, R"("extensionsRequired": ["KHR_draco_mesh_compression"], )");
  const TemporaryFile file("draco.gltf", text);
  EXPECT_THAT(refusal(model_of(file.path())), HasSubstr("KHR_draco_mesh_compression. Export it without compression"));
}

TEST(Models, SayWhichDensityGivesTheirMass) {
  const TemporaryFile file("cube.gltf", gltf_cube(R"([{"mesh": 0}])"));
  scene::Body body = model_of(file.path());
  body.file_mass = 1200.0;
  EXPECT_THAT(read_mesh(body).notes,
              testing::Contains(HasSubstr("the mass 1200 kg, which it has with the density 1200 kg/m3")));
}

}  // namespace
}  // namespace idiophone::mesher
