// The file that a body's or an obstacle's shape comes from.

#include <algorithm>

#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

/// repair, gap
void read_repair(Section& section, MeshingSettings& settings, const std::filesystem::path& mesh) {
  constexpr std::array with_triangles = {".stl", ".obj", ".ply", ".gltf", ".glb", ".fbx"};
  section.optional("repair", settings.repair, Choices<Repair>{{{"none", Repair::none}, {"wrap", Repair::wrap}}});
  if (settings.repair == Repair::none) {
    section.refuse("gap", "has no meaning without repair: wrap");
    return;
  }
  section.optional("gap", settings.gap, Range{.above = 0.0, .at_most = 1e4, .unit = "m"});
  const std::string extension = mesh.extension().string();
  if (std::ranges::find(with_triangles, extension) == with_triangles.end()) {
    section.refuse("repair", fmt::format("has no meaning: a {} file is no surface of triangles, as {} files are",
                                         extension, fmt::join(with_triangles, ", ")));
  }
}

}  // namespace

static bool read(const Node& node, Mistakes& mistakes, MeshingSettings& settings, const std::filesystem::path& mesh) {
  Section section(node, mistakes);
  section.optional("time_limit", settings.time_limit, Range{.above = 0.0, .at_most = 1e6, .unit = "s"});
  section.optional("memory_limit", settings.memory_limit, Range{.at_least = 1e8, .at_most = 1e15, .unit = "bytes"});
  read_repair(section, settings, mesh);
  return section.finish();
}

namespace {

template <class Shaped>
void read_parameters(const Node& node, Mistakes& mistakes, Shaped& shaped) {
  if (node.kind != Node::Kind::map) {
    mistakes.add(node, "expected a map of numbers, found " + describe(node));
    return;
  }
  if (shaped.mesh.extension() == ".h5") {
    mistakes.add(node.key_where,
                 fmt::format("{}: a .h5 file is a mesh already and has no parameters; leave them out", node.path));
  }
  for (const Node& parameter : node.children) {
    read(parameter, mistakes, shaped.parameters[parameter.key], Range{});
    shaped.parameters_where[parameter.key] = parameter.key_where;
  }
}

template <class Shaped>
void read_object(Section& section, Shaped& shaped) {
  section.optional("object", shaped.object);
  const Node* object = section.find("object");
  if (object == nullptr) {
    return;
  }
  shaped.object_where = object->where;
  constexpr std::array with_objects = {".obj", ".gltf", ".glb", ".fbx"};
  const std::string extension = shaped.mesh.extension().string();
  if (std::ranges::find(with_objects, extension) == with_objects.end()) {
    section.refuse("object", fmt::format("has no meaning: a {} file has no named objects, as {} files have", extension,
                                         fmt::join(with_objects, ", ")));
  }
}

}  // namespace

template <class Shaped>
void read_mesh(Section& section, Shaped& shaped, const Folder& folder) {
  const Node* mesh = section.find("mesh");
  if (section.required("mesh", shaped.mesh, folder)) {
    shaped.mesh_where = mesh->where;
    constexpr std::array known = {".geo", ".msh", ".h5",   ".step", ".stp", ".brep",
                                  ".stl", ".obj", ".gltf", ".glb",  ".ply", ".fbx"};
    if (std::ranges::find(known, shaped.mesh.extension()) == known.end()) {
      section.mistakes().add(*mesh, fmt::format("must end in {}, found {}", fmt::join(known, ", "), describe(*mesh)));
    }
  }
  read_object(section, shaped);
  if (const Node* parameters = section.find("parameters")) {
    read_parameters(*parameters, section.mistakes(), shaped);
  }
  if (shaped.mesh.extension() == ".h5") {
    section.refuse("meshing", "has no meaning: a .h5 file is a mesh already");
  } else {
    section.optional("meshing", shaped.meshing, shaped.mesh);
  }
}

template void read_mesh(Section& section, Body& shaped, const Folder& folder);
template void read_mesh(Section& section, Obstacle& shaped, const Folder& folder);

}  // namespace idiophone::scene
