#pragma once
// What a plate beside a screen radiates at two frequencies.

#include "idiophone/air/harmonic/body_radiation.hpp"

namespace idiophone::harmonic {

inline Radiation small_radiation() {
  Radiation radiation;
  radiation.body = "plate";
  radiation.parts = {"plate", "screen"};
  radiation.first_triangle = {0, 1, 2};
  radiation.bodies = 1;
  radiation.air_density = 1.2;
  radiation.air_speed = 340.0;
  radiation.surfaces = {{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}, {0, 2, 1}}}};
  radiation.directions = {{0, 0, 1}};
  radiation.weights = {1.0};
  for (const double frequency : {200.0, 450.5}) {
    harmonic::RadiatedSound& sound = radiation.sounds.emplace_back();
    sound.frequency = frequency;
    sound.solution.pressure.resize(3);
    sound.solution.normal_velocity.resize(6);
    sound.far_field.resize(1);
  }
  return radiation;
}

}  // namespace idiophone::harmonic
