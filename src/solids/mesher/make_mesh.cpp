#include "make_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "flat_tetrahedra.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "quadrilaterals.hpp"
#include "refusal.hpp"
#include "serendipity.hpp"
#include "triangles.hpp"
#include "unit_check.hpp"
#include "views.hpp"

namespace idiophone::mesher {

namespace {

using mesh::FileFormat;

/// Metres for each unit of length of a file other than .geo and .msh.
double scale_of(const mesh::MeshingRequest& request) {
  const auto scale = request.parameters.find("scale");
  return request.format == FileFormat::geo || scale == request.parameters.end() ? 1.0 : scale->second;
}

std::vector<mesh::Objection> open_file(const mesh::MeshingRequest& request, const GeoScripts& scripts) {
  if (request.format == FileFormat::geo) {
    return scripts.open_with_parameters(request);
  }
  if (const auto size = request.parameters.find("size"); size != request.parameters.end()) {
    gmsh::option::setNumber("Mesh.MeshSizeMax", size->second / scale_of(request));
  }
  if (request.format == FileFormat::obj) {
    open_obj(request.file, request.object);
  } else if (request.format == FileFormat::model) {
    open_model(request.file, request.object);
  } else {
    gmsh::open(request.file);
  }
  return request.format == FileFormat::msh ? std::vector<mesh::Objection>() : doubts_about_unit(request);
}

std::vector<mesh::ElementBlock> elements(int dimension) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> element_tags, node_tags;
  gmsh::model::mesh::getElements(types, element_tags, node_tags, dimension);
  std::vector<mesh::ElementBlock> blocks;
  for (std::size_t i = 0; i < types.size(); ++i) {
    auto& block = blocks.emplace_back();
    block.type = types[i];
    int order = 0, corners = 0;
    std::vector<double> positions;
    gmsh::model::mesh::getElementProperties(types[i], block.type_name, dimension, order, block.width, positions,
                                            corners);
    block.element_tags.assign(element_tags[i].begin(), element_tags[i].end());
    block.node_tags.assign(node_tags[i].begin(), node_tags[i].end());
  }
  return blocks;
}

bool has_elements(int dimension) {
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, dimension);
  return !types.empty();
}

/// Makes elements whose order is outside the request's range elements of the nearest order in it. A mixed mesh, which
/// will be refused, keeps its elements, because gmsh would number them anew.
void bring_to_order(const mesh::MeshingRequest& request) {
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, request.dimension);
  if (types.size() != 1) {
    return;
  }
  std::string name;
  int dimension = 0, order = 0, nodes = 0, corners = 0;
  std::vector<double> positions;
  gmsh::model::mesh::getElementProperties(types.front(), name, dimension, order, nodes, positions, corners);
  if (order < request.lowest_order || order > request.highest_order) {
    gmsh::option::setNumber("Mesh.SecondOrderIncomplete", 0);
    gmsh::model::mesh::setOrder(std::clamp(order, request.lowest_order, request.highest_order));
  }
}

/// Of all elements of some points, curves, surfaces or volumes, ascending. gmsh's own list of them takes it ten times
/// as long.
std::vector<std::uint64_t> nodes_of(int dimension, const std::vector<int>& entities) {
  std::vector<std::uint64_t> nodes;
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> element_tags, node_tags;
    gmsh::model::mesh::getElements(types, element_tags, node_tags, dimension, entity);
    for (const auto& block : node_tags) {
      nodes.insert(nodes.end(), block.begin(), block.end());
    }
  }
  keep_each_once(nodes);
  return nodes;
}

/// The tags of all elements of some surfaces or volumes.
std::vector<std::uint64_t> elements_of(int dimension, const std::vector<int>& entities) {
  std::vector<std::uint64_t> elements;
  for (const int entity : entities) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> element_tags, node_tags;
    gmsh::model::mesh::getElements(types, element_tags, node_tags, dimension, entity);
    for (const auto& block : element_tags) {
      elements.insert(elements.end(), block.begin(), block.end());
    }
  }
  return elements;
}

/// The nodes of the linear triangles of some surfaces; [3 x triangles].
std::vector<std::uint64_t> triangles_of(const std::vector<int>& surfaces) {
  constexpr int linear_triangle = 2;  // gmsh's number of the type
  std::vector<std::uint64_t> nodes;
  for (const int surface : surfaces) {
    std::vector<std::size_t> element_tags, node_tags;
    gmsh::model::mesh::getElementsByType(linear_triangle, element_tags, node_tags, surface);
    nodes.insert(nodes.end(), node_tags.begin(), node_tags.end());
  }
  return nodes;
}

/// @param of_body  dimension of the elements that the body is made of
std::vector<mesh::GroupBlock> groups(int of_body) {
  gmsh::vectorpair found;
  gmsh::model::getPhysicalGroups(found);
  std::vector<mesh::GroupBlock> blocks;
  for (const auto& [dimension, tag] : found) {
    auto& block = blocks.emplace_back();
    block.tag = tag;
    gmsh::model::getPhysicalName(dimension, tag, block.name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, entities);
    block.node_tags = nodes_of(dimension, entities);
    if (dimension == 2) {
      block.triangles = triangles_of(entities);
    }
    if (dimension == of_body) {
      block.elements = elements_of(dimension, entities);
    }
  }
  return blocks;
}

