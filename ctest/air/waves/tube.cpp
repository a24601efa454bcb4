#include "tube.hpp"

#include <cmath>
#include <numbers>

#include "idiophone/air/waves/pulse_response.hpp"

namespace idiophone::waves {

using std::numbers::pi;

radiation::Solid revolved(const Profile& profile) {
  constexpr int around = 60;
  const auto points = static_cast<Index>(profile.size());
  radiation::Solid solid;
  for (int step = 0; step < around; ++step) {
    const double angle = 2.0 * pi * step / around;
    for (const auto& [radius, height] : profile) {
      solid.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (Index step = 0; step < around; ++step) {
    const Index here = step * points, next = (step + 1) % around * points;
    for (Index p = 0; p < points; ++p) {
      const Index q = (p + 1) % points;
      if (profile[q][0] > 0.0) {
        solid.triangles.push_back({here + p, next + q, here + q});
      }
      if (profile[p][0] > 0.0) {
        solid.triangles.push_back({here + p, next + p, next + q});
      }
    }
  }
  return solid;
}

radiation::Solid closed_tube(double radius, double length, double wall) {
  return revolved({{0.0, 0.0},
                   {radius + wall, 0.0},
                   {radius + wall, wall + length},
                   {radius, wall + length},
                   {radius, wall},
                   {0.0, wall}});
}

Recording record(const radiation::Solid& solid, double bottom, double cell, const Vector3& place, double duration,
                 const std::optional<LossyAir>& lossy) {
  const auto positions = positions_of(solid);
  const auto shape = shape_of(solid, [bottom](const Vector3& at, const Vector3& normal) {
    return normal[2] > 0.5 && std::abs(at[2] - bottom) < 1e-9 ? 1.0 : 0.0;
  });
  PulsedField pulsed({.obstruction = {solid.triangles, positions},
                      .shape = shape,
                      .cell = cell,
                      .speed = speed,
                      .impedance = impedance,
                      .lossy = lossy});
  const Index number = pulsed.field().subdomain().number(cell_at(pulsed.plan().grid.in_cells(place)));
  Recording recording;
  while (pulsed.time() < duration) {
    pulsed.advance();
    recording.pressure.push_back(pulsed.field().pressure(number));
  }
  recording.step = pulsed.time() / static_cast<double>(recording.pressure.size());
  return recording;
}

Complex spectrum(const Recording& recording, double start, double length, double frequency) {
  Complex sum = 0.0;
  const auto first = static_cast<std::size_t>(start / recording.step);
  const auto count = static_cast<std::size_t>(length / recording.step);
  for (std::size_t i = 0; i < count; ++i) {
    const double time = static_cast<double>(first + i) * recording.step;
    const double window = 1.0 - std::cos(2.0 * pi * static_cast<double>(i) / static_cast<double>(count));
    sum += window * recording.pressure.at(first + i) * std::exp(Complex(0.0, -2.0 * pi * frequency * time));
  }
  return sum;
}

double frequency_near(const Recording& recording, double expected, double length) {
  constexpr double start = 0.003, later = 0.002;  // s
  const Complex turn =
      spectrum(recording, start + later, length, expected) / spectrum(recording, start, length, expected);
  return expected + std::arg(turn) / (2.0 * pi * later);
}

double end_correction(double radius, double outer, double frequency) {
  const double ratio = radius / outer, square = std::pow(2.0 * pi * frequency / speed * radius, 2);
  const double still = 0.8216 + ratio * (0.6133 - 0.8216) + 0.057 * ratio * (1.0 - std::pow(ratio, 5));
  return radius * still * (1.0 + 0.0599 * square) / (1.0 + 0.238 * square);
}

}  // namespace idiophone::waves
