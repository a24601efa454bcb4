#include "ringing.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "idiophone/waves/surface_sources.hpp"

namespace idiophone::waves {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double width = 4e-5;   // of the pulse, s: -3 dB at 3.3 kHz
constexpr double middle = 3e-4;  // s

double pulse(double time) {
  const double x = (time - middle) / width;
  return std::exp(-0.5 * x * x);
}

/// Sums up a signal times exp(-i w t).
struct Spectrum {
  double w;
  Complex sum = 0.0;
  void add(double time, double value) { sum += value * std::exp(Complex(0.0, -w * time)); }
};

/// The pressure at a point from spectra at the box (Kirchhoff-Helmholtz).
class Box {
 public:
  Box(const EnclosingBox& box, std::span<const double> frequencies) {
    for (const double frequency : frequencies) {
      waves_.push_back(
          {2.0 * pi * frequency, std::vector<Complex>(box.patches()), std::vector<Complex>(box.patches())});
    }
  }

  void add(double time, const surface::Emission& emission) {
    for (auto& [w, pressure, gradient] : waves_) {
      const Complex turn = std::exp(Complex(0.0, -w * time));
      for (std::size_t i = 0; i < pressure.size(); ++i) {
        pressure[i] += emission.surface_pressure[i] * turn;
        gradient[i] += emission.pressure_gradient[i] * turn;
      }
    }
  }

  [[nodiscard]] Complex at(std::size_t frequency, const Vector3& point, const surface::Emission& emission) const {
    const auto& [w, pressure, gradient] = waves_[frequency];
    const Complex ik(0.0, w / speed);
    Complex sum = 0.0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      Vector3 way = point, normal;
      for (std::size_t k = 0; k < 3; ++k) {
        way[k] -= emission.centre[k][i];
        normal[k] = emission.normal[k][i];
      }
      const double distance = way.norm();
      const double cosine = way.dot(normal) / distance;
      sum += emission.area[i] * std::exp(-ik * distance) / (4.0 * pi * distance) *
             (cosine * (ik + 1.0 / distance) * pressure[i] - gradient[i]);
    }
    return sum;
  }

 private:
  struct Wave {
    double w;
    std::vector<Complex> pressure, gradient;
  };
  std::vector<Wave> waves_;
};

/// The solid's surface as the grid takes it.
class Surface {
 public:
  explicit Surface(const Ringing& ringing) : solid_(ringing.solid) {
    for (const auto& [a, b, c] : solid_.corners()) {
      const Vector3 normal = (b - a).cross(c - a).normalized();
      double sum = 0.0;  // over the middles of the edges: the mean of a quadratic shape is exact
      for (const Vector3& place : {Vector3((a + b) / 2.0), Vector3((b + c) / 2.0), Vector3((c + a) / 2.0)}) {
        sum += ringing.shape(place, normal);
      }
      shape_.push_back(static_cast<float>(sum / 3.0));
    }
    move(Vector3::Zero());
  }
  void move(const Vector3& shift) {
    positions_.clear();
    for (const Vector3& vertex : solid_.vertices) {
      const Vector3 place = vertex + shift;
      positions_.insert(positions_.end(), place.begin(), place.end());
    }
  }
  [[nodiscard]] Obstruction obstruction() const { return {solid_.triangles, positions_}; }
  [[nodiscard]] const std::vector<float>& shape() const { return shape_; }

 private:
  const radiation::Solid& solid_;
  std::vector<float> positions_, shape_;
};

}  // namespace

Responses ring_in_motion(const Ringing& ringing, const Vector3& velocity, std::span<const double> frequencies,
                         std::span<const Vector3> points) {
  const double way = velocity.norm() * ringing.duration;
  Wishes wishes{.cell = ringing.cell, .margin = way, .speed = speed, .rate = 44100, .floor = {}};
  for (const Vector3& vertex : ringing.solid.vertices) {
    wishes.low = wishes.low.cwiseMin(vertex);
    wishes.high = wishes.high.cwiseMax(vertex);
  }
  const Plan plan = make_plan(wishes);
  const Slab slab(plan.grid, 0, plan.grid.cells[2]);
  WaveField field(slab, plan.courant, MPI_COMM_SELF);
  EnclosingBox box(slab, plan.enclosure);
  Surface surface(ringing);
  SurfaceSources sources;
  std::vector<float> node_sources, changes(surface.shape().size());
  const auto set_surfaces = [&] {
    CutCells cells(slab, surface.obstruction());
    sources = SurfaceSources(slab, surface.obstruction(), changes.size(), cells, plan.courant);
    node_sources.resize(cells.nodes().size());
    field.set_surfaces(std::move(cells));
  };
  set_surfaces();
  Box spectra(box, frequencies);
  std::vector<Spectrum> driven;
  for (const double frequency : frequencies) {
    driven.push_back({2.0 * pi * frequency});
  }
  const double step = 1.0 / (wishes.rate * plan.steps);
  const int steps_between_updates = std::max(1, static_cast<int>(1e-3 / step));
  for (int n = 0; n * step < ringing.duration; ++n) {
    const double time = n * step;
    if (!velocity.isZero() && n % steps_between_updates == 0) {
      surface.move((time - ringing.duration / 2) * velocity);
      set_surfaces();
    }
    const double change = impedance * (pulse(time + step / 2) - pulse(time - step / 2));
    for (std::size_t i = 0; i < changes.size(); ++i) {
      changes[i] = static_cast<float>(change * surface.shape()[i]);
    }
    sources.add(changes, node_sources);
    field.step(node_sources);
    spectra.add(time + step, box.emission(field));
    for (Spectrum& spectrum : driven) {
      spectrum.add(time + step, pulse(time + step));
    }
  }
  Responses responses(frequencies.size());
  for (std::size_t f = 0; f < frequencies.size(); ++f) {
    for (const Vector3& point : points) {
      responses[f].push_back(spectra.at(f, point, box.emission(field)) / driven[f].sum);
    }
  }
  return responses;
}

Responses ring(const Ringing& ringing, std::span<const double> frequencies, std::span<const Vector3> points) {
  return ring_in_motion(ringing, Vector3::Zero(), frequencies, points);
}

double level(std::span<const Complex> one, std::span<const Complex> other) {
  const auto square = [](std::span<const Complex> values) {
    return std::accumulate(values.begin(), values.end(), 0.0, [](double sum, Complex v) { return sum + std::norm(v); });
  };
  return 10.0 * std::log10(square(one) / square(other));
}

}  // namespace idiophone::waves
