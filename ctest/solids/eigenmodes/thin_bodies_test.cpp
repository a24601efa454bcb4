// Walls made from surfaces, against plates of extruded hexahedra and thin rings.

#include <cmath>
#include <numbers>

#include "ranks.hpp"
#include "samples.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

mesh::Mesh wall(const std::filesystem::path& file, element::Type type, double thickness) {
  scene::Body body = mesh::body_of(file, type);
  body.thickness = thickness;
  return mesh::read_mesh(body);
}

ON_RANKS(1);

TEST(ThinBodies, APlateFromItsSurfaceIsTheExtrudedPlate) {
  const std::string square =
      "SetFactory(\"OpenCASCADE\"); Rectangle(1) = {0, 0, 0, 0.2, 0.15};"
      "Transfinite Curve {1:4} = 3; Transfinite Surface {1}; Recombine Surface {1};";
  const mesh::TemporaryFile surface("surface.geo", square);
  const mesh::TemporaryFile extruded("extruded.geo",
                                     square + "Extrude {0, 0, 0.004} { Surface{1}; Layers{1}; Recombine; }");
  const element::Type type = element::hex(4, 2);
  const Modes one = VibratingBody(wall(surface.path(), type, 0.004)).find({.count = 8});
  const Modes other = VibratingBody(mesh::read_mesh(mesh::body_of(extruded.path(), type))).find({.count = 8});
  ASSERT_EQ(one.rigid_motions, 6);
  for (std::size_t mode = 0; mode < 8; ++mode) {
    EXPECT_NEAR(one.modes[mode].frequency / other.modes[mode].frequency, 1, 1e-6) << mode;
  }
}

// Hoppe 1871: w^2 = E h^2/(12 rho R^4) n^2 (n^2 - 1)^2/(n^2 + 1) of a thin ring that bends in its plane. Without
// lateral contraction it does not matter how wide the ring is. What the formula leaves out is of the order of (n
// h/R)^2/12.
TEST(ThinBodies, ARingBendsAsHoppeSays) {
  constexpr double radius = 0.1, thickness = 0.002;
  const mesh::TemporaryFile file("ring.geo",
                                 "SetFactory(\"OpenCASCADE\"); Circle(1) = {0, 0, 0, 0.1, 0, Pi};"
                                 "Circle(2) = {0, 0, 0, 0.1, Pi, 2 * Pi};"
                                 "Extrude {0, 0, 0.02} { Curve{1, 2}; Layers{1}; Recombine; } Coherence;"
                                 "Transfinite Curve {1, 2} = 6;");
  VibratingBody ring(wall(file.path(), element::hex(4, 2), thickness));
  ring.scene.materials[0].poisson = 0.0;
  const Modes found = ring.find({.count = 10});
  EXPECT_EQ(found.rigid_motions, 6);
  for (const double n : {2.0, 3.0}) {
    const double hoppe = n * (n * n - 1) / std::sqrt(n * n + 1) * thickness / std::sqrt(12) / (radius * radius) *
                         std::sqrt(2e11 / 7850) / (2 * std::numbers::pi);
    const auto is_near = [&](const Mode& mode) { return std::abs(mode.frequency / hoppe - 1) < 1e-3; };
    EXPECT_GE(std::ranges::count_if(found.modes, is_near), 2) << "a pair of waves around the ring, n = " << n;
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
