#pragma once
// A surface that is driven by a known motion, and what it emits.

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include <Eigen/Dense>

#include "idiophone/air/surface/emitter.hpp"
#include "idiophone/air/surface/surface.hpp"

namespace idiophone::surface {

inline constexpr double pi = std::numbers::pi;

inline const Sampling paper{.rate = 44100, .steps_per_sample = 24, .steps_per_read = 4};

/// Where every vertex is displaced to at a time in s.
using Motion = std::function<Vector3(const Vector3& reference, double time)>;

/// A right triangle of 0.5 cm2 in the plane z = 0, normal +z.
inline const std::vector<Vector3> corners = {{0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}, {0.0, 0.01, 0.0}};

/// Drives a surface and keeps what the first triangle emits; emitted[i] belongs to audio sample i.
class Driven {
 public:
  Driven(Motion motion, const Sampling& sampling, std::vector<Vector3> reference = corners,
         const std::vector<std::array<Index, 3>>& triangles = {{0, 1, 2}}, double dc_loss = 0.0)
      : reference_(std::move(reference)),
        motion_(std::move(motion)),
        sampling_(sampling),
        surface_(triangles, reference_, sampling),
        emitter_(triangles, dc_loss) {
    displace(0.0);
    emitter_.start(surface_.start());
  }

  void advance(int samples) {
    for (int sample = 0; sample < samples; ++sample) {
      for (int read = 0; read < sampling_.reads_per_sample(); ++read) {
        ++reads_;
        displace(static_cast<double>(reads_) / (sampling_.rate * static_cast<double>(sampling_.reads_per_sample())));
        surface_.read();
      }
      surface_.take(low_passed_);
      emitter_.emit(low_passed_, emission);
      emissions.push_back(emission);
    }
  }

  /// Emission of an audio sample.
  [[nodiscard]] const Emission& at(int sample) const { return emissions.at(sample + sampling_.latency() - 1); }

  Surface& surface() { return surface_; }
  Emitter& emitter() { return emitter_; }
  [[nodiscard]] double time(int sample) const { return static_cast<double>(sample) / sampling_.rate; }

  Emission emission;
  std::vector<Emission> emissions;

 private:
  void displace(double time) {
    for (std::size_t vertex = 0; vertex < reference_.size(); ++vertex) {
      Vector3::Map(&surface_.displacements()[3 * vertex]) = motion_(reference_[vertex], time);
    }
  }

  std::vector<Vector3> reference_;
  Motion motion_;
  Sampling sampling_;
  Surface surface_;
  Emitter emitter_;
  SurfaceMotion low_passed_;
  std::int64_t reads_ = 0;
};

/// Amplitude and phase of a sine in what was sampled, as c of Re(c exp(i w t)), by least squares.
inline std::complex<double> fit(const std::function<double(int)>& value, double frequency, int rate, int first,
                                int count) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (int sample = first; sample < first + count; ++sample) {
    const double angle = 2.0 * pi * frequency * sample / rate;
    const Eigen::Vector2d basis(std::cos(angle), -std::sin(angle));
    normal += basis * basis.transpose();
    right += basis * value(sample);
  }
  normal.diagonal().array() += 1e-9;  // at half the rate the sine is zero in every sample
  const Eigen::Vector2d solution = normal.inverse() * right;
  return {solution[0], solution[1]};
}

/// Response of the pressure to a triangle that swings along its normal: 1 is an exact copy.
inline std::complex<double> pressure_response(double frequency, const Sampling& sampling, double dc_loss = 0.0) {
  const double amplitude = 1e-6;
  Driven driven(
      [&](const Vector3&, double t) -> Vector3 {
        return {0, 0, amplitude / (2 * pi * frequency) * std::sin(2 * pi * frequency * t)};
      },
      sampling, corners, {{0, 1, 2}}, dc_loss);
  driven.advance(900 + sampling.latency());
  return fit([&](int i) { return driven.at(i).pressure[0] / (sampling.impedance * amplitude); }, frequency,
             sampling.rate, 400, 480);
}

inline double decibels(std::complex<double> response) {
  return 20.0 * std::log10(std::abs(response));
}

}  // namespace idiophone::surface
