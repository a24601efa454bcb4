#include "idiophone/instruments/sound_maps/surface_search.hpp"

#include <gtest/gtest.h>

#include <random>

#include "ranks.hpp"
#include "vibrating_map.hpp"

namespace idiophone::sound_maps {

ON_RANKS(1);

/// At places around, in and on a box, and at its corners and edges, where several triangles are equally near.
TEST(SurfaceSearch, FindsWhatASearchOfAllTrianglesFinds) {
  const radiation::Solid box = radiation::box({0.3, 0.2, 0.1}, {6, 4, 2});
  const SoundMap map = map_of(box, [](const Vector3& place) { return place; }, {440.0});
  std::vector<Vector3> places = box.vertices;
  for (const auto& [i, j, k] : box.triangles) {
    places.emplace_back(0.5 * (map.vertices[i] + map.vertices[j]));
    places.emplace_back(1.5 * map.vertices[k]);
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> anywhere(-0.3, 0.3);
  for (int i = 0; i < 500; ++i) {
    places.emplace_back(anywhere(random), anywhere(random), anywhere(random));
  }
  const SurfaceSearch search(map);
  for (const Vector3& place : places) {
    const SurfacePoint found = search.nearest(place), expected = nearest_point(map, place);
    EXPECT_EQ(found.triangle, expected.triangle) << place.transpose();
    EXPECT_EQ(found.weights, expected.weights);
    EXPECT_EQ(found.distance, expected.distance);
  }
}

TEST(SurfaceSearch, TakesTheOnlyTriangle) {
  const radiation::Solid one{.triangles = {{0, 1, 2}}, .vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const SoundMap map = map_of(one, [](const Vector3& place) { return place; }, {440.0});
  EXPECT_EQ(SurfaceSearch(map).nearest({2, 0, 0}).weights, Vector3::UnitY());
}

}  // namespace idiophone::sound_maps
