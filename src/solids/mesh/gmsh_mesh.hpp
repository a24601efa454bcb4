#pragma once
// A mesh as loaded from a body's file, before checks and order.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "idiophone/solids/mesh/mesh.hpp"
#include "idiophone/solids/mesh/mesh_file.hpp"
#include "idiophone/solids/mesh/meshing.hpp"

namespace idiophone::mesh {

/// A mesh in gmsh's order, without surface and hash, and the numbers ("tags") by which the file and gmsh know its
/// parts.
struct GmshMesh {
  Mesh mesh;
  std::vector<std::size_t> node_tags;                              ///< [nodes]
  std::vector<std::size_t> element_tags;                           ///< [elements]
  std::map<std::string, std::vector<std::size_t>> element_groups;  ///< physical group -> tags of its elements, if any
  std::vector<ViewBlock> views;                                    ///< of a .msh file
  bool made_here = false;  ///< from a geometry; false for a mesh, whose nodes stay where they are
  bool is_stored = false;  ///< from a mesh file of the program: its hexahedra are spectral ones already
};

/// What bodies of the same shape share.
struct Answers {
  std::map<std::string, MeshingAnswer> of_gmsh;        ///< by the bytes of the request
  std::map<std::filesystem::path, StoredMesh> stored;  ///< by the path of the mesh file
};

inline constexpr std::size_t most_kept_nodes = 100'000;  ///< of one of them: about 10 MB

/// Reads the body's file, meshes it where it is a geometry, and brings it to the order that the body asks for. Nodes
/// that no element uses, as the centres of arcs, may be among the nodes.
/// @param known  is asked first, and gets the answer unless it is large
/// @throws deck::DeckError, pointing at the body's mesh key or a parameter, when that can't be done.
[[nodiscard]] GmshMesh load(const scene::Body& body, Answers& known);

}  // namespace idiophone::mesh
