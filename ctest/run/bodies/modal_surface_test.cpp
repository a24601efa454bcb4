#include "modal_surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "idiophone/air/surface/surface.hpp"
#include "ranks.hpp"

namespace idiophone::bodies {
namespace {

const surface::Sampling sampling{.rate = 44100, .steps_per_sample = 24, .steps_per_read = 4};
const std::vector<mesh::Triangle> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
const std::vector<Vector3> corners = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.08, 0}, {0.01, 0.02, 0.09}};
const Vector3 centre(0.02, 0.02, 0.02);

/// Two modes of a tetrahedron.
modal_bodies::ModalBasis some_basis() {
  modal_bodies::ModalBasis basis;
  basis.masses.assign(4, 0.01);
  basis.frequencies = {3000.0, 30000.0};
  for (int i = 0; i < 24; ++i) {
    basis.shapes.push_back(5 * std::sin(1.7 * i + 0.3));
  }
  return basis;
}

/// Flies, spins and vibrates.
struct Flight {
  std::vector<double> places, rates;
  Eigen::Matrix3d turn_less_one;

  motion::ModalState at(double time) {
    const Vector3 spin(30, -50, 200);
    turn_less_one =
        Eigen::AngleAxisd(spin.norm() * time, spin.normalized()).toRotationMatrix() - Eigen::Matrix3d::Identity();
    places = {1e-6 * std::sin(3000.0 * time), 1e-7 * std::sin(30000.0 * time)};
    rates = {3e-3 * std::cos(3000.0 * time), 3e-3 * std::cos(30000.0 * time)};
    return {Vector3(1.0, -0.5, 2.0) * time, turn_less_one, {1.0, -0.5, 2.0}, spin, places, rates};
  }
};

/// Displacements of the corners.
void put_displacements(const modal_bodies::ModalBasis& basis, const motion::ModalState& state,
                       std::span<double> result) {
  for (std::size_t node = 0; node < 4; ++node) {
    Vector3 vibration = Vector3::Zero();
    for (std::size_t mode = 0; mode < 2; ++mode) {
      vibration += state.places[mode] * Eigen::Map<const Vector3>(&basis.shapes[3 * (4 * mode + node)]);
    }
    const Vector3 displacement = state.shift + state.turn_less_one * (corners[node] - centre + vibration) + vibration;
    std::ranges::copy(displacement, &result[3 * node]);
  }
}

ON_RANKS(1);

TEST(ModalSurface, SoundsAsItsTrianglesOneByOne) {
  const modal_bodies::ModalBasis basis = some_basis();
  ModalSurface modal(basis, {faces, {0, 1, 2, 3}, corners, centre}, sampling);
  surface::Surface plain(faces, corners, sampling);
  Flight flight;
  std::vector<double> pressure(4), position(12), velocities(12);
  const motion::ModalState begin = flight.at(0.0);
  put_displacements(basis, begin, plain.displacements());
  for (std::size_t node = 0; node < 4; ++node) {
    Vector3 velocity = begin.velocity + begin.spin.cross(corners[node] - centre);
    for (std::size_t mode = 0; mode < 2; ++mode) {
      velocity += begin.rates[mode] * Eigen::Map<const Vector3>(&basis.shapes[3 * (4 * mode + node)]);
    }
    std::ranges::copy(velocity, &velocities[3 * node]);
  }
  surface::SurfaceMotion expected = plain.start(velocities);
  modal.start(begin, pressure, position);
  // Of 1000 Pa. The surface turns its steady motion by half a read at the start, and the vibration tilts it by 1e-4.
  const auto compare = [&](int sample) {
    const double tolerance = sample < 8 ? 0.7 : 0.15;
    for (std::size_t t = 0; t < 4; ++t) {
      EXPECT_NEAR(pressure[t], expected.pressure[t], tolerance) << sample;
    }
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_NEAR(position[i], expected.position[i], 1e-9) << sample;
    }
  };
  compare(0);
  double largest = 0.0;
  for (int sample = 1; sample < 60; ++sample) {
    for (int read = 1; read <= sampling.reads_per_sample(); ++read) {
      const double time = (sample - 1 + static_cast<double>(read) / sampling.reads_per_sample()) / sampling.rate;
      put_displacements(basis, flight.at(time), plain.displacements());
      plain.read();
      modal.read(flight.at(time));
    }
    plain.take(expected);
    modal.take(pressure, position);
    compare(sample);
    largest = std::max(largest, std::abs(pressure[0]));
  }
  EXPECT_GT(largest, 100.0);
}

}  // namespace
}  // namespace idiophone::bodies
