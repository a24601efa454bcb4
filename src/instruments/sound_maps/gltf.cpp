#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>

#include "idiophone/foundation/web/base64.hpp"
#include "idiophone/instruments/sound_maps/exports.hpp"
#include "principal_inertia.hpp"
#include "rayleigh_damping.hpp"

namespace idiophone::sound_maps {

namespace {

using nlohmann::json;

// glTF 2.0, 3.6.2.2 and 5.1.
constexpr int float_component = 5126;
constexpr int unsigned_int_component = 5125;
constexpr int array_buffer = 34962;
constexpr int element_array_buffer = 34963;

/// The arrays of a file, one after the other in one buffer.
class Buffer {
 public:
  /// Appends an array. All components have four bytes.
  /// @param type    "SCALAR" or "VEC3"
  /// @param target  of the buffer view; 0 for none
  /// @return index of its accessor
  template <class T>
  std::size_t add(std::span<const T> values, const std::string& type, int component, int target) {
    static_assert(sizeof(T) == 4);
    json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", values.size_bytes()}};
    if (target != 0) {
      view["target"] = target;
    }
    views_.push_back(view);
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + values.size_bytes());
    std::memcpy(&bytes_[begin], values.data(), values.size_bytes());
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", component},
                          {"count", values.size() / (type == "VEC3" ? 3 : 1)},
                          {"type", type}});
    return accessors_.size() - 1;
  }

  /// The same for numbers that have more digits.
  std::size_t add_scalars(const std::vector<double>& values) {
    const std::vector<float> rounded(values.begin(), values.end());
    return add(std::span(rounded), "SCALAR", float_component, 0);
  }

  json& accessor(std::size_t number) { return accessors_[number]; }

  void put_into(json& file) const {
    file["buffers"] = {
        {{"byteLength", bytes_.size()},
         {"uri", "data:application/octet-stream;base64," + web::base64(std::as_bytes(std::span(bytes_)))}}};
    file["bufferViews"] = views_;
    file["accessors"] = accessors_;
  }

 private:
  std::string bytes_;
  json views_ = json::array();
  json accessors_ = json::array();
};

/// glTF wants the bounds of positions.
void add_bounds(json& accessor, const std::vector<float>& positions) {
  std::array<float, 3> least = {positions[0], positions[1], positions[2]};
  std::array<float, 3> most = least;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    least[i % 3] = std::min(least[i % 3], positions[i]);
    most[i % 3] = std::max(most[i % 3], positions[i]);
  }
  accessor["min"] = least;
  accessor["max"] = most;
}

json mass_properties(const SoundMap& map) {
  json properties = {{"mass", map.mass}, {"centerOfMass", {map.centre[0], map.centre[1], map.centre[2]}}};
  if (map.kind == "solid") {
    const auto [moments, axes] = principal_inertia(map);
    properties["inertiaDiagonal"] = {moments[0], moments[1], moments[2]};
    properties["inertiaOrientation"] = {axes.x(), axes.y(), axes.z(), axes.w()};
  }
  return properties;
}

/// Of a map with a material. An orthotropic one has no Poisson's ratio; alpha and beta are left out where they do not
/// give the decay.
json acoustic_material(const SoundMap& map) {
  json material = {
      {"name", map.material->name}, {"density", map.material->density}, {"youngsModulus", map.material->young}};
  if (map.material->poisson != 0.0) {
    material["poissonRatio"] = map.material->poisson;
  }
  if (const auto damping = rayleigh_damping(map)) {
    material["alpha"] = damping->alpha;
    material["beta"] = damping->beta;
  }
  return material;
}

}  // namespace

std::string gltf_file(const sound_maps::SoundMap& map) {
  std::vector<float> positions;
  for (const Vector3& vertex : map.vertices) {
    for (const double coordinate : vertex) {
      positions.push_back(static_cast<float>(coordinate));
    }
  }
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : map.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  std::vector<double> damped, decay;
  for (std::size_t mode = 0; mode < map.modes(); ++mode) {
    decay.push_back(map.decay(mode));
    const double turns = decay.back() / (2.0 * std::numbers::pi);
    const double square = map.frequency[mode] * map.frequency[mode] - turns * turns;
    damped.push_back(std::sqrt(std::max(square, 1e-6)));  // the draft wants frequencies above zero
  }
  Buffer buffer;
  const std::size_t places = buffer.add(std::span<const float>(positions), "VEC3", float_component, array_buffer);
  add_bounds(buffer.accessor(places), positions);
  const std::size_t indices =
      buffer.add(std::span<const std::uint32_t>(corners), "SCALAR", unsigned_int_component, element_array_buffer);
  json model = {{"name", map.body},
                {"frequencies", buffer.add_scalars(damped)},
                {"decayRates", buffer.add_scalars(decay)},
                {"positions", places},
                {"shapes", buffer.add(std::span<const float>(map.shape), "VEC3", float_component, 0)},
                {"indices", indices},
                {"massProperties", mass_properties(map)}};
  json extension = json::object();
  json roles = {{"modalModel", 0}};
  if (map.material) {
    model["material"] = 0;
    extension["acousticMaterials"] = {acoustic_material(map)};
    extension["acousticSurfaces"] = {{{"name", map.body}, {"material", 0}}};  // its finish is not known
    roles["acousticSurface"] = 0;
  }
  extension["modalModels"] = {model};
  json file = {
      {"asset",
       {{"version", "2.0"},
        {"generator", "idiophone " + map.code_version},
        {"extras",
         {{"KHR_audio_rigid_bodies", "draft of 2026 with acousticMaterials, acousticSurfaces, modalModels"}}}}},
      {"extensionsUsed", {"KHR_audio_rigid_bodies"}},
      {"extensions", {{"KHR_audio_rigid_bodies", extension}}},
      {"scene", 0},
      {"scenes", {{{"name", map.name}, {"nodes", {0}}}}},
      {"nodes", {{{"name", map.body}, {"mesh", 0}, {"extensions", {{"KHR_audio_rigid_bodies", roles}}}}}},
      {"meshes",
       {{{"name", map.body}, {"primitives", {{{"attributes", {{"POSITION", places}}}, {"indices", indices}}}}}}}};
  buffer.put_into(file);
  return file.dump(1) + "\n";
}

}  // namespace idiophone::sound_maps
