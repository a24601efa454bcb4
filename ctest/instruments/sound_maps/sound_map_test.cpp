// Sound maps: what is written comes back to the bit; what contradicts itself or is damaged is refused.

#include <hdf5.h>

#include <cmath>
#include <functional>
#include <limits>

#include "idiophone/instruments/sound_maps/sound_map_file.hpp"
#include "idiophone/run/results/verification.hpp"
#include "idiophone/study/contents/describe.hpp"
#include "ranks.hpp"
#include "results.hpp"
#include "small_map.hpp"
#include "temporary_file.hpp"

namespace idiophone::sound_maps {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Only one rank reads and writes: a map has nothing to do with MPI.
class SoundMapFile : public ::testing::Test {
 protected:
  /// What reading a map says after a change that the writer can't know of.
  std::string refusal_after(const std::function<void(hid_t)>& change) {
    write_sound_map(path_, small_map());
    const auto file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    change(file);
    H5Fclose(file);
    return support::error_of([&] { (void)read_sound_map(path_); });
  }

  support::TemporaryFile file_{"map.h5"};
  const std::filesystem::path path_ = file_.path();
};

ON_RANKS(1);

TEST_F(SoundMapFile, ComesBackToTheBit) {
  const SoundMap map = small_map();
  write_sound_map(path_, map);
  const SoundMap read = read_sound_map(path_);
  EXPECT_EQ(read.name, map.name);
  EXPECT_EQ(read.body, map.body);
  EXPECT_EQ(read.kind, map.kind);
  EXPECT_EQ(read.code_version, map.code_version);
  EXPECT_EQ(read.deck_text, map.deck_text);
  EXPECT_EQ(read.overrides, map.overrides);
  EXPECT_EQ(read.resolved_deck, map.resolved_deck);
  ASSERT_TRUE(read.material.has_value());
  EXPECT_EQ(read.material->name, "steel");
  EXPECT_EQ(read.material->young, 2e11);
  EXPECT_EQ(read.mass, map.mass);
  EXPECT_EQ(read.centre, map.centre);
  EXPECT_EQ(read.radiation, map.radiation);
  EXPECT_EQ(read.frequency, map.frequency);
  EXPECT_EQ(read.material_decay, map.material_decay);
  EXPECT_EQ(read.radiation_decay, map.radiation_decay);
  ASSERT_TRUE(read.scalable.has_value());
  EXPECT_EQ(read.scalable->mesh, map.scalable->mesh);
  EXPECT_EQ(read.scalable->held, "rim xyz");
  ASSERT_TRUE(read.scalable->mesh_shape.has_value());
  EXPECT_EQ(read.scalable->mesh_shape->kind, map.scalable->mesh_shape->kind);
  EXPECT_EQ(read.scalable->mesh_shape->middle, map.scalable->mesh_shape->middle);
  EXPECT_EQ(read.scalable->mesh_shape->size, map.scalable->mesh_shape->size);
  EXPECT_EQ(read.scalable->mesh_shape->pattern, map.scalable->mesh_shape->pattern);
  EXPECT_EQ(read.scalable->stiffness, map.scalable->stiffness);
  EXPECT_EQ(read.scalable->lossless_frequency, map.scalable->lossless_frequency);
  EXPECT_EQ(read.decay(1), 2 + 1.0 / 3);
  EXPECT_EQ(read.vertices, map.vertices);
  EXPECT_EQ(read.triangles, map.triangles);
  EXPECT_EQ(read.shape, map.shape);
  ASSERT_EQ(read.listeners.size(), 1);
  EXPECT_EQ(read.listeners[0].name, "ears.left");
  EXPECT_EQ(read.listeners[0].position, map.listeners[0].position);
  EXPECT_EQ(read.listeners[0].delay, 0.003);
  EXPECT_EQ(read.listeners[0].pressure, map.listeners[0].pressure);
  EXPECT_EQ(read.sphere.direction, map.sphere.direction);
  EXPECT_EQ(read.sphere.weight, map.sphere.weight);
  EXPECT_EQ(read.sphere.pressure, map.sphere.pressure);
  EXPECT_EQ(read.sphere.azimuths, 2);
}

TEST_F(SoundMapFile, HasTheErrorOfTheMeshWhereItIsKnown) {
  SoundMap map = small_map();
  write_sound_map(path_, map);
  EXPECT_TRUE(read_sound_map(path_).mesh_error.empty());
  EXPECT_THAT(contents::describe(path_), Not(HasSubstr("cents")));
  map.mesh_error = {-7.25, std::numeric_limits<double>::quiet_NaN()};
  write_sound_map(path_, map);
  const SoundMap read = read_sound_map(path_);
  ASSERT_EQ(read.mesh_error.size(), 2);
  EXPECT_EQ(read.mesh_error[0], -7.25);
  EXPECT_TRUE(std::isnan(read.mesh_error[1]));
  EXPECT_THAT(contents::describe(path_), HasSubstr("up to 7.2 cents (mode 1), as estimated for 1 of 2 modes"));
}

TEST_F(SoundMapFile, OfABodyThatSwingsLeavesItsRigidMotionsOut) {
  SoundMap map = small_map();
  map.mesh_error = {-383, 12.5};
  for (std::size_t i = 0; i < 3 * map.vertices.size(); ++i) {
    map.shape[i] = i % 3 == 2 ? 1 : 0;  // up and down, at a frequency that can be heard
  }
  EXPECT_EQ(mesh_error_text(map),
            "the mesh makes frequencies wrong by up to 12.5 cents (mode 2), as estimated for 1 of 1 modes besides 1 "
            "rigid motion");
}

TEST_F(SoundMapFile, OfAMembraneHasNoMaterial) {
  SoundMap map = small_map();
  map.material.reset();
  map.scalable.reset();
  write_sound_map(path_, map);
  EXPECT_FALSE(read_sound_map(path_).material.has_value());
}

/// Of two modes and three terms.
modal_bodies::Stretching some_stretching() {
  return {.linear = {1, 2, 3, 1.0 / 3, 5, 6},
          .quadratic = {1, 2, 2, 3, 4, 5, 5, 6, 7, 8, 8, 1.0 / 9},
          .rotation = {2, 1, 1, 3}};
}

TEST_F(SoundMapFile, HasTheStretchingOfLargeVibrations) {
  SoundMap map = small_map();
  write_sound_map(path_, map);
  EXPECT_FALSE(read_sound_map(path_).stretching.exists());
  map.stretching = some_stretching();
  write_sound_map(path_, map);
  const modal_bodies::Stretching read = read_sound_map(path_).stretching;
  EXPECT_EQ(read.linear, map.stretching.linear);
  EXPECT_EQ(read.quadratic, map.stretching.quadratic);
  EXPECT_EQ(read.rotation, map.stretching.rotation);
  EXPECT_EQ(results::verify(path_).unproved, 0);
  EXPECT_THAT(contents::describe(path_), HasSubstr("large amplitudes: 3 terms of stretching"));
}

TEST_F(SoundMapFile, RefusesStretchingThatCannotBe) {
  const auto refusal = [&](const std::function<void(modal_bodies::Stretching&)>& change) {
    SoundMap map = small_map();
    map.stretching = some_stretching();
    change(map.stretching);
    return support::error_of([&] { write_sound_map(path_, map); });
  };
  EXPECT_THAT(refusal([](auto& stretching) { stretching.quadratic.pop_back(); }), HasSubstr("11 values, not 12"));
  EXPECT_THAT(refusal([](auto& stretching) { stretching.rotation = {}; }), HasSubstr("/stretching/rotation"));
  EXPECT_THAT(refusal([](auto& stretching) { stretching.linear = {}; }), HasSubstr("no terms"));
  EXPECT_THAT(refusal([](auto& stretching) { stretching.quadratic[1] = 2.1; }), HasSubstr("not symmetric"));
  EXPECT_THAT(refusal([](auto& stretching) { stretching.linear[0] = std::nan(""); }), HasSubstr("not finite"));
  SoundMap map = small_map();
  map.stretching = some_stretching();
  write_sound_map(path_, map);
  const auto file = H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Adelete_by_name(file, "/stretching", "version", H5P_DEFAULT);
  H5Fclose(file);
  EXPECT_THAT(support::error_of([&] { (void)read_sound_map(path_); }), HasSubstr("version"));
}

TEST_F(SoundMapFile, ReplacesAnOlderOneAndLeavesNothingBeside) {
  write_sound_map(path_, small_map());
  SoundMap map = small_map();
  map.mass = 7;
  write_sound_map(path_, map);
  EXPECT_EQ(read_sound_map(path_).mass, 7);
  EXPECT_FALSE(std::filesystem::exists(path_.string() + ".part"));
}

TEST_F(SoundMapFile, IsDescribedAndVerified) {
  write_sound_map(path_, small_map());
  EXPECT_THAT(contents::describe(path_), HasSubstr("sound map of the solid 'plate' of the deck 'deck'"));
  EXPECT_THAT(contents::describe_as_json(path_), HasSubstr("/modes/shape"));
  const results::Verification verification = results::verify(path_);
  EXPECT_TRUE(verification.damaged.empty());
  EXPECT_EQ(verification.unproved, 0);
}

TEST_F(SoundMapFile, IsNotWrittenIfItContradictsItself) {
  const auto refusal = [&](const std::function<void(SoundMap&)>& change) {
    SoundMap map = small_map();
    change(map);
    return support::error_of([&] { write_sound_map(path_, map); });
  };
  EXPECT_THAT(refusal([](auto& map) { map.shape.pop_back(); }), HasSubstr("/modes/shape has 23 values, not 24"));
  EXPECT_THAT(refusal([](auto& map) { map.triangles[2][1] = 4; }), HasSubstr("vertex 4; there are 4"));
  EXPECT_THAT(refusal([](auto& map) { map.frequency = {200, 100}; }), HasSubstr("do not ascend"));
  EXPECT_THAT(refusal([](auto& map) { map.material_decay[0] = -1; }), HasSubstr("below 0"));
  EXPECT_THAT(refusal([](auto& map) { map.radiation_decay[0] = std::numeric_limits<double>::quiet_NaN(); }),
              HasSubstr("not finite"));
  EXPECT_THAT(refusal([](auto& map) { map.mesh_error = {1}; }), HasSubstr("/modes/mesh_error has 1 values, not 2"));
  EXPECT_THAT(refusal([](auto& map) {
                map.mesh_error = {1, std::numeric_limits<double>::infinity()};
              }),
              HasSubstr("infinite"));
  EXPECT_THAT(refusal([](auto& map) { map.sphere.rings = 3; }), HasSubstr("4 directions are not 3 rings of 2"));
  EXPECT_THAT(refusal([](auto& map) { map.listeners[0].delay = -1; }), HasSubstr("ears.left"));
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(SoundMapFile, IsNotReadIfItIsDamagedOrLacksSomething) {
  EXPECT_THAT(refusal_after([](hid_t file) {
                const auto dataset = H5Dopen2(file, "/modes/decay", H5P_DEFAULT);
                const std::array<double, 2> zeros{};
                H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
                H5Dclose(dataset);
              }),
              HasSubstr("/modes/decay"));
  EXPECT_THAT(refusal_after([](hid_t file) { H5Ldelete(file, "/sphere/weight", H5P_DEFAULT); }),
              HasSubstr("/sphere/weight"));
  EXPECT_THAT(refusal_after([](hid_t file) {
                H5Ldelete(file, "/listeners/delay", H5P_DEFAULT);
                H5Lcreate_hard(file, "/modes/frequency", file, "/listeners/delay", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("/listeners/delay does not have the size of the others"));
}

}  // namespace
}  // namespace idiophone::sound_maps
