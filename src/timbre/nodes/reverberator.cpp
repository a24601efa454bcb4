#include "idiophone/timbre/nodes/reverberator.hpp"

#include <cmath>

#include "idiophone/timbre/nodes/sound_node.hpp"

namespace idiophone::timbre {

Reverberator::Reverberator(double decay, int rate) {
  constexpr std::array<double, line_count> lengths = {0.02973, 0.03319, 0.03711, 0.04111,
                                                      0.04537, 0.05077, 0.05623, 0.06287};  // s, without common factor
  for (std::size_t l = 0; l < line_count; ++l) {
    const auto samples = static_cast<std::size_t>(std::lround(lengths[l] * rate)) | 1U;
    lines_[l].samples.assign(samples, 0.0);
    lines_[l].gain = std::pow(10.0, -3.0 * static_cast<double>(samples) / (rate * decay));
  }
}

double Reverberator::step(double input) {
  std::array<double, line_count> arriving{};
  double sum = 0.0, sound = 0.0;
  for (std::size_t l = 0; l < line_count; ++l) {
    arriving[l] = lines_[l].gain * lines_[l].samples[lines_[l].place];
    sum += arriving[l];
    sound += l % 2 == 0 ? arriving[l] : -arriving[l];
  }
  // Householder's reflection x - (2/n) sum(x) keeps the energy and joins every line to every other.
  const double reflected = 2.0 / line_count * sum;
  for (std::size_t l = 0; l < line_count; ++l) {
    Line& line = lines_[l];
    line.samples[line.place] = without_denormals(input + arriving[l] - reflected);
    line.place = (line.place + 1) % line.samples.size();
  }
  return sound / std::sqrt(static_cast<double>(line_count));
}

}  // namespace idiophone::timbre
