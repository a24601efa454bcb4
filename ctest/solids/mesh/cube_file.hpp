#pragma once
// Files that gmsh writes.

#include <fstream>
#include <iterator>
#include <string>

#include "gmsh_session.hpp"
#include "samples.hpp"

namespace idiophone::mesh {

/// Of the formats that have both.
enum class Encoding { text, binary };

/// A cube of 1 m in the format of this extension.
inline std::string cube_file(const std::string& extension, Encoding encoding = Encoding::text) {
  const GmshSession session;
  gmsh::model::occ::addBox(0, 0, 0, 1, 1, 1);
  gmsh::model::occ::synchronize();
  gmsh::option::setNumber("Mesh.MeshSizeMax", 0.5);
  gmsh::option::setNumber("Mesh.Binary", encoding == Encoding::binary ? 1 : 0);
  gmsh::model::mesh::generate(3);
  const TemporaryFile file("cube" + extension);
  gmsh::write(file.path().string());
  std::ifstream stream(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace idiophone::mesh
