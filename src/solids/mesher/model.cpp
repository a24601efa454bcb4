// glTF, PLY and FBX files, which assimp reads.

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <vector>

#include "files_of_folder.hpp"
#include "refusal.hpp"
#include "triangles.hpp"

namespace idiophone::mesher {

namespace {

using Place = std::array<double, 3>;

/// Triangles without two vertices at one place.
class Welded {
 public:
  void add(const std::array<Place, 3>& corners) {
    std::array<std::size_t, 3> vertices = {};
    for (std::size_t i = 0; i < 3; ++i) {
      vertices.at(i) = vertex_at(corners.at(i));
    }
    if (vertices[0] != vertices[1] && vertices[1] != vertices[2] && vertices[2] != vertices[0]) {
      triangles_.insert(triangles_.end(), vertices.begin(), vertices.end());
    }
  }
  [[nodiscard]] const std::vector<double>& coordinates() const { return coordinates_; }
  [[nodiscard]] const std::vector<std::size_t>& triangles() const { return triangles_; }

 private:
  std::size_t vertex_at(const Place& place) {
    for (const double coordinate : place) {
      if (!std::isfinite(coordinate)) {
        throw Refusal("it is damaged: a vertex is nowhere (its coordinates are not finite)");
      }
    }
    const auto [found, is_new] = vertices_.try_emplace(place, vertices_.size() + 1);
    if (is_new) {
      coordinates_.insert(coordinates_.end(), place.begin(), place.end());
    }
    return found->second;
  }
  std::map<Place, std::size_t> vertices_;  // from 1
  std::vector<double> coordinates_;        // [3 x vertices]
  std::vector<std::size_t> triangles_;     // [3 x triangles]
};

/// A node that has meshes, and its place in the file.
struct PlacedNode {
  const aiNode* node = nullptr;
  aiMatrix4x4 transform;
  bool is_wanted = false;  ///< it or a node above it has the wanted name
};

/// assimp calls the second and further parts of the mesh "bowl" "bowl-1", and so on.
bool has_name(const aiScene& scene, const aiNode& node, const std::string& name) {
  const auto mesh_has = [&](unsigned index) {
    const std::string mesh = scene.mMeshes[index]->mName.C_Str();
    return mesh == name || mesh.starts_with(name + "-");
  };
  return node.mName.C_Str() == name || std::any_of(node.mMeshes, node.mMeshes + node.mNumMeshes, mesh_has);
}

/// All nodes with meshes.
std::vector<PlacedNode> placed_nodes(const aiScene& scene, const std::string& object) {
  std::vector<PlacedNode> open = {{scene.mRootNode, aiMatrix4x4(), object.empty()}};
  std::vector<PlacedNode> result;
  while (!open.empty()) {
    PlacedNode place = open.back();
    open.pop_back();
    place.transform = place.transform * place.node->mTransformation;
    place.is_wanted = place.is_wanted || has_name(scene, *place.node, object);
    for (unsigned i = place.node->mNumChildren; i > 0; --i) {
      open.push_back({place.node->mChildren[i - 1], place.transform, place.is_wanted});
    }
    if (place.node->mNumMeshes > 0) {
      result.push_back(place);
    }
  }
  return result;
}

/// The nodes of the object that is asked for.
std::vector<PlacedNode> wanted_nodes(const aiScene& scene, const std::string& object) {
  std::vector<PlacedNode> nodes = placed_nodes(scene, object);
  std::vector<std::string> names;
  for (const PlacedNode& place : nodes) {
    names.emplace_back(place.node->mName.C_Str());
  }
  if (object.empty() && nodes.size() > 1) {
    throw NoSuchObject(
        fmt::format("it has {} objects. Name one by the key object: {}", nodes.size(), fmt::join(names, ", ")));
  }
  std::erase_if(nodes, [](const PlacedNode& place) { return !place.is_wanted; });
  if (!object.empty() && nodes.empty()) {
    throw NoSuchObject(fmt::format("it has no object '{}'. It has: {}", object, fmt::join(names, ", ")));
  }
  return nodes;
}

/// Metres for a file's unit of length. An FBX file gives its unit in centimetres; those of glTF are metres.
double unit_of(const aiScene& scene) {
  float centimetres = 100.0F;
  if (scene.mMetaData != nullptr) {
    scene.mMetaData->Get("UnitScaleFactor", centimetres);
  }
  return 0.01 * double(centimetres);
}

void add_mesh(const aiMesh& mesh, const aiMatrix4x4& transform, double unit, Welded& surface) {
  if (mesh.HasBones() || mesh.mNumAnimMeshes > 0) {
    throw Refusal(
        fmt::format("its mesh '{}' is deformed by bones or shape keys. Apply them in the program that made the "
                    "file, and export the mesh without them",
                    mesh.mName.C_Str()));
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) {
      continue;  // points and lines enclose nothing
    }
    std::array<Place, 3> corners = {};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (face.mIndices[corner] >= mesh.mNumVertices) {
        throw Refusal(
            fmt::format("it is damaged: a face of mesh '{}' has a vertex that there isn't", mesh.mName.C_Str()));
      }
      const aiVector3D place = transform * mesh.mVertices[face.mIndices[corner]];
      corners.at(corner) = {unit * double(place.x), unit * double(place.y), unit * double(place.z)};
    }
    surface.add(corners);
  }
}

/// assimp misreads vertices that are compressed.
void refuse_compressed(const std::string& file) {
  if (!file.ends_with(".gltf") && !file.ends_with(".glb")) {
    return;
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  for (const char* extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"}) {
    if (bytes.find(fmt::format("\"{}\"", extension)) != std::string::npos) {
      throw Refusal(fmt::format("it needs the extension {}. Export it without compression", extension));
    }
  }
}

}  // namespace

void open_model(const std::string& file, const std::string& object) {
  refuse_compressed(file);
  Assimp::Importer importer;
  auto* files = new FilesOfFolder(std::filesystem::path(file).parent_path());
  importer.SetIOHandler(files);  // which owns it
  const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Refusal(files->complaint().empty() ? fmt::format("it can't be read: {}", importer.GetErrorString())
                                             : files->complaint());
  }
  Welded surface;
  for (const PlacedNode& place : wanted_nodes(*scene, object)) {
    for (unsigned i = 0; i < place.node->mNumMeshes; ++i) {
      add_mesh(*scene->mMeshes[place.node->mMeshes[i]], place.transform, unit_of(*scene), surface);
    }
  }
  if (surface.triangles().empty()) {
    throw Refusal("it has no triangles");
  }
  add_triangles(surface.coordinates(), surface.triangles());
}

}  // namespace idiophone::mesher
