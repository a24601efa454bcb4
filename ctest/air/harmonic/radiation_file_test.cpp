// Results of `radiate`: what is written comes back to the bit, also the solutions on refined surfaces.

#include "idiophone/air/harmonic/radiation_file.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <array>
#include <limits>
#include <random>

#include "shared_folder.hpp"
#include "small_radiation.hpp"
#include "surface_levels.hpp"
#include "with_petsc.hpp"

namespace idiophone::harmonic {
namespace {

using ::testing::HasSubstr;

using RadiationFile = WithPetsc;

const Origin origin = {.name = "deck", .code_version = "0.2.0", .deck_text = "name: deck", .overrides = {"a=1"}};

/// Any numbers, to be told apart.
std::vector<Complex> some_numbers(std::size_t count, std::size_t seed) {
  std::mt19937 random(seed);
  std::vector<Complex> numbers(count);
  for (Complex& number : numbers) {
    number = {static_cast<double>(random()), -static_cast<double>(random())};
  }
  return numbers;
}

/// Three sounds above a floor; the second one was solved on a refined surface.
Radiation refined_radiation() {
  Radiation radiation = small_radiation();
  radiation.surfaces.front().floor = radiation::ReflectingPlane{{0, 0, -1}, {0, 0, 1}, 0.5};
  radiation.surfaces.push_back(refined(radiation.surfaces.front()).boundary);
  radiation.sounds.push_back(radiation.sounds.front());
  radiation.sounds[1].refinements = 1;
  std::size_t seed = 0;
  for (RadiatedSound& sound : radiation.sounds) {
    const Boundary& surface = radiation.surfaces[sound.refinements];
    sound.solution.pressure = some_numbers(surface.vertices.size(), ++seed);
    sound.solution.normal_velocity = some_numbers(3 * surface.triangles.size(), ++seed);
  }
  return radiation;
}

TEST_F(RadiationFile, ComesBackToTheBit) {
  const support::Folder folder;
  const auto file = folder / "radiation.h5";
  const Radiation radiation = refined_radiation();
  write_radiation(file, origin, radiation);
  const auto [read_origin, read] = read_radiation(file);
  EXPECT_EQ(read_origin.deck_text, origin.deck_text);
  EXPECT_EQ(read_origin.overrides, origin.overrides);
  EXPECT_EQ(read.bodies, radiation.bodies);
  EXPECT_EQ(read.parts, radiation.parts);
  EXPECT_EQ(read.first_triangle, radiation.first_triangle);
  EXPECT_EQ(read.air_speed, radiation.air_speed);
  EXPECT_EQ(read.weights, radiation.weights);
  ASSERT_EQ(read.surfaces.size(), 2);
  for (std::size_t level = 0; level < 2; ++level) {
    EXPECT_EQ(read.surfaces[level].vertices, radiation.surfaces[level].vertices);
    EXPECT_EQ(read.surfaces[level].triangles, radiation.surfaces[level].triangles);
    ASSERT_TRUE(read.surfaces[level].floor.has_value());
    EXPECT_EQ(read.surfaces[level].floor->at, radiation.surfaces[0].floor->at);
    EXPECT_EQ(read.surfaces[level].floor->reflection, 0.5);
  }
  ASSERT_EQ(read.sounds.size(), 3);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_EQ(read.sounds[s].frequency, radiation.sounds[s].frequency);
    EXPECT_EQ(read.sounds[s].refinements, radiation.sounds[s].refinements);
    EXPECT_EQ(read.sounds[s].solution.pressure, radiation.sounds[s].solution.pressure);
    EXPECT_EQ(read.sounds[s].solution.normal_velocity, radiation.sounds[s].solution.normal_velocity);
  }
}

/// What reading a file says after one of its parts has been removed.
std::string refusal_without(const char* part) {
  const support::Folder folder;
  const auto file = folder / "radiation.h5";
  write_radiation(file, origin, refined_radiation());
  const auto open = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Ldelete(open, part, H5P_DEFAULT);
  H5Fclose(open);
  return support::error_of([&] { (void)read_radiation(file); });
}

TEST_F(RadiationFile, IsRefusedWhereItContradictsItself) {
  const support::Folder folder;
  const auto file = folder / "radiation.h5";
  const auto refusal_of = [&](Radiation radiation) {
    write_radiation(file, origin, radiation);
    return support::error_of([&] { (void)read_radiation(file); });
  };
  Radiation radiation = refined_radiation();
  radiation.sounds[0].solution.pressure[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal_of(radiation), HasSubstr("/solutions/0/pressure has a number that is not finite"));
  write_radiation(file, origin, refined_radiation());
  const auto open = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const auto numbers = H5Dopen2(open, "/solutions/0/sound", H5P_DEFAULT);
  const std::array<std::int32_t, 2> twice = {0, 0};
  H5Dwrite(numbers, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, twice.data());
  H5Dclose(numbers);
  H5Fclose(open);
  EXPECT_THAT(support::error_of([&] { (void)read_radiation(file); }), HasSubstr("names sound 0 again"));
}

TEST_F(RadiationFile, IsRefusedWithoutItsSolutions) {
  EXPECT_THAT(refusal_without("/solutions"), HasSubstr("run radiate on its deck again"));
  EXPECT_THAT(refusal_without("/solutions/1"), HasSubstr("solutions of 2 sounds; there are 3"));
  EXPECT_THAT(refusal_without("/solutions/0/pressure"), HasSubstr("/solutions/0/pressure"));
}

}  // namespace
}  // namespace idiophone::harmonic
