#include "idiophone/source/proxy_source.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace idiophone::source {

namespace {

std::shared_ptr<const proxies::Lattice> rubber_box() {
  const auto place = [](const Vector3& at) { return Vector3(0.1 * at); };
  return std::make_shared<proxies::Lattice>(
      proxies::grid_mesh({3, 3, 3}, place),
      proxies::Material{.young = 1e5, .density = 1000.0, .damping = {.mass = 100.0, .stiffness = 1e-5}});
}

scene::Scene quiet_scene() {
  scene::Scene scene;
  scene.audio.rate = 44100;
  scene.audio.max_frequency = 22050;
  scene.radiation.model = scene::RadiationModel::kirchhoff;
  return scene;
}

}  // namespace

/// The vibrations of this box are far below the largest frequency, so that the low-pass changes nothing.
TEST(ProxySource, MovesTheSurfaceAsTheProxyMoves) {
  const auto lattice = rubber_box();
  const scene::Scene scene = quiet_scene();
  proxies::Force blow = proxies::impact(1, 10, {0.03, 0.06, 0.1}, {0.0, 0.0, -1e-3}, 5e-3, 44100);
  ProxySource source({{"still", lattice}, {"struck", lattice}}, {blow}, scene, {});
  ASSERT_EQ(source.surface().global_triangles(), 2 * static_cast<Index>(lattice->mesh().surface.size()));
  ASSERT_EQ(source.surface().radii.size(), source.surface().triangles.size());
  proxies::Proxy proxy(lattice, {.rate = 6 * 44100.0});
  const proxies::Contact contact = lattice->contact_at(blow.at);
  surface::SurfaceMotion motion, before;
  source.start(motion);
  const Index vertex = source.surface().first_vertex[1];  // of the first surface mass, which is mass 0
  const std::int64_t latency = -source.first_sample();
  constexpr int samples = 600;
  std::vector<double> expected, found;
  for (int sample = 0; sample < samples; ++sample) {
    const int since = sample - 10;
    for (int read = 0; read < 6; ++read) {
      const bool acts = since >= 0 && since < static_cast<int>(blow.curve.size());
      const proxies::PointForce force{.contact = contact,
                                      .force = acts ? Vector3(blow.curve[since] * blow.direction) : Vector3::Zero()};
      acts ? proxy.advance({&force, 1}) : proxy.advance({});
    }
    expected.push_back(proxy.displacement(0)[2]);
    before = motion;
    source.advance(motion);
    found.push_back(motion.position[3 * vertex + 2] - source.surface().reference[vertex][2]);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i + latency < expected.size(); ++i) {
    largest = std::max(largest, std::abs(expected[i]));
    EXPECT_NEAR(found[i + latency], expected[i], 1e-3 * 2e-6);
  }
  EXPECT_GT(largest, 1e-6);
  // The pressure of a triangle is impedance times the velocity of its centre along its normal (O'Brien 2001, eq. 2).
  for (Index t = source.surface().first_triangle[1]; t < source.surface().global_triangles(); ++t) {
    const auto& [i, j, k] = source.surface().triangles[t];
    const auto& place = source.surface().reference;
    const Vector3 normal = (place[j] - place[i]).cross(place[k] - place[i]).normalized();
    double moved = 0.0;
    for (const Index corner : {i, j, k}) {
      for (Index axis = 0; axis < 3; ++axis) {
        moved += (motion.position[3 * corner + axis] - before.position[3 * corner + axis]) * normal[axis] / 3.0;
      }
    }
    const double pressure = scene.radiation.air.impedance() * moved * 44100;
    EXPECT_NEAR(motion.pressure[t], pressure, 0.05 * std::abs(pressure) + 1e-3);
  }
  EXPECT_EQ(motion.position[2], source.surface().reference[0][2]);  // the other box was not struck
}

}  // namespace idiophone::source