/// Groups of the faces of a part, by their numbers: CAD files name none. (Those of the volumes; other ones have nodes
/// that no element uses.)
std::vector<mesh::GroupBlock> numbered_faces(int dimension) {
  gmsh::vectorpair found;
  if (dimension == 3) {
    gmsh::vectorpair volumes;
    gmsh::model::getEntities(volumes, 3);
    gmsh::model::getBoundary(volumes, found, false, false, false);
    keep_each_once(found);
  } else {
    gmsh::model::getEntities(found, 2);
  }
  std::vector<mesh::GroupBlock> blocks;
  for (const auto& [of_surface, tag] : found) {
    auto& block = blocks.emplace_back();
    block.tag = tag;
    block.name = "face_" + std::to_string(tag);
    block.node_tags = nodes_of(of_surface, {tag});
    block.triangles = triangles_of({tag});
  }
  return blocks;
}

/// Options of the second and third attempt at a part that gmsh can't mesh as it is, and a note that says so.
std::vector<std::string> try_otherwise(std::int32_t attempt) {
  std::vector<std::string> notes;
  if (attempt >= 1) {  // coarse meshes of the two sides of a curved wall may cross each other
    gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 16);
    notes.emplace_back("elements are smaller than `size` on curved surfaces, because gmsh can't fill it otherwise");
  }
  if (attempt >= 2) {
    gmsh::option::setNumber("Mesh.Algorithm3D", 1);
    notes.emplace_back("Delaunay filled the volume, because HXT can't; it may leave flatter elements");
  }
  return notes;
}

bool is_facets(const mesh::MeshingRequest& request) {
  return request.format == FileFormat::stl || request.format == FileFormat::obj || request.format == FileFormat::model;
}

/// Surfaces with a thickness must be all that there is.
void refuse_volumes(const mesh::MeshingRequest& request) {
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  if (request.dimension == 2 && !volumes.empty()) {
    throw Refusal(
        "it has a volume, but the body has a `thickness`, which makes one from a surface. Leave the "
        "key out, or keep only the middle surface in the file");
  }
}

/// Meshes a geometry.
/// @return notes for the user
std::vector<std::string> generate(const mesh::MeshingRequest& request) {
  const bool thin = request.dimension == 2;
  if (is_facets(request)) {
    thin ? smooth_triangles() : enclose_triangles();
  }
  auto notes = try_otherwise(request.attempt);
  if (!thin) {
    gmsh::model::mesh::generate(3);
    std::ranges::copy(mend_flat_tetrahedra(), std::back_inserter(notes));
    return notes;
  }
  gmsh::option::setNumber("Mesh.SecondOrderLinear", is_facets(request) ? 1 : 0);  // facets are flat
  mesh_with_quadrilaterals();
  return notes;
}

void answer_request(mesh::MeshingAnswer& answer, const mesh::MeshingRequest& request, const GeoScripts& scripts) {
  if (request.format == FileFormat::geo && !request.parameters.empty()) {
    answer.objections = scripts.undefined_parameters(request);
    if (!answer.objections.empty()) {
      return;
    }
  }
  answer.objections = open_file(request, scripts);
  if (!answer.objections.empty()) {
    return;
  }
  refuse_volumes(request);
  if (is_facets(request) || (request.format != FileFormat::msh && !has_elements(request.dimension))) {
    answer.notes = generate(request);
  }
  bring_to_order(request);
  std::vector<std::size_t> tags;
  std::vector<double> parametric;
  gmsh::model::mesh::getNodes(tags, answer.coordinates, parametric);
  answer.node_tags.assign(tags.begin(), tags.end());
  for (double& coordinate : answer.coordinates) {
    coordinate *= scale_of(request);
  }
  if (request.format == FileFormat::msh) {
    answer.views = views();
  }
  answer.groups = groups(request.dimension);  // before the elements, which are larger
  answer.elements = elements(request.dimension);
  complete_serendipity(answer);
  if (request.format != FileFormat::geo && request.format != FileFormat::msh) {
    std::ranges::move(numbered_faces(request.dimension), std::back_inserter(answer.groups));
  }
}

}  // namespace

mesh::MeshingAnswer make_mesh(const mesh::MeshingRequest& request, const GeoScripts& scripts) {
  mesh::MeshingAnswer answer;
  try {
    answer_request(answer, request, scripts);
  } catch (const NoSuchObject& error) {
    answer.objections = {{"object", request.file + ": " + error.what()}};
  } catch (const Refusal& error) {
    answer.objections = {{"", request.file + ": " + error.what()}};
  }
  return answer;
}

}  // namespace idiophone::mesher
