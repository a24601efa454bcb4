// Geometry files that would harm: they end in an error at the deck's mesh key, and leave nothing behind.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "cube_file.hpp"
#include "model_files.hpp"
#include "samples.hpp"

namespace idiophone::mesher {

using namespace mesh;  // bodies and files of its tests
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::filesystem::path hostile_folder =
    std::filesystem::temp_directory_path() / ("mesher_test_" + std::to_string(getpid()));
const std::string victim = (hostile_folder / "victim").string();

/// What is said of a file with this text, without hanging.
std::string refusal_of(const std::string& name, const std::string& text) {
  std::filesystem::create_directory(hostile_folder);
  const auto file = hostile_folder / name;
  std::ofstream(file) << text;
  scene::Body body = body_of(file, element::tet4);
  body.meshing.time_limit = 2.0;
  body.meshing.memory_limit = 5e8;
  const auto start = std::chrono::steady_clock::now();
  std::string said = refusal(body);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  EXPECT_THAT(said, StartsWith("deck.yaml:7:9: "));
  std::filesystem::remove(file);
  EXPECT_TRUE(std::filesystem::is_empty(hostile_folder)) << name << " left something behind";
  std::filesystem::remove_all(hostile_folder);
  return said;
}

constexpr const char* box = "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 1, 1, 1};\n";

TEST(HostileFiles, CannotStartPrograms) {
  for (const std::string command : {"SystemCall", "NonBlockingSystemCall", "System"}) {
    EXPECT_THAT(refusal_of("file.geo", fmt::format("{} \"touch {}\";\n{}", command, victim, box)),
                AnyOf(HasSubstr("tried to start another program"), HasSubstr("syntax error")))
        << command;
  }
  EXPECT_THAT(refusal_of("file.geo", "OnelabRun(\"client\", \"touch " + victim + "\");\n" + box),
              AnyOf(HasSubstr("start another program"), HasSubstr("network"), HasSubstr("isn't allowed")));
}

TEST(HostileFiles, CannotWriteFiles) {
  for (const std::string& line :
       {fmt::format(R"(Printf("text") > "{}";)", victim), fmt::format(R"(Printf("text") >> "{}";)", victim),
        fmt::format(R"(Save "{}.msh";)", victim), fmt::format(R"(Print "{}.geo_unrolled";)", victim)}) {
    EXPECT_THAT(refusal_of("file.geo", box + line), HasSubstr("tried to write a file, which isn't allowed")) << line;
  }
  EXPECT_THAT(refusal_of("file.geo", "CreateDir \"" + victim + "\";"),
              HasSubstr("make, move or remove a file or folder"));
}

TEST(HostileFiles, CannotReadOtherFolders) {
  EXPECT_THAT(refusal_of("file.geo", "Include \"/etc/passwd\";\n"), AllOf(HasSubstr("open"), Not(HasSubstr("root"))));
}

TEST(HostileFiles, CannotFindOutWhichOtherFilesThereAre) {
  EXPECT_THAT(refusal_of("file.geo",
                         "Error(\"seen: %g %g\", FileExists(\"/etc/passwd\"), "
                         "FileExists(StrCat(CurrentDirectory, \"file.geo\")));\n"),
              HasSubstr("seen: 0 1"));
}

TEST(HostileFiles, CannotEndTheProgram) {
  EXPECT_THAT(refusal_of("file.geo", "Exit;"), HasSubstr("ended without a mesh (does the file say Exit?)"));
}

TEST(HostileFiles, CannotHangTheProgram) {
  EXPECT_THAT(refusal_of("file.geo", "For i In {1:1e9}\n x = i;\nEndFor\n"), HasSubstr("longer than 2 s"));
  EXPECT_THAT(refusal_of("file.geo", "Sleep 100000;"), HasSubstr("longer than 2 s"));
  EXPECT_THAT(refusal_of("file.geo", "Macro A\n  Call A;\nReturn\nCall A;\n"), HasSubstr("gmsh"));
}

TEST(HostileFiles, CannotTakeTheMemory) {
  EXPECT_THAT(refusal_of("file.geo", "a[] = {0:1e12};"), AnyOf(HasSubstr("memory"), HasSubstr("longer than 2 s")));
  EXPECT_THAT(refusal_of("file.geo", std::string(box) + "Mesh.MeshSizeMax = 1e-300;"), HasSubstr("gmsh"));
  EXPECT_THAT(refusal_of("file.geo", std::string(box) + "Mesh.MeshSizeMax = 1e-3;"),
              AnyOf(HasSubstr("memory"), HasSubstr("longer than 2 s")));
}

TEST(HostileFiles, CannotHaveListsOfNegativeLength) {
  EXPECT_THAT(refusal_of("file.msh",
                         "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 1 1 1 0 0\n"
                         "$EndEntities\n$Nodes\n1 4 1 4\n3 1 0 -4\n1\n2\n3\n4\n$EndNodes\n"),
              HasSubstr("a list of impossible length"));
}

TEST(HostileFiles, ErrorsOfTheFileAreShown) {
  EXPECT_THAT(refusal_of("file.geo", "Error(\"size must be above %g\", 3);\n"), HasSubstr("size must be above 3"));
}

/// The text with twenty bytes changed by a generator with this seed.
std::string damaged(std::string text, std::uint32_t seed) {
  for (int i = 0; i < 20; ++i) {
    seed = seed * 1664525U + 1013904223U;
    text[(seed >> 8U) % text.size()] = static_cast<char>(seed >> 24U);
  }
  return text;
}

/// Damages a file in several ways.
void expect_mesh_or_error(const std::string& extension, const std::string& good, std::uint32_t seeds) {
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const TemporaryFile file("damaged" + extension, damaged(good, seed));
    scene::Body body = body_of(file.path(), element::tet10);
    body.meshing.time_limit = 2.0;
    body.meshing.memory_limit = 5e8;
    EXPECT_THAT(refusal(body), AnyOf(IsEmpty(), StartsWith("deck.yaml:7:9: "))) << extension << seed;
  }
  const TemporaryFile half("half" + extension, good.substr(0, good.size() / 2));
  EXPECT_THAT(refusal(body_of(half.path(), element::tet4)), StartsWith("deck.yaml:7:9: ")) << extension;
}

