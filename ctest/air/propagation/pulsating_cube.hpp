#pragma once
// A cube that pulsates on a grid.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "idiophone/scene/scene.hpp"
#include "stages.hpp"
#include "wave_air.hpp"

namespace idiophone::propagation {

class PulsatingCube : public ::testing::Test {
 protected:
  static constexpr double edge = 0.04;  // of the cube, m
  static constexpr double cube_area = 6 * edge * edge;
  static constexpr double peak = 5.0;     // of P, Pa
  static constexpr double width = 5e-4;   // of the pulse, s
  static constexpr double middle = 3e-3;  // of the pulse, s
  static constexpr std::int64_t steady_sample = -2;
  static constexpr std::size_t heard_samples = 70;

  /// The cube about the origin, its triangles dealt to so many ranks.
  static AudibleSurface cube(int rank, int ranks) {
    propagation::AudibleSurface surface;
    surface.bodies = {"cube"};
    surface.first_triangle = {0, 12};
    surface.first_vertex = {0, 8};
    for (Index vertex = 0; vertex < 8; ++vertex) {
      surface.vertex_ids.push_back(vertex);
      surface.reference.emplace_back(edge * ((vertex & 1) - 0.5), edge * ((vertex >> 1 & 1) - 0.5),
                                     edge * ((vertex >> 2 & 1) - 0.5));
    }
    Index number = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Index along = 1 << axis, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
      for (const auto& triangle : {mesh::Triangle{along, along + u, along + u + v},
                                   {along, along + u + v, along + v},
                                   {0, u + v, u},
                                   {0, v, u + v}}) {
        if (number++ % ranks == rank) {
          surface.triangle_ids.push_back(number - 1);
          surface.triangles.push_back(triangle);
        }
      }
    }
    return surface;
  }

  PulsatingCube() {
    scene_.audio.rate = 8000;
    scene_.audio.dc_loss = 0.1;
    scene_.radiation.model = scene::RadiationModel::waves;
    scene_.radiation.grid.cell = 0.01;
    scene_.radiation.visibility.reset();
  }

  scene::Listener& listen_at(const Vector3& place) {
    auto& listener = scene_.listeners.emplace_back();
    listener.name = "ear";
    listener.receivers.push_back({.channel = "ear", .position = place});
    return listener;
  }

  /// What a microphone at a distance should hear in an audio sample, Pa.
  [[nodiscard]] double exact(double distance, double sample) const {
    const double x = (sample / scene_.audio.rate - distance / scene_.radiation.air.speed - middle) / width;
    return -cube_area * peak * x * std::exp(-0.5 * x * x) / width /
           (4.0 * std::numbers::pi * distance * scene_.radiation.air.speed);
  }

  [[nodiscard]] static surface::SurfaceMotion motion(const propagation::AudibleSurface& surface, double shift) {
    surface::SurfaceMotion motion;
    motion.pressure.resize(padded(surface.triangles.size()));
    for (const Vector3& vertex : surface.reference) {
      motion.position.insert(motion.position.end(), {vertex[0] + shift, vertex[1], vertex[2]});
    }
    motion.position.resize(surface::SurfaceMotion::position_length(surface.reference.size()));
    return motion;
  }

  /// Audio samples from `begin` to before `end`, in which the cube moves along x, m/s.
  void propagate(WaveAir& air, const propagation::AudibleSurface& surface, std::int64_t begin, std::int64_t end,
                 double speed = 0.0) const {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      const double time = static_cast<double>(sample) / scene_.audio.rate;
      surface::Emission emission;
      emission.resize(padded(surface.triangles.size()));
      const double x = (time - middle) / width;
      std::fill_n(emission.pressure.begin(), surface.triangles.size(), peak * std::exp(-0.5 * x * x));
      air.propagate(sample, emission, motion(surface, speed * time));
    }
  }

  /// What all listeners hear of the cube on the ranks of a communicator; nothing on other ranks than 0.
  [[nodiscard]] std::vector<std::vector<double>> hear(MPI_Comm communicator, double speed = 0.0,
                                                      accelerator::Accelerator* accelerator = nullptr) const {
    const auto surface = cube(parallel::rank_of(communicator), parallel::size_of(communicator));
    WaveAir air(scene_, surface, steady_sample, support::stages(), communicator, accelerator);
    air.start(steady_sample, motion(surface, 0.0));
    const std::int64_t end = heard_samples - air.final_before(0) + 1;
    propagate(air, surface, steady_sample + 1, end, speed);
    air.finish();
    return air.take(heard_samples);
  }

  /// Largest difference over the largest value.
  static double error(const std::vector<double>& heard, const std::function<double(double)>& exact) {
    double largest = 0.0, wrong = 0.0;
    for (std::size_t i = 0; i < heard.size(); ++i) {
      largest = std::max(largest, std::abs(exact(static_cast<double>(i))));
      wrong = std::max(wrong, std::abs(heard[i] - exact(static_cast<double>(i))));
    }
    return wrong / largest;
  }

  scene::Scene scene_;
};

}  // namespace idiophone::propagation
