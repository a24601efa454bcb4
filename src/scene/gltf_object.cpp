#include "gltf_object.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "idiophone/foundation/deck/tree.hpp"

namespace idiophone::scene {

namespace {

using nlohmann::json;
constexpr const char* audio_extension = "KHR_audio_rigid_bodies";
constexpr const char* physics_extension = "KHR_physics_rigid_bodies";

/// The JSON of a file: all of a .gltf file, the first chunk of a .glb file (glTF 2.0, 4.4).
json document(const std::filesystem::path& file) {
  const std::string bytes = deck::read_text(file);
  if (!bytes.starts_with("glTF")) {
    return json::parse(bytes);
  }
  constexpr std::size_t header = 20;  // magic number, version and length of the file; length and type of the chunk
  std::uint32_t length = 0;
  if (bytes.size() >= header) {
    std::memcpy(&length, bytes.data() + 12, sizeof(length));
  }
  if (bytes.size() < header || length > bytes.size() - header || bytes.compare(16, 4, "JSON") != 0) {
    throw std::runtime_error("is damaged: it doesn't begin as a .glb file of glTF 2.0");
  }
  return json::parse(bytes.begin() + header, bytes.begin() + header + length);
}

/// The value at keys one below the other; null where there is none.
const json* find(const json& from, std::initializer_list<const char*> keys) {
  const json* place = &from;
  for (const char* key : keys) {
    if (!place->is_object() || !place->contains(key)) {
      return nullptr;
    }
    place = &place->at(key);
  }
  return place;
}

/// The item of a list whose index is at keys of `from`; null where there is none.
const json* referred(const json* list, const json& from, std::initializer_list<const char*> keys) {
  const json* index = find(from, keys);
  return list == nullptr || index == nullptr ? nullptr : &list->at(index->get<std::size_t>());
}

std::string name_of(const json* item) {
  const json* name = item == nullptr ? nullptr : find(*item, {"name"});
  return name == nullptr ? "" : name->get<std::string>();
}

/// All nodes, or those of this name, or with a mesh of this name, and their descendants.
std::vector<const json*> nodes_of(const json& file, const std::optional<std::string>& object) {
  static const json none = json::array();
  const json* found = find(file, {"nodes"});
  const json& nodes = found == nullptr ? none : *found;
  std::vector<std::size_t> open;
  std::set<std::string> names;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string mesh = name_of(referred(find(file, {"meshes"}), nodes.at(i), {"mesh"}));
    names.insert({name_of(&nodes.at(i)), mesh});
    if (!object || name_of(&nodes.at(i)) == *object || mesh == *object) {
      open.push_back(i);
    }
  }
  if (object && open.empty()) {
    names.erase("");
    throw std::runtime_error(fmt::format("has no object '{}'. It has: {}", *object, fmt::join(names, ", ")));
  }
  std::set<std::size_t> seen;
  std::vector<const json*> result;
  while (!open.empty()) {
    const std::size_t index = open.back();
    open.pop_back();
    if (!seen.insert(index).second) {
      continue;
    }
    const json& node = nodes.at(index);
    result.push_back(&node);
    if (const json* children = find(node, {"children"})) {
      for (const json& child : *children) {
        open.push_back(child.get<std::size_t>());
      }
    }
  }
  return result;
}

/// The acoustic material of a node, by its modal model or its surface; null where it has none.
const json* acoustic_material(const json& file, const json& node) {
  const auto list = [&](const char* key) { return find(file, {"extensions", audio_extension, key}); };
  for (const auto& [key, models] :
       {std::pair("modalModel", list("modalModels")), std::pair("acousticSurface", list("acousticSurfaces"))}) {
    const json* model = referred(models, node, {"extensions", audio_extension, key});
    if (model != nullptr && model->contains("material")) {
      return referred(list("acousticMaterials"), *model, {"material"});
    }
  }
  return nullptr;
}

/// Names of the materials that are seen on a node's mesh.
void add_visible_materials(const json& file, const json& node, std::set<std::string>& names) {
  const json* mesh = referred(find(file, {"meshes"}), node, {"mesh"});
  if (mesh == nullptr) {
    return;
  }
  for (const json& primitive : mesh->at("primitives")) {
    names.insert(name_of(referred(find(file, {"materials"}), primitive, {"material"})));
  }
}

std::optional<double> number(const json& from, std::initializer_list<const char*> keys) {
  const json* value = find(from, keys);
  return value == nullptr ? std::nullopt : std::optional(value->get<double>());
}

/// A node's mass, kg.
std::optional<double> mass_of(const json& file, const json& node) {
  if (const auto mass = number(node, {"extensions", physics_extension, "motion", "mass"})) {
    return mass;
  }
  const json* model = referred(find(file, {"extensions", audio_extension, "modalModels"}), node,
                               {"extensions", audio_extension, "modalModel"});
  return model == nullptr ? std::nullopt : number(*model, {"massProperties", "mass"});
}

FileObject read_object(const json& file, const std::optional<std::string>& name) {
  FileObject object;
  std::set<std::string> acoustic, visible;
  for (const json* node : nodes_of(file, name)) {
    if (const auto mass = mass_of(file, *node)) {
      object.mass = object.mass.value_or(0.0) + *mass;
    }
    if (const json* material = acoustic_material(file, *node)) {
      acoustic.insert(name_of(material));
      object.density = number(*material, {"density"});
      object.young = number(*material, {"youngsModulus"});
      object.poisson = number(*material, {"poissonRatio"});
    }
    add_visible_materials(file, *node, visible);
  }
  visible.erase("");
  const std::set<std::string>& names = acoustic.empty() ? visible : acoustic;
  if (names.size() == 1) {
    object.material = *names.begin();
  }
  if (object.mass && !(*object.mass > 0.0 && std::isfinite(*object.mass))) {
    object.mass.reset();  // glTF's 0 stands for an infinite mass
  }
  return object;
}

}  // namespace

bool is_gltf(const std::filesystem::path& file) {
  return file.extension() == ".gltf" || file.extension() == ".glb";
}

FileObject object_in_gltf(const std::filesystem::path& file, const std::optional<std::string>& object) {
  try {
    return read_object(document(file), object);
  } catch (const json::exception& error) {
    throw std::runtime_error(fmt::format("is damaged: {}", error.what()));
  }
}

std::string constants_in_words(const FileObject& object) {
  const auto words = [](const std::optional<double>& value) { return value ? fmt::format("{:g}", *value) : "..."; };
  return fmt::format("young: {}, poisson: {}, density: {}", words(object.young), words(object.poisson),
                     words(object.density));
}

}  // namespace idiophone::scene
