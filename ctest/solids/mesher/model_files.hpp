#pragma once
// Files that assimp writes.

#include <assimp/scene.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "gltf_cube.hpp"
#include "temporary_file.hpp"

namespace idiophone::mesher {

/// A cube of one unit of length in a file with this extension: .glb, .gltf, .ply or .fbx.
inline std::string model_cube(const std::string& extension) {
  const std::string text = gltf_cube(R"([{"name": "cube", "mesh": 0}])");
  if (extension == ".gltf") {
    return text;
  }
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(text.data(), text.size(), 0, "gltf");
  Assimp::Exporter exporter;
  const support::TemporaryFile file("cube" + extension);
  const std::string format = extension == ".glb" ? "glb2" : extension == ".fbx" ? "fbxa" : "ply";
  if (exporter.Export(scene, format, file.path().string()) != AI_SUCCESS) {
    throw std::runtime_error("assimp writes no " + extension + ": " + exporter.GetErrorString());
  }
  std::ifstream stream(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace idiophone::mesher