TEST(HostileFiles, DamageEndsInAMeshOrAnError) {
  for (const std::string extension : {".step", ".brep", ".stl", ".msh"}) {
    expect_mesh_or_error(extension, cube_file(extension), 4);
  }
}

TEST(HostileFiles, DamageOfModelsEndsInAMeshOrAnError) {
  for (const std::string extension : {".gltf", ".glb", ".ply", ".fbx"}) {
    expect_mesh_or_error(extension, model_cube(extension), 3);
  }
}

TEST(HostileFiles, ShippedFilesCheckTheirParameters) {
  for (const auto& entry : std::filesystem::directory_iterator(IDIOPHONE_SOURCE_DIR "/meshes")) {
    if (entry.path().filename() == "cubed_sphere.geo") {
      continue;  // a part of the two spheres, which check what it uses
    }
    const bool has_radius = entry.path().filename() == "string.geo" || entry.path().filename() == "drum_head.geo";
    for (const double size : {0.0, -1.0}) {
      const std::string parameter = has_radius ? "radius" : "size";  // the cells of those two have other parameters
      EXPECT_THAT(refusal(body_of(entry.path(), element::tet10, {{parameter, size}})), HasSubstr("must be above 0"))
          << entry.path();
    }
  }
  for (const std::string parameter : {"side", "bump"}) {
    EXPECT_THAT(refusal(shipped("square_plate.geo", element::tet4, {{parameter, 0.0}})), HasSubstr("must be above 0"));
  }
  EXPECT_THAT(refusal(shipped("bar.geo", element::tet4, {{"layers", 1.5}})), HasSubstr("whole number"));
}

}  // namespace
}  // namespace idiophone::mesher
