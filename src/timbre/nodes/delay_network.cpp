#include "idiophone/timbre/nodes/delay_network.hpp"

#include <cmath>

#include "idiophone/timbre/nodes/sound_node.hpp"

namespace idiophone::timbre {

DelayNetwork::DelayNetwork(const std::vector<std::size_t>& lengths, double decay, int rate)
    : arriving_(lengths.size()) {
  for (const std::size_t samples : lengths) {
    lines_.push_back({.samples = std::vector<double>(samples),
                      .gain = std::pow(10.0, -3.0 * static_cast<double>(samples) / (rate * decay))});
  }
}

std::span<const double> DelayNetwork::step(double input) {
  double sum = 0.0;
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    arriving_[l] = lines_[l].gain * lines_[l].samples[lines_[l].place];
    sum += arriving_[l];
  }
  // Householder's reflection x - (2/n) sum(x) keeps the energy and joins every line to every other.
  const double reflected = 2.0 / static_cast<double>(lines_.size()) * sum;
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    Line& line = lines_[l];
    line.samples[line.place] = without_denormals(input + arriving_[l] - reflected);
    line.place = line.place + 1 == line.samples.size() ? 0 : line.place + 1;
  }
  return arriving_;
}

}  // namespace idiophone::timbre
