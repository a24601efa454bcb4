// What the exports say, as those who read them take it.

#include "idiophone/instruments/sound_maps/exports.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <numbers>

#include "ranks.hpp"
#include "vibrating_map.hpp"

namespace idiophone::sound_maps {
namespace {

using nlohmann::json;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

sound_maps::SoundMap plate_map() {
  sound_maps::SoundMap map = map_of(radiation::sphere(0.1, 2), [](const Vector3& place) { return place; }, {300, 400});
  map.name = "deck";
  map.body = "ball";
  map.code_version = "0.2.0";
  map.material = {"steel", 7850, 2e11, 0.3};
  map.material_decay = {3, 40};
  map.radiation_decay = {1, 2};
  map.listeners = {{.name = "ear", .position = {0, 0, 1}, .delay = 0.002, .pressure = {{1, 2}, {3, 4}}}};
  return map;
}

/// Numbers of an accessor.
template <class T>
std::vector<T> values_of(const json& file, std::size_t accessor) {
  const std::string uri = file["buffers"][0]["uri"];
  const std::string text = uri.substr(uri.find(',') + 1);
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char letter : text) {
    const auto digit = std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(letter);
    if (digit == std::string::npos) {
      break;
    }
    bits = bits << 6U | static_cast<unsigned>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255U);
    }
  }
  EXPECT_EQ(bytes.size(), file["buffers"][0]["byteLength"].get<std::size_t>());
  const json& view = file["bufferViews"][file["accessors"][accessor]["bufferView"].get<std::size_t>()];
  std::vector<T> values(view["byteLength"].get<std::size_t>() / sizeof(T));
  std::memcpy(values.data(), &bytes.at(view["byteOffset"].get<std::size_t>()), values.size() * sizeof(T));
  return values;
}

ON_RANKS(1);

TEST(Gltf, HasTheModesAsTheDraftSays) {
  const sound_maps::SoundMap map = plate_map();
  const json file = json::parse(gltf_file(map));
  EXPECT_EQ(file["asset"]["version"], "2.0");
  EXPECT_THAT(file["asset"]["extras"]["KHR_audio_rigid_bodies"].get<std::string>(), HasSubstr("draft"));
  EXPECT_THAT(file["extensionsUsed"], ElementsAre("KHR_audio_rigid_bodies"));
  EXPECT_FALSE(file.contains("extensionsRequired"));
  EXPECT_EQ(file["nodes"][0]["extensions"]["KHR_audio_rigid_bodies"]["modalModel"], 0);
  const json& extension = file["extensions"]["KHR_audio_rigid_bodies"];
  EXPECT_EQ(extension["acousticMaterials"][0]["youngsModulus"], 2e11);
  const json& model = extension["modalModels"][0];
  EXPECT_EQ(model["massProperties"]["mass"], 1.0);
  const auto require = [&](const char* key, const char* type, int component, std::size_t count) {
    const json& accessor = file["accessors"][model[key].get<std::size_t>()];
    EXPECT_EQ(accessor["type"], type) << key;
    EXPECT_EQ(accessor["componentType"], component) << key;
    EXPECT_EQ(accessor["count"], count) << key;
  };
  const std::size_t points = map.vertices.size();
  require("frequencies", "SCALAR", 5126, 2);
  require("decayRates", "SCALAR", 5126, 2);
  require("positions", "VEC3", 5126, points);
  require("shapes", "VEC3", 5126, 2 * points);
  require("indices", "SCALAR", 5125, 3 * map.triangles.size());
  EXPECT_THAT(values_of<float>(file, model["decayRates"]), ElementsAre(4.0F, 42.0F));
  EXPECT_NEAR(values_of<float>(file, model["frequencies"]).at(1), std::sqrt(400 * 400 - std::pow(42 / 6.2831853, 2)),
              1e-4);
  EXPECT_EQ(values_of<float>(file, model["shapes"]), map.shape);
  const auto corners = values_of<std::uint32_t>(file, model["indices"]);
  EXPECT_EQ(corners.at(4), static_cast<std::uint32_t>(map.triangles[1][1]));
  const json& bounds = file["accessors"][file["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>()];
  EXPECT_NEAR(bounds["max"][2].get<double>(), 0.1, 1e-6);
}

/// A box of steel along turned axes.
sound_maps::SoundMap turned_box() {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()));
  sound_maps::SoundMap map = plate_map();
  map.kind = "solid";
  map.mass = 12.0;
  map.centre = {5, 6, 7};
  map.vertices.clear();
  for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7}) {
    const Vector3 sides(corner & 1 ? 1 : -1, corner & 2 ? 2 : -2, corner & 4 ? 3 : -3);
    map.vertices.emplace_back(map.centre + turn * (0.5 * sides));
  }
  map.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  map.shape.assign(2 * 3 * map.vertices.size(), 0.0F);
  return map;
}

