#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <numbers>

#include "geo_parameters.hpp"
#include "gmsh_extract.hpp"
#include "gmsh_mesh.hpp"
#include "gmsh_session.hpp"
#include "idiophone/deck/location.hpp"

namespace idiophone::mesh {

namespace {

enum class Format { geo, msh, cad, stl };

Format format_of(const scene::Body& body) {
  std::string extension = body.mesh.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
  static const std::map<std::string, Format> formats = {{".geo", Format::geo},  {".msh", Format::msh},
                                                        {".step", Format::cad}, {".stp", Format::cad},
                                                        {".brep", Format::cad}, {".stl", Format::stl}};
  const auto found = formats.find(extension);
  if (found == formats.end()) {
    throw deck::DeckError(body.mesh_where, fmt::format("{} isn't a mesh or geometry that can be read: give a .geo, "
                                                       ".msh, .step, .stp, .brep or .stl file",
                                                       body.mesh.string()));
  }
  return found->second;
}

/// The parameters of files other than .geo: `size` for geometries, none for meshes.
void apply_parameters(const scene::Body& body, Format format) {
  for (const auto& [name, value] : body.parameters) {
    if (format == Format::msh || name != "size" || !(value > 0.0)) {
      const auto place = body.parameters_where.find(name);
      throw deck::DeckError(place == body.parameters_where.end() ? body.mesh_where : place->second,
                            fmt::format("{} takes no parameter {} = {}: {}", body.mesh.string(), name, value,
                                        format == Format::msh ? "a .msh file has none"
                                                              : "its only one is size, the largest element size, "
                                                                "above 0 m"));
    }
    gmsh::option::setNumber("Mesh.MeshSizeMax", value);
  }
}

bool has_volume_elements() {
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 3);
  return !types.empty();
}

/// Makes the volume that the triangles of an STL file enclose. Facets that meet at less than 40 degrees become one
/// smooth surface, which is meshed anew.
void enclose_triangles() {
  gmsh::model::mesh::classifySurfaces(40.0 * std::numbers::pi / 180.0, true, true);
  gmsh::model::mesh::createGeometry();
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  std::vector<int> tags;
  for (const auto& [dimension, tag] : surfaces) {
    tags.push_back(tag);
  }
  gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop(tags)});
  gmsh::model::geo::synchronize();
}

void open_and_mesh(const scene::Body& body, Format format) {
  if (format == Format::geo) {
    open_with_parameters(body);
  } else {
    apply_parameters(body, format);
    gmsh::open(body.mesh.string());
  }
  if (format == Format::msh || has_volume_elements()) {
    return;
  }
  if (format == Format::stl) {
    enclose_triangles();
  }
  gmsh::model::mesh::generate(3);
}

}  // namespace

GmshMesh load(const scene::Body& body) {
  const Format format = format_of(body);
  if (!std::filesystem::is_regular_file(body.mesh)) {
    throw deck::DeckError(body.mesh_where, fmt::format("there is no file {}; the path counts from the deck's folder",
                                                       body.mesh.string()));
  }
  if (format == Format::geo && !body.parameters.empty()) {
    require_parameters(body);
  }
  return with_gmsh(body, [&] {
    open_and_mesh(body, format);
    bring_to_order(body);
    return extract(body);
  });
}

}  // namespace idiophone::mesh
