// The materials of a body: one for all of it, or one for each of its regions.

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "gltf_object.hpp"
#include "idiophone/scene/body_materials.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

std::vector<MaterialRegion> Body::all_regions() const {
  if (!regions.empty()) {
    return regions;
  }
  MaterialRegion whole;
  whole.material = material;
  whole.grain = grain;
  whole.where = where;
  return {whole};
}

double softest_modulus(const Body& body, std::span<const Material> materials) {
  double softest = std::numeric_limits<double>::infinity();
  for (const MaterialRegion& region : body.all_regions()) {
    softest = std::min(softest, materials[region.material].young);
  }
  return softest;
}

bool is_undamped(const Body& body, std::span<const Material> materials) {
  return std::ranges::none_of(body.all_regions(), [&](const MaterialRegion& region) {
    const Damping& damping = materials[region.material].damping;
    return damping.mass > 0 || damping.stiffness > 0 || damping.loss;
  });
}

namespace {

/// The material of the mesh file's object, by its name.
/// @throws std::runtime_error when it has none, or another density than the file says
std::size_t material_of_file(const FileObject& object, const std::vector<Material>& materials) {
  if (object.material.empty()) {
    throw std::runtime_error("gives it no material, or several: name one by the key material");
  }
  const auto found = std::ranges::find(materials, object.material, &Material::name);
  if (found == materials.end()) {
    throw std::runtime_error(
        fmt::format("has the material '{}', which the deck doesn't know. Name another by the key "
                    "material, or add to materials: {}: {{{}}}",
                    object.material, object.material, constants_in_words(object)));
  }
  if (object.density && std::abs(*object.density / found->density - 1.0) > 0.01) {
    throw std::runtime_error(
        fmt::format("says that '{}' has {:g} kg/m3, but here it has {:g}. Name a material by the key material",
                    object.material, *object.density, found->density));
  }
  return static_cast<std::size_t>(found - materials.begin());
}

/// The material that the deck names, or else the one that a glTF file gives.
bool read_material(Section& section, Body& body, const std::vector<Material>& materials) {
  const bool is_named = section.find("material") != nullptr;
  const Node* mesh = section.find("mesh");
  if (mesh == nullptr || !is_gltf(body.mesh) || !std::filesystem::is_regular_file(body.mesh)) {
    return section.required("material", body.material, names_of(materials));
  }
  try {
    const FileObject object = object_in_gltf(body.mesh, body.object);
    body.file_mass = object.mass;
    if (!is_named) {
      body.material = material_of_file(object, materials);
      return true;
    }
  } catch (const std::runtime_error& error) {
    return section.mistakes().add(*mesh, fmt::format("{} {}", body.mesh.string(), error.what()));
  }
  return section.required("material", body.material, names_of(materials));
}

/// The key grain, right or wrong: that depends on the material.
void read_grain(Section& section, const Material& material, Eigen::Matrix3d& axes) {
  if (!material.is_isotropic()) {
    section.optional("grain", axes, grain);
  } else {
    section.refuse("grain", fmt::format("has no meaning: '{}' is isotropic", material.name));
  }
}

/// The keys material and grain of a region.
void read_region_material(Section& section, MaterialRegion& region, const std::vector<Material>& materials) {
  section.know("grain");
  if (section.required("material", region.material, names_of(materials))) {
    read_grain(section, materials[region.material], region.grain);
  }
}

/// MATERIAL, or {material, grain}
bool read_group(const Node& node, Mistakes& mistakes, MaterialRegion& region, const std::vector<Material>& materials) {
  if (node.kind != Node::Kind::map) {
    return read(node, mistakes, region.material, names_of(materials));
  }
  Section section(node, mistakes);
  read_region_material(section, region, materials);
  return section.finish();
}

/// {material, grain, thickness}
bool read_layer(const Node& node, Mistakes& mistakes, MaterialRegion& layer, const std::vector<Material>& materials) {
  Section section(node, mistakes);
  read_region_material(section, layer, materials);
  section.required("thickness", layer.thickness, wall_thickness);
  return section.finish();
}

/// materials: {GROUP: region}. Groups of a mesh have any name.
bool read_groups(const Node& node, Mistakes& mistakes, Body& body, const std::vector<Material>& materials) {
  if (node.kind != Node::Kind::map) {
    return mistakes.add(node, "expected a map from groups of the mesh to materials, found " + describe(node));
  }
  if (node.children.empty()) {
    return mistakes.add(node, "is empty; it needs a material for each group of the mesh's elements");
  }
  bool good = true;
  for (const Node& group : node.children) {
    MaterialRegion& region = body.regions.emplace_back();
    region.name = group.key;
    region.where = group.key_where;
    good &= read_group(group, mistakes, region, materials);
  }
  return good;
}

/// layers: [layer, ...]; the wall is as thick as all of them
bool read_layers(const Node& node, Mistakes& mistakes, Body& body, const std::vector<Material>& materials) {
  if (node.kind != Node::Kind::list) {
    return mistakes.add(node, "expected a list of layers, found " + describe(node));
  }
  if (node.children.empty()) {
    return mistakes.add(node, "is empty; a wall has at least one layer");
  }
  bool good = true;
  body.thickness = 0.0;
  body.thickness_where = node.where;
  for (const Node& layer : node.children) {
    MaterialRegion& region = body.regions.emplace_back();
    region.name = std::to_string(body.regions.size());
    region.where = layer.where;
    good &= read_layer(layer, mistakes, region, materials);
    *body.thickness += region.thickness;
  }
  return good;
}

/// What a body with several materials does not have.
void check_regions(Section& section, const Body& body, const std::vector<Material>& materials) {
  const char* key = body.has_layers() ? "layers" : "materials";
  for (const char* other : {"material", "grain", "springs", "mass_scaling"}) {
    section.refuse(other, fmt::format("has no meaning beside {}", key));
  }
  const double damping = materials[body.regions.front().material].damping.of_all_motion();
  for (const MaterialRegion& region : body.regions) {
    if (materials[region.material].damping.of_all_motion() != damping) {
      section.mistakes().add(region.where,
                             fmt::format("bodies.{}.{}: the damping `mass` slows every motion of the whole body, so "
                                         "all its materials must have the same one, or mass_of: vibration",
                                         body.name, key));
      return;
    }
  }
}

}  // namespace

void read_materials(Section& section, Body& body, const std::vector<Material>& materials) {
  section.know("material");
  const Node* groups = section.find("materials");
  const Node* layers = section.find("layers");
  section.know("grain");  // right or wrong: that depends on the material
  if (groups == nullptr && layers == nullptr) {
    if (read_material(section, body, materials)) {
      read_grain(section, materials[body.material], body.grain);
    }
    return;
  }
  bool good = false;
  if (layers == nullptr) {
    good = read_groups(*groups, section.mistakes(), body, materials);
  } else if (!element::has_choice_of_orders(body.element)) {
    section.refuse("layers",
                   fmt::format("has no meaning with element {}: only hex has it", element::name(body.element)));
  } else {
    section.refuse("materials", "has no meaning beside layers");
    section.refuse("thickness", "has no meaning beside layers: each of them has its own");
    good = read_layers(*layers, section.mistakes(), body, materials);
  }
  if (good) {
    body.material = body.regions.front().material;
    check_regions(section, body, materials);
  }
}

}  // namespace idiophone::scene
