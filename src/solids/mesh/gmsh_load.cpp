#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "gmsh_extract.hpp"
#include "gmsh_mesh.hpp"
#include "group_name.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "load_mesh_file.hpp"
#include "mesher_process.hpp"
#include "regions_by_group.hpp"
#include "spectral_hexahedra.hpp"
#include "thick_wall.hpp"

namespace idiophone::mesh {

namespace {

FileFormat format_of(const scene::Body& body) {
  std::string extension = body.mesh.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  static const std::map<std::string, FileFormat> formats = {
      {".geo", FileFormat::geo},   {".msh", FileFormat::msh},    {".step", FileFormat::cad},
      {".stp", FileFormat::cad},   {".brep", FileFormat::cad},   {".stl", FileFormat::stl},
      {".obj", FileFormat::obj},   {".gltf", FileFormat::model}, {".glb", FileFormat::model},
      {".ply", FileFormat::model}, {".fbx", FileFormat::model}};
  const auto found = formats.find(extension);
  if (found == formats.end()) {
    throw deck::DeckError(body.mesh_where,
                          fmt::format("{} isn't a mesh or geometry that can be read: give a .geo, "
                                      ".msh, .h5, .step, .stp, .brep, .stl, .obj, .gltf, .glb, .ply or .fbx file",
                                      body.mesh.string()));
  }
  return found->second;
}

const deck::Location& place_of(const scene::Body& body, const std::string& parameter) {
  if (parameter == "object" && body.object) {
    return body.object_where;
  }
  const auto found = body.parameters_where.find(parameter);
  return found == body.parameters_where.end() ? body.mesh_where : found->second;
}

/// The parameters of files other than .geo: `size` for geometries, `scale` for them and for meshes.
void check_parameters(const scene::Body& body, FileFormat format) {
  for (const auto& [name, value] : body.parameters) {
    if (name != "scale" && (name != "size" || format == FileFormat::msh)) {
      throw deck::DeckError(
          place_of(body, name),
          fmt::format("{} takes no parameter {} = {}: it has {}scale, its unit (m)", body.mesh.string(), name, value,
                      format == FileFormat::msh ? "" : "size, the largest element size (m), and "));
    }
    if (!(value > 0.0)) {
      throw deck::DeckError(place_of(body, name), fmt::format("{} is {}; it has to be above 0", name, value));
    }
  }
}

/// Elements that gmsh makes for hexahedra follow curved faces as closely as the body's elements can. Those of a .msh
/// file stay as they are; linear ones get nodes on their faces, so that groups tell faces apart.
void set_orders(const scene::Body& body, MeshingRequest& request) {
  switch (body.element.kind) {
    case element::Kind::tet4:
    case element::Kind::tet10:
      request.lowest_order = request.highest_order = element::reference(body.element).gmsh.order;
      return;
    case element::Kind::hex:
      request.hexahedra = 1;
      request.highest_order = std::min<int>(body.element.plane, highest_geometry_order);
      request.lowest_order = request.highest_order;
      if (request.format == FileFormat::msh) {
        request.lowest_order = lowest_geometry_order;
        request.highest_order = std::numeric_limits<std::int32_t>::max();
      }
      return;
  }
  element::unknown_kind();
}

MeshingRequest request_of(const scene::Body& body) {
  MeshingRequest request;
  request.format = format_of(body);
  require_file(body);
  if (request.format != FileFormat::geo) {
    check_parameters(body, request.format);
  }
  request.file = std::filesystem::canonical(body.mesh).string();
  request.object = body.object.value_or("");
  request.parameters = body.parameters;
  request.dimension = body.thickness ? 2 : 3;
  set_orders(body, request);
  request.wrap = body.meshing.repair == scene::Repair::wrap ? 1 : 0;
  request.gap = body.meshing.gap.value_or(0.0);
  request.memory_limit = static_cast<std::uint64_t>(body.meshing.memory_limit);
  return request;
}

/// How often gmsh may try. A surface of triangles is asked once more, why it can't be filled.
int attempts_at(const MeshingRequest& request) {
  if (request.dimension != 3 || request.format == FileFormat::geo || request.format == FileFormat::msh) {
    return 1;
  }
  if (request.format == FileFormat::cad) {
    return 3;
  }
  return request.wrap == 1 ? 2 : 4;
}

/// gmsh's answer. It may try several times to fill a CAD file or a surface, in processes of their own: a failed attempt
/// leaves gmsh unable to start another.
MeshingAnswer answer_of_gmsh(const scene::Body& body, MeshingRequest request) {
  const int attempts = attempts_at(request);
  std::string reason;
  for (; request.attempt < attempts; ++request.attempt) {
    try {
      return run_mesher(request, body.meshing.time_limit);
    } catch (const MesherFailure& failure) {
      reason = request.attempt == 0 || !failure.may_succeed_otherwise ? failure.what() : reason;
      if (!failure.may_succeed_otherwise) {
        break;
      }
    }
  }
  throw deck::DeckError(
      body.mesh_where,
      fmt::format("gmsh can't make the mesh of body '{}' from {}: {}{}", body.name, body.mesh.string(), reason,
                  attempts > 1
                      ? "\n  (A surface that crosses itself can't be filled, nor a wall much thinner than `size`.)"
                      : ""));
}

MeshingAnswer answer_to(const scene::Body& body, Answers& known) {
  const MeshingRequest request = request_of(body);
  const std::string key = to_bytes(request);
  if (const auto found = known.of_gmsh.find(key); found != known.of_gmsh.end()) {
    return found->second;
  }
  MeshingAnswer answer = answer_of_gmsh(body, request);
  if (answer.node_tags.size() <= most_kept_nodes) {
    known.of_gmsh.emplace(key, answer);
  }
  return answer;
}

GmshMesh wall_of(const scene::Body& body, const MeshingAnswer& answer) {
  SurfaceMesh surface = extract_surface(body, answer);
  orient(body, surface);
  return thick_wall(body, surface);
}

GmshMesh load_by_gmsh(const scene::Body& body, Answers& known) {
  const MeshingAnswer answer = answer_to(body, known);
  std::vector<deck::Mistake> mistakes;
  for (const auto& [parameter, message] : answer.objections) {
    mistakes.push_back({place_of(body, parameter), message});
  }
  if (!mistakes.empty()) {
    throw deck::DeckError(mistakes);
  }
  GmshMesh result = body.thickness ? wall_of(body, answer) : extract(body, answer);
  result.made_here = format_of(body) != FileFormat::msh;
  result.mesh.notes = answer.notes;
  result.views = answer.views;
  for (const GroupBlock& group : answer.groups) {
    if (!group.elements.empty()) {
      auto& elements = result.element_groups[name_of(group)];
      elements.insert(elements.end(), group.elements.begin(), group.elements.end());
    }
  }
  return result;
}

}  // namespace

GmshMesh load(const scene::Body& body, Answers& known) {
  GmshMesh result = is_mesh_file(body.mesh) ? load_mesh_file(body, known) : load_by_gmsh(body, known);
  if (!body.regions.empty() && !body.has_layers()) {
    result.mesh.regions = regions_by_group(body, result);
  }
  return result;
}

}  // namespace idiophone::mesh
