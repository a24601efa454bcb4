#include "idiophone/instruments/voices/proxy_film.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "tile_voices.hpp"

namespace idiophone::voices {

namespace {

constexpr int filmed_rate = 16000;

/// A tile of 60 x 60 x 5 mm that is struck from below, filmed with 500 frames per second for 0.02 s.
std::unique_ptr<ProxyVoices> filmed_tile(double tensile, const drivers::BodyTrack& track = {}) {
  auto voices = tile_voices({.cells = 8, .damping = 10.0, .tensile = tensile, .track = track}, filmed_rate);
  voices->take_film(500.0);
  strike_tile(*voices, -1.0);
  std::vector<double> sound(320);
  for (std::size_t first = 0; first < sound.size(); first += 80) {
    voices->render(std::span(sound).subspan(first, 80), 0);
  }
  return voices;
}

Vector3 place_in(const FilmedBody& body, const FilmFrame& frame, Index node) {
  return body.nodes[node] + Eigen::Map<const Vector3>(&frame.displacement[0][3 * static_cast<std::size_t>(node)]);
}

double volume_in(const FilmedBody& body, const FilmFrame& frame, const std::array<Index, 4>& tetrahedron) {
  const Vector3 a = place_in(body, frame, tetrahedron[0]);
  return (place_in(body, frame, tetrahedron[1]) - a)
             .cross(place_in(body, frame, tetrahedron[2]) - a)
             .dot(place_in(body, frame, tetrahedron[3]) - a) /
         6.0;
}

/// How far nodes are apart in a frame that have one place at rest, at most, m.
double largest_gap(const FilmedBody& body, const FilmFrame& frame) {
  std::map<std::tuple<double, double, double>, Index> first;
  double gap = 0.0;
  for (Index node = 0; node < std::ssize(body.nodes); ++node) {
    const Vector3& at = body.nodes[node];
    const auto found = first.try_emplace({at.x(), at.y(), at.z()}, node).first;
    gap = std::max(gap, (place_in(body, frame, node) - place_in(body, frame, found->second)).norm());
  }
  return gap;
}

}  // namespace

TEST(ProxyFilm, HasMotionAndVibrationOfABody) {
  const drivers::BodyTrack track = [](double time) {
    return Eigen::Isometry3d(Eigen::Translation3d(3.0 * time, 0, 0) * Eigen::AngleAxisd(time, Vector3::UnitZ()));
  };
  const auto voices = filmed_tile(std::numeric_limits<double>::infinity(), track);
  const FilmedBody& body = voices->film()->bodies()[0];
  EXPECT_EQ(body.nodes.size(), 9U * 9U * 2U);
  ASSERT_EQ(voices->film()->frames().size(), 10U);
  for (std::size_t f = 0; f < 10; ++f) {
    const FilmFrame& frame = voices->film()->frames()[f];
    EXPECT_DOUBLE_EQ(frame.time, static_cast<double>(f) / 500.0);
    double vibration = 0.0;
    for (Index node = 0; node < std::ssize(body.nodes); ++node) {
      vibration = std::max(vibration, (place_in(body, frame, node) - track(frame.time) * body.nodes[node]).norm());
    }
    EXPECT_LT(vibration, 3e-3);
    EXPECT_EQ(vibration > 1e-7, f > 0);
  }
}

TEST(ProxyFilm, ShowsHowPiecesFlyApart) {
  const auto held = filmed_tile(1e12), voices = filmed_tile(1e6);
  const FilmedBody& body = voices->film()->bodies()[0];
  EXPECT_EQ(body.nodes.size(), 4U * body.tetrahedra.size());
  EXPECT_LT(largest_gap(held->film()->bodies()[0], held->film()->frames().back()), 1e-12);
  ASSERT_GE(voices->fractures().size(), 1U);
  const double early = largest_gap(body, voices->film()->frames()[5]),
               late = largest_gap(body, voices->film()->frames().back());
  EXPECT_GT(early, 1e-4);
  EXPECT_GT(late, 1.2 * early);
  for (const auto& tetrahedron : body.tetrahedra) {  // what flies is not torn
    const double before = volume_in(body, voices->film()->frames().front(), tetrahedron);
    EXPECT_NEAR(volume_in(body, voices->film()->frames().back(), tetrahedron) / before, 1.0, 0.3);
  }
}

}  // namespace idiophone::voices
