#include "idiophone/air/waves/pulse_response.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace idiophone::waves {

namespace {

using Complex = std::complex<double>;

constexpr double width = 4e-5;   // of the pulse, s: -3 dB at 3.3 kHz
constexpr double middle = 3e-4;  // of the pulse, s
constexpr double memory = 1e-3;  // of what was heard recently, s
constexpr double faint = 1e-3;   // part of a spectrum that may come after the end
constexpr int rate = 44100;      // of which the steps are a multiple, 1/s

double pulse_at(double time) {
  const double x = (time - middle) / width;
  return std::exp(-0.5 * x * x);
}

Plan plan_for(const PulsedSurface& surface) {
  Wishes wishes{.low = Vector3::Constant(std::numeric_limits<double>::max()),
                .cell = surface.cell,
                .speed = surface.speed,
                .rate = rate,
                .floor = {}};
  wishes.high = -wishes.low;
  const auto& positions = surface.obstruction.positions;
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const Vector3 vertex(positions[i], positions[i + 1], positions[i + 2]);
    wishes.low = wishes.low.cwiseMin(vertex);
    wishes.high = wishes.high.cwiseMax(vertex);
  }
  return make_plan(wishes);
}

double norm(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values)).norm();
}

}  // namespace

PulsedField::PulsedField(const PulsedSurface& surface)
    : surface_(surface),
      plan_(plan_for(surface)),
      step_length_(1.0 / (rate * plan_.steps)),
      field_(Division(plan_.grid, 1), plan_.courant, MPI_COMM_SELF, surface.lossy),
      changes_(surface.shape.size()) {
  CutCells cells(field_.subdomain(), surface.obstruction, plan_.courant, surface.lossy.has_value());
  sources_ = SurfaceSources(field_.subdomain(), surface.obstruction, changes_.size(), cells, plan_.courant);
  node_sources_.resize(cells.nodes().size());
  field_.set_surfaces(std::move(cells));
}

double PulsedField::pulse() const {
  return pulse_at(time());
}

void PulsedField::advance() {
  const double half = step_length_ / 2.0;
  const double change = surface_.impedance * (pulse_at(time() + half) - pulse_at(time() - half));
  std::ranges::transform(surface_.shape, changes_.begin(),
                         [change](float shape) { return static_cast<float>(change * shape); });
  sources_.add(changes_, node_sources_);
  field_.step(node_sources_);
  ++step_;
}

PulseResponse::PulseResponse(const PulsedSurface& surface, std::span<const double> frequencies, double longest)
    : speed_(surface.speed) {
  PulsedField pulsed(surface);
  EnclosingBox box(pulsed.field(), pulsed.plan().enclosure);
  for (const double frequency : frequencies) {
    waves_.push_back({2.0 * std::numbers::pi * frequency, 0.0, std::vector<Complex>(box.patches()),
                      std::vector<Complex>(box.patches())});
  }
  double recent = 0.0;  // sum of the pressures on the box, the newest ones most, Pa
  bool ended = false;
  for (int step = 1; pulsed.time() < longest && !ended; ++step) {
    pulsed.advance();
    box_ = box.emission();
    for (Wave& wave : waves_) {
      add(wave, pulsed.time(), pulsed.pulse());
    }
    recent += norm(box_.surface_pressure) - recent * pulsed.time() / (step * memory);
    ended = step % 64 == 0 && has_faded(recent);
  }
  duration_ = pulsed.time();
}

/// A tone that rings on changes a spectrum by its amplitude over its angular frequency at the most.
bool PulseResponse::has_faded(double recent) const {
  return std::ranges::all_of(waves_, [recent](const Wave& wave) {
    return recent < faint * Eigen::Map<const Eigen::VectorXcd>(wave.pressure.data(), std::ssize(wave.pressure)).norm();
  });
}

void PulseResponse::add(Wave& wave, double time, double pulse) const {
  const Complex turn = std::exp(Complex(0.0, -wave.angular * time));
  wave.driven += pulse * turn;
  for (std::size_t i = 0; i < wave.pressure.size(); ++i) {
    wave.pressure[i] += box_.surface_pressure[i] * turn;
    wave.gradient[i] += box_.pressure_gradient[i] * turn;
  }
}

template <class FindPath>
Complex PulseResponse::integral(const Wave& wave, const FindPath& find_path) const {
  Complex sum = 0.0;
  for (std::size_t i = 0; i < wave.pressure.size(); ++i) {
    const Vector3 normal(box_.normal[0][i], box_.normal[1][i], box_.normal[2][i]);
    const Path path = find_path(Vector3(box_.centre[0][i], box_.centre[1][i], box_.centre[2][i]));
    sum += box_.area[i] * path.transfer *
           (path.direction.dot(normal) * path.decrease * wave.pressure[i] - wave.gradient[i]);
  }
  return sum / (4.0 * std::numbers::pi * wave.driven);
}

Complex PulseResponse::at(std::size_t frequency, const Vector3& point) const {
  const Complex ik = wave_number(waves_[frequency]);
  return integral(waves_[frequency], [&](const Vector3& centre) {
    const Vector3 way = point - centre;
    const double distance = way.norm();
    return Path{std::exp(-ik * distance) / distance, way / distance, ik + 1.0 / distance};
  });
}

Complex PulseResponse::towards(std::size_t frequency, const Vector3& direction) const {
  const Complex ik = wave_number(waves_[frequency]);
  return integral(waves_[frequency], [&](const Vector3& centre) {
    return Path{std::exp(ik * direction.dot(centre)), direction, ik};
  });
}

}  // namespace idiophone::waves
