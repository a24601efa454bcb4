#include "make_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "flat_tetrahedra.hpp"
#include "groups.hpp"
#include "part_parameters.hpp"
#include "quadrilaterals.hpp"
#include "refusal.hpp"
#include "repair.hpp"
#include "serendipity.hpp"
#include "triangles.hpp"
#include "unit_check.hpp"
#include "views.hpp"

namespace idiophone::mesher {

namespace {

using mesh::FileFormat;

std::vector<mesh::Objection> open_file(const mesh::MeshingRequest& request, const GeoScripts& scripts) {
  if (request.format == FileFormat::geo) {
    return scripts.open_with_parameters(request);
  }
  if (const auto size = size_of(request)) {
    gmsh::option::setNumber("Mesh.MeshSizeMax", *size);
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

constexpr std::int32_t last_attempt = 2;  // a request after this one asks why gmsh can't mesh the part

/// Options of the second and third attempt at a part that gmsh can't mesh as it is, and a note that says so.
std::vector<std::string> try_otherwise(const mesh::MeshingRequest& request) {
  const bool keeps_surface = request.wrap == 1;
  std::vector<std::string> notes;
  if (request.attempt >= 1 && !keeps_surface) {  // coarse meshes of the two sides of a curved wall may cross each other
    gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 16);
    notes.emplace_back("elements are smaller than `size` on curved surfaces, because gmsh can't fill it otherwise");
  }
  if (request.attempt >= (keeps_surface ? 1 : 2)) {
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
  std::vector<std::string> notes;
  if (request.wrap == 1) {
    notes = wrap_triangles(request);
    fill_triangles();
  } else if (is_facets(request)) {
    thin ? smooth_triangles() : enclose_triangles();
  }
  std::ranges::copy(try_otherwise(request), std::back_inserter(notes));
  if (!thin) {
    gmsh::model::mesh::generate(3);
    std::ranges::copy(mend_flat_tetrahedra(request.wrap == 1), std::back_inserter(notes));
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
  if (request.attempt > last_attempt) {
    explain_failure(scale_of(request));
  }
  if (is_facets(request) || (request.format != FileFormat::msh && !has_elements(request.dimension))) {
    answer.notes = generate(request);
  }
  bring_to_order(request);
  std::ranges::copy(note_on_ungrouped(request.dimension), std::back_inserter(answer.notes));
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
