#include "idiophone/air/receivers/absorbing_walls.hpp"

#include <algorithm>
#include <cmath>

#include "zero_phase.hpp"

namespace idiophone::receivers {

double AbsorbingWalls::gain(std::size_t path, double frequency) const {
  const std::vector<double>& losses = losses_[path];
  const auto last = static_cast<double>(losses.size() - 1);
  const double octave = frequency > lowest_ ? std::min(last, std::log2(frequency / lowest_)) : 0.0;
  const auto below = static_cast<std::size_t>(octave);
  const std::size_t above = std::min(below + 1, losses.size() - 1);
  return std::exp(-losses[below] - (octave - static_cast<double>(below)) * (losses[above] - losses[below]));
}

std::vector<double> AbsorbingWalls::response(std::size_t path) const {
  return zero_phase_filter(half_width(), rate_, [&](double frequency) { return gain(path, frequency); });
}

}  // namespace idiophone::receivers