TEST(Gltf, HasTheInertiaOfABox) {
  const json file = json::parse(gltf_file(turned_box()));
  const json& mass = file["extensions"]["KHR_audio_rigid_bodies"]["modalModels"][0]["massProperties"];
  const auto moments = mass["inertiaDiagonal"].get<std::vector<double>>();  // m (a2 + b2) / 12 of sides 1, 2, 3
  EXPECT_THAT(moments, ElementsAre(DoubleNear(5, 1e-12), DoubleNear(10, 1e-12), DoubleNear(13, 1e-12)));
  const auto q = mass["inertiaOrientation"].get<std::vector<double>>();
  const Vector3 easiest = Eigen::Quaterniond(q[3], q[0], q[1], q[2]) * Vector3::UnitX();
  const Vector3 longest = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()) * Vector3::UnitZ();
  EXPECT_NEAR(std::abs(easiest.dot(longest)), 1.0, 1e-12);
}

TEST(Gltf, HasRayleighDampingWhereThatIsTheDecay) {
  sound_maps::SoundMap map = plate_map();
  map.frequency = {300, 400, 1000};
  const auto material_of = [&](auto decay) {
    map.material_decay.clear();
    for (const double frequency : map.frequency) {
      map.material_decay.push_back(decay(2 * std::numbers::pi * frequency));
    }
    map.radiation_decay = {1, 1, 1};
    map.shape.resize(3 * 3 * map.vertices.size());
    return json::parse(gltf_file(map))["extensions"]["KHR_audio_rigid_bodies"]["acousticMaterials"][0];
  };
  const json rayleigh = material_of([](double w) { return (6 + 1e-7 * w * w) / 2; });
  EXPECT_NEAR(rayleigh["alpha"].get<double>(), 6, 1e-9);
  EXPECT_NEAR(rayleigh["beta"].get<double>(), 1e-7, 1e-16);
  const json loss_factor = material_of([](double w) { return 1e-3 * w / 2; });
  EXPECT_FALSE(loss_factor.contains("alpha") || loss_factor.contains("beta"));
}

TEST(Gltf, HasASurfaceOfItsMaterial) {
  const json file = json::parse(gltf_file(plate_map()));
  EXPECT_EQ(file["extensions"]["KHR_audio_rigid_bodies"]["acousticSurfaces"][0]["material"], 0);
  EXPECT_EQ(file["nodes"][0]["extensions"]["KHR_audio_rigid_bodies"]["acousticSurface"], 0);
}

TEST(Gltf, OfAMembraneHasNoMaterial) {
  sound_maps::SoundMap map = plate_map();
  map.material.reset();
  const json file = json::parse(gltf_file(map));
  EXPECT_FALSE(file["extensions"]["KHR_audio_rigid_bodies"].contains("acousticMaterials"));
}

TEST(Faust, HasALineForEachMode) {
  const std::string program = faust_program(plate_map(), std::vector{1.0, 2.0}, 0, "here");
  EXPECT_THAT(program, HasSubstr("struck here, heard at ear"));
  EXPECT_THAT(program, HasSubstr("declare name \"deck ball\""));
  EXPECT_THAT(program, HasSubstr("mode(299.9"));
  EXPECT_THAT(program, HasSubstr(":> _;"));
}

}  // namespace
}  // namespace idiophone::sound_maps
